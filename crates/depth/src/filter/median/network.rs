//! Comparator networks, lane by lane. The median networks take sorted columns and were found by a search: they sort
//! each row, then the values that can still be the median, without the comparators that are not needed. Testing all
//! inputs of zeros and ones proves them correct (Knuth, *The Art of Computer Programming* 5.3.4).

use super::{LANES, Pixel};

/// Neighbouring pixels of a row.
pub(crate) type Lanes<P, const N: usize = LANES> = [P; N];

/// Sorts two values in every lane. The loop over the lanes contains one pair only: the compiler does not vectorize a
/// loop over lanes with many pairs in it.
#[inline(always)]
fn order<P: Pixel, const N: usize>(places: &mut [Lanes<P, N>], [low, high]: [usize; 2]) {
    let (a, b) = (places[low], places[high]);
    for lane in 0..N {
        places[low][lane] = a[lane].min(b[lane]);
        places[high][lane] = a[lane].max(b[lane]);
    }
}

/// Sorts pairs of values, one pair after the other.
macro_rules! order {
    ($places:expr; $($low:literal $high:literal),*) => {$(
        order(&mut $places, [$low, $high]);
    )*};
}

/// The networks of K×K pixels. They are trait functions because functions passed as values are not compiled for the
/// instruction set of the calling function.
pub(crate) trait Network<const K: usize> {
    /// Sorts a column.
    fn sort<P: Pixel, const N: usize>(column: &mut [Lanes<P, N>; K]);

    /// The median of sorted columns.
    fn median<P: Pixel, const N: usize>(square: [[Lanes<P, N>; K]; K]) -> Lanes<P, N>;
}

pub(crate) struct Networks;

impl Network<3> for Networks {
    #[inline(always)]
    fn sort<P: Pixel, const N: usize>(column: &mut [Lanes<P, N>; 3]) {
        order!(*column; 0 2, 0 1, 1 2);
    }

    /// The median of three sorted columns is the median of the largest of their smallest values, the median of their middle
    /// values and the smallest of their largest values.
    #[inline(always)]
    fn median<P: Pixel, const N: usize>(mut square: [[Lanes<P, N>; 3]; 3]) -> Lanes<P, N> {
        let square = square.as_flattened_mut();
        order!(*square;
            0 1, 1 2, 3 5, 3 4, 4 5, 6 7, 6 8, 2 6, 2 4, 4 6);
        square[4]
    }
}

impl Network<5> for Networks {
    #[inline(always)]
    fn sort<P: Pixel, const N: usize>(column: &mut [Lanes<P, N>; 5]) {
        order!(*column; 0 3, 1 4, 0 2, 1 3, 0 1, 2 4, 1 2, 3 4, 2 3);
    }

    #[inline(always)]
    fn median<P: Pixel, const N: usize>(mut square: [[Lanes<P, N>; 5]; 5]) -> Lanes<P, N> {
        let square = square.as_flattened_mut();
        order!(*square;
            0 3, 1 4, 0 2, 1 3, 2 4, 3 4, 2 3, 5 8, 6 9, 6 8, 5 6, 7 9, 6 7, 8 9, 7 8, 10 13, 11 14, 10 12, 11 13,
            10 11, 12 14, 11 12, 13 14, 12 13, 15 18, 16 19, 15 17, 16 18, 15 16, 17 19, 16 17, 17 18, 20 23,
            21 24, 20 22, 21 23, 20 21, 22 24, 21 22, 3 16, 11 8, 15 4, 7 20, 12 16, 12 4, 8 20, 16 21, 13 9, 4 17,
            15 12, 4 16, 20 13, 12 8, 4 20, 8 16, 8 4);
        square[4]
    }
}

impl Network<7> for Networks {
    #[inline(always)]
    fn sort<P: Pixel, const N: usize>(column: &mut [Lanes<P, N>; 7]) {
        order!(*column; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2, 3 4, 5 6);
    }

    /// Sorts rows first, then values of the whole square.
    #[inline(always)]
    fn median<P: Pixel, const N: usize>(mut square: [[Lanes<P, N>; 7]; 7]) -> Lanes<P, N> {
        order!(square[0]; 0 6, 2 3, 0 2, 1 4, 3 6, 2 5, 1 2, 4 6, 2 3, 4 5, 3 4, 5 6);
        order!(square[1]; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 3 4, 5 6);
        order!(square[2]; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2, 3 4, 5 6);
        order!(square[3]; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2, 3 4, 5 6);
        order!(square[4]; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2);
        order!(square[5]; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 4 6, 2 3, 4 5, 1 2, 3 4);
        order!(square[6]; 0 6, 2 3, 4 5, 0 2, 1 4, 3 6, 0 1, 2 5, 3 4, 1 2, 2 3, 1 2);
        let square = square.as_flattened_mut();
        order!(*square;
            10 30, 4 31, 5 25, 29 13, 17 43, 35 20, 11 38, 12 44, 22 35, 4 23, 16 6, 28 12, 5 24, 29 18, 17 42,
            36 20, 31 26, 19 32, 11 30, 6 19, 12 37, 35 12, 23 18, 6 42, 30 25, 31 13, 19 43, 5 30, 5 11, 29 23,
            12 36, 24 30, 18 31, 42 19, 35 23, 11 6, 12 18, 24 42, 36 31, 30 19, 17 24, 23 36, 6 30, 18 37, 42 25,
            23 12, 6 24, 18 36, 42 30, 23 6, 12 24, 18 42, 36 30, 17 18, 6 18, 24 36, 24 18);
        square[18]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks the median of all combinations of K sorted columns of zeros and ones.
    fn is_right<const K: usize>()
    where
        Networks: Network<K>,
    {
        let power = |n: usize| (K + 1).pow(u32::try_from(n).unwrap());
        for first in (0..power(K)).step_by(LANES) {
            let ones = |l: usize, c: usize| (first + l) / power(c) % (K + 1);
            let square: [[Lanes<u8>; K]; K] = std::array::from_fn(|row| {
                std::array::from_fn(|c| std::array::from_fn(|l| u8::from(row >= K - ones(l, c))))
            });
            let wanted =
                std::array::from_fn(|l| u8::from((0..K).map(|c| ones(l, c)).sum::<usize>() > K * K / 2));
            assert_eq!(Networks::median(square), wanted, "from number {first} on");
        }
    }

    #[test]
    fn networks_find_the_median() {
        is_right::<3>();
        is_right::<5>();
        is_right::<7>();
    }

    fn sorts<const K: usize>()
    where
        Networks: Network<K>,
    {
        for number in 0..1u32 << K {
            let mut column = std::array::from_fn(|i| [u8::try_from(number >> i & 1).unwrap(); LANES]);
            Networks::sort(&mut column);
            assert!(column.is_sorted(), "{number:b}");
            assert_eq!(
                column.iter().filter(|lanes| lanes[0] == 1).count(),
                number.count_ones() as usize
            );
        }
    }

    #[test]
    fn networks_sort_columns() {
        sorts::<3>();
        sorts::<5>();
        sorts::<7>();
    }
}
