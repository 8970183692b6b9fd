//! Complete sets of solutions: see `data/truth.rs`.

use denhart_core::Transform;

use crate::arms;
use crate::support::Arm;

#[path = "../data/truth.rs"]
mod data;

/// Arms of this suite, and what the data call them.
const ARMS: [(&str, &str); 4] = [
    ("jaco", "kinova_jaco"),
    ("crx10", "fanuc_crx10ial"),
    ("xarm6", "ufactory_xarm6"),
    ("gen3_lite", "kinova_gen3_lite"),
];

#[test]
fn complete_sets_are_found() {
    for (name, called) in ARMS {
        let truth = data::TRUTHS.iter().find(|truth| truth.arm == called).unwrap();
        let rotation = truth.pose.map(|[x, y, z, _]| [x, y, z]);
        let translation = truth.pose.map(|[.., p]| p);
        let arm = Arm::of(arms::named(name));
        let found = arm.solve(&Transform { rotation, translation }, &[0.0; 6]);
        assert_eq!(found.list.len(), truth.solutions.len(), "{name}");
        for joints in truth.solutions {
            assert!(found.distance(&arm.chain, joints) < 1e-6, "{name}: {joints:?}");
        }
    }
}
