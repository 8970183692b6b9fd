//! Arms of seven joints, one of them given.

arms! {
    franka_panda 7 Pose given 7 "../specs/franka_panda.yaml";
    kinova_gen3_7dof 7 Pose given 3 "../specs/kinova_gen3_7dof.yaml";
    kuka_iiwa7_r800 7 Pose given 3 "../specs/kuka_iiwa7_r800.yaml";
    franka_panda_q4 7 Pose given 4 "arms/redundant/franka_panda_q4.yaml";
    franka_panda_q5 7 Pose given 5 "arms/redundant/franka_panda_q5.yaml";
    franka_panda_q6 7 Pose given 6 "arms/redundant/franka_panda_q6.yaml";
    kinova_gen3_7dof_q1 7 Pose given 1 "arms/redundant/kinova_gen3_7dof_q1.yaml";
    kinova_gen3_7dof_q2 7 Pose given 2 "arms/redundant/kinova_gen3_7dof_q2.yaml";
    kinova_gen3_7dof_q4 7 Pose given 4 "arms/redundant/kinova_gen3_7dof_q4.yaml";
    kuka_iiwa7_r800_q1 7 Pose given 1 "arms/redundant/kuka_iiwa7_r800_q1.yaml";
    kuka_iiwa7_r800_q2 7 Pose given 2 "arms/redundant/kuka_iiwa7_r800_q2.yaml";
    kuka_iiwa7_r800_q5 7 Pose given 5 "arms/redundant/kuka_iiwa7_r800_q5.yaml";
    kuka_iiwa7_r800_q6 7 Pose given 6 "arms/redundant/kuka_iiwa7_r800_q6.yaml";
    kuka_iiwa7_r800_q7 7 Pose given 7 "arms/redundant/kuka_iiwa7_r800_q7.yaml";
    kuka_lwr4_q1 7 Pose given 1 "arms/redundant/kuka_lwr4_q1.yaml";
    kuka_lwr4_q7 7 Pose given 7 "arms/redundant/kuka_lwr4_q7.yaml";
    yaskawa_sia10d_q1 7 Pose given 1 "arms/redundant/yaskawa_sia10d_q1.yaml";
    yaskawa_sia10d_q2 7 Pose given 2 "arms/redundant/yaskawa_sia10d_q2.yaml";
    yaskawa_sia10d_q6 7 Pose given 6 "arms/redundant/yaskawa_sia10d_q6.yaml";
    yaskawa_sia10d_q7 7 Pose given 7 "arms/redundant/yaskawa_sia10d_q7.yaml";
}
