//! Made-up arms of seven joints, one of them given.

arms! {
    ur_on_a_rail 7 Pose given 1 "arms/redundant_made_up/ur_on_a_rail.yaml";
    puma_on_a_rail 7 Pose given 1 "arms/redundant_made_up/puma_on_a_rail.yaml";
    puma_on_a_turntable 7 Pose given 1 "arms/redundant_made_up/puma_on_a_turntable.yaml";
    skew_meet_567_q2 7 Pose given 2 "arms/redundant_made_up/skew_meet_567_q2.yaml";
    skew_parallel_234_q6 7 Pose given 6 "arms/redundant_made_up/skew_parallel_234_q6.yaml";
    slide_given_between 7 Pose given 3 "arms/redundant_made_up/slide_given_between.yaml";
}
