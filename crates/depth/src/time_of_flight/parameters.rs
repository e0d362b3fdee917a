use crate::ParameterError;
use crate::random::{Stage, Stream, standard_normal};

/// What a time-of-flight camera measures with, and how wrong it is.
///
/// [`Parameters::set`] and [`Parameters::get`] reach each by its name in [`NAMES`](super::NAMES): `DepthAI`'s
/// (`ToFConfig`, `ToFDepthConfidenceFilterConfig`) where it has one. What is marked *estimate* has no public number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// `focalLength`: of images [`width_px`](Self::width_px) wide, px.
    pub focal_length_px: f64,
    /// `width`: of the sensor's images, px. Images of another width are the same view in other pixels.
    pub width_px: u32,
    /// `principalPoint`: where the optical axis meets an image of that width, px; the first pixel's centre is 0.5. None:
    /// the middle of each image.
    pub principal_point_px: Option<[f64; 2]>,
    /// `modulationFrequencies`, MHz, the lower first: 80 and 100, as `DepthAI` documents.
    pub frequencies_mhz: [f64; 2],
    /// `enablePhaseUnwrapping`: without it, level 0.
    pub enable_phase_unwrapping: bool,
    /// `phaseUnwrappingLevel`, 0 to 5: how far it looks. 0: one period of the lower frequency, which alone is used
    /// (1.87 m at 80 MHz). n: n + 1 periods of the higher (3, 4.5, 6, 7.5 m at 100 MHz), up to where both begin anew
    /// together: 7.5 m. The distances are `DepthAI`'s; that they are these periods is read off them.
    pub phase_unwrapping_level: u32,
    /// `phaseUnwrapErrorThreshold`: what the two frequencies may disagree by. `DepthAI` does not say in what unit:
    /// millimetres here, an estimate, by which its presets of 50 to 130 lie inside what a disagreement can be, 187 mm.
    pub phase_unwrap_error_threshold: u16,
    /// `enablePhaseShuffleTemporalFilter`: whether each frequency is measured twice, the second time with its phases
    /// shuffled, and averaged: less noise, more motion blur.
    pub enable_phase_shuffle_temporal_filter: bool,
    /// `enableBurstMode`: whether no measurement is used in two frames. If they are (the default), as the shuffled and
    /// the plain ones take turns, a frame shares half of its noise with the one before.
    pub enable_burst_mode: bool,
    /// `enableOpticalCorrection`: whether distance along the ray becomes depth along the optical axis.
    pub enable_optical_correction: bool,
    /// `enableWiggleCorrection`: whether the periodic error is corrected, to [`wiggling_residual`](Self::wiggling_residual).
    pub enable_wiggle_correction: bool,
    /// `wiggling`, w: of the correlation's harmonics, as a fraction of its amplitude. The phase is wrong by
    /// −atan(w·sin 4φ), the amplitude by the factor 1 + w·cos 4φ. 0.071 is what a triangle has, 1/9 less 1/25: an
    /// estimate, of square waves.
    pub wiggling: f64,
    /// `wigglingResidual`: what the correction leaves of the phase's; estimate.
    pub wiggling_residual: f64,
    /// `enableFPPNCorrection`: whether pixels' constant errors are corrected.
    pub enable_fppn_correction: bool,
    /// `fixedPattern`: the standard deviation of pixels' constant errors where they are not, m; estimate.
    pub fixed_pattern_m: f64,
    /// `bias`: the device's constant error, m: above 0 it reports too far.
    pub bias_m: f64,
    /// `signal`: electrons that the light of a white surface at 1 m, facing the camera, adds to a sample; estimate. It
    /// falls with the cosine of the angle to the surface's normal and the square of the distance.
    pub signal_e: f64,
    /// `contrast`, 0 to 1: of the demodulation; estimate.
    pub contrast: f64,
    /// `ambient`: electrons that other light on a white surface adds to a sample, at any distance: [`INDOOR_E`],
    /// [`OUTDOOR_E`].
    pub ambient_e: f64,
    /// `readNoise`: standard deviation of a sample, electrons; estimate.
    pub read_noise_e: f64,
    /// `fullWell`: electrons that a sample can hold; a pixel with more is lost; estimate, by which a white wall is lost
    /// nearer than 0.2 m.
    pub full_well_e: f64,
    /// `albedo`, 0 to 1: of everything, at 940 nm, where a shot has no picture.
    pub albedo: f64,
    /// `pixelMixing`, 0 to 0.25: the weight of the pixel on each side in what a pixel sees. ⅛ is a pixel's whole area, of
    /// light interpolated between pixels.
    pub pixel_mixing: f64,
    /// `multipath`: how much of the light that comes by another surface there is; 0: none, 1: as much as there would be. More
    /// stands in for what is left out.
    pub multipath: f64,
    /// `radialVelocity`: of everything away from the camera, m/s, where a shot does not say it pixel by pixel.
    pub radial_velocity_m_s: f64,
    /// `measurementInterval`: between one measurement and the next, s: 1/60 in `DepthAI`'s example, two a frame.
    pub measurement_interval_s: f64,
    /// `minAmplitude`: a pixel with less is lost, electrons; estimate, twice the noise of darkness.
    pub min_amplitude_e: f64,
    /// `confidenceThreshold`: of [`DepthConfidence`](crate::filter::DepthConfidence).
    pub confidence_threshold: f32,
}

/// Ambient light indoors, electrons a sample; estimate.
pub const INDOOR_E: f64 = 50.0;

/// Ambient light outdoors, electrons a sample; estimate.
pub const OUTDOOR_E: f64 = 500.0;

/// The spread of devices' constant errors, m: an estimate, well inside the 1 % of 0.2 m that the vendor publishes.
pub const DEVICE_BIAS_SIGMA_M: f64 = 0.0005;

impl Parameters {
    /// The defaults for a camera: `DepthAI`'s settings where it has them, estimates else. With these the vendor's method
    /// finds errors under 1 % from 0.2 to 5 m, and under 2 % outdoors.
    #[must_use]
    pub fn new(focal_length_px: f64, width_px: u32) -> Self {
        Self {
            focal_length_px,
            width_px,
            principal_point_px: None,
            frequencies_mhz: [80.0, 100.0],
            enable_phase_unwrapping: true,
            phase_unwrapping_level: 4,
            phase_unwrap_error_threshold: 100,
            enable_phase_shuffle_temporal_filter: true,
            enable_burst_mode: false,
            enable_optical_correction: true,
            enable_wiggle_correction: true,
            wiggling: 0.071,
            wiggling_residual: 0.003,
            enable_fppn_correction: true,
            fixed_pattern_m: 0.01,
            bias_m: 0.0,
            signal_e: 3000.0,
            contrast: 0.8,
            ambient_e: INDOOR_E,
            read_noise_e: 5.0,
            full_well_e: 135_000.0,
            albedo: 0.5,
            pixel_mixing: 0.125,
            multipath: 0.0,
            radial_velocity_m_s: 0.0,
            measurement_interval_s: 1.0 / 60.0,
            min_amplitude_e: 5.0,
            confidence_threshold: 0.1,
        }
    }

    /// With the constant error of one device of many.
    #[must_use]
    pub fn of_device(mut self, device_seed: u64) -> Self {
        let plane = Stream::new(device_seed, "").plane(Stage::DeviceBias, 0, 0);
        let [a, b, ..] = plane.words(0, 0);
        self.bias_m = DEVICE_BIAS_SIGMA_M * standard_normal(a, b)[0];
        self
    }

    /// Whether these make a sensor.
    ///
    /// # Errors
    /// One that is out of its range, or no number.
    pub fn check(&self) -> Result<(), ParameterError> {
        let [low, high] = self.frequencies_mhz;
        let [cx, cy] = self.principal_point_px.unwrap_or_default();
        let level = f64::from(self.phase_unwrapping_level);
        let ranges = [
            ("focalLength", self.focal_length_px, 1.0, 1e5, "px"),
            ("width", f64::from(self.width_px), 1.0, 16384.0, "px"),
            ("principalPoint", cx, -65536.0, 65536.0, "px"),
            ("principalPoint", cy, -65536.0, 65536.0, "px"),
            ("modulationFrequencies", low, 1.0, 1000.0, "MHz"),
            ("modulationFrequencies", high, 1.0, 1000.0, "MHz"),
            ("phaseUnwrappingLevel", level, 0.0, 5.0, "whole"),
            ("wiggling", self.wiggling, 0.0, 0.5, "of the amplitude"),
            (
                "wigglingResidual",
                self.wiggling_residual,
                0.0,
                0.5,
                "of the amplitude",
            ),
            ("fixedPattern", self.fixed_pattern_m, 0.0, 1.0, "m"),
            ("bias", self.bias_m, -1.0, 1.0, "m"),
            ("signal", self.signal_e, 0.0, 1e6, "electrons"),
            ("contrast", self.contrast, 0.0, 1.0, "of the signal"),
            ("ambient", self.ambient_e, 0.0, 1e6, "electrons"),
            ("readNoise", self.read_noise_e, 0.0, 1e4, "electrons"),
            ("fullWell", self.full_well_e, 1.0, 1e9, "electrons"),
            ("albedo", self.albedo, 0.0, 1.0, "of the light"),
            ("pixelMixing", self.pixel_mixing, 0.0, 0.25, "of the light"),
            ("multipath", self.multipath, 0.0, 10.0, "of what is physical"),
            ("radialVelocity", self.radial_velocity_m_s, -100.0, 100.0, "m/s"),
            ("measurementInterval", self.measurement_interval_s, 0.0, 1.0, "s"),
            ("minAmplitude", self.min_amplitude_e, 0.0, 65535.0, "electrons"),
            (
                "confidenceThreshold",
                f64::from(self.confidence_threshold),
                0.0,
                1e7,
                "",
            ),
        ];
        for (name, value, least, most, unit) in ranges {
            if !(least..=most).contains(&value) {
                let what = if value.is_nan() {
                    "it is no number".to_owned()
                } else {
                    format!("{value} is out of range")
                };
                let remedy = format!("give {least} to {most} {unit}");
                return Err(ParameterError::new(name, what, remedy.trim_end()));
            }
        }
        if low >= high {
            return Err(ParameterError::new(
                "modulationFrequencies",
                format!("{low},{high} are not in order"),
                "give the lower first, and another",
            ));
        }
        Ok(())
    }
}
