/// A set of pixels of an image, one bit each.
#[derive(Debug)]
pub(super) struct Stencil {
    width: u32,
    words_per_row: usize,
    words: Vec<u64>,
    /// The rows that may have pixels: the first, and one after the last.
    rows: [u32; 2],
}

/// The bounding rectangle of a set of pixels, and their number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Extent {
    pub(super) count: u64,
    /// The first and the last column.
    pub(super) x: [u32; 2],
    /// The first and the last row.
    pub(super) y: [u32; 2],
}

impl Extent {
    pub(super) const EMPTY: Self = Self {
        count: 0,
        x: [u32::MAX, 0],
        y: [u32::MAX, 0],
    };

    /// Adds a pixel.
    pub(super) fn add(&mut self, x: u32, y: u32) {
        *self = self.union(Self {
            count: 1,
            x: [x; 2],
            y: [y; 2],
        });
    }

    /// Returns the union of two disjoint sets.
    pub(super) fn union(self, other: Self) -> Self {
        let hull = |a: [u32; 2], b: [u32; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        Self {
            count: self.count + other.count,
            x: hull(self.x, other.x),
            y: hull(self.y, other.y),
        }
    }
}

impl Stencil {
    pub(super) fn new(width: u32, height: u32) -> Self {
        let words_per_row = (width as usize).div_ceil(64);
        Self {
            width,
            words_per_row,
            words: vec![0; words_per_row * height as usize],
            rows: [u32::MAX, 0],
        }
    }

    pub(super) fn has(&self, x: u32, y: u32) -> bool {
        let at = y as usize * self.words_per_row + x as usize / 64;
        self.words.get(at).is_some_and(|word| word >> (x % 64) & 1 == 1)
    }

    /// Adds a pixel; pixels outside the image are ignored.
    pub(super) fn insert(&mut self, x: u32, y: u32) {
        let at = y as usize * self.words_per_row + x as usize / 64;
        if x < self.width
            && let Some(word) = self.words.get_mut(at)
        {
            *word |= 1 << (x % 64);
            self.rows = [self.rows[0].min(y), self.rows[1].max(y + 1)];
        }
    }

    pub(super) fn extent(&self) -> Extent {
        let mut extent = Extent::EMPTY;
        for y in self.rows[0]..self.rows[1] {
            let row = y as usize * self.words_per_row;
            for (word, first) in self.words[row..row + self.words_per_row]
                .iter()
                .zip((0..).step_by(64))
            {
                if *word != 0 {
                    extent = extent.union(Extent {
                        count: u64::from(word.count_ones()),
                        x: [first + word.trailing_zeros(), first + 63 - word.leading_zeros()],
                        y: [y; 2],
                    });
                }
            }
        }
        extent
    }

    /// Returns the pixels, row by row.
    pub(super) fn places(&self) -> impl Iterator<Item = [u32; 2]> {
        (self.rows[0]..self.rows[1]).flat_map(move |y| {
            let row = y as usize * self.words_per_row;
            let words = (0u32..)
                .step_by(64)
                .zip(&self.words[row..row + self.words_per_row]);
            words.flat_map(move |(first, word)| {
                let mut left = *word;
                std::iter::from_fn(move || {
                    let bit = (left != 0).then(|| left.trailing_zeros())?;
                    left &= left - 1;
                    Some([first + bit, y])
                })
            })
        })
    }

    pub(super) fn clear(&mut self) {
        for y in self.rows[0]..self.rows[1] {
            let row = y as usize * self.words_per_row;
            self.words[row..row + self.words_per_row].fill(0);
        }
        self.rows = [u32::MAX, 0];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_bounds_the_inserted_pixels() {
        let mut stencil = Stencil::new(130, 4);
        for (x, y) in [(3, 1), (64, 1), (129, 2), (3, 1), (130, 2), (0, 4)] {
            stencil.insert(x, y);
        }
        assert!(stencil.has(129, 2) && !stencil.has(128, 2));
        let expected = Extent {
            count: 3,
            x: [3, 129],
            y: [1, 2],
        };
        assert_eq!(stencil.extent(), expected);
        let places: Vec<_> = stencil.places().collect();
        assert_eq!(places, [[3, 1], [64, 1], [129, 2]]);
        stencil.clear();
        assert_eq!(stencil.extent(), Extent::EMPTY);
        assert!(!stencil.has(3, 1));
    }
}
