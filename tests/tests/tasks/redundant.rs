//! Arms of seven joints, one of them given.

arms! {
    franka_panda 7 Pose given 7 { spec = "../specs/franka_panda.yaml" };
    kinova_gen3_7dof 7 Pose given 3 { spec = "../specs/kinova_gen3_7dof.yaml" };
    kuka_iiwa7_r800 7 Pose given 3 { spec = "../specs/kuka_iiwa7_r800.yaml" };
    franka_panda_q4 7 Pose given 4 { yaml = "
# franka_panda with joint 4 given
name: franka_panda_q4
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q4, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 0.333, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0, limits: [-101, 101]}
  - {type: revolute, a: 0, alpha: 90, d: 0.316, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0.0825, alpha: 90, d: 0, theta: 0, limits: [-176, -4]}
  - {type: revolute, a: -0.0825, alpha: -90, d: 0.384, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0, limits: [-1, 215]}
  - {type: revolute, a: 0.088, alpha: 90, d: 0.107, theta: 0, limits: [-166, 166]}
  - {type: fixed, a: 0, alpha: 0, d: 0.103, theta: -45}
" };
    franka_panda_q5 7 Pose given 5 { yaml = "
# franka_panda with joint 5 given
name: franka_panda_q5
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q5, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 0.333, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0, limits: [-101, 101]}
  - {type: revolute, a: 0, alpha: 90, d: 0.316, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0.0825, alpha: 90, d: 0, theta: 0, limits: [-176, -4]}
  - {type: revolute, a: -0.0825, alpha: -90, d: 0.384, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0, limits: [-1, 215]}
  - {type: revolute, a: 0.088, alpha: 90, d: 0.107, theta: 0, limits: [-166, 166]}
  - {type: fixed, a: 0, alpha: 0, d: 0.103, theta: -45}
" };
    franka_panda_q6 7 Pose given 6 { yaml = "
# franka_panda with joint 6 given
name: franka_panda_q6
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q6, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 0.333, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0, limits: [-101, 101]}
  - {type: revolute, a: 0, alpha: 90, d: 0.316, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0.0825, alpha: 90, d: 0, theta: 0, limits: [-176, -4]}
  - {type: revolute, a: -0.0825, alpha: -90, d: 0.384, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0, limits: [-1, 215]}
  - {type: revolute, a: 0.088, alpha: 90, d: 0.107, theta: 0, limits: [-166, 166]}
  - {type: fixed, a: 0, alpha: 0, d: 0.103, theta: -45}
" };
    kinova_gen3_7dof_q1 7 Pose given 1 { yaml = "
# kinova_gen3_7dof with joint 1 given
name: kinova_gen3_7dof_q1
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q1, require: true}
joints:
  - {type: fixed, a: 0, alpha: 180, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: -0.2848, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: -0.0118, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: -0.4208, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: -0.0128, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: -0.3143, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 180}
  - {type: revolute, a: 0, alpha: 180, d: -0.1674, theta: 180}
" };
    kinova_gen3_7dof_q2 7 Pose given 2 { yaml = "
# kinova_gen3_7dof with joint 2 given
name: kinova_gen3_7dof_q2
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q2, require: true}
joints:
  - {type: fixed, a: 0, alpha: 180, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: -0.2848, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: -0.0118, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: -0.4208, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: -0.0128, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: -0.3143, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 180}
  - {type: revolute, a: 0, alpha: 180, d: -0.1674, theta: 180}
" };
    kinova_gen3_7dof_q4 7 Pose given 4 { yaml = "
# kinova_gen3_7dof with joint 4 given
name: kinova_gen3_7dof_q4
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q4, require: true}
joints:
  - {type: fixed, a: 0, alpha: 180, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: -0.2848, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: -0.0118, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: -0.4208, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: -0.0128, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: -0.3143, theta: 180}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 180}
  - {type: revolute, a: 0, alpha: 180, d: -0.1674, theta: 180}
" };
    kuka_iiwa7_r800_q1 7 Pose given 1 { yaml = "
# kuka_iiwa7_r800 with joint 1 given
name: kuka_iiwa7_r800_q1
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: q1, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 340, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 400, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 400, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 126, theta: 0}
" };
    kuka_iiwa7_r800_q2 7 Pose given 2 { yaml = "
# kuka_iiwa7_r800 with joint 2 given
name: kuka_iiwa7_r800_q2
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: q2, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 340, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 400, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 400, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 126, theta: 0}
" };
    kuka_iiwa7_r800_q5 7 Pose given 5 { yaml = "
# kuka_iiwa7_r800 with joint 5 given
name: kuka_iiwa7_r800_q5
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: q5, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 340, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 400, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 400, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 126, theta: 0}
" };
    kuka_iiwa7_r800_q6 7 Pose given 6 { yaml = "
# kuka_iiwa7_r800 with joint 6 given
name: kuka_iiwa7_r800_q6
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: q6, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 340, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 400, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 400, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 126, theta: 0}
" };
    kuka_iiwa7_r800_q7 7 Pose given 7 { yaml = "
# kuka_iiwa7_r800 with joint 7 given
name: kuka_iiwa7_r800_q7
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: q7, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 340, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 400, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 400, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 126, theta: 0}
" };
    kuka_lwr4_q1 7 Pose given 1 { yaml = "
# kuka_lwr4 with joint 1 given
name: kuka_lwr4_q1
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q1, require: true}
joints:
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0.4, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0.39, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0}
  - {type: fixed, a: 0, alpha: 0, d: 0.103, theta: -45}
" };
    kuka_lwr4_q7 7 Pose given 7 { yaml = "
# kuka_lwr4 with joint 7 given
name: kuka_lwr4_q7
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q7, require: true}
joints:
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0.4, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0.39, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0}
  - {type: fixed, a: 0, alpha: 0, d: 0.103, theta: -45}
" };
    yaskawa_sia10d_q1 7 Pose given 1 { yaml = "
# yaskawa_sia10d with joint 1 given
name: yaskawa_sia10d_q1
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: q1, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 360, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 360, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 155, theta: 180}
" };
    yaskawa_sia10d_q2 7 Pose given 2 { yaml = "
# yaskawa_sia10d with joint 2 given
name: yaskawa_sia10d_q2
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: q2, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 360, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 360, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 155, theta: 180}
" };
    yaskawa_sia10d_q6 7 Pose given 6 { yaml = "
# yaskawa_sia10d with joint 6 given
name: yaskawa_sia10d_q6
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: q6, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 360, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 360, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 155, theta: 180}
" };
    yaskawa_sia10d_q7 7 Pose given 7 { yaml = "
# yaskawa_sia10d with joint 7 given
name: yaskawa_sia10d_q7
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, redundant: q7, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 360, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 360, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 155, theta: 180}
" };
}
