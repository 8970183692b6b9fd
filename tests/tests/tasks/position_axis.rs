//! Arms of five joints that place the tool point and point one of the tool's axes.

arms! {
    meet_123_x 5 PositionAxis(X) "arms/position_axis/meet_123_x.yaml";
    meet_234_y 5 PositionAxis(Y) "arms/position_axis/meet_234_y.yaml";
    meet_345_z 5 PositionAxis(Z) "arms/position_axis/meet_345_z.yaml";
    parallel_123_x 5 PositionAxis(X) "arms/position_axis/parallel_123_x.yaml";
    parallel_234_y 5 PositionAxis(Y) "arms/position_axis/parallel_234_y.yaml";
    parallel_345_z 5 PositionAxis(Z) "arms/position_axis/parallel_345_z.yaml";
    meet_123_z 5 PositionAxis(Z) "arms/position_axis/meet_123_z.yaml";
    parallel_234_z 5 PositionAxis(Z) "arms/position_axis/parallel_234_z.yaml";
    parallel_123_y 5 PositionAxis(Y) "arms/position_axis/parallel_123_y.yaml";
    puma_without_flange_z 5 PositionAxis(Z) "arms/position_axis/puma_without_flange_z.yaml";
    puma_without_flange_x 5 PositionAxis(X) "arms/position_axis/puma_without_flange_x.yaml";
    puma_with_torch 5 PositionAxis(Z) "arms/position_axis/puma_with_torch.yaml";
    puma_with_bent_torch 5 PositionAxis(X) "arms/position_axis/puma_with_bent_torch.yaml";
    ur_without_flange_z 5 PositionAxis(Z) "arms/position_axis/ur_without_flange_z.yaml";
    ur_without_flange_mounted 5 PositionAxis(X) "arms/position_axis/ur_without_flange_mounted.yaml";
    scorbot_x 5 PositionAxis(X) "arms/position_axis/scorbot_x.yaml";
    scorbot_y_mounted 5 PositionAxis(Y) "arms/position_axis/scorbot_y_mounted.yaml";
    youbot_x 5 PositionAxis(X) "arms/position_axis/youbot_x.yaml";
    ur_without_flange_y 5 PositionAxis(Y) "arms/position_axis/ur_without_flange_y.yaml";
    stanford_without_flange 5 PositionAxis(Z) "arms/position_axis/stanford_without_flange.yaml";
    stanford_with_torch 5 PositionAxis(Z) "arms/position_axis/stanford_with_torch.yaml";
    gantry_with_two_axes 5 PositionAxis(Z) "arms/position_axis/gantry_with_two_axes.yaml";
    pitches_and_offset_axis 5 PositionAxis(Z) "arms/position_axis/pitches_and_offset_axis.yaml";
    rail_and_four 5 PositionAxis(Z) "arms/position_axis/rail_and_four.yaml";
    flipped_rrprr 5 PositionAxis(X) "arms/position_axis/flipped_rrprr.yaml";
    axis_prprp 5 PositionAxis(Z) "arms/position_axis/axis_prprp.yaml";
}
