//! A model of time-of-flight cameras, which measure the phase of reflected, modulated light.
//!
//! There is no lens distortion ([`Parameters::focal_length_px`] and [`Parameters::principal_point_px`] define the rays of
//! pixels), and no filter except the amplitude's.
//!
//! # Steps
//! 1. **Light.** Depth that is not finite, not above 0, or beyond 10 km means no surface and reflects nothing. Elsewhere the
//!    distance along the pixel's ray is r, the light of a sample A = [signal](Parameters::signal_e)·albedo·cos θ/r²
//!    electrons, and ambient light [ambient](Parameters::ambient_e)·albedo. The normal is derived from the depth: on a
//!    plane 1/z is linear over the image, so that its gradient is exact; the flatter of the two sides of a pixel is used,
//!    and pixels steeper than 89° on both sides count as facing the camera. The albedo at 940 nm is estimated as the luma of
//!    the colour image (not its linear value, as dark surfaces reflect more at 940 nm), at least 0.02; without a colour image
//!    it is [`Parameters::albedo`].
//! 2. **Phasors.** C·A·e^{iφ} for each frequency, φ = 4π·f·r/c. If surfaces move ([`DepthShot::with_radial_velocity`],
//!    [`DepthShot::with_radial_velocities`]), each frequency sees them at the middle of its measurements; the last one of the higher frequency is now. With
//!    [`Parameters::multipath`], indirect light is added: one bounce between the visible surfaces, in 40 × 30 patches at
//!    most, without occlusion. It moves concave corners away and rounds them: two walls at 90° whose edge is 1.5 m away, with
//!    an albedo of 0.5, by 30 mm at 0.2 m from the edge, with 0.9 by 51 mm, and less at the edge itself.
//! 3. **Mixing.** A pixel receives light of its neighbours in rows and columns ([`Parameters::pixel_mixing`]): at an edge the
//!    phasors of both sides add up, and the measurement lies between them: flying pixels. Pixels without a surface stay
//!    invalid.
//! 4. **Wiggling** of phase and amplitude with four times the phase, as for four samples of a wave that is not a sine.
//! 5. **Noise.** Four samples have shot noise and read noise. The parts of the phasor, halves of the differences of two
//!    samples, are independent and have the same variance at every phase, so they are drawn directly as normal numbers. In
//!    low light the phase is random, and the amplitude has Rice's distribution.
//! 6. **Unwrapping.** Of all periods of both frequencies within range
//!    ([`Parameters::phase_unwrapping_level`]), those with the smallest difference between the two distances; invalid if they
//!    differ by more than [`Parameters::phase_unwrap_error_threshold`]; the mean of both, weighted by the squares of the
//!    frequencies. Strong noise leads to a wrong period; surfaces out of range are reported nearer, or are invalid.
//! 7. **Depth** z = r·cos of the ray's angle in whole millimetres. Pixels are invalid if they are saturated
//!    ([`Parameters::full_well_e`]), dark ([`Parameters::min_amplitude_e`]) or, by `DepthAI`'s filter, have too little
//!    [confidence](Parameters::confidence_threshold).
//!
//! # Sources and estimates
//! * The frequencies, the ranges of the levels, the settings and their defaults are `DepthAI`'s; so are the accuracy
//!   (error below 1 % indoors and 2 % outdoors from 0.2 to 5 m) and the precision (below 0.1 %), within which the
//!   estimates of light and noise are chosen.
//! * Not modelled: more bounces, mirrors and glass, light scattered in the lens, and light from outside the image.
//! * Estimates: electrons of signal, ambient light, read noise and full well; contrast; wiggling and its residual
//!   after correction; the fixed pattern; the unit of the unwrapping threshold; the minimum amplitude.
//! * A measurement is one exposure with all four samples, as a four-tap pixel takes them. The order of the measurements is
//!   low, high, low shuffled, high shuffled; two per frame, so that each frame shares half of its measurements with
//!   the previous one except in burst mode. The four samples of a frequency see the same; the two frequencies see a
//!   moving edge at different places of the image. The brightness is taken from the time of the frame. A device also blurs the edge.
//! * `enableTemperatureCorrection` and `enableDistortionCorrection` have no counterpart: neither temperature nor lens distortion is modelled.

mod batch;
mod closed_form;
mod light;
mod multipath;
mod optics;
mod parameters;
mod receive;
mod sense;
#[cfg(test)]
mod tests;
mod unwrap;

pub use parameters::{DEVICE_BIAS_SIGMA_M, INDOOR_E, OUTDOOR_E, Parameters};

use oaktwin_image::{Image, ZDepth, millimetres};

use self::light::Lamp;
use self::receive::{Limits, Receiver};
use self::sense::{Constants, Job};
use self::unwrap::{Unwrapping, range_m, turn_m};
use crate::filter::DepthConfidence;
use crate::random::Stream;
use crate::reason::ReasonCodes;
use crate::{DepthShot, ParameterError};

/// The engine, with checked parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeOfFlight {
    parameters: Parameters,
    constants: Constants,
    unwrapping: Unwrapping,
}

/// All outputs of the engine.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeOfFlightOutput {
    /// Metres, whole millimetres; 0 where nothing was measured. Distance along the ray without
    /// [`Parameters::enable_optical_correction`].
    pub distance: ZDepth,
    /// The mean amplitude of the two frequencies in whole electrons per sample. The unit of `DepthAI`'s amplitude is not
    /// published.
    pub amplitude: Image<u16>,
    /// The [`DepthConfidence`] of both frequencies.
    pub confidence: Image<u16>,
}

impl TimeOfFlight {
    /// Creates the engine from its parameters.
    ///
    /// # Errors
    /// Returns an error if a parameter is out of range.
    pub fn new(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.check()?;
        Ok(Self {
            parameters,
            constants: Constants::new(&parameters),
            unwrapping: Unwrapping::new(&parameters),
        })
    }

    /// The parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Returns the distance in metres beyond which a white wall facing the camera saturates no sample.
    #[must_use]
    pub fn nearest_m(&self) -> f64 {
        let p = &self.parameters;
        let room = (p.full_well_e - p.ambient_e).max(f64::MIN_POSITIVE);
        (p.signal_e * (1.0 + p.contrast) / room).sqrt()
    }

    /// Returns the unambiguous range in metres along the ray.
    #[must_use]
    pub fn range_m(&self) -> f64 {
        range_m(&self.parameters)
    }

    /// Measures the distance of a shot: metres, whole millimetres, 0 where nothing was measured.
    #[must_use]
    pub fn sense(&self, shot: &DepthShot<'_>, random: &Stream) -> ZDepth {
        let mut out = Image::filled(shot.depth().width(), shot.depth().height(), 0.0);
        Job::new(self, shot, random).distance(out.pixels_mut());
        ZDepth(out)
    }

    /// Measures all outputs of a shot.
    #[must_use]
    pub fn output(&self, shot: &DepthShot<'_>, random: &Stream) -> TimeOfFlightOutput {
        let (width, height) = (shot.depth().width(), shot.depth().height());
        let mut out = TimeOfFlightOutput {
            distance: ZDepth(Image::filled(width, height, 0.0)),
            amplitude: Image::filled(width, height, 0),
            confidence: Image::filled(width, height, 0),
        };
        Job::new(self, shot, random).output(&mut out);
        out
    }

    /// Measures a shot as [`TimeOfFlight::sense`] does, and returns the confidence of each pixel as [`DepthConfidence::of`]
    /// does.
    pub(crate) fn sense_with_confidence(
        &self,
        shot: &DepthShot<'_>,
        random: &Stream,
    ) -> (ZDepth, Image<u16>) {
        let output = self.output(shot, random);
        let mut confidence = output.amplitude;
        let depths = millimetres::from_metres(&output.distance.0);
        for (level, depth) in confidence.pixels_mut().iter_mut().zip(depths.pixels()) {
            *level = DepthConfidence::of(*level, *depth);
        }
        (output.distance, confidence)
    }

    /// Returns why pixels of [`TimeOfFlight::sense`] have no value.
    pub(crate) fn reasons(&self, shot: &DepthShot<'_>, random: &Stream) -> ReasonCodes {
        let depth = shot.depth();
        let mut codes = Image::filled(depth.width(), depth.height(), 0);
        Job::new(self, shot, random).reasons(codes.pixels_mut());
        ReasonCodes(codes)
    }

    /// Returns how long ago the middle of each frequency's measurements was, s.
    #[must_use]
    pub fn ages_s(&self) -> [f64; 2] {
        self.constants.lamp.age_s.map(f64::from)
    }

    fn constants(&self) -> &Constants {
        &self.constants
    }

    fn unwrapping(&self) -> &Unwrapping {
        &self.unwrapping
    }
}

impl Constants {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "checked parameters; rows are single precision"
    )]
    fn new(p: &Parameters) -> Self {
        // The ages at the middle of the measurements; the last one of the higher frequency is now.
        let ages = if p.enable_phase_shuffle_temporal_filter {
            [2.0, 1.0]
        } else {
            [1.0, 0.0]
        };
        let noise = match (p.enable_phase_shuffle_temporal_filter, p.enable_burst_mode) {
            (false, _) => 1.0,
            // The mean of two measurements.
            (true, true) => 0.5f64.sqrt(),
            // The sum of both measurements.
            (true, false) => 0.5,
        };
        let residual = if p.enable_wiggle_correction {
            p.wiggling_residual
        } else {
            p.wiggling
        };
        Self {
            lamp: Lamp {
                signal: p.signal_e as f32,
                contrast: p.contrast as f32,
                ambient: p.ambient_e as f32,
                turns_per_m: p.frequencies_mhz.map(|f| (1.0 / turn_m(f)) as f32),
                age_s: ages.map(|age| (age * p.measurement_interval_s) as f32),
            },
            receiver: Receiver {
                mixing: p.pixel_mixing as f32,
                wiggling: [p.wiggling as f32, residual as f32],
                read_variance: (p.read_noise_e * p.read_noise_e) as f32,
                noise: noise as f32,
            },
            limits: Limits {
                min_amplitude: p.min_amplitude_e as f32,
                full_well: p.full_well_e as f32,
                is_depth: p.enable_optical_correction,
            },
            albedo: p.albedo as f32,
            multipath: p.multipath as f32,
            bias_m: p.bias_m as f32,
            fixed_pattern_m: p.fixed_pattern_m as f32,
            velocity_m_s: p.radial_velocity_m_s as f32,
            confidence: DepthConfidence {
                threshold: p.confidence_threshold,
            },
        }
    }
}
