//! Stack, measured by painting it.

use cortex_m::register::msp;

const PAINT: u32 = 0xa5a5_5a5a;
/// Bytes that are painted.
const DEPTH: usize = 1 << 16;

/// Bytes of stack that `work` uses, with the call itself.
#[inline(never)]
pub fn of(work: &mut dyn FnMut()) -> usize {
    let top = msp::read() as usize;
    let bottom = top - DEPTH;
    for place in (bottom..top).step_by(4) {
        // SAFETY: RAM below the stack pointer, which nothing uses: the stack is at the end of RAM, the loop calls
        // nothing, and there are no interrupts.
        unsafe { (place as *mut u32).write_volatile(PAINT) };
    }
    work();
    let mut place = bottom;
    // SAFETY: as above; it was written before.
    while place < top && unsafe { (place as *const u32).read_volatile() } == PAINT {
        place += 4;
    }
    top - place
}
