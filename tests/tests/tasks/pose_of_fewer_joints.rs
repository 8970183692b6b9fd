//! Arms of four and five joints that are asked for a whole pose.

arms! {
    cobra600_rrpr 4 Pose "../specs/cobra600_rrpr.yaml";
    scara_rrrp_325_275 4 Pose "../specs/scara_rrrp_325_275.yaml";
    kuka_youbot 5 Pose "../specs/kuka_youbot.yaml";
    scorbot_er5 5 Pose "../specs/scorbot_er5.yaml";
    scara_rrpr_mounted 4 Pose "arms/pose_of_fewer_joints/scara_rrpr_mounted.yaml";
    scara_rrrp_mounted 4 Pose "arms/pose_of_fewer_joints/scara_rrrp_mounted.yaml";
    scara_prrr 4 Pose "arms/pose_of_fewer_joints/scara_prrr.yaml";
    scara_rprr 4 Pose "arms/pose_of_fewer_joints/scara_rprr.yaml";
    youbot_mounted 5 Pose "arms/pose_of_fewer_joints/youbot_mounted.yaml";
    scorbot_offsets 5 Pose "arms/pose_of_fewer_joints/scorbot_offsets.yaml";
    gantry_pppr 4 Pose "arms/pose_of_fewer_joints/gantry_pppr.yaml";
    table_rppp 4 Pose "arms/pose_of_fewer_joints/table_rppp.yaml";
    cylindrical_rppr 4 Pose "arms/pose_of_fewer_joints/cylindrical_rppr.yaml";
    rail_prpr 4 Pose "arms/pose_of_fewer_joints/rail_prpr.yaml";
    rail_pprr 4 Pose "arms/pose_of_fewer_joints/rail_pprr.yaml";
    hanging_rprp 4 Pose "arms/pose_of_fewer_joints/hanging_rprp.yaml";
    flipped_prrp 4 Pose "arms/pose_of_fewer_joints/flipped_prrp.yaml";
    flipped_rrpp 4 Pose "arms/pose_of_fewer_joints/flipped_rrpp.yaml";
    slide_behind 5 Pose "arms/pose_of_fewer_joints/slide_behind.yaml";
    pose_prprp 5 Pose "arms/pose_of_fewer_joints/pose_prprp.yaml";
    pose_wrist_rrrrr 5 Pose "arms/pose_of_fewer_joints/pose_wrist_rrrrr.yaml";
}
