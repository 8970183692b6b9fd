//! Solutions in order.

use core::cmp::Ordering;
use core::mem;

use super::Solutions;
use crate::math::Scalar;
use crate::solution::Solution;

impl<T, const N: usize, const M: usize> Solutions<T, N, M> {
    /// Sorts by `compare`, keeping the order of equal solutions.
    ///
    /// Insertion: the list is short, and an inconsistent comparison gives some order, never a panic.
    #[inline]
    pub fn sort_by(&mut self, mut compare: impl FnMut(&Solution<T, N>, &Solution<T, N>) -> Ordering) {
        self.sort_with(&mut [(); M], |(a, ()), (b, ())| compare(a, b) == Ordering::Greater);
    }

    /// Sorts by a number of each solution, which is computed once; the solution may change on the way. Numbers that do
    /// not compare count as equal.
    #[inline]
    pub(crate) fn sort_by_number(&mut self, mut number: impl FnMut(&mut Solution<T, N>) -> T)
    where
        T: Scalar,
    {
        let mut numbers = [T::ZERO; M];
        for (place, solution) in numbers.iter_mut().zip(self.as_mut_slice()) {
            *place = number(solution);
        }
        self.sort_with(&mut numbers, |(_, a), (_, b)| a > b);
    }

    /// Sorts the solutions together with a key of each: `follows` tells whether the first one of two comes after the
    /// second one.
    #[inline]
    fn sort_with<K>(
        &mut self,
        keys: &mut [K; M],
        mut follows: impl FnMut((&Solution<T, N>, &K), (&Solution<T, N>, &K)) -> bool,
    ) {
        let items = self.as_mut_slice();
        for end in 1..=items.len() {
            let (Some(mut items), Some(mut keys)) = (items.get_mut(..end), keys.get_mut(..end)) else { return };
            while let (Some((last, front)), Some((last_key, front_keys))) =
                (items.split_last_mut(), keys.split_last_mut())
            {
                match (front.last_mut(), front_keys.last_mut()) {
                    (Some(before), Some(key)) if follows((before, key), (last, last_key)) => {
                        mem::swap(before, last);
                        mem::swap(key, last_key);
                    }
                    _ => break,
                }
                (items, keys) = (front, front_keys);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flags::Flags;
    use crate::solution::Status;
    use std::vec::Vec;

    fn list(values: &[f64]) -> Solutions<f64, 1, 8> {
        let mut list = Solutions::new(Status::Reachable);
        for q in values {
            assert!(list.push(Solution { q: [*q], flags: Flags::EXACT, ..Solution::EMPTY }));
        }
        list
    }

    fn values<const M: usize>(list: &Solutions<f64, 1, M>) -> Vec<f64> {
        list.iter().map(|solution| solution.q[0]).collect()
    }

    #[test]
    fn sort_is_stable_and_total() {
        let mut some = list(&[3.5, 1.0, 2.0, 3.0, 1.5, 0.0]);
        some.sort_by(|a, b| a.q[0].floor().total_cmp(&b.q[0].floor()));
        assert_eq!(values(&some), [0.0, 1.0, 1.5, 2.0, 3.5, 3.0]);
        some.sort_by(|_, _| Ordering::Greater);
        assert_eq!(some.len(), 6);
        let mut none = list(&[]);
        none.sort_by(|_, _| Ordering::Greater);
        assert!(none.is_empty());
    }

    #[test]
    fn a_number_sorts_as_a_comparison_does() {
        let all = [3.0, -1.0, 2.0, 1.0, -2.0, -3.0, 0.5, 1.0];
        for len in 0..=all.len() {
            let (mut by_number, mut compared) = (list(&all[..len]), list(&all[..len]));
            by_number.sort_by_number(|solution| solution.q[0].abs());
            compared.sort_by(|a, b| a.q[0].abs().total_cmp(&b.q[0].abs()));
            assert_eq!(values(&by_number), values(&compared));
        }
        let mut unknown = list(&[2.0, f64::NAN, 1.0]);
        unknown.sort_by_number(|solution| solution.q[0]);
        assert_eq!(unknown.len(), 3);
    }
}
