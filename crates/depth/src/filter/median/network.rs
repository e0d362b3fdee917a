//! Comparator networks, lane by lane. Those for medians begin with columns that are sorted and were found by a search: the
//! sorting of each row, then of those that can still be the median, less every comparator that can be left out. That they
//! are right follows from all inputs of zeros and ones (Knuth, *The Art of Computer Programming* 5.3.4), which are tested.

use super::{LANES, Pixel};

/// Pixels of neighbouring columns.
pub(super) type Lanes<P> = [P; LANES];

/// Puts each pair of places in order.
macro_rules! order {
    ($v:ident: $($a:literal $b:literal),*) => {$(
        ($v[$a], $v[$b]) = ($v[$a].min($v[$b]), $v[$a].max($v[$b]));
    )*};
}

/// Puts each pair of a row in order, in every lane.
macro_rules! order_row {
    ($row:expr, $count:literal; $($pairs:tt)*) => {{
        let (row, ordered) = (&$row, &mut [[P::default(); LANES]; $count]);
        for l in 0..LANES {
            let mut v = [P::default(); $count];
            for i in 0..$count {
                v[i] = row[i][l];
            }
            order!(v: $($pairs)*);
            for i in 0..$count {
                ordered[i][l] = v[i];
            }
        }
        $row = *ordered;
    }};
}

/// Takes some places, numbered row by row, of a square whose rows have so many; puts each pair of what was taken in
/// order; gives one.
macro_rules! select {
    ($square:ident, $of:literal; $($place:literal)*; [$($pairs:tt)*]; $median:literal) => {{
        let mut selected = $square[0][0];
        for l in 0..LANES {
            let mut v = [$($square[$place / $of][$place % $of][l]),*];
            order!(v: $($pairs)*);
            selected[l] = v[$median];
        }
        selected
    }};
}

#[inline(always)]
pub(super) fn sort3<P: Pixel>(column: &mut [Lanes<P>; 3]) {
    order_row!(*column, 3; 0 2, 0 1, 1 2);
}

#[inline(always)]
pub(super) fn sort5<P: Pixel>(column: &mut [Lanes<P>; 5]) {
    order_row!(*column, 5; 0 3, 1 4, 0 2, 1 3, 0 1, 2 4, 1 2, 3 4, 2 3);
}

#[inline(always)]
pub(super) fn sort7<P: Pixel>(column: &mut [Lanes<P>; 7]) {
    order_row!(*column, 7; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2, 3 4, 5 6);
}

/// The median of three sorted columns: that of the largest of their first, the middle of their second and the smallest
/// of their third.
#[inline(always)]
pub(super) fn median3<P: Pixel>(square: [[Lanes<P>; 3]; 3]) -> Lanes<P> {
    select!(square, 3; 0 1 2 3 4 5 6 7 8;
        [0 1, 1 2, 3 5, 3 4, 4 5, 6 7, 6 8, 2 6, 2 4, 4 6]; 4)
}

/// The median of five sorted columns.
#[inline(always)]
pub(super) fn median5<P: Pixel>(square: [[Lanes<P>; 5]; 5]) -> Lanes<P> {
    select!(square, 5; 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24;
        [0 3, 1 4, 0 2, 1 3, 2 4, 3 4, 2 3, 5 8, 6 9, 6 8, 5 6, 7 9, 6 7, 8 9, 7 8, 10 13, 11 14, 10 12,
        11 13, 10 11, 12 14, 11 12, 13 14, 12 13, 15 18, 16 19, 15 17, 16 18, 15 16, 17 19, 16 17, 17 18,
        20 23, 21 24, 20 22, 21 23, 20 21, 22 24, 21 22, 3 16, 11 8, 15 4, 7 20, 12 16, 12 4, 8 20, 16 21,
        13 9, 4 17, 15 12, 4 16, 20 13, 12 8, 4 20, 8 16, 8 4]; 4)
}

/// The median of seven sorted columns. By rows first: more than this at once the compiler does not make lanes of.
#[inline(always)]
pub(super) fn median7<P: Pixel>(mut square: [[Lanes<P>; 7]; 7]) -> Lanes<P> {
    order_row!(square[0], 7; 0 6, 2 3, 0 2, 1 4, 3 6, 2 5, 1 2, 4 6, 2 3, 4 5, 3 4, 5 6);
    order_row!(square[1], 7; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 3 4, 5 6);
    order_row!(square[2], 7; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2, 3 4, 5 6);
    order_row!(square[3], 7; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2, 3 4, 5 6);
    order_row!(square[4], 7; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2);
    order_row!(square[5], 7; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2, 3 4);
    order_row!(square[6], 7; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 2 3, 1 2);
    select!(square, 7;
        4 5 6 10 11 12 13 16 17 18 19 20 22 23 24 25 26 28 29 30 31 32 35 36 37 38 42 43 44;
        [3 19, 0 20, 1 15, 18 6, 8 27, 22 11, 4 25, 5 28, 12 22, 0 13, 7 2, 17 5, 1 14, 18 9, 8 26, 23 11,
        20 16, 10 21, 4 19, 2 10, 5 24, 22 5, 13 9, 2 26, 19 15, 20 6, 10 27, 1 19, 1 4, 18 13, 5 23, 14 19,
        9 20, 26 10, 22 13, 4 2, 5 9, 14 26, 23 20, 19 10, 8 14, 13 23, 2 19, 9 24, 26 15, 13 5, 2 14, 9 23,
        26 19, 13 2, 5 14, 9 26, 23 19, 8 9, 2 9, 14 23, 14 9]; 9)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All columns of zeros and ones that are sorted, and the median of each K of them.
    fn is_right<const K: usize>(median: impl Fn([[Lanes<u8>; K]; K]) -> Lanes<u8>) {
        let power = |n: usize| (K + 1).pow(u32::try_from(n).unwrap());
        for first in (0..power(K)).step_by(LANES) {
            let ones = |l: usize, c: usize| (first + l) / power(c) % (K + 1);
            let square = std::array::from_fn(|row| {
                std::array::from_fn(|c| std::array::from_fn(|l| u8::from(row >= K - ones(l, c))))
            });
            let wanted =
                std::array::from_fn(|l| u8::from((0..K).map(|c| ones(l, c)).sum::<usize>() > K * K / 2));
            assert_eq!(median(square), wanted, "from number {first} on");
        }
    }

    #[test]
    fn networks_find_the_median_of_all_zeros_and_ones() {
        is_right(median3);
        is_right(median5);
        is_right(median7);
    }

    fn sorts<const K: usize>(sort: impl Fn(&mut [Lanes<u8>; K])) {
        for number in 0..1u32 << K {
            let mut column = std::array::from_fn(|i| [u8::try_from(number >> i & 1).unwrap(); LANES]);
            sort(&mut column);
            assert!(column.is_sorted(), "{number:b}");
            assert_eq!(
                column.iter().filter(|lanes| lanes[0] == 1).count(),
                number.count_ones() as usize
            );
        }
    }

    #[test]
    fn columns_are_sorted() {
        sorts(sort3);
        sorts(sort5);
        sorts(sort7);
    }
}
