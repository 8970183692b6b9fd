//! Arms and targets for denhart, rs-opw-kinematics and ik-geo alike.

pub mod agreement;
pub mod arms;
pub mod elimination;
pub mod k_chain;
pub mod opw;
pub mod product_of_exponentials;
#[path = "../../../tests/src/random.rs"]
pub mod random;
#[path = "../../../tests/src/timing.rs"]
pub mod timing;
