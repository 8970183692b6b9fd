//! Arms of three joints that place the tool point.

arms! {
    anthro3r 3 Position "../specs/anthro3r.yaml";
    cartesian_ppp 3 Position "../specs/cartesian_ppp.yaml";
    cylindrical_rpp 3 Position "../specs/cylindrical_rpp.yaml";
    polar_rrp 3 Position "../specs/polar_rrp.yaml";
    salman_rrr 3 Position "../specs/salman_rrr.yaml";
    salman_rrr_table1 3 Position "../specs/salman_rrr_table1.yaml";
    ppp_skew 3 Position "arms/position/ppp_skew.yaml";
    rpp_skew 3 Position "arms/position/rpp_skew.yaml";
    prp_skew 3 Position "arms/position/prp_skew.yaml";
    ppr_skew 3 Position "arms/position/ppr_skew.yaml";
    rrp_skew 3 Position "arms/position/rrp_skew.yaml";
    rpr_skew 3 Position "arms/position/rpr_skew.yaml";
    prr_skew 3 Position "arms/position/prr_skew.yaml";
    rrr_skew 3 Position "arms/position/rrr_skew.yaml";
    prp_column 3 Position "arms/position/prp_column.yaml";
    rpr_parallel 3 Position "arms/position/rpr_parallel.yaml";
    rrp_parallel 3 Position "arms/position/rrp_parallel.yaml";
    prr_parallel 3 Position "arms/position/prr_parallel.yaml";
    rpr_planar_arm 3 Position "arms/position/rpr_planar_arm.yaml";
    rrr_first_meet 3 Position "arms/position/rrr_first_meet.yaml";
    rrr_last_meet 3 Position "arms/position/rrr_last_meet.yaml";
    rrr_first_parallel 3 Position "arms/position/rrr_first_parallel.yaml";
    rrr_orthogonal 3 Position "arms/position/rrr_orthogonal.yaml";
    rrr_equal_links 3 Position "arms/position/rrr_equal_links.yaml";
    rrr_antiparallel_mm 3 Position "arms/position/rrr_antiparallel_mm.yaml";
    rrr_modified 3 Position "arms/position/rrr_modified.yaml";
    anthro3r_mounted 3 Position "arms/position/anthro3r_mounted.yaml";
    polar_rrp_mounted 3 Position "arms/position/polar_rrp_mounted.yaml";
    cylindrical_rpp_mounted 3 Position "arms/position/cylindrical_rpp_mounted.yaml";
    rrr_skew_mounted 3 Position "arms/position/rrr_skew_mounted.yaml";
    ppp_skew_mounted 3 Position "arms/position/ppp_skew_mounted.yaml";
}
