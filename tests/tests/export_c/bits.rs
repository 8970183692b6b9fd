//! Text that the program in C prints, made of values of Rust.

use denhart::{Branch, Flags, Pose, Scalar, Solution, Solutions, Status};

/// A number by its bits; one that is none is `nan`, since its bits are nobody's promise.
pub trait Real: Scalar {
    fn bits(self) -> u64;
    fn is_none(self) -> bool;
}

impl Real for f32 {
    fn is_none(self) -> bool {
        self.is_nan()
    }
    fn bits(self) -> u64 {
        self.to_bits().into()
    }
}

impl Real for f64 {
    fn is_none(self) -> bool {
        self.is_nan()
    }
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

pub fn shown<'a, T: Real>(numbers: impl IntoIterator<Item = &'a T>) -> String {
    let one = |x: &T| if x.is_none() { " nan".to_owned() } else { format!(" {:x}", x.bits()) };
    numbers.into_iter().map(one).collect()
}

pub fn pose<T: Real>(pose: &Pose<T>) -> String {
    shown(pose.rotation.iter().flatten().chain(&pose.translation))
}

pub fn solution<T: Real, const N: usize>(one: &Solution<T, N>) -> String {
    let flags = [Flags::EXACT, Flags::BOUNDARY, Flags::FREE, Flags::APPROXIMATE, Flags::OUT_OF_LIMITS];
    let flags: u16 = flags.iter().enumerate().map(|(place, flag)| u16::from(one.flags.contains(*flag)) << place).sum();
    let free: u16 = one.free.iter().map(|joint| 1 << joint).sum();
    let [shoulder, elbow, wrist, root] = parts(one.branch);
    let numbers = shown(one.q.iter().chain([&one.residual.position, &one.residual.orientation]));
    format!("{numbers} {flags} {free} {shoulder} {elbow} {wrist} {root}")
}

pub fn parts(branch: Branch) -> [u8; 4] {
    [
        branch.shoulder().map_or(0, |part| part as u8),
        branch.elbow().map_or(0, |part| part as u8),
        branch.wrist().map_or(0, |part| part as u8),
        branch.root().unwrap_or(0),
    ]
}

pub fn status<T: Real>(status: Status<T>) -> (i32, T) {
    match status {
        Status::Reachable => (0, T::ZERO),
        Status::Unreachable { residual } => (1, residual),
        Status::BadTarget => (2, T::ZERO),
    }
}

pub fn solutions<T: Real, const N: usize, const M: usize>(all: &Solutions<T, N, M>) -> String {
    let (code, gap) = status(all.status());
    let each: String = all.iter().map(solution).collect();
    format!(" | {code} {}{}{each}", all.len(), shown(&[gap, all.deviation()]))
}
