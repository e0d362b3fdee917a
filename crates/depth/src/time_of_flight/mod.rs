//! What a time-of-flight camera reports: light whose brightness is modulated comes back with a phase.
//!
//! Images are taken as they are: there is no lens here ([`Parameters::focal_length_px`] and
//! [`Parameters::principal_point_px`] say where pixels look), and no filter but the amplitude's.
//!
//! # Steps
//! 1. **Light.** What is not finite, not above 0, or beyond 10 km is no surface and throws nothing back. Elsewhere the
//!    distance along the pixel's ray is r, and the light of a sample A = [signal](Parameters::signal_e)·albedo·cos θ/r²
//!    electrons, and that of other lamps [ambient](Parameters::ambient_e)·albedo. The normal comes from the depth itself: on
//!    a plane 1/z is linear over the image, so that its gradient is exact there; of the two sides of a pixel the flatter
//!    counts, and what is steeper than 89° on both is taken to face the camera. The albedo at 940 nm is, an estimate, the
//!    luma of the shot's picture (not its linear value, as what looks dark reflects more there), at least 0.02; without a
//!    picture [`Parameters::albedo`].
//! 2. **Phasors.** Of each frequency C·A·e^{iφ}, φ = 4π·f·r/c. If things move ([`Shot::with_radial_velocity`]), each
//!    frequency sees them where they were in the middle of its measurements: the last of the higher one is now.
//!    To them comes, if asked for, the light that went by another surface ([`Parameters::multipath`]): once, from what the
//!    image shows, in 40 × 30 patches at most, whether or not something stands between. It makes concave corners too far
//!    and round: two walls at 90°, their edge 1.5 m away, of albedo 0.5 by 30 mm where they are 0.2 m from the middle, of
//!    0.9 by 51 mm, less at the edge itself.
//! 3. **Mixing.** A pixel sees its neighbours' light too ([`Parameters::pixel_mixing`]), rows and columns: at an edge the
//!    phasors of both sides add up, and what is measured lies between them: flying pixels. What has no surface stays so.
//! 4. **Wiggling** of phase and amplitude with four times the phase, as four samples of what is no sine have it.
//! 5. **Noise.** Of four samples with shot noise and read noise: as both parts of the phasor, halves of two samples'
//!    differences, have the same variance at every phase and are independent, they are drawn at once, normal. Where there
//!    is little light the phase becomes any, and the amplitude has Rice's distribution.
//! 6. **Unwrapping.** Of all periods of both frequencies within range
//!    ([`Parameters::phase_unwrapping_level`]) those by which the two distances differ least, lost where they differ by
//!    more than [`Parameters::phase_unwrap_error_threshold`]; the mean of both, weighted by the squares of the
//!    frequencies. Much noise finds a wrong period; what is out of range is reported nearer, or lost.
//! 7. **Depth** z = r·cos of the ray's angle in whole millimetres. Lost are pixels that are full
//!    ([`Parameters::full_well_e`]), dark ([`Parameters::min_amplitude_e`]) or, by `DepthAI`'s filter, of too little
//!    [confidence](Parameters::confidence_threshold).
//!
//! # What is known, and what is an estimate
//! * The frequencies, the ranges of the levels, the settings and their defaults are `DepthAI`'s; so are the accuracy
//!   (error below 1 % indoors and 2 % outdoors from 0.2 to 5 m) and the precision (below 0.1 %) that the estimates of light
//!   and noise are chosen to stay inside.
//! * Not modelled: more bounces, mirrors and glass, light scattered in the lens, and what lights from outside the image.
//! * Estimates: electrons of signal, ambient light, read noise and full well; contrast; wiggling and what its correction
//!   leaves; the fixed pattern; the unit of the threshold of unwrapping; the least amplitude.
//! * A measurement is one exposure with all four samples, as a four-tap pixel takes them. The order of the measurements is
//!   low, high, low shuffled, high shuffled; two of them a frame, so that each frame shares half of its measurements with
//!   the one before unless in burst mode. Movement across the image is not modelled: it blurs edges on a device.
//! * `enableTemperatureCorrection` and `enableDistortionCorrection` have no counterpart: there is no temperature and no lens.

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

use oaktwin_image::{Image, ZDepth};

use self::light::Lamp;
use self::receive::{Limits, Receiver};
use self::sense::{Constants, Job};
use self::unwrap::{Unwrapping, range_m, turn_m};
use crate::filter::DepthConfidence;
use crate::random::Stream;
use crate::{ParameterError, Shot};

/// The sensor, ready to look.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeOfFlight {
    parameters: Parameters,
    constants: Constants,
    unwrapping: Unwrapping,
}

/// All that it reports of a shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Metres, whole millimetres; 0 where nothing was measured. Distance along the ray without
    /// [`Parameters::enable_optical_correction`].
    pub distance: ZDepth,
    /// The mean amplitude of the two frequencies, whole electrons of a sample. In what unit `DepthAI`'s is, is not
    /// published.
    pub amplitude: Image<u16>,
    /// [`DepthConfidence`] of both.
    pub confidence: Image<u16>,
}

impl TimeOfFlight {
    /// Of its parameters.
    ///
    /// # Errors
    /// A parameter out of its range.
    pub fn new(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.check()?;
        Ok(Self {
            parameters,
            constants: Constants::new(&parameters),
            unwrapping: Unwrapping::new(&parameters),
        })
    }

    /// Its parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// From where on a white wall that faces it fills no sample, metres.
    #[must_use]
    pub fn nearest_m(&self) -> f64 {
        let p = &self.parameters;
        let room = (p.full_well_e - p.ambient_e).max(f64::MIN_POSITIVE);
        (p.signal_e * (1.0 + p.contrast) / room).sqrt()
    }

    /// How far it measures, metres along the ray.
    #[must_use]
    pub fn range_m(&self) -> f64 {
        range_m(&self.parameters)
    }

    /// What it reports of a shot: metres, whole millimetres, 0 where nothing was measured.
    #[must_use]
    pub fn sense(&self, shot: &Shot<'_>, random: &Stream) -> ZDepth {
        let mut out = Image::filled(shot.depth().width(), shot.depth().height(), 0.0);
        Job::new(self, shot, random).distance(out.pixels_mut());
        ZDepth(out)
    }

    /// All that it reports of a shot.
    #[must_use]
    pub fn output(&self, shot: &Shot<'_>, random: &Stream) -> Output {
        let (width, height) = (shot.depth().width(), shot.depth().height());
        let mut out = Output {
            distance: ZDepth(Image::filled(width, height, 0.0)),
            amplitude: Image::filled(width, height, 0),
            confidence: Image::filled(width, height, 0),
        };
        Job::new(self, shot, random).output(&mut out);
        out
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
        // In the middle of its measurements, of which the last of the higher frequency is now.
        let ages = if p.enable_phase_shuffle_temporal_filter {
            [2.0, 1.0]
        } else {
            [1.0, 0.0]
        };
        let noise = match (p.enable_phase_shuffle_temporal_filter, p.enable_burst_mode) {
            (false, _) => 1.0,
            // Of the mean of two.
            (true, true) => 0.5f64.sqrt(),
            // Of both, which are added up.
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
