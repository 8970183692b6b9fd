//! The known word a misspelt one was probably meant to be.

/// The nearest of `known` to `found`, if it is near enough to be meant.
pub fn nearest<'a>(found: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let found = found.to_lowercase();
    let known: Vec<&str> = known.into_iter().collect();
    // The beginning of a word stands for the shortest one that begins so: `rev` for `revolute`.
    let begins = |word: &&str| {
        let rest = word.to_lowercase();
        rest.strip_prefix(&found).is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()))
    };
    let begun = known.iter().copied().filter(|_| found.chars().count() >= 3).filter(begins);
    if let Some(word) = begun.min_by_key(|word| word.chars().count()) {
        return Some(word);
    }
    let (distance, word) =
        known.into_iter().map(|word| (distance(&found, &word.to_lowercase()), word)).min_by_key(|pair| pair.0)?;
    let letters = word.chars().count().max(found.chars().count());
    // Another number is another joint, not a slip.
    let number =
        |word: &str| word.strip_prefix('q').is_some_and(|n| !n.is_empty() && n.chars().all(|c| c.is_ascii_digit()));
    if number(word) && number(&found) && word != found {
        return None;
    }
    // One mistake in a short word, two in five letters of a longer one; a word with nothing in common is no advice.
    (distance <= (letters * 2 / 5).max(1) && distance < letters).then_some(word)
}

/// Insertions, deletions, replacements and swaps of neighbors that lead from one word to the other
/// (optimal string alignment distance).
fn distance(from: &str, to: &str) -> usize {
    let from: Vec<char> = from.chars().collect();
    let to: Vec<char> = to.chars().collect();
    let at = |row: &[usize], column: usize| row.get(column).copied().unwrap_or(usize::MAX / 2);
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=to.len()).collect();
    for (i, &a) in from.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, &b) in to.iter().enumerate() {
            let mut cost = (at(&last, j) + usize::from(a != b)).min(at(&last, j + 1) + 1).min(at(&row, j) + 1);
            let swapped = j > 0 && i > 0 && to.get(j - 1) == Some(&a) && from.get(i - 1) == Some(&b);
            if swapped {
                cost = cost.min(at(&before, j - 1) + 1);
            }
            row.push(cost);
        }
        before = std::mem::replace(&mut last, row);
    }
    at(&last, to.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_edits() {
        assert_eq!(distance("alfa", "alpha"), 2);
        assert_eq!(distance("theat", "theta"), 1);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("limit", "limits"), 1);
    }

    #[test]
    fn suggests_only_what_is_near() {
        let row = ["type", "name", "a", "alpha", "d", "theta", "limits"];
        assert_eq!(nearest("alfa", row), Some("alpha"));
        assert_eq!(nearest("limit", row), Some("limits"));
        assert_eq!(nearest("Alpha", row), Some("alpha"));
        assert_eq!(nearest("tehta", row), Some("theta"));
        assert_eq!(nearest("color", row), None);
        assert_eq!(nearest("x", row), None);
        assert_eq!(nearest("A", row), Some("a"));
        assert_eq!(nearest("q7", ["q1", "q2"]), None);
        assert_eq!(nearest("posi", ["pose", "position_axis", "position"]), Some("position"));
        assert_eq!(nearest("rev", ["revolute", "prismatic"]), Some("revolute"));
        assert_eq!(nearest("joint1", ["joint10", "joint11x"]), Some("joint10"));
        assert_eq!(nearest("x", []), None);
    }
}
