//! The receiver of moves that the control loop has, on the host.
#![allow(clippy::unwrap_used)]

#[path = "../../examples/loop/src/moves.rs"]
mod moves;

use moves::Receiver;

/// Moves of `N` motors that a receiver takes from a text.
fn taken<const N: usize>(text: &str) -> Vec<[i32; N]> {
    let mut receiver = Receiver::new();
    text.bytes().filter_map(|byte| receiver.take(byte)).collect()
}

/// A line with its sum.
fn line(text: &str) -> String {
    let sum = text.bytes().fold(0, |all, byte| all ^ byte);
    format!("{text}*{sum:02X}\n")
}

#[test]
fn the_line_of_the_page_is_taken() {
    let page = include_str!("../../../docs/motors.md");
    let (_, after) = page.split_once("```moves\n").unwrap();
    let (lines, _) = after.split_once("```").unwrap();
    assert_eq!(taken(lines), [[1067, -240, 3550]]);
    assert_eq!(taken(&lines.replace('\n', "\r\n")), [[1067, -240, 3550]]);
}

#[test]
fn counts_are_those_of_i32() {
    let ends = format!("MOVE {} {} 0", i32::MIN, i32::MAX);
    assert_eq!(taken(&line(&ends)), [[i32::MIN, i32::MAX, 0]]);
    assert_eq!(taken(&line("MOVE -0 007")), [[0, 7]]);
    for beyond in ["MOVE 2147483648", "MOVE -2147483649", "MOVE 9999999999", "MOVE 00000000001"] {
        assert_eq!(taken::<1>(&line(beyond)), [] as [[i32; 1]; 0], "{beyond}");
    }
}

#[test]
fn other_lines_are_dropped_and_the_next_one_is_taken() {
    let next = line("MOVE 1 -2");
    let long = format!("MOVE 1 2{}", " 3".repeat(1000));
    for other in [
        "",
        "M",
        "MOVE",
        "MOVE ",
        "MOVE 1",
        "MOVE 1 ",
        "MOVE 1 2 3",
        "MOVE  1 2",
        "MOVE 1 2 ",
        "MOVE 1 +2",
        "MOVE 1 --2",
        "MOVE 1 -",
        "MOVE 1-2",
        "move 1 2",
        "MOVEX 1 2",
        "MOVER 1 2",
        " MOVE 1 2",
        "MOVE 1 2*00",
        "MOVE 1\r 2",
        &long,
    ] {
        let text = line(other) + &next;
        assert_eq!(taken(&text), [[1, -2]], "{other}");
    }
    let right = line("MOVE 1 10");
    for place in 0..right.len() - 1 {
        for byte in 0..=u8::MAX {
            let mut spoiled = right.clone().into_bytes();
            if std::mem::replace(&mut spoiled[place], byte) == byte || byte == b'\n' {
                continue;
            }
            let mut receiver = Receiver::<2>::new();
            let moves: Vec<_> = spoiled.iter().chain(next.as_bytes()).filter_map(|byte| receiver.take(*byte)).collect();
            assert_eq!(moves, [[1, -2]], "{place} {byte}");
        }
    }
    // A sum of one digit, of three, in lower case; a line that a line feed has cut.
    for text in ["MOVE 1 10*5\n", "MOVE 1 10*055\n", "MOVE 1\n 10*55\n", "MOVE 3 -7*4f\n"] {
        assert_eq!(taken::<2>(text), [] as [[i32; 2]; 0], "{text}");
    }
}
