//! Converts light to recorded values, row by row.

use oaktwin_base::interrupt;
use oaktwin_camera::{Intrinsics, Usd};
use oaktwin_image::ImageView;
use oaktwin_simd::{self as simd, Kernel, saturating_trunc};
use rayon::prelude::*;

use super::blur::Blur;
use super::{Exposure, Parameters};
use crate::random::RandomPlane;

/// The number of rows in a unit of work.
pub(super) const ROWS: usize = 16;

/// The type of a recorded value.
pub(super) trait Number: Copy + Default + Send {
    /// Converts a value that is in range.
    fn of(value: i32) -> Self;
}

impl Number for u8 {
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    fn of(value: i32) -> Self {
        value as Self
    }
}

impl Number for u16 {
    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "0 to 1023"
    )]
    fn of(value: i32) -> Self {
        value as Self
    }
}

/// The light falloff from the centre of an image.
#[derive(Clone, Copy, Debug)]
pub(super) struct Falloff {
    /// The weight of cos⁴.
    share: f32,
    per_pixel: [f32; 2],
    centre: [f32; 2],
}

impl Falloff {
    #[expect(clippy::cast_possible_truncation, reason = "a share, in single precision")]
    pub(super) fn new(intrinsics: &Intrinsics, share: f64) -> Self {
        let centre = intrinsics.principal_point::<Usd>();
        Self {
            share: share as f32,
            per_pixel: [(1.0 / intrinsics.fx) as f32, (1.0 / intrinsics.fy) as f32],
            centre: [centre.x as f32, centre.y as f32],
        }
    }

    /// Returns the relative light of a pixel. cos⁴ of the angle from the axis is 1/(1 + x² + y²)² at (x, y) on the
    /// plane z = 1.
    #[inline(always)]
    pub(super) fn at(&self, x: u32, y: u32) -> f32 {
        let [x, y] = [(x, 0), (y, 1)].map(|(place, axis): (u32, usize)| {
            (place.cast_signed() as f32 + 0.5 - self.centre[axis]) * self.per_pixel[axis]
        });
        let t = 1.0 + x * x + y * y;
        1.0 - self.share * (1.0 - 1.0 / (t * t))
    }
}

/// How light becomes values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Response {
    /// The number of electrons of light 1.
    electrons: f32,
    /// The limit of electrons, far above saturation.
    most_electrons: f32,
    read_variance: f32,
    per_electron: f32,
    largest: f32,
}

/// The constants of an image.
pub(super) struct Rows<'a> {
    pub(super) random: &'a RandomPlane,
    pub(super) blur: Blur,
    pub(super) falloff: Falloff,
    pub(super) response: Response,
    pub(super) noise: bool,
}

impl Response {
    /// Returns the recorded value of light, with a standard normal number for its noise.
    #[inline(always)]
    pub(super) fn value<N: Number>(&self, light: f32, normal: f32) -> N {
        let electrons = light * self.electrons;
        let electrons = if electrons > 0.0 { electrons } else { 0.0 };
        let electrons = electrons.min(self.most_electrons);
        let noisy = electrons + (electrons + self.read_variance).sqrt() * normal;
        let number = (noisy * self.per_electron).max(0.0).min(self.largest);
        N::of(saturating_trunc(number + 0.5))
    }

    /// Returns one of two, without a branch.
    #[inline(always)]
    pub(super) fn pick(is_first: bool, first: &Self, second: &Self) -> Self {
        let pick = |first, second| if is_first { first } else { second };
        Self {
            electrons: pick(first.electrons, second.electrons),
            most_electrons: pick(first.most_electrons, second.most_electrons),
            read_variance: pick(first.read_variance, second.read_variance),
            per_electron: pick(first.per_electron, second.per_electron),
            largest: pick(first.largest, second.largest),
        }
    }
}

impl<'a> Rows<'a> {
    #[expect(clippy::cast_possible_truncation, reason = "in single precision")]
    pub(super) fn new(
        parameters: &Parameters,
        intrinsics: &Intrinsics,
        exposure: Exposure,
        random: &'a RandomPlane,
    ) -> Self {
        let full = parameters.full_well_e;
        let largest = f32::from(parameters.bits.max());
        Self {
            random,
            blur: Blur::new(parameters.lens_blur_px),
            falloff: Falloff::new(intrinsics, parameters.vignetting),
            response: Response {
                electrons: (full * exposure.time) as f32,
                most_electrons: (100.0 * full) as f32,
                read_variance: (parameters.read_noise_e * parameters.read_noise_e) as f32,
                per_electron: (f64::from(largest) * exposure.gain / full) as f32,
                largest,
            },
            noise: parameters.noise,
        }
    }

    pub(super) fn record<N: Number>(&self, light: ImageView<'_, f32>, out: &mut [N]) {
        let width = (light.width() as usize).max(1);
        let bands = out.par_chunks_mut(width * ROWS).enumerate();
        bands.for_each_init(
            || Scratch::new(width, &self.blur),
            |scratch, (band, out)| {
                if interrupt::is_unwanted() {
                    return;
                }
                for (out, y) in out.chunks_exact_mut(width).zip(band * ROWS..) {
                    simd::run(Record {
                        rows: self,
                        y,
                        light,
                        scratch,
                        out,
                    });
                }
            },
        );
    }
}

/// The buffers of a thread.
struct Scratch {
    /// Standard normal numbers; 0 without noise.
    normals: Vec<f32>,
    padded: Vec<f32>,
    blurred: Vec<f32>,
}

impl Scratch {
    fn new(width: usize, blur: &Blur) -> Self {
        Self {
            normals: vec![0.0; width],
            padded: vec![0.0; width + 2 * blur.reach()],
            blurred: vec![0.0; width],
        }
    }
}

struct Record<'a, N> {
    rows: &'a Rows<'a>,
    y: usize,
    light: ImageView<'a, f32>,
    scratch: &'a mut Scratch,
    out: &'a mut [N],
}

impl<N: Number> Kernel for Record<'_, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self {
            rows,
            y,
            light,
            scratch,
            out,
        } = self;
        let Scratch {
            normals,
            padded,
            blurred,
        } = scratch;
        let row = rows.blur.shown(light, y, padded, blurred);
        let y = u32::try_from(y).unwrap_or(u32::MAX);
        if rows.noise {
            rows.random.normals_here(y, normals);
        }
        if rows.falloff.share > 0.0 {
            record(rows, row, normals, out, |x| rows.falloff.at(x, y));
        } else {
            record(rows, row, normals, out, |_| 1.0);
        }
    }
}

#[inline(always)]
fn record<N: Number>(
    rows: &Rows<'_>,
    light: &[f32],
    normals: &[f32],
    out: &mut [N],
    falloff: impl Fn(u32) -> f32,
) {
    for (((out, &light), &normal), x) in out.iter_mut().zip(light).zip(normals).zip(0u32..) {
        *out = rows.response.value(light * falloff(x), normal);
    }
}

#[cfg(test)]
mod tests {
    use oaktwin_camera::ImageSize;

    use super::*;
    use crate::random::{NoiseStage, Stream};
    use oaktwin_simd::{Level, run_at};

    #[test]
    fn does_not_depend_on_instructions() {
        let parameters = Parameters {
            vignetting: 0.6,
            lens_blur_px: 0.9,
            ..Parameters::default()
        };
        let intrinsics = Intrinsics::from_hfov(ImageSize::new(1283, 800), 1.3);
        let random = Stream::new(1, "left").plane(NoiseStage::Exposure, 2, 0);
        let exposure = Exposure { time: 2.0, gain: 1.7 };
        let rows = Rows::new(&parameters, &intrinsics, exposure, &random);
        let light: Vec<f32> = (0..9 * 1283i16).map(|i| f32::from(i % 1283) / 1700.0).collect();
        let light = oaktwin_image::Image::new(1283, 9, light).unwrap();
        let with = |level| {
            let mut out = vec![0u16; 1283];
            run_at(
                level,
                Record {
                    rows: &rows,
                    y: 7,
                    light: (&light).into(),
                    scratch: &mut Scratch::new(1283, &rows.blur),
                    out: &mut out,
                },
            );
            out
        };
        let baseline = with(Level::BASELINE);
        assert!(Level::available().iter().all(|&level| with(level) == baseline));
        assert!(baseline.iter().any(|&number| number > 100));
    }
}
