//! A planted panic: this must not link.

#![no_std]
#![no_main]

use core::hint::black_box;

firmware_board::no_panic!();

#[firmware_board::entry]
fn main() -> ! {
    // Hidden from the compiler, which would else prove the index right and drop the panic.
    let (list, index): ([f32; 3], usize) = black_box(([1.0, 2.0, 3.0], 2));
    black_box(list[index]);
    loop {
        core::hint::spin_loop();
    }
}
