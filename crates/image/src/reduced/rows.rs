use super::{Average, shares, values};
use crate::Image;

/// A box filter for rows from the top to the bottom: a pixel of the result is the mean of the area that it covers, with parts of
/// pixels at the edges.
pub(super) struct Rows {
    full: (u32, u32),
    reduced: (u32, u32),
    average: Average,
    /// The values, 0 to 1, of the samples.
    values: [f32; 256],
    /// The next row.
    y: u32,
    /// The sums of a row.
    line: Vec<[f32; 4]>,
    /// The sums of the current row of the result.
    sums: Vec<[f32; 4]>,
    pixels: Vec<[u8; 4]>,
}

impl Rows {
    pub(super) fn new(full: (u32, u32), divisor: u32, average: Average) -> Self {
        let reduced = (full.0.div_ceil(divisor), full.1.div_ceil(divisor));
        Self {
            full,
            reduced,
            average,
            values: average.values(),
            y: 0,
            line: vec![[0.0; 4]; reduced.0 as usize],
            sums: vec![[0.0; 4]; reduced.0 as usize],
            pixels: Vec::with_capacity(reduced.0 as usize * reduced.1 as usize),
        }
    }

    /// Adds the next row: for each pixel `count` samples, grey or colours, with or without alpha.
    pub(super) fn push(&mut self, samples: &[u8], count: usize) {
        self.line.fill([0.0; 4]);
        for (x, pixel) in (0..self.full.0).zip(samples.chunks_exact(count)) {
            let rgba = values(&self.values, pixel);
            for (at, share) in shares(x, self.full.0, self.reduced.0) {
                if let Some(sums) = self.line.get_mut(at as usize).filter(|_| share > 0.0) {
                    for (sum, value) in sums.iter_mut().zip(rgba) {
                        *sum += value * share;
                    }
                }
            }
        }
        let y = self.y;
        self.y += 1;
        let [(at, part), (_, rest)] = shares(y, self.full.1, self.reduced.1);
        self.add(part);
        // The row of the result is complete.
        if rest > 0.0 || shares(y + 1, self.full.1, self.reduced.1)[0].0 > at {
            for sums in &mut self.sums {
                self.pixels.push(self.average.encode(std::mem::take(sums)));
            }
            self.add(rest);
        }
    }

    fn add(&mut self, share: f32) {
        for (sums, values) in self.sums.iter_mut().zip(&self.line) {
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += value * share;
            }
        }
    }

    /// Returns the result; `None` if rows are missing.
    pub(super) fn finish(self) -> Option<Image<[u8; 4]>> {
        Image::new(self.reduced.0, self.reduced.1, self.pixels)
    }
}
