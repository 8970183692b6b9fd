//! Arms in the plane.

arms! {
    planar2r 2 PlanarPosition "../specs/planar2r.yaml";
    planar2r_unit 2 PlanarPosition "../specs/planar2r_unit.yaml";
    planar3r 3 PlanarPose "../specs/planar3r.yaml";
    planar4r_redundant 4 PlanarPose given 1 "../specs/planar4r_redundant.yaml";
    planar4r_q2 4 PlanarPose given 2 "arms/planar/planar4r_q2.yaml";
    planar4r_q3 4 PlanarPose given 3 "arms/planar/planar4r_q3.yaml";
    planar4r_q4 4 PlanarPose given 4 "arms/planar/planar4r_q4.yaml";
    planar3r_mounted 3 PlanarPose "arms/planar/planar3r_mounted.yaml";
    planar3r_upside_down 3 PlanarPose "arms/planar/planar3r_upside_down.yaml";
    planar3r_antiparallel 3 PlanarPose "arms/planar/planar3r_antiparallel.yaml";
    planar2r_mounted 2 PlanarPosition "arms/planar/planar2r_mounted.yaml";
    planar2r_upside_down 2 PlanarPosition "arms/planar/planar2r_upside_down.yaml";
    planar_rpr 3 PlanarPose "arms/planar/planar_rpr.yaml";
    planar_rrp 3 PlanarPose "arms/planar/planar_rrp.yaml";
    planar_prr 3 PlanarPose "arms/planar/planar_prr.yaml";
    planar_rp 2 PlanarPosition "arms/planar/planar_rp.yaml";
    planar_pr 2 PlanarPosition "arms/planar/planar_pr.yaml";
    planar3r_position_q1 3 PlanarPosition given 1 "arms/planar/planar3r_position_q1.yaml";
    planar3r_position_q2 3 PlanarPosition given 2 "arms/planar/planar3r_position_q2.yaml";
}
