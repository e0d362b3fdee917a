use super::Pixel;
use oaktwin_image::Image;

/// `SpatialFilter`: smooths along rows and columns, both ways, and stops at edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spatial {
    /// `alpha`, 0 to 1: the weight of the pixel itself; 1 smooths nothing.
    pub alpha: f32,
    /// `delta`: the step that is an edge. In pixel values; `DepthAI` keeps 8 bits of it.
    pub delta: u8,
    /// `holeFillingRadius`: holes along a row are filled for one pixel less than this, each way.
    pub hole_filling_radius: u8,
    /// `numIterations`
    pub num_iterations: u32,
}

impl Default for Spatial {
    fn default() -> Self {
        Self {
            alpha: 0.5,
            delta: 3,
            hole_filling_radius: 2,
            num_iterations: 1,
        }
    }
}

impl Spatial {
    /// More iterations are an error.
    pub const MAX_ITERATIONS: u32 = 100;

    pub(super) fn run<P: Pixel>(&self, image: &mut Image<P>) {
        let (width, height) = (image.width() as usize, image.height() as usize);
        for _ in 0..self.num_iterations {
            for row in image.pixels_mut().chunks_exact_mut(width.max(1)) {
                self.along(row);
            }
            let pixels = image.pixels_mut();
            for y in 1..height {
                let (above, row) = pixels[(y - 1) * width..(y + 1) * width].split_at_mut(width);
                for (&mut above, pixel) in above.iter_mut().zip(row) {
                    if self.is_below(above, *pixel) {
                        *pixel = self.mix(*pixel, above);
                    }
                }
            }
            for y in (1..height).rev() {
                let (row, below) = pixels[(y - 1) * width..(y + 1) * width].split_at_mut(width);
                for (pixel, &mut below) in row.iter_mut().zip(below) {
                    let zero = P::default();
                    if *pixel != zero && below != zero && self.is_below(*pixel, below) {
                        *pixel = self.mix(*pixel, below);
                    }
                }
            }
        }
    }

    fn along<P: Pixel>(&self, row: &mut [P]) {
        let (zero, one) = (P::default(), P::cut(1));
        let radius = u32::from(self.hole_filling_radius);
        let (Some(&first), Some(&last)) = (row.first(), row.last()) else {
            return;
        };
        let end = row.len() - 1;
        let (mut before, mut filled) = (first, 0);
        for pixel in row.iter_mut().take(end).skip(1) {
            if before != zero {
                if *pixel != zero {
                    filled = 0;
                    let step = step(*pixel, before);
                    if step >= 1 && step <= i32::from(self.delta) {
                        *pixel = self.mix(*pixel, before);
                    }
                } else if radius > 0 {
                    filled += 1;
                    if filled < radius {
                        *pixel = before;
                    }
                }
            }
            before = *pixel;
        }
        let (mut before, mut filled) = (last, 0);
        for pixel in row[..end].iter_mut().rev() {
            if before != zero {
                // 1 is taken for a hole on the way back.
                if *pixel > one {
                    filled = 0;
                    if step(*pixel, before) <= i32::from(self.delta) {
                        *pixel = self.mix(*pixel, before);
                    }
                } else if radius > 0 {
                    filled += 1;
                    if filled < radius {
                        *pixel = before;
                    }
                }
            }
            before = *pixel;
        }
    }

    fn is_below<P: Pixel>(&self, a: P, b: P) -> bool {
        step(a, b) < i32::from(self.delta)
    }

    #[expect(clippy::cast_possible_truncation, reason = "DepthAI cuts off too")]
    fn mix<P: Pixel>(&self, pixel: P, before: P) -> P {
        let mixed = Into::<f32>::into(pixel) * self.alpha + Into::<f32>::into(before) * (1.0 - self.alpha);
        P::cut((mixed + 0.5) as i32)
    }
}

fn step<P: Pixel>(a: P, b: P) -> i32 {
    (Into::<i32>::into(a) - Into::<i32>::into(b)).abs()
}
