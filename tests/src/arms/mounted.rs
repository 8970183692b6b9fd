//! Arms of `specs/` on a base that is off and turned, with a tool that is off and turned.

/// Calls `$with!` with every arm of this page: test name, type, joints, whether it has an inverse, attribute.
#[macro_export]
macro_rules! mounted_arms {
    ($with:ident) => {
        $with! {
            ur5_mounted Ur5Mounted 6 inverse { yaml = "
name: ur5_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: revolute, a: 0, alpha: 90, d: 0.089159, theta: 0}
  - {type: revolute, a: -0.425, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: -0.39225, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0.10915, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0.09465, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: 0.0823, theta: 0}
base: {xyz: [0.553, 0.354, 0.012], rpy: [-66.4, -47, -173.6]}
tool: {xyz: [0.016, 0.135, -0.228], rpy: [117, 21.5, -89.4]}
" };
            puma560_mounted Puma560Mounted 6 inverse { yaml = "
name: puma560_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: revolute, a: 0, alpha: 90, d: 0.67183, theta: 0, limits: [-160, 160]}
  - {type: revolute, a: 0.4318, alpha: 0, d: 0, theta: 0, limits: [-45, 225]}
  - {type: revolute, a: 0.0203, alpha: -90, d: 0.15005, theta: 0, limits: [-225, 45]}
  - {type: revolute, a: 0, alpha: 90, d: 0.4318, theta: 0, limits: [-110, 170]}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0, limits: [-100, 100]}
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0, limits: [-266, 266]}
base: {xyz: [-0.036, -0.075, -0.346], rpy: [54.4, 34.1, -134.6]}
tool: {xyz: [0.249, -0.05, 0.068], rpy: [9, -66.1, -32.5]}
" };
            abb_irb2400_mounted AbbIrb2400Mounted 6 inverse { yaml = "
name: abb_irb2400_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: revolute, a: 0.1, alpha: -90, d: 0.615, theta: 0}
  - {type: revolute, a: 0.705, alpha: 0, d: 0, theta: -90}
  - {type: revolute, a: 0.135, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0.755, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: 0.085, theta: 180}
base: {xyz: [0.48, 0.557, -0.002], rpy: [134.9, -82.4, -163.1]}
tool: {xyz: [-0.092, 0.231, 0.158], rpy: [-60.8, -14.3, -51.7]}
" };
            abb_irb120_mounted AbbIrb120Mounted 6 inverse { yaml = "
name: abb_irb120_mounted
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 290, theta: 0, limits: [-165, 165]}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: -90, limits: [-110, 110]}
  - {type: revolute, a: 270, alpha: 0, d: 0, theta: 0, limits: [-90, 70]}
  - {type: revolute, a: 70, alpha: -90, d: 302, theta: 0, limits: [-160, 160]}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0, limits: [-120, 120]}
  - {type: revolute, a: 0, alpha: -90, d: 72, theta: 180, limits: [-400, 400]}
base: {xyz: [502.174, -431.096, 438.647], rpy: [150.8, -57.2, 107.8]}
tool: {xyz: [189.222, -231.626, 151.083], rpy: [-17.3, 61.2, -90.2]}
" };
            spherical_shoulder_6r_mounted SphericalShoulder6rMounted 6 inverse { yaml = "
name: spherical_shoulder_6r_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0.3, theta: 0}
  - {type: revolute, a: 0.25, alpha: 0, d: 0.04, theta: 0}
  - {type: revolute, a: 0.05, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: 0.03, alpha: 0, d: 0.1, theta: 0}
base: {xyz: [0.006, 0.538, 0.538], rpy: [156, 35.9, -62.7]}
tool: {xyz: [-0.087, 0.216, 0.247], rpy: [117.7, 46.5, -39.3]}
" };
            gen3r_sphwrist_mounted Gen3rSphwristMounted 6 inverse { yaml = "
name: gen3r_sphwrist_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: revolute, a: 0.3, alpha: 70, d: 0.4, theta: 0}
  - {type: revolute, a: 0.4, alpha: 55, d: 0.15, theta: 0}
  - {type: revolute, a: 0.25, alpha: -60, d: 0.1, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0.35, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: 0.1, theta: 0}
base: {xyz: [-0.38, 0.128, -0.517], rpy: [-161.5, 12, -126.1]}
tool: {xyz: [-0.055, -0.196, -0.238], rpy: [-166.7, -34.9, 155.7]}
" };
            stanford_mounted StanfordMounted 6 inverse { yaml = "
name: stanford_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: revolute, a: 0, alpha: -90, d: 0.412, theta: 0, limits: [-170, 170]}
  - {type: revolute, a: 0, alpha: 90, d: 0.154, theta: 0, limits: [-170, 170]}
  - {type: prismatic, a: 0.0203, alpha: 0, d: 0, theta: -90, limits: [0.3048, 1.27]}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0, limits: [-170, 170]}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0, limits: [-90, 90]}
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0, limits: [-170, 170]}
base: {xyz: [0.249, 0.257, 0.103], rpy: [5.2, -67.5, -174.5]}
tool: {xyz: [0.073, -0.152, -0.168], rpy: [37.7, -80.6, -159.4]}
" };
            staubli_tx40_mounted StaubliTx40Mounted 6 inverse { yaml = "
name: staubli_tx40_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: revolute, a: 0, alpha: -90, d: 0.32, theta: 0}
  - {type: revolute, a: 0.225, alpha: 0, d: 0.035, theta: -90}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0.225, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: 0.065, theta: 180}
base: {xyz: [0.476, 0.27, 0.409], rpy: [150.4, -80.4, 28.7]}
tool: {xyz: [0.181, -0.054, 0.169], rpy: [81.2, 61.8, 140.8]}
" };
            techman_tm5_700_mounted TechmanTm5700Mounted 6 inverse { yaml = "
name: techman_tm5_700_mounted
convention: standard
units: {length: mm, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: revolute, a: 0, alpha: -90, d: 145.1, theta: 0}
  - {type: revolute, a: 329, alpha: 0, d: 0, theta: -90}
  - {type: revolute, a: 311.5, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: -122.2, theta: 90}
  - {type: revolute, a: 0, alpha: 90, d: 106, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: 114.4, theta: 0}
base: {xyz: [430.365, -153.175, -331.188], rpy: [163.8, 6, -10.2]}
tool: {xyz: [-213.547, 236.167, 42.352], rpy: [72.8, -31.9, -139.3]}
" };
            franka_panda_mounted FrankaPandaMounted 7 forward { yaml = "
name: franka_panda_mounted
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q7}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 0.333, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0, limits: [-101, 101]}
  - {type: revolute, a: 0, alpha: 90, d: 0.316, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0.0825, alpha: 90, d: 0, theta: 0, limits: [-176, -4]}
  - {type: revolute, a: -0.0825, alpha: -90, d: 0.384, theta: 0, limits: [-166, 166]}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0, limits: [-1, 215]}
  - {type: revolute, a: 0.088, alpha: 90, d: 0.107, theta: 0, limits: [-166, 166]}
  - {type: fixed, a: 0, alpha: 0, d: 0.103, theta: -45}
base: {xyz: [0.19, -0.484, -0.573], rpy: [-172.8, 82.6, -29.9]}
tool: {xyz: [0.15, 0.176, -0.16], rpy: [-78.1, -72.1, 16]}
" };
            scara_rrrp_325_275_mounted ScaraRrrp325275Mounted 4 forward { yaml = "
name: scara_rrrp_325_275_mounted
convention: standard
units: {length: mm, angle: deg}
inverse: {task: pose}
joints:
  - {type: revolute, a: 325, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 275, alpha: 0, d: -50, theta: 0}
  - {type: revolute, a: 0, alpha: 180, d: 0, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: 0, limits: [0, 200]}
base: {xyz: [-333.277, -109.709, -469.039], rpy: [-161.4, 30.1, -148.7]}
tool: {xyz: [-98.71, -26.106, -54.116], rpy: [-111.8, -10.3, -120.5]}
" };
            jupiter_mounted JupiterMounted 4 forward { yaml = "
name: jupiter_mounted
convention: modified
units: {length: cm, angle: deg}
inverse: {task: position_angle}
joints:
  - {type: revolute, a: 0, alpha: 0, d: 4, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 10, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 10, alpha: 0, d: 0, theta: 0}
  - {type: fixed, a: 0, alpha: 0, d: 0, theta: 0}
base: {xyz: [12.155, -36.1, -5.235], rpy: [-124, 82.9, 56.9]}
tool: {xyz: [-7.951, 16.757, -9.242], rpy: [13.3, 28.8, -14.1]}
" };
            planar3r_mounted Planar3rMounted 3 forward { yaml = "
name: planar3r_mounted
convention: standard
units: {length: cm, angle: deg}
inverse: {task: planar_pose}
joints:
  - {type: revolute, a: 20, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 10, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 7, alpha: 0, d: 0, theta: 0}
base: {xyz: [28.98, 35.021, -23.084], rpy: [16.2, -80.6, -101]}
tool: {xyz: [6.882, 6.028, -8.802], rpy: [-161.6, -54.3, -60.6]}
" };
        }
    };
}
