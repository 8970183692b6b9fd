//! Followers on paths: the rows of the measured table, random splines, targets that jump, and what has to hold in each
//! tick.

pub mod arms;
pub mod path;
pub mod random;
pub mod sight;
pub mod table;
pub mod watch;
