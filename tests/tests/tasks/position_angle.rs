//! Arms that yaw and pitch three times.

arms! {
    al5d 4 PositionAngle "../specs/al5d.yaml";
    jupiter 4 PositionAngle "../specs/jupiter.yaml";
    jupiter_l4_6cm 4 PositionAngle "../specs/jupiter_l4_6cm.yaml";
    yaw_pitch_offsets 4 PositionAngle "arms/position_angle/yaw_pitch_offsets.yaml";
    yaw_pitch_turned 4 PositionAngle "arms/position_angle/yaw_pitch_turned.yaml";
    yaw_pitch_all_turned 4 PositionAngle "arms/position_angle/yaw_pitch_all_turned.yaml";
    yaw_pitch_mounted 4 PositionAngle "arms/position_angle/yaw_pitch_mounted.yaml";
    yaw_pitch_skew_yaw 4 PositionAngle "arms/position_angle/yaw_pitch_skew_yaw.yaml";
    crane_rrpr 4 PositionAngle "arms/position_angle/crane_rrpr.yaml";
    digger_rrrp 4 PositionAngle "arms/position_angle/digger_rrrp.yaml";
    beam_rprr 4 PositionAngle "arms/position_angle/beam_rprr.yaml";
    polar_rppr 4 PositionAngle "arms/position_angle/polar_rppr.yaml";
}
