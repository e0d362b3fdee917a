//! Comparator networks. Those for medians begin with columns that are sorted and were found by a search: the sorting of
//! each row, then of those that can still be the median, less every comparator that can be left out. That they are right
//! follows from all inputs of zeros and ones (Knuth, *The Art of Computer Programming* 5.3.4), which are tested.

use super::Pixel;

/// Puts each pair in order. Places are numbered row by row.
macro_rules! order {
    ($of:literal, $v:ident: $($a:literal $b:literal),*) => {$(
        {
            let (a, b) = ($v[$a / $of][$a % $of], $v[$b / $of][$b % $of]);
            $v[$a / $of][$a % $of] = a.min(b);
            $v[$b / $of][$b % $of] = a.max(b);
        }
    )*};
}

#[inline(always)]
pub(super) fn sort3<P: Pixel>(column: &mut [P; 3]) {
    let mut v = [*column];
    order!(3, v: 0 2, 0 1, 1 2);
    *column = v[0];
}

#[inline(always)]
pub(super) fn sort5<P: Pixel>(column: &mut [P; 5]) {
    let mut v = [*column];
    order!(5, v: 0 3, 1 4, 0 2, 1 3, 0 1, 2 4, 1 2, 3 4, 2 3);
    *column = v[0];
}

#[inline(always)]
pub(super) fn sort7<P: Pixel>(column: &mut [P; 7]) {
    let mut v = [*column];
    order!(7, v:
        0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2, 3 4, 5 6);
    *column = v[0];
}

/// The median of three sorted columns: that of the largest of their first, the middle of their second and the smallest
/// of their third.
#[inline(always)]
pub(super) fn median3<P: Pixel>(mut v: [[P; 3]; 3]) -> P {
    order!(3, v: 0 1, 1 2, 3 5, 3 4, 4 5, 6 7, 6 8, 2 6, 2 4, 4 6);
    v[1][1]
}

/// The median of five sorted columns.
#[inline(always)]
pub(super) fn median5<P: Pixel>(mut v: [[P; 5]; 5]) -> P {
    order!(5, v:
        0 3, 1 4, 0 2, 1 3, 2 4, 3 4, 2 3, 5 8, 6 9, 6 8, 5 6, 7 9, 6 7, 8 9, 7 8, 10 13, 11 14, 10 12, 11 13,
        10 11, 12 14, 11 12, 13 14, 12 13, 15 18, 16 19, 15 17, 16 18, 15 16, 17 19, 16 17, 17 18, 20 23, 21 24,
        20 22, 21 23, 20 21, 22 24, 21 22, 3 16, 11 8, 15 4, 7 20, 12 16, 12 4, 8 20, 16 21, 13 9, 4 17, 15 12,
        4 16, 20 13, 12 8, 4 20, 8 16, 8 4);
    v[0][4]
}

/// The median of seven sorted columns.
#[inline(always)]
pub(super) fn median7<P: Pixel>(mut v: [[P; 7]; 7]) -> P {
    order!(7, v:
        0 6, 2 3, 4 5, 0 2, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 3 4, 5 6, 7 13, 9 10, 11 12, 7 9, 8 11, 10 13, 7 8,
        9 12, 10 11, 8 9, 11 13, 9 10, 11 12, 10 11, 12 13, 14 20, 16 17, 18 19, 14 16, 15 18, 17 20, 14 15,
        16 19, 17 18, 15 16, 18 20, 16 17, 18 19, 15 16, 17 18, 19 20, 21 27, 23 24, 25 26, 21 23, 22 25, 24 27,
        21 22, 23 26, 24 25, 22 23, 25 27, 23 24, 25 26, 24 25, 26 27, 28 34, 30 31, 32 33, 28 30, 29 32, 31 34,
        28 29, 30 33, 31 32, 29 30, 32 34, 30 31, 32 33, 29 30, 35 41, 37 38, 39 40, 35 37, 36 39, 38 41, 35 36,
        37 40, 38 39, 36 37, 39 41, 37 38, 39 40, 36 37, 38 39, 42 48, 44 45, 46 47, 42 44, 43 46, 45 48, 42 43,
        44 47, 45 46, 43 44, 44 45, 16 13, 11 37, 29 25, 35 26, 18 38, 22 5, 28 23, 4 35, 10 36, 29 42, 17 6,
        30 20, 24 44, 19 32, 5 30, 36 19, 18 13, 12 37, 42 25, 6 31, 4 29, 5 18, 23 12, 35 42, 36 6, 30 13,
        24 37, 43 25, 19 31, 11 24, 12 44, 11 23, 29 35, 17 36, 18 30, 12 24, 42 43, 6 19, 5 35, 23 36, 18 42,
        12 6, 30 43, 24 19, 29 13, 29 18, 17 12, 35 30, 36 24, 42 13, 35 18, 36 12, 42 30, 6 24, 35 36, 18 12,
        42 6, 30 24, 36 42, 12 30, 12 42);
    v[6][0]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All columns of zeros and ones that are sorted, and the median of each K of them.
    fn is_right<const K: usize>(median: impl Fn([[u8; K]; K]) -> u8) {
        let all = (K + 1).pow(u32::try_from(K).unwrap());
        for number in 0..all {
            let ones: [usize; K] =
                std::array::from_fn(|c| number / (K + 1).pow(u32::try_from(c).unwrap()) % (K + 1));
            let square: [[u8; K]; K] =
                std::array::from_fn(|row| std::array::from_fn(|c| u8::from(row >= K - ones[c])));
            let wanted = u8::from(ones.iter().sum::<usize>() > K * K / 2);
            assert_eq!(median(square), wanted, "{ones:?}");
        }
    }

    #[test]
    fn networks_find_the_median_of_all_zeros_and_ones() {
        is_right(median3);
        is_right(median5);
        is_right(median7);
    }

    #[test]
    fn columns_are_sorted() {
        for number in 0..1u32 << 7 {
            let bit = |i: usize| u8::try_from(number >> i & 1).unwrap();
            let (mut three, mut five, mut seven): ([u8; 3], [u8; 5], [u8; 7]) = (
                std::array::from_fn(bit),
                std::array::from_fn(bit),
                std::array::from_fn(bit),
            );
            sort3(&mut three);
            sort5(&mut five);
            sort7(&mut seven);
            assert!(
                three.is_sorted() && five.is_sorted() && seven.is_sorted(),
                "{number:b}"
            );
        }
    }
}
