//! Lines on which a function over a grid changes its sign.

use std::collections::BTreeMap;

use crate::vector::{Flat, add, moved, scaled, sub};

/// An edge of the grid: column, row, and whether it leads to the next row.
type Edge = (usize, usize, bool);

/// The lines on which `field` changes its sign, in units of the grid; closed ones end where they begin. Values that are not
/// finite have no line.
pub fn contours(columns: usize, rows: usize, field: &dyn Fn(usize, usize) -> f64) -> Vec<Vec<Flat>> {
    let mut links: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
    for row in 0..rows.saturating_sub(1) {
        for column in 0..columns.saturating_sub(1) {
            let corners = [(column, row), (column + 1, row), (column + 1, row + 1), (column, row + 1)];
            let [a, b, c, d] = corners.map(|(column, row)| field(column, row));
            if ![a, b, c, d].iter().all(|value| value.is_finite()) {
                continue;
            }
            let [a, b, c, d] = [a, b, c, d].map(|value| value > 0.0);
            let (bottom, right) = ((column, row, false), (column + 1, row, true));
            let (top, left) = ((column, row + 1, false), (column, row, true));
            let mut crossed = Vec::new();
            for (edge, differs) in [(bottom, a != b), (right, b != c), (top, c != d), (left, d != a)] {
                if differs {
                    crossed.push(edge);
                }
            }
            // Two lines cross a cell whose corners alternate: they go around the corners of one sign.
            if let [e1, e2, e3, e4] = crossed.as_slice() {
                let pairs = if a { [(*e4, *e1), (*e2, *e3)] } else { [(*e1, *e2), (*e3, *e4)] };
                for (from, to) in pairs {
                    links.entry(from).or_default().push(to);
                    links.entry(to).or_default().push(from);
                }
            } else if let [from, to] = crossed.as_slice() {
                links.entry(*from).or_default().push(*to);
                links.entry(*to).or_default().push(*from);
            }
        }
    }
    let place = |(column, row, upward): Edge| -> Flat {
        let (next, at) = if upward { ((column, row + 1), [0.0, 1.0]) } else { ((column + 1, row), [1.0, 0.0]) };
        let (here, there) = (field(column, row), field(next.0, next.1));
        let part = if here == there { 0.5 } else { (here / (here - there)).clamp(0.0, 1.0) };
        moved([column as f64, row as f64], at, part)
    };
    let mut lines = Vec::new();
    // Open lines first, from their ends.
    let ends: Vec<Edge> = links.iter().filter(|(_, next)| next.len() == 1).map(|(edge, _)| *edge).collect();
    let all: Vec<Edge> = links.keys().copied().collect();
    for start in ends.into_iter().chain(all) {
        let mut line = Vec::new();
        let mut at = start;
        loop {
            line.push(place(at));
            let Some(next) = links.get_mut(&at).and_then(Vec::pop) else { break };
            if let Some(back) = links.get_mut(&next) {
                back.retain(|edge| *edge != at);
            }
            at = next;
        }
        if line.len() > 1 {
            lines.push(line);
        }
    }
    lines
}

/// A closed line without the stairs of its raster: each point goes to the middle of its neighbors, a few times.
pub fn smoothed(line: &[Flat]) -> Vec<Flat> {
    let mut line = line.to_vec();
    for _ in 0..6 {
        let before: Vec<Flat> = line.clone();
        // The last point of a closed line is the first one.
        let count = before.len().saturating_sub(1);
        for (index, point) in line.iter_mut().enumerate() {
            let neighbor = |step: usize| before.get((index + step) % count.max(1)).copied().unwrap_or(*point);
            let middle = scaled(add(neighbor(1), neighbor(count.saturating_sub(1))), 0.5);
            *point = moved(*point, sub(middle, *point), 0.5);
        }
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::length;

    #[test]
    fn a_circle_is_one_closed_line() {
        let field = |column: usize, row: usize| length([column as f64 - 10.0, row as f64 - 10.0]) - 6.3;
        let lines = contours(21, 21, &field);
        assert_eq!(lines.len(), 1);
        assert_eq!(lines[0].first(), lines[0].last());
        assert!(lines[0].iter().all(|[x, y]| (length([x - 10.0, y - 10.0]) - 6.3).abs() < 0.05));
        assert!(smoothed(&lines[0]).iter().all(|[x, y]| (length([x - 10.0, y - 10.0]) - 6.3).abs() < 0.2));
    }

    #[test]
    fn a_straight_line_ends_at_the_edges() {
        let lines = contours(5, 4, &|column, _| column as f64 - 1.25);
        assert_eq!(lines, [vec![[1.25, 0.0], [1.25, 1.0], [1.25, 2.0], [1.25, 3.0]]]);
        assert!(contours(5, 4, &|_, _| f64::NAN).is_empty());
    }
}
