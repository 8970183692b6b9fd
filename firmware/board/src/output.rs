//! Text to the host by semihosting, and the end of the emulation.

use core::fmt::{self, Write};

use cortex_m_semihosting::{debug, hio};

/// A buffer, since each write stops the processor.
pub struct Output {
    buffer: [u8; 2048],
    len: usize,
}

impl Output {
    /// Empty.
    #[must_use]
    pub const fn new() -> Self {
        Self { buffer: [0; 2048], len: 0 }
    }

    /// Writes what is left. Output that the host refuses is lost; the host finds lines missing.
    pub fn flush(&mut self) {
        if let Ok(mut stream) = hio::hstdout() {
            let _ = stream.write_all(self.buffer.get(..self.len).unwrap_or_default());
        }
        self.len = 0;
    }
}

impl Default for Output {
    fn default() -> Self {
        Self::new()
    }
}

impl Write for Output {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            if self.len == self.buffer.len() {
                self.flush();
            }
            if let Some(place) = self.buffer.get_mut(self.len) {
                *place = byte;
                self.len += 1;
            }
        }
        Ok(())
    }
}

/// Prints one line.
pub fn line(text: fmt::Arguments<'_>) {
    let mut output = Output::new();
    let _ = writeln!(output, "{text}");
    output.flush();
}

/// Ends the emulation; the emulator's exit status is 0 for `success`.
pub fn exit(success: bool) -> ! {
    debug::exit(if success { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
    loop {
        cortex_m::asm::nop();
    }
}
