//! Made-up arms with a pose of six joints, by structure. Their files are in `tests/arms/`.

/// Calls `$with!` with every made-up arm of six joints: test name, type, joints, whether it has an inverse, file.
#[macro_export]
macro_rules! made_up_arms {
    ($with:ident) => {
        $with! {
            // Arms of `specs/` on a base that is off and turned, with a tool that is off and turned.
            ur5_mounted Ur5Mounted 6 inverse "arms/mounted/ur5_mounted.yaml";
            puma560_mounted Puma560Mounted 6 inverse "arms/mounted/puma560_mounted.yaml";
            abb_irb2400_mounted AbbIrb2400Mounted 6 inverse "arms/mounted/abb_irb2400_mounted.yaml";
            abb_irb120_mounted AbbIrb120Mounted 6 inverse "arms/mounted/abb_irb120_mounted.yaml";
            spherical_shoulder_6r_mounted SphericalShoulder6rMounted 6 inverse "arms/mounted/spherical_shoulder_6r_mounted.yaml";
            gen3r_sphwrist_mounted Gen3rSphwristMounted 6 inverse "arms/mounted/gen3r_sphwrist_mounted.yaml";
            stanford_mounted StanfordMounted 6 inverse "arms/mounted/stanford_mounted.yaml";
            staubli_tx40_mounted StaubliTx40Mounted 6 inverse "arms/mounted/staubli_tx40_mounted.yaml";
            techman_tm5_700_mounted TechmanTm5700Mounted 6 inverse "arms/mounted/techman_tm5_700_mounted.yaml";
            franka_panda_mounted FrankaPandaMounted 7 task "arms/mounted/franka_panda_mounted.yaml";
            scara_rrrp_325_275_mounted ScaraRrrp325275Mounted 4 task "arms/mounted/scara_rrrp_325_275_mounted.yaml";
            jupiter_mounted JupiterMounted 4 task "arms/mounted/jupiter_mounted.yaml";
            planar3r_mounted Planar3rMounted 3 forward "arms/mounted/planar3r_mounted.yaml";
            // Made-up arms with three consecutive axes that meet in a point.
            meet_123_a Meet123A 6 inverse "arms/meeting/meet_123_a.yaml";
            meet_123_b Meet123B 6 inverse "arms/meeting/meet_123_b.yaml";
            meet_234_a Meet234A 6 inverse "arms/meeting/meet_234_a.yaml";
            meet_234_b Meet234B 6 inverse "arms/meeting/meet_234_b.yaml";
            meet_345_a Meet345A 6 inverse "arms/meeting/meet_345_a.yaml";
            meet_345_b Meet345B 6 inverse "arms/meeting/meet_345_b.yaml";
            meet_456_a Meet456A 6 inverse "arms/meeting/meet_456_a.yaml";
            meet_456_b Meet456B 6 inverse "arms/meeting/meet_456_b.yaml";
            meet_123_square Meet123Square 6 inverse "arms/meeting/meet_123_square.yaml";
            meet_234_square Meet234Square 6 inverse "arms/meeting/meet_234_square.yaml";
            meet_345_square Meet345Square 6 inverse "arms/meeting/meet_345_square.yaml";
            wrist_60_60 Wrist6060 6 inverse "arms/meeting/wrist_60_60.yaml";
            wrist_45_70 Wrist4570 6 inverse "arms/meeting/wrist_45_70.yaml";
            wrist_110_30 Wrist11030 6 inverse "arms/meeting/wrist_110_30.yaml";
            equal_links EqualLinks 6 inverse "arms/meeting/equal_links.yaml";
            equal_links_on_axis EqualLinksOnAxis 6 inverse "arms/meeting/equal_links_on_axis.yaml";
            no_offsets NoOffsets 6 inverse "arms/meeting/no_offsets.yaml";
            odd_zeros OddZeros 6 inverse "arms/meeting/odd_zeros.yaml";
            modified_wrist ModifiedWrist 6 inverse "arms/meeting/modified_wrist.yaml";
            fixed_rows_wrist FixedRowsWrist 6 inverse "arms/meeting/fixed_rows_wrist.yaml";
            inches Inches 6 inverse "arms/meeting/inches.yaml";
            // Made-up arms with three consecutive axes that are parallel.
            parallel_123_a Parallel123A 6 inverse "arms/parallel/parallel_123_a.yaml";
            parallel_123_b Parallel123B 6 inverse "arms/parallel/parallel_123_b.yaml";
            parallel_123_wall Parallel123Wall 6 inverse "arms/parallel/parallel_123_wall.yaml";
            parallel_234_a Parallel234A 6 inverse "arms/parallel/parallel_234_a.yaml";
            parallel_234_b Parallel234B 6 inverse "arms/parallel/parallel_234_b.yaml";
            parallel_345_a Parallel345A 6 inverse "arms/parallel/parallel_345_a.yaml";
            parallel_345_b Parallel345B 6 inverse "arms/parallel/parallel_345_b.yaml";
            parallel_456_a Parallel456A 6 inverse "arms/parallel/parallel_456_a.yaml";
            parallel_456_b Parallel456B 6 inverse "arms/parallel/parallel_456_b.yaml";
            parallel_123_square Parallel123Square 6 inverse "arms/parallel/parallel_123_square.yaml";
            parallel_345_square Parallel345Square 6 inverse "arms/parallel/parallel_345_square.yaml";
            parallel_456_square Parallel456Square 6 inverse "arms/parallel/parallel_456_square.yaml";
            equal_links_parallel EqualLinksParallel 6 inverse "arms/parallel/equal_links_parallel.yaml";
            flipped_234 Flipped234 6 inverse "arms/parallel/flipped_234.yaml";
            flipped_123 Flipped123 6 inverse "arms/parallel/flipped_123.yaml";
            modified_234 Modified234 6 inverse "arms/parallel/modified_234.yaml";
            fixed_rows_parallel FixedRowsParallel 6 inverse "arms/parallel/fixed_rows_parallel.yaml";
            parallel_mm ParallelMm 6 inverse "arms/parallel/parallel_mm.yaml";
            // Made-up arms with prismatic joints beside three axes that meet.
            rrprrr_meet_456 RrprrrMeet456 6 inverse "arms/sliding/rrprrr_meet_456.yaml";
            rprrrr_meet_456 RprrrrMeet456 6 inverse "arms/sliding/rprrrr_meet_456.yaml";
            prrrrr_meet_456 PrrrrrMeet456 6 inverse "arms/sliding/prrrrr_meet_456.yaml";
            pprrrr_meet_456 PprrrrMeet456 6 inverse "arms/sliding/pprrrr_meet_456.yaml";
            prprrr_meet_456 PrprrrMeet456 6 inverse "arms/sliding/prprrr_meet_456.yaml";
            rpprrr_meet_456 RpprrrMeet456 6 inverse "arms/sliding/rpprrr_meet_456.yaml";
            ppprrr_meet_456 PpprrrMeet456 6 inverse "arms/sliding/ppprrr_meet_456.yaml";
            rrrprr_meet_123 RrrprrMeet123 6 inverse "arms/sliding/rrrprr_meet_123.yaml";
            rrrrpr_meet_123 RrrrprMeet123 6 inverse "arms/sliding/rrrrpr_meet_123.yaml";
            rrrrrp_meet_123 RrrrrpMeet123 6 inverse "arms/sliding/rrrrrp_meet_123.yaml";
            rrrppp_meet_123 RrrpppMeet123 6 inverse "arms/sliding/rrrppp_meet_123.yaml";
            prrrrr_meet_234 PrrrrrMeet234 6 inverse "arms/sliding/prrrrr_meet_234.yaml";
            rrrrpr_meet_234 RrrrprMeet234 6 inverse "arms/sliding/rrrrpr_meet_234.yaml";
            rrrrrp_meet_234 RrrrrpMeet234 6 inverse "arms/sliding/rrrrrp_meet_234.yaml";
            rprrrp_meet_345 RprrrpMeet345 6 inverse "arms/sliding/rprrrp_meet_345.yaml";
            gantry_wrist GantryWrist 6 inverse "arms/sliding/gantry_wrist.yaml";
            prrrrr_meet_456_steep PrrrrrMeet456Steep 6 inverse "arms/sliding/prrrrr_meet_456_steep.yaml";
            rrrrrp_meet_123_square RrrrrpMeet123Square 6 inverse "arms/sliding/rrrrrp_meet_123_square.yaml";
            gantry_offset_wrist GantryOffsetWrist 6 inverse "arms/sliding/gantry_offset_wrist.yaml";
            turned_slides TurnedSlides 6 inverse "arms/sliding/turned_slides.yaml";
            slides_on_either_side SlidesOnEitherSide 6 inverse "arms/sliding/slides_on_either_side.yaml";
            rprprp Rprprp 6 inverse "arms/sliding/rprprp.yaml";
            prpprr Prpprr 6 inverse "arms/sliding/prpprr.yaml";
            slide_across_wrist SlideAcrossWrist 6 inverse "arms/sliding/slide_across_wrist.yaml";
            // Made-up arms with a prismatic joint beside three parallel axes.
            prrrrr_parallel_234 PrrrrrParallel234 6 inverse "arms/sliding_parallel/prrrrr_parallel_234.yaml";
            rrrrpr_parallel_234 RrrrprParallel234 6 inverse "arms/sliding_parallel/rrrrpr_parallel_234.yaml";
            rrrrrp_parallel_234 RrrrrpParallel234 6 inverse "arms/sliding_parallel/rrrrrp_parallel_234.yaml";
            rrrprr_parallel_123 RrrprrParallel123 6 inverse "arms/sliding_parallel/rrrprr_parallel_123.yaml";
            rrrrpr_parallel_123 RrrrprParallel123 6 inverse "arms/sliding_parallel/rrrrpr_parallel_123.yaml";
            rrrrrp_parallel_123 RrrrrpParallel123 6 inverse "arms/sliding_parallel/rrrrrp_parallel_123.yaml";
            prrrrr_parallel_456 PrrrrrParallel456 6 inverse "arms/sliding_parallel/prrrrr_parallel_456.yaml";
            rprrrr_parallel_456 RprrrrParallel456 6 inverse "arms/sliding_parallel/rprrrr_parallel_456.yaml";
            rrprrr_parallel_456 RrprrrParallel456 6 inverse "arms/sliding_parallel/rrprrr_parallel_456.yaml";
            prrrrr_parallel_345 PrrrrrParallel345 6 inverse "arms/sliding_parallel/prrrrr_parallel_345.yaml";
            rprrrr_parallel_345 RprrrrParallel345 6 inverse "arms/sliding_parallel/rprrrr_parallel_345.yaml";
            rrrrrp_parallel_345 RrrrrpParallel345 6 inverse "arms/sliding_parallel/rrrrrp_parallel_345.yaml";
            ur_on_a_rail UrOnARail 6 inverse "arms/sliding_parallel/ur_on_a_rail.yaml";
            rrrrrp_parallel_123_square RrrrrpParallel123Square 6 inverse "arms/sliding_parallel/rrrrrp_parallel_123_square.yaml";
            rrrrrp_parallel_234_square RrrrrpParallel234Square 6 inverse "arms/sliding_parallel/rrrrrp_parallel_234_square.yaml";
            rail_to_stretch RailToStretch 6 inverse "arms/sliding_parallel/rail_to_stretch.yaml";
            slide_flip_123 SlideFlip123 6 inverse "arms/sliding_parallel/slide_flip_123.yaml";
            slide_flip_234 SlideFlip234 6 inverse "arms/sliding_parallel/slide_flip_234.yaml";
            slide_flip_456 SlideFlip456 6 inverse "arms/sliding_parallel/slide_flip_456.yaml";
        }
    };
}
