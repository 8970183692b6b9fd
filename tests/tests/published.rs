//! Five published arms, number by number. What the papers print wrong is asserted as a misprint: the printed value, the
//! true one, and why. `docs/published-arms.md` tells the same for readers.
#![allow(clippy::unwrap_used)]

#[path = "published/agreement.rs"]
mod agreement;
#[path = "published/tables.rs"]
mod tables;

#[path = "published/denso.rs"]
mod denso;
#[path = "published/jupiter.rs"]
mod jupiter;
#[path = "published/newton_raphson.rs"]
mod newton_raphson;
#[path = "published/page.rs"]
mod page;
#[path = "published/planar.rs"]
mod planar;
#[path = "published/salman.rs"]
mod salman;
