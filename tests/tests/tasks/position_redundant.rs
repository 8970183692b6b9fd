//! Arms of four joints that place the tool point, and of six that also point it, one joint given.

arms! {
    rrrr_skew_q1 4 Position given 1 "arms/position_redundant/rrrr_skew_q1.yaml";
    rrrr_skew_q2 4 Position given 2 "arms/position_redundant/rrrr_skew_q2.yaml";
    rrrr_skew_q3 4 Position given 3 "arms/position_redundant/rrrr_skew_q3.yaml";
    rrrr_skew_q4 4 Position given 4 "arms/position_redundant/rrrr_skew_q4.yaml";
    prrr_q1 4 Position given 1 "arms/position_redundant/prrr_q1.yaml";
    rrrp_q4 4 Position given 4 "arms/position_redundant/rrrp_q4.yaml";
    rrrr_mounted_q3 4 Position given 3 "arms/position_redundant/rrrr_mounted_q3.yaml";
    ur_pointing_q6 6 PositionAxis(Z) given 6 "arms/position_redundant/ur_pointing_q6.yaml";
    puma_welding_q2 6 PositionAxis(X) given 2 "arms/position_redundant/puma_welding_q2.yaml";
    puma_welding_q1 6 PositionAxis(Z) given 1 "arms/position_redundant/puma_welding_q1.yaml";
}
