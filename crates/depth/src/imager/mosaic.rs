//! Records the mosaic of a colour sensor: each pixel has one channel, and so one random number.

use oaktwin_base::interrupt;
use oaktwin_image::{Image, ImageView};
use oaktwin_simd::{self as simd, Kernel};
use rayon::prelude::*;

use super::blur::Blur;
use super::rows::{ROWS, Response, Rows};

/// The channels of the even and the odd pixels of a row: red and green, then green and blue.
const CHANNELS: [[usize; 2]; 2] = [[0, 1], [1, 2]];

/// Records light, with the constants of each channel. They have the same blur, falloff and random numbers.
pub(super) fn record(planes: &[Image<f32>; 3], channels: &[Rows<'_>; 3]) -> Image<u16> {
    let [red, _, _] = planes;
    let mut out = Image::filled(red.width(), red.height(), 0u16);
    let width = (red.width() as usize).max(1);
    let bands = out.pixels_mut().par_chunks_mut(width * ROWS).enumerate();
    bands.for_each_init(
        || Scratch::new(width, &channels[1].blur),
        |scratch, (band, out)| {
            if interrupt::is_unwanted() {
                return;
            }
            for (out, y) in out.chunks_exact_mut(width).zip(band * ROWS..) {
                let own = CHANNELS[y & 1];
                simd::run(Record {
                    channels: own.map(|channel| &channels[channel]),
                    light: own.map(|channel| (&planes[channel]).into()),
                    y,
                    scratch,
                    out,
                });
            }
        },
    );
    out
}

/// The buffers of a thread.
struct Scratch {
    /// Standard normal numbers; 0 without noise.
    normals: Vec<f32>,
    padded: Vec<f32>,
    blurred: [Vec<f32>; 2],
}

impl Scratch {
    fn new(width: usize, blur: &Blur) -> Self {
        Self {
            normals: vec![0.0; width],
            padded: vec![0.0; width + 2 * blur.reach()],
            blurred: [vec![0.0; width], vec![0.0; width]],
        }
    }
}

/// One row.
struct Record<'a> {
    /// Of the even and the odd pixels.
    channels: [&'a Rows<'a>; 2],
    light: [ImageView<'a, f32>; 2],
    y: usize,
    scratch: &'a mut Scratch,
    out: &'a mut [u16],
}

impl Kernel for Record<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self {
            channels: [even, odd],
            light,
            y,
            scratch,
            out,
        } = self;
        let Scratch {
            normals,
            padded,
            blurred,
        } = scratch;
        let [first, second] = blurred;
        let first = even.blur.shown(light[0], y, padded, first);
        let second = even.blur.shown(light[1], y, padded, second);
        let y = u32::try_from(y).unwrap_or(u32::MAX);
        if even.noise {
            even.random.normals_here(y, normals);
        }
        let falloff = even.falloff;
        let lights = first.iter().zip(second.iter()).zip(normals.iter());
        for ((out, ((first, second), normal)), x) in out.iter_mut().zip(lights).zip(0u32..) {
            let is_even = x & 1 == 0;
            let light = if is_even { *first } else { *second };
            let response = Response::pick(is_even, &even.response, &odd.response);
            *out = response.value(light * falloff.at(x, y), *normal);
        }
    }
}

#[cfg(test)]
mod tests {
    use oaktwin_camera::{ImageSize, Intrinsics};
    use oaktwin_simd::{Level, run_at};

    use super::*;
    use crate::imager::{Bits, Exposure, Imager, Parameters, Recorded};
    use crate::random::{NoiseStage, Stream};

    const SIZE: ImageSize = ImageSize::new(203, 37);

    fn parameters(full_well_e: f64, lens_blur_px: f64) -> Parameters {
        Parameters {
            full_well_e,
            lens_blur_px,
            vignetting: 0.4,
            bits: Bits::Ten,
            ..Parameters::default()
        }
    }

    fn planes() -> [Image<f32>; 3] {
        [3u16, 5, 7].map(|step| {
            let light = (0..203 * 37u16).map(|i| f32::from(i / 7 * step % 801) / 900.0);
            Image::new(203, 37, light.collect()).unwrap()
        })
    }

    /// Each pixel has the value that an image sensor of its channel alone records with the same random numbers.
    #[test]
    fn each_pixel_is_recorded_by_its_channel() {
        let intrinsics = Intrinsics::from_hfov(SIZE, 1.3);
        let random = Stream::new(1, "rgb").plane(NoiseStage::Color, 2, 0);
        let exposure = Exposure { time: 0.8, gain: 1.7 };
        for sigma in [0.0, 0.7] {
            let all = [2000.0, 4000.0, 2500.0].map(|full_well_e| parameters(full_well_e, sigma));
            let rows = (all.each_ref()).map(|own| Rows::new(own, &intrinsics, exposure, &random));
            let mosaic = record(&planes(), &rows);
            let alone = [0, 1, 2].map(|channel| {
                let imager = Imager::new(all[channel]).unwrap();
                match imager.record((&planes()[channel]).into(), &intrinsics, exposure, &random) {
                    Recorded::Ten(image) => image,
                    Recorded::Eight(_) => unreachable!(),
                }
            });
            for y in 0..37 {
                for x in 0..203 {
                    let channel = CHANNELS[(y & 1) as usize][(x & 1) as usize];
                    assert_eq!(mosaic.get(x, y), alone[channel].get(x, y), "{x} {y}");
                }
            }
        }
    }

    #[test]
    fn does_not_depend_on_instructions() {
        let intrinsics = Intrinsics::from_hfov(SIZE, 1.3);
        let random = Stream::new(1, "rgb").plane(NoiseStage::Color, 2, 0);
        let exposure = Exposure { time: 0.8, gain: 1.7 };
        let all = [2000.0, 4000.0].map(|full_well_e| parameters(full_well_e, 0.7));
        let rows = (all.each_ref()).map(|own| Rows::new(own, &intrinsics, exposure, &random));
        let planes = planes();
        let with = |level| {
            let mut out = vec![0u16; 203];
            let record = Record {
                channels: rows.each_ref(),
                light: [(&planes[0]).into(), (&planes[1]).into()],
                y: 8,
                scratch: &mut Scratch::new(203, &rows[0].blur),
                out: &mut out,
            };
            run_at(level, record);
            out
        };
        let baseline = with(Level::BASELINE);
        assert!(Level::available().iter().all(|&level| with(level) == baseline));
        assert!(baseline.iter().any(|&number| number > 100));
    }
}
