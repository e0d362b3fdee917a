use super::shares;
use crate::Image;

/// A box filter for pixels in any order: a pixel of the result is the mean of the area that it covers.
pub(super) struct Areas {
    full: (u32, u32),
    reduced: (u32, u32),
    /// The pixels of the result in which each column lies.
    columns: Vec<[(u32, f32); 2]>,
    sums: Vec<[f32; 4]>,
}

/// The bytes per pixel of the result and per column.
pub(super) const BYTES_PER_PIXEL: u64 = size_of::<[f32; 4]>() as u64;
pub(super) const BYTES_PER_COLUMN: u64 = size_of::<[(u32, f32); 2]>() as u64;

impl Areas {
    pub(super) fn new(full: (u32, u32), divisor: u32) -> Self {
        let reduced = (full.0.div_ceil(divisor), full.1.div_ceil(divisor));
        Self {
            full,
            reduced,
            columns: (0..full.0).map(|x| shares(x, full.0, reduced.0)).collect(),
            sums: vec![[0.0; 4]; reduced.0 as usize * reduced.1 as usize],
        }
    }

    /// Adds pixels of row `y`.
    pub(super) fn add(&mut self, y: u32, pixels: impl Iterator<Item = (u32, [f32; 4])>) {
        let width = self.reduced.0 as usize;
        let rows = shares(y, self.full.1, self.reduced.1);
        for (x, values) in pixels {
            let Some(columns) = self.columns.get(x as usize) else {
                continue;
            };
            for (row, down) in rows {
                for (column, across) in columns {
                    let share = down * across;
                    let at = row as usize * width + *column as usize;
                    if let Some(sums) = self.sums.get_mut(at).filter(|_| share > 0.0) {
                        for (sum, value) in sums.iter_mut().zip(values) {
                            *sum += value * share;
                        }
                    }
                }
            }
        }
    }

    /// Returns the means.
    pub(super) fn finish(self) -> Option<Image<[f32; 4]>> {
        Image::new(self.reduced.0, self.reduced.1, self.sums)
    }
}
