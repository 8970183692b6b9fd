//! Every arm of `specs/`.

/// Calls `$with!` with every arm of `specs/`: test name, type, joints, whether it has an inverse, file.
///
/// `inverse`: six joints, of which three consecutive ones have axes that meet or are parallel. `task`: an inverse for
/// another task than a pose, or with a redundant joint. `held`: an inverse that holds a joint. `forward`: no inverse.
#[macro_export]
macro_rules! published_arms {
    ($with:ident) => {
        $with! {
            abb_irb120 AbbIrb120 6 inverse "../specs/abb_irb120.yaml";
            abb_irb140 AbbIrb140 6 inverse "../specs/abb_irb140.yaml";
            abb_irb2400 AbbIrb2400 6 inverse "../specs/abb_irb2400.yaml";
            abb_irb4600_60 AbbIrb460060 6 inverse "../specs/abb_irb4600_60.yaml";
            al5d Al5d 4 task "../specs/al5d.yaml";
            anthro3r Anthro3r 3 task "../specs/anthro3r.yaml";
            baxter_left BaxterLeft 7 held "../specs/baxter_left.yaml";
            cartesian_ppp CartesianPpp 3 task "../specs/cartesian_ppp.yaml";
            cobra600_rrpr Cobra600Rrpr 4 task "../specs/cobra600_rrpr.yaml";
            cylindrical_rpp CylindricalRpp 3 task "../specs/cylindrical_rpp.yaml";
            denso_vs6556 DensoVs6556 6 inverse "../specs/denso_vs6556.yaml";
            fanuc_crx10ial FanucCrx10ial 6 held "../specs/fanuc_crx10ial.yaml";
            fanuc_lrmate200id FanucLrmate200id 6 inverse "../specs/fanuc_lrmate200id.yaml";
            fanuc_r2000ib_200r FanucR2000ib200r 6 inverse "../specs/fanuc_r2000ib_200r.yaml";
            franka_panda FrankaPanda 7 task "../specs/franka_panda.yaml";
            gen3r_sphwrist Gen3rSphwrist 6 inverse "../specs/gen3r_sphwrist.yaml";
            gen6r_a Gen6rA 6 held "../specs/gen6r_a.yaml";
            igus_rebel IgusRebel 6 inverse "../specs/igus_rebel.yaml";
            jupiter Jupiter 4 task "../specs/jupiter.yaml";
            jupiter_l4_6cm JupiterL46cm 4 task "../specs/jupiter_l4_6cm.yaml";
            kinova_gen3_7dof KinovaGen37dof 7 task "../specs/kinova_gen3_7dof.yaml";
            kinova_gen3_lite KinovaGen3Lite 6 held "../specs/kinova_gen3_lite.yaml";
            kinova_jaco KinovaJaco 6 held "../specs/kinova_jaco.yaml";
            kinova_mico KinovaMico 6 held "../specs/kinova_mico.yaml";
            kuka_iiwa7_r800 KukaIiwa7R800 7 task "../specs/kuka_iiwa7_r800.yaml";
            kuka_kr5_arc KukaKr5Arc 6 inverse "../specs/kuka_kr5_arc.yaml";
            kuka_kr6_r700 KukaKr6R700 6 inverse "../specs/kuka_kr6_r700.yaml";
            kuka_lwr4 KukaLwr4 7 task "../specs/kuka_lwr4.yaml";
            kuka_youbot KukaYoubot 5 task "../specs/kuka_youbot.yaml";
            manseur_doty_16 ManseurDoty16 6 held "../specs/manseur_doty_16.yaml";
            mecademic_meca500 MecademicMeca500 6 inverse "../specs/mecademic_meca500.yaml";
            planar2r Planar2r 2 task "../specs/planar2r.yaml";
            planar2r_unit Planar2rUnit 2 task "../specs/planar2r_unit.yaml";
            planar3r Planar3r 3 task "../specs/planar3r.yaml";
            planar4r_redundant Planar4rRedundant 4 task "../specs/planar4r_redundant.yaml";
            polar_rrp PolarRrp 3 task "../specs/polar_rrp.yaml";
            puma560 Puma560 6 inverse "../specs/puma560.yaml";
            rethink_sawyer RethinkSawyer 7 held "../specs/rethink_sawyer.yaml";
            salman_rrr SalmanRrr 3 task "../specs/salman_rrr.yaml";
            salman_rrr_table1 SalmanRrrTable1 3 task "../specs/salman_rrr_table1.yaml";
            scara_rrrp_325_275 ScaraRrrp325275 4 task "../specs/scara_rrrp_325_275.yaml";
            scorbot_er5 ScorbotEr5 5 task "../specs/scorbot_er5.yaml";
            singular_6r Singular6r 6 forward "../specs/singular_6r.yaml";
            spherical_shoulder_6r SphericalShoulder6r 6 inverse "../specs/spherical_shoulder_6r.yaml";
            stanford Stanford 6 inverse "../specs/stanford.yaml";
            staubli_tx2_160l StaubliTx2160l 6 inverse "../specs/staubli_tx2_160l.yaml";
            staubli_tx40 StaubliTx40 6 inverse "../specs/staubli_tx40.yaml";
            techman_tm5_700 TechmanTm5700 6 inverse "../specs/techman_tm5_700.yaml";
            two_parallel_6r TwoParallel6r 6 held "../specs/two_parallel_6r.yaml";
            ufactory_xarm6 UfactoryXarm6 6 held "../specs/ufactory_xarm6.yaml";
            ufactory_xarm7 UfactoryXarm7 7 held "../specs/ufactory_xarm7.yaml";
            ur10 Ur10 6 inverse "../specs/ur10.yaml";
            ur16e Ur16e 6 inverse "../specs/ur16e.yaml";
            ur3 Ur3 6 inverse "../specs/ur3.yaml";
            ur5 Ur5 6 inverse "../specs/ur5.yaml";
            ur5e Ur5e 6 inverse "../specs/ur5e.yaml";
            yaskawa_sia10d YaskawaSia10d 7 task "../specs/yaskawa_sia10d.yaml";
        }
    };
}
