//! The square root instruction of processors with a floating-point unit.
//!
//! The root of `core` is not stable, and that of `std` is not there on a microcontroller. Both functions return `None`
//! on a processor that is not known to have the instruction. That choice is made when the crate is compiled, so that a
//! `match` on the result costs nothing.
//!
//! | processor | single | double |
//! |---|---|---|
//! | ARM with the ABI `eabihf`, such as `thumbv7em-none-eabihf` | `vsqrt.f32` | `None`: the unit may be of single precision |
//! | AArch64 | `fsqrt` | `fsqrt` |
//! | RISC-V with the extensions F, D | `fsqrt.s` | `fsqrt.d` |
//!
//! # Safety
//! Each block of assembly is one root, from a register to a register. On ARM the block also has the moves between a
//! core register and one of the unit. A block accesses no memory and no stack, and does not jump. It exists only where
//! the compilation target guarantees the instruction. The ABI `eabihf` passes floats in registers of the unit, and
//! VSQRT belongs to every version of that unit from VFPv2 on.
//! The instruction sets flags of the floating-point status (inexact, invalid), which the compiler is not told to be
//! preserved.
//!
//! # Rounding
//! IEEE 754 asks for the nearest float, halves to even, in the processor's rounding mode, which Rust leaves at that. So
//! the bits are those of every other correctly rounded root. Less than zero gives not a number, of any bits.

#![no_std]

/// The square root of `x`, correctly rounded, where the processor has the instruction.
#[inline(always)]
#[must_use]
pub fn single(x: f32) -> Option<f32> {
    #[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
    {
        let mut bits = x.to_bits();
        // By a core register, since operands in the unit's registers need a feature that the compiler does not know of
        // units of single precision.
        // SAFETY: see the head of the crate; s0 is given as overwritten.
        unsafe {
            core::arch::asm!(
                "vmov s0, {bits}",
                "vsqrt.f32 s0, s0",
                "vmov {bits}, s0",
                bits = inout(reg) bits,
                out("s0") _,
                options(pure, nomem, nostack)
            );
        }
        Some(f32::from_bits(bits))
    }
    #[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
    {
        let root;
        // SAFETY: see the head of the crate.
        unsafe {
            core::arch::asm!("fsqrt {root:s}, {x:s}", x = in(vreg) x, root = lateout(vreg) root, options(pure, nomem, nostack));
        }
        Some(root)
    }
    #[cfg(all(any(target_arch = "riscv32", target_arch = "riscv64"), target_feature = "f"))]
    {
        let root;
        // SAFETY: see the head of the crate.
        unsafe {
            core::arch::asm!("fsqrt.s {root}, {x}", x = in(freg) x, root = lateout(freg) root, options(pure, nomem, nostack));
        }
        Some(root)
    }
    #[cfg(not(any(
        all(target_arch = "arm", target_abi = "eabihf"),
        all(target_arch = "aarch64", target_feature = "neon"),
        all(any(target_arch = "riscv32", target_arch = "riscv64"), target_feature = "f"),
    )))]
    {
        let _ = x;
        None
    }
}

/// As [`single`], in double precision.
#[inline(always)]
#[must_use]
pub fn double(x: f64) -> Option<f64> {
    #[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
    {
        let root;
        // SAFETY: see the head of the crate.
        unsafe {
            core::arch::asm!("fsqrt {root:d}, {x:d}", x = in(vreg) x, root = lateout(vreg) root, options(pure, nomem, nostack));
        }
        Some(root)
    }
    #[cfg(all(any(target_arch = "riscv32", target_arch = "riscv64"), target_feature = "d"))]
    {
        let root;
        // SAFETY: see the head of the crate.
        unsafe {
            core::arch::asm!("fsqrt.d {root}, {x}", x = in(freg) x, root = lateout(freg) root, options(pure, nomem, nostack));
        }
        Some(root)
    }
    #[cfg(not(any(
        all(target_arch = "aarch64", target_feature = "neon"),
        all(any(target_arch = "riscv32", target_arch = "riscv64"), target_feature = "d"),
    )))]
    {
        let _ = x;
        None
    }
}

// Elsewhere there is nothing to compare. `firmware/check.sh` compares the bits of programs on a Cortex-M4F.
#[cfg(all(test, any(target_arch = "aarch64", target_arch = "riscv64")))]
mod tests {
    extern crate std;

    use super::*;

    #[test]
    fn roots_are_those_of_the_standard_library() {
        let mut bits = 1_u64;
        for _ in 0..100_000 {
            bits = bits.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
            let (x, y) = (f32::from_bits((bits >> 32) as u32), f64::from_bits(bits));
            let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
            assert!(single(x).is_some_and(|root| same(root.into(), x.sqrt().into())), "{x}");
            assert!(double(y).is_some_and(|root| same(root, y.sqrt())), "{y}");
        }
    }
}
