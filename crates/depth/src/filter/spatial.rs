use oaktwin_base::parameter::parameters;
use oaktwin_image::Image;
use oaktwin_simd::{Level, Weight};
use rayon::prelude::*;

use super::Pixel;
use super::kernels::kernels;

parameters! {
    /// `SpatialFilter`: smooths along rows and columns, in both directions, and stops at edges.
    ///
    /// As in `DepthAI`, a hole is 0 to the right and 0 or 1 to the left; the last pixel of a row only starts the way back;
    /// downwards, holes are not edges, so that they mix with values below `delta`.
    pub struct Spatial("spatial filter", platform) {
        /// The weight of the pixel itself; 1 disables smoothing.
        alpha: f32 = 0.5 => ("alpha".range(0.0..=1.0)),
        /// The step that is an edge, in pixel values: along a row if it is larger, along a column also if it is equal.
        /// `DepthAI` keeps 8 bits of it.
        delta: u8 = 3 => ("delta".range(0.0..=255.0)),
        /// Holes along a row are filled up to one pixel less than this, in each direction.
        hole_filling_radius: u8 = 2 => ("radius".alias("holeFillingRadius").unit("px").range(0.0..=255.0)),
        /// The number of iterations.
        num_iterations: u32 = 1 => ("iterations".alias("numIterations").range(0.0..=100.0)),
    }
}

/// The number of rows that are filtered together: along a row, each step waits for the previous one.
const LANES: usize = 32;

/// The number of columns in a unit of work.
const STRIP: usize = 256;

/// The settings of the loops.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settings<P> {
    weight: Weight,
    delta: P,
    radius: P,
}

impl Spatial {
    pub(super) fn run<P: Pixel>(&self, level: Level, image: &mut Image<P>) {
        let settings = Settings {
            weight: Weight::new(self.alpha),
            delta: P::from(self.delta),
            radius: P::from(self.hole_filling_radius),
        };
        let width = image.width() as usize;
        if width == 0 {
            return;
        }
        for _ in 0..self.num_iterations {
            image.pixels_mut().par_chunks_mut(LANES * width).for_each_init(
                || vec![P::default(); LANES * width],
                |tile, rows| run_along(level, &settings, rows, tile),
            );
            strips(image.pixels_mut(), width)
                .into_par_iter()
                .for_each(|mut strip| {
                    for y in 1..strip.len() {
                        if let [above, row] = &mut strip[y - 1..=y] {
                            run_down(level, &settings, above, row);
                        }
                    }
                    for y in (1..strip.len()).rev() {
                        if let [row, below] = &mut strip[y - 1..=y] {
                            run_up(level, &settings, below, row);
                        }
                    }
                });
        }
    }
}

/// The image as groups of columns, each a list of pieces of rows.
fn strips<P>(pixels: &mut [P], width: usize) -> Vec<Vec<&mut [P]>> {
    let height = pixels.len() / width;
    let mut strips: Vec<Vec<&mut [P]>> = (0..width.div_ceil(STRIP))
        .map(|_| Vec::with_capacity(height))
        .collect();
    for row in pixels.chunks_exact_mut(width) {
        for (strip, piece) in strips.iter_mut().zip(row.chunks_mut(STRIP)) {
            strip.push(piece);
        }
    }
    strips
}

/// Filters up to [`LANES`] rows in both directions; `tile` is a buffer of [`LANES`] rows.
#[inline(always)]
pub(super) fn along<P: Pixel>(settings: &Settings<P>, rows: &mut [P], tile: &mut [P]) {
    let width = tile.len() / LANES;
    let (tile, _) = tile.as_chunks_mut::<LANES>();
    for (lane, row) in rows.chunks_exact(width).enumerate() {
        for (column, &pixel) in tile.iter_mut().zip(row) {
            column[lane] = pixel;
        }
    }
    let (zero, one) = (P::default(), P::from(1));
    if let [first, inner @ .., _] = &mut *tile {
        let (mut before, mut filled) = (*first, [zero; LANES]);
        for column in inner {
            step(settings, column, &before, &mut filled, zero, one);
            before = *column;
        }
    }
    if let [inner @ .., last] = &mut *tile {
        let (mut before, mut filled) = (*last, [zero; LANES]);
        for column in inner.iter_mut().rev() {
            step(settings, column, &before, &mut filled, one, zero);
            before = *column;
        }
    }
    for (lane, row) in rows.chunks_exact_mut(width).enumerate() {
        for (column, pixel) in tile.iter().zip(row) {
            *pixel = column[lane];
        }
    }
}

/// Filters one step along the rows. Pixels up to `hole` are holes; differences below `least` have no effect.
#[inline(always)]
fn step<P: Pixel>(
    settings: &Settings<P>,
    column: &mut [P; LANES],
    before: &[P; LANES],
    filled: &mut [P; LANES],
    hole: P,
    least: P,
) {
    let zero = P::default();
    for lane in 0..LANES {
        let (pixel, before, count) = (column[lane], before[lane], filled[lane]);
        let (begun, is_hole) = (before != zero, pixel <= hole);
        let distance = pixel.distance(before);
        let mixed = P::cut(settings.weight.mix_rounded(pixel.into(), before.into()));
        let is_mixed = begun & !is_hole & (distance >= least) & (distance <= settings.delta);
        let longer = count.next();
        let is_filled = begun & is_hole & (longer < settings.radius);
        let counted = if is_hole { longer } else { zero };
        filled[lane] = if begun { counted } else { count };
        let kept = if is_filled { before } else { pixel };
        column[lane] = if is_mixed { mixed } else { kept };
    }
}

/// Filters a row downwards, from the row above.
#[inline(always)]
pub(super) fn down<P: Pixel>(settings: &Settings<P>, above: &[P], row: &mut [P]) {
    for (&above, pixel) in above.iter().zip(row) {
        let mixed = P::cut(settings.weight.mix_rounded((*pixel).into(), above.into()));
        *pixel = if pixel.distance(above) < settings.delta {
            mixed
        } else {
            *pixel
        };
    }
}

/// Filters a row upwards, from the row below.
#[inline(always)]
pub(super) fn up<P: Pixel>(settings: &Settings<P>, below: &[P], row: &mut [P]) {
    let zero = P::default();
    for (&below, pixel) in below.iter().zip(row) {
        let mixed = P::cut(settings.weight.mix_rounded((*pixel).into(), below.into()));
        let is_mixed = (*pixel != zero) & (below != zero) & (pixel.distance(below) < settings.delta);
        *pixel = if is_mixed { mixed } else { *pixel };
    }
}

kernels! {
    /// [`along`]
    fn run_along<'a> = along => (settings: &'a Settings<P>, rows: &'a mut [P], tile: &'a mut [P]);
    /// [`down`]
    fn run_down<'a> = down => (settings: &'a Settings<P>, above: &'a [P], row: &'a mut [P]);
    /// [`up`]
    fn run_up<'a> = up => (settings: &'a Settings<P>, below: &'a [P], row: &'a mut [P]);
}
