//! Memory of C, and what Rust asks of a library without `std`.

use crate::export::arm::Arm;

/// The code that reads and writes the arguments of an arm's functions.
pub fn text(arm: &Arm<'_>) -> String {
    let optional = if arm.has_optional_results() { OPTIONAL } else { "" };
    [MEMORY, optional, PANIC].concat()
}

const MEMORY: &str = r#"
/// The value at `from`; `None` for a pointer that is null or not aligned.
///
/// # Safety
/// Any other pointer is to a `T` that nobody writes during the call.
unsafe fn read<T: Copy>(from: *const T) -> Option<T> {
    if from.is_null() || !from.is_aligned() {
        return None;
    }
    // SAFETY: neither null nor out of line, and to a `T` by the contract of this function. Each `T` here is made of
    // numbers alone, so any bits are one. The value is copied: no reference into the memory of C is made.
    Some(unsafe { from.read() })
}

/// A place of C for a result, neither null nor out of line.
struct Output<T>(*mut T);

impl<T: Copy> Output<T> {
    /// The place at `to`; `None` for a pointer that is null or not aligned.
    ///
    /// # Safety
    /// Any other pointer is to memory for a `T`, with any content. Nobody else reads or writes this memory as long as
    /// the `Output` is used.
    unsafe fn at(to: *mut T) -> Option<Self> {
        (!to.is_null() && to.is_aligned()).then_some(Self(to))
    }

    fn write(self, value: T) {
        // SAFETY: neither null nor out of line, and to memory for a `T` by the contract of `at`. Arguments are copied before,
        // so it may be the memory of one of them.
        unsafe { self.0.write(value) }
    }
}
"#;

const OPTIONAL: &str = r#"
impl<T: Copy> Output<T> {
    /// The place at `to` as of `at`; `Some(None)` for a pointer that is null.
    ///
    /// # Safety
    /// As of `at`.
    unsafe fn unless_null(to: *mut T) -> Option<Option<Self>> {
        // SAFETY: the contract is the same.
        if to.is_null() { Some(None) } else { unsafe { Self::at(to) }.map(Some) }
    }
}
"#;

const PANIC: &str = r#"
/// The generated code does not panic: in optimized builds nothing calls this.
#[cfg(not(feature = "std"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
"#;
