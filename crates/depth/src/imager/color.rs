//! An image sensor with a Bayer mosaic.

use oaktwin_base::parameter::{Platform, parameters};
use oaktwin_camera::Intrinsics;
use oaktwin_image::Image;
use oaktwin_image::srgb::srgb_from_linear;

use super::demosaic::{self, UNITS};
use super::rows::Rows;
use super::{Bits, Exposure, Imager, Parameters, blur, mosaic};
use crate::ParameterError;
use crate::random::{NoiseStage, Stream};

/// The variance of light over the area of a pixel, px².
const PIXEL_VARIANCE: f64 = 1.0 / 12.0;

/// The share of a Bayer mosaic's photosites that each channel has.
const SHARES: [f64; 3] = [0.25, 0.5, 0.25];

/// The photosites along the side of a pixel from which a sensor has all channels in each pixel.
const WHOLE_MOSAIC: f64 = 2.0;

parameters! {
    /// The image sensor of a colour camera. The defaults describe a back-illuminated rolling sensor such as an IMX378; how large the pixels
    /// are is known for each camera.
    pub struct ColorParameters("color-imager", platform) {
        /// The light, as a multiple of typical light in the scene: 0.01 is a dim room, in which automatic exposure reaches its limits.
        light: f64 = 1.0 => ("light".range(0.0..=1e6).typical(0.001..=10.0).chosen("the scene's own")),
        /// Whether exposure follows the mean of the images.
        auto_exposure: bool = true => ("autoExposure".chosen("a camera's default")),
        /// The mean of linear light that automatic exposure aims at, as a share of the largest value: the middle grey of photography.
        exposure_target: f64 = 0.18 => ("exposureTarget".range(0.001..=0.95).estimate()),
        /// Exposure time times gain without automatic exposure; at 1, white has the largest value.
        exposure: f64 = 0.8 => ("exposure".range(1e-6..=1e6).typical(0.01..=4.0).estimate()),
        /// The longest exposure time, as a multiple of the one at which white has the largest value. A value of 2 corresponds to
        /// 33 ms under office lighting.
        max_exposure_time: f64 = 2.0 => ("maxExposureTime".range(1e-6..=1e6).typical(0.1..=4.0).estimate()),
        /// The largest gain: `DepthAI`'s ISO 1600 over its ISO 100.
        max_gain: f64 = 16.0 => ("maxGain".range(1.0..=1000.0).typical(1.0..=32.0)),
        /// The electrons of the largest value at a gain of 1, for each µm² of a photosite. The default gives the 4800 electrons
        /// that are usual for photosites of 1.55 µm with a rolling shutter.
        well_density_e: f64 = 2000.0 => ("wellDensity".unit("electrons/µm²").range(10.0..=1e6).typical(300.0..=4000.0).estimate()),
        /// The standard deviation of the read noise of a photosite.
        read_noise_e: f64 = 2.0 => ("readNoise".unit("electrons").range(0.0..=1e4).typical(0.0..=20.0).estimate()),
        /// The gain of red in the balance of white: how much more green light than red light a white surface gives.
        red_gain: f64 = 1.9 => ("redGain".range(1.0..=8.0).typical(1.0..=3.0).estimate()),
        /// The gain of blue in the balance of white.
        blue_gain: f64 = 1.6 => ("blueGain".range(1.0..=8.0).typical(1.0..=3.0).estimate()),
        /// Whether noise is added.
        noise: bool = true => ("noise".chosen("a real sensor")),
        /// The standard deviation of the lens's point spread function, in photosites: diffraction at f/1.8 on photosites of 1.55 µm
        /// (0.42 λN) and aberrations of the same size. The photosites' own area adds to it.
        lens_blur_px: f64 = 0.4 => ("lensBlur".unit("px").range(0.0..=8.0).typical(0.0..=3.0).estimate()),
        /// The share of cos⁴ falloff. The rest after a device's own correction is not published.
        vignetting: f64 = 0.0 => ("vignetting".range(0.0..=1.0).estimate()),
    }
}

impl Default for ColorParameters {
    fn default() -> Self {
        Self::defaults(Platform::default())
    }
}

/// What a camera's images are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photosites {
    /// The pitch of the photosites, µm.
    pub pitch_um: f64,
    /// The number of photosites along the side of a pixel; at least 1 is used.
    pub per_pixel: f64,
    /// Whether they have no colour filters, so that images are grey.
    pub is_monochrome: bool,
}

/// How the photosites of a sensor see colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Layout {
    /// One channel in each pixel, and the others from its surroundings.
    Mosaic,
    /// All channels in each pixel.
    Whole,
    /// Luminance.
    Monochrome,
}

/// The shares of red, green and blue in Rec. 709's luminance, as in the images of stereo pairs.
const LUMINANCE: [f32; 3] = [0.2126, 0.7152, 0.0722];

/// The image sensor of a colour camera.
///
/// # Steps
/// 1. **Blur** of the lens and of the pixels' area, as one normal point spread function.
/// 2. **Exposure** as by an [`Imager`].
/// 3. **Noise** of each channel as by an [`Imager`] of 10 bits. Red and blue filters pass less light, which the balance of white makes up for.
/// 4. **Mosaic**: where a pixel is one photosite, it has one channel, red and green or green and blue by turns, and the others come from
///    its surroundings (Malvar, He, Cutler: "High-quality linear interpolation for demosaicing of Bayer-patterned color images", ICASSP
///    2004). Where images are at least twice reduced, each pixel has its own photosites of all channels. Photosites without filters see
///    luminance, with all of their electrons, and images are grey.
/// 5. **Encoding** in sRGB without a tone curve, so that saturated pixels are white.
///
/// Denoising and sharpening, which devices add, are not modelled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorImager {
    channels: [Imager; 3],
    light: f32,
    layout: Layout,
}

impl ColorImager {
    /// Creates the image sensor of a camera.
    ///
    /// # Errors
    /// Returns an error if a parameter is out of range.
    pub fn new(parameters: ColorParameters, photosites: Photosites) -> Result<Self, ParameterError> {
        parameters.check()?;
        let p = parameters;
        let across = photosites.per_pixel.max(1.0);
        let layout = match photosites.is_monochrome {
            true => Layout::Monochrome,
            false if across < WHOLE_MOSAIC => Layout::Mosaic,
            false => Layout::Whole,
        };
        let lens = p.lens_blur_px / across;
        let well = p.well_density_e * photosites.pitch_um * photosites.pitch_um;
        let gains = match layout {
            Layout::Monochrome => [1.0; 3],
            Layout::Mosaic | Layout::Whole => [p.red_gain, 1.0, p.blue_gain],
        };
        let channel = |index: usize| {
            let share = match layout {
                Layout::Whole => SHARES[index],
                Layout::Mosaic | Layout::Monochrome => 1.0,
            };
            let count = across * across * share;
            Imager::new(Parameters {
                auto_exposure: p.auto_exposure,
                exposure_target: p.exposure_target,
                exposure: p.exposure,
                max_exposure_time: p.max_exposure_time,
                max_gain: p.max_gain,
                full_well_e: (count * well / gains[index]).clamp(10.0, 1e7),
                read_noise_e: (count.sqrt() * p.read_noise_e).min(1e4),
                noise: p.noise,
                lens_blur_px: (lens * lens + PIXEL_VARIANCE).sqrt().min(blur::MAX_SIGMA_PX),
                vignetting: p.vignetting,
                bits: Bits::Ten,
            })
        };
        Ok(Self {
            channels: [channel(0)?, channel(1)?, channel(2)?],
            #[expect(clippy::cast_possible_truncation, reason = "light is float32")]
            light: p.light as f32,
            layout,
        })
    }

    /// Returns the colours that the sensor records of linear light, sRGB with the coverage of the light; light of 1 is a white surface in
    /// typical light after multiplication by `scale`. `intrinsics` are the image's; the noise is a function of the camera's random numbers
    /// and the number of the frame.
    #[must_use]
    pub fn record(
        &self,
        light: &Image<[f32; 4]>,
        scale: f32,
        intrinsics: &Intrinsics,
        random: &Stream,
        frame: u64,
    ) -> Image<[u8; 4]> {
        let linear = self.linear(light, scale, intrinsics, random, frame);
        let table: Vec<u8> = (0..=UNITS * Bits::Ten.max())
            .map(|value| srgb_from_linear(f32::from(value) / f32::from(UNITS * Bits::Ten.max())))
            .collect();
        let mut colors = linear.map(|channels| {
            let [r, g, b] = channels.map(|value| table.get(usize::from(value)).copied().unwrap_or(u8::MAX));
            [r, g, b, 0]
        });
        for (color, light) in colors.pixels_mut().iter_mut().zip(light.pixels()) {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "the cast saturates"
            )]
            {
                color[3] = (light[3] * 255.0).round() as u8;
            }
        }
        colors
    }

    /// Returns linear colours in [`UNITS`] of a step of 10 bits.
    fn linear(
        &self,
        light: &Image<[f32; 4]>,
        scale: f32,
        intrinsics: &Intrinsics,
        random: &Stream,
        frame: u64,
    ) -> Image<[u16; 3]> {
        let scale = scale * self.light;
        let random = [0, 1, 2].map(|item| random.plane(NoiseStage::Color, frame, item));
        let rows = |exposure: Exposure, channel: usize, random| {
            Rows::new(self.channels[channel].parameters(), intrinsics, exposure, random)
        };
        let numbers = |plane: &Image<f32>, rows: &Rows<'_>| {
            let mut out = Image::filled(plane.width(), plane.height(), 0u16);
            rows.record(plane.into(), out.pixels_mut());
            out
        };
        if self.layout == Layout::Monochrome {
            let luminance = |pixel: &[f32; 4]| {
                let channels = pixel.iter().zip(LUMINANCE);
                channels.map(|(value, share)| value * share).sum::<f32>() * scale
            };
            let plane = light.map(luminance);
            let exposure = self.channels[1].expose(&[((&plane).into(), intrinsics)]);
            let grey = numbers(&plane, &rows(exposure, 1, &random[0]));
            return grey.map(|value| [value * UNITS; 3]);
        }
        let planes = [0, 1, 2].map(|channel: usize| light.map(|pixel| pixel[channel] * scale));
        let views = planes.each_ref().map(|plane| (plane.into(), intrinsics));
        let exposure = self.channels[1].expose(&views);
        match self.layout {
            Layout::Mosaic => {
                let rows = [0, 1, 2].map(|channel| rows(exposure, channel, &random[0]));
                demosaic::demosaic(&mosaic::record(&planes, &rows))
            }
            _ => demosaic::whole(
                &[0, 1, 2]
                    .map(|channel| numbers(&planes[channel], &rows(exposure, channel, &random[channel]))),
            ),
        }
    }
}

#[cfg(test)]
#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "counts of pixels, and light is float32"
)]
mod tests {
    use oaktwin_camera::ImageSize;

    use super::*;

    const SIZE: ImageSize = ImageSize::new(512, 384);

    fn parameters() -> ColorParameters {
        ColorParameters {
            auto_exposure: false,
            exposure: 0.9,
            max_exposure_time: 0.6,
            ..ColorParameters::default()
        }
    }

    fn linear(parameters: ColorParameters, per_pixel: f64, light: [f64; 3]) -> Image<[u16; 3]> {
        let photosites = Photosites {
            pitch_um: 1.55,
            per_pixel,
            is_monochrome: false,
        };
        let imager = ColorImager::new(parameters, photosites).unwrap();
        let [r, g, b] = light.map(|value| value as f32);
        let light = Image::filled(SIZE.width, SIZE.height, [r, g, b, 1.0]);
        let intrinsics = Intrinsics::from_hfov(SIZE, 1.2);
        imager.linear(&light, 1.0, &intrinsics, &Stream::new(3, "rgb"), 5)
    }

    /// The mean and the variance of a channel at the pixels with these parities, in shares of the largest value.
    fn moments(image: &Image<[u16; 3]>, channel: usize, [px, py]: [u32; 2]) -> [f64; 2] {
        let full = f64::from(UNITS) * 1023.0;
        let values: Vec<f64> = (4 + py..SIZE.height - 4)
            .step_by(2)
            .flat_map(|y| (4 + px..SIZE.width - 4).step_by(2).map(move |x| (x, y)))
            .map(|(x, y)| f64::from(image.get(x, y).unwrap()[channel]) / full)
            .collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / values.len() as f64;
        [mean, variance]
    }

    /// The variance of a channel's recorded values: shot noise, read noise, and rounding to 10 bits.
    fn recorded_variance(p: &ColorParameters, channel: usize, light: f64, photosites: f64) -> f64 {
        let gain = [p.red_gain, 1.0, p.blue_gain][channel];
        let full = p.well_density_e * 1.55 * 1.55 * photosites;
        let (time, iso) = (p.max_exposure_time, p.exposure / p.max_exposure_time);
        let electrons = light * time * full / gain;
        let read = p.read_noise_e.powi(2) * photosites;
        (electrons + read) * (iso * gain / full).powi(2) + 1.0 / 12.0 / 1023.0f64.powi(2)
    }

    /// Demosaicing is linear, so that the variance of a pixel is the sum over its neighbours of squared weights times theirs.
    #[test]
    fn noise_has_the_variance_of_the_model_at_each_place_of_the_mosaic() {
        let p = parameters();
        let light = [0.5, 0.4, 0.3];
        let image = linear(p, 1.0, light);
        let [r, g, b] = [0, 1, 2].map(|channel| recorded_variance(&p, channel, light[channel], 1.0));
        // Red at (0, 0), green at (1, 0) and (0, 1), blue at (1, 1).
        let expected = [
            (0, [0, 0], r),
            (1, [1, 0], g),
            (2, [1, 1], b),
            (1, [0, 0], (20.0 * r + 16.0 * g) / 64.0),
            (1, [1, 1], (20.0 * b + 16.0 * g) / 64.0),
            (0, [1, 1], (45.0 * b + 16.0 * r) / 64.0),
            (2, [0, 0], (45.0 * r + 16.0 * b) / 64.0),
            (0, [1, 0], (31.5 * g + 32.0 * r) / 64.0),
            (0, [0, 1], (31.5 * g + 32.0 * r) / 64.0),
            (2, [1, 0], (31.5 * g + 32.0 * b) / 64.0),
        ];
        for (channel, place, variance) in expected {
            let [mean, found] = moments(&image, channel, place);
            assert!(
                (found / variance - 1.0).abs() < 0.03,
                "{channel} {place:?}: {found} {variance}"
            );
            // Colours differ, so that interpolation keeps the mean of each only where the image is even, which this one is.
            let error = mean - light[channel] * p.exposure;
            assert!(error.abs() < 3e-4, "{channel} {place:?}: {error}");
        }
    }

    #[test]
    fn reduced_images_have_the_photosites_of_a_pixel() {
        let p = parameters();
        let light = [0.5, 0.4, 0.3];
        let image = linear(p, 3.0, light);
        for (channel, share) in [(0, 0.25), (1, 0.5), (2, 0.25)] {
            let [mean, found] = moments(&image, channel, [0, 0]);
            let variance = recorded_variance(&p, channel, light[channel], 9.0 * share);
            assert!(
                (found / variance - 1.0).abs() < 0.03,
                "{channel}: {found} {variance}"
            );
            assert!((mean - light[channel] * p.exposure).abs() < 2e-4);
        }
    }

    #[test]
    fn without_noise_even_light_is_encoded_as_it_is() {
        let p = ColorParameters {
            noise: false,
            exposure: 1.0,
            max_exposure_time: 1.0,
            ..parameters()
        };
        for per_pixel in [1.0, 1.6, 2.0] {
            let photosites = Photosites {
                pitch_um: 1.55,
                per_pixel,
                is_monochrome: false,
            };
            let imager = ColorImager::new(p, photosites).unwrap();
            let light = Image::filled(64, 48, [0.25, 0.125, 3.0, 0.6]);
            let intrinsics = Intrinsics::from_hfov(ImageSize::new(64, 48), 1.2);
            let colors = imager.record(&light, 2.0, &intrinsics, &Stream::new(0, "rgb"), 0);
            let expected = [srgb_from_linear(0.5), srgb_from_linear(0.25), 255, 153];
            let far = |color: &[u8; 4]| {
                color
                    .iter()
                    .zip(&expected)
                    .any(|(own, other)| own.abs_diff(*other) > 1)
            };
            assert!(
                !colors.pixels().iter().any(far),
                "{per_pixel}: {:?}",
                colors.get(9, 9)
            );
        }
    }

    /// Without filters, all light counts, and every pixel has one random number of its own.
    #[test]
    fn monochrome_sensors_record_luminance() {
        let p = parameters();
        let light = [0.5f32, 0.4, 0.3];
        let [r, g, b] = light;
        for per_pixel in [1.0, 3.0] {
            let photosites = Photosites {
                pitch_um: 1.55,
                per_pixel,
                is_monochrome: true,
            };
            let imager = ColorImager::new(p, photosites).unwrap();
            let image = Image::filled(SIZE.width, SIZE.height, [r, g, b, 1.0]);
            let intrinsics = Intrinsics::from_hfov(SIZE, 1.2);
            let image = imager.linear(&image, 1.0, &intrinsics, &Stream::new(3, "left"), 5);
            assert!(image.pixels().iter().all(|[r, g, b]| r == g && g == b));
            let luminance = 0.2126 * 0.5 + 0.7152 * 0.4 + 0.0722 * 0.3;
            let variance = recorded_variance(&p, 1, luminance, per_pixel * per_pixel);
            for place in [[0, 0], [1, 0], [1, 1]] {
                let [mean, found] = moments(&image, 0, place);
                assert!((found / variance - 1.0).abs() < 0.03, "{found} {variance}");
                assert!((mean - luminance * p.exposure).abs() < 3e-4, "{mean}");
            }
        }
    }

    #[test]
    fn exposure_aims_at_middle_grey_and_gain_adds_noise_in_the_dark() {
        let auto = ColorParameters {
            auto_exposure: true,
            ..ColorParameters::default()
        };
        let image = linear(auto, 1.0, [0.3; 3]);
        let [mean, bright] = moments(&image, 1, [1, 0]);
        assert!((mean - 0.18).abs() < 1e-3, "{mean}");
        let [mean, dark] = moments(&linear(auto, 1.0, [0.006; 3]), 1, [1, 0]);
        assert!((mean - 0.18).abs() < 2e-3, "{mean}");
        assert!(dark > 10.0 * bright, "{dark} {bright}");
    }
}
