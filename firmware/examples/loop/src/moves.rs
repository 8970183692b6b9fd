//! A receiver of moves: lines of text such as `MOVE 1067 -240 3550*29`, byte by byte, as docs/motors.md has them.

/// The word that a line begins with.
const WORD: &[u8] = b"MOVE";
/// Digits of the longest count, -2147483648.
const MOST_DIGITS: u8 = 10;

/// Reads lines, each of which has a count for each of `N` motors. A line that is not as docs/motors.md has it is dropped.
#[derive(Debug)]
pub struct Receiver<const N: usize> {
    counts: [i32; N],
    sum: u8,
    next: Next,
}

/// Part of a line that the next byte belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Next {
    /// The word, of which so many letters have been read.
    Word(usize),
    /// The count of a motor.
    Count { motor: usize, digits: u8, negative: bool },
    /// The two digits of the sum: their value, and how many have been read.
    Sum(u8, u8),
    /// The line feed.
    End,
    /// A line that is dropped, up to its line feed.
    Dropped,
}

impl<const N: usize> Receiver<N> {
    /// Before the first line.
    pub const fn new() -> Self {
        Self { counts: [0; N], sum: 0, next: Next::Word(0) }
    }

    /// Takes a byte: counts of all motors, in pulses from home, where it ends a line that is right.
    pub fn take(&mut self, byte: u8) -> Option<[i32; N]> {
        if byte == b'\n' {
            let counts = (self.next == Next::End).then_some(self.counts);
            *self = Self::new();
            return counts;
        }
        self.next = self.after(byte).unwrap_or(Next::Dropped);
        if !matches!(self.next, Next::Sum(..) | Next::End) {
            self.sum ^= byte;
        }
        None
    }

    /// The part after a byte, or `None` where no line has it there.
    fn after(&mut self, byte: u8) -> Option<Next> {
        match self.next {
            Next::Word(read) => match WORD.get(read) {
                Some(letter) => (byte == *letter).then_some(Next::Word(read + 1)),
                None => self.count_or_sum(byte, 0),
            },
            Next::Count { motor, digits: 0, negative: false } if byte == b'-' => {
                Some(Next::Count { motor, digits: 0, negative: true })
            }
            Next::Count { digits: MOST_DIGITS.., .. } if byte.is_ascii_digit() => None,
            Next::Count { motor, digits, negative } if byte.is_ascii_digit() => {
                let count = self.counts.get_mut(motor)?;
                let digit = i32::from(byte - b'0');
                let moved = count.checked_mul(10)?;
                *count = if negative { moved.checked_sub(digit)? } else { moved.checked_add(digit)? };
                Some(Next::Count { motor, digits: digits + 1, negative })
            }
            Next::Count { motor, digits: 1.., .. } => self.count_or_sum(byte, motor + 1),
            Next::Sum(high, 0) => Some(Next::Sum(hexadecimal(byte)? << 4 | high, 1)),
            Next::Sum(high, _) => (high | hexadecimal(byte)? == self.sum).then_some(Next::End),
            Next::End => (byte == b'\r').then_some(Next::End),
            Next::Count { .. } | Next::Dropped => None,
        }
    }

    /// After the word or a count: the count of `motor`, or the sum where all motors have theirs.
    const fn count_or_sum(&self, byte: u8, motor: usize) -> Option<Next> {
        match byte {
            b' ' if motor < N => Some(Next::Count { motor, digits: 0, negative: false }),
            b'*' if motor == N => Some(Next::Sum(0, 0)),
            _ => None,
        }
    }
}

/// The value of a hexadecimal digit in upper case.
const fn hexadecimal(byte: u8) -> Option<u8> {
    match byte {
        b'0'..=b'9' => Some(byte - b'0'),
        b'A'..=b'F' => Some(byte - b'A' + 10),
        _ => None,
    }
}
