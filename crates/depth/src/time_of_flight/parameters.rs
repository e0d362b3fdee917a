use oaktwin_base::parameter::{FieldText, Kind, ParameterError, Platform, Value, parameters};

use crate::random::{NoiseStage, Stream, standard_normal};

parameters! {
    /// The measurement and the errors of a time-of-flight camera.
    pub struct Parameters("time-of-flight", platform) {
        /// The focal length of images of the given width.
        focal_length_px: f64 = 457.0 => ("focalLength".unit("px").range(1.0..=1e5).typical(200.0..=1000.0).from_camera()),
        /// The width of the sensor's images. Images of another width show the same view in other pixels.
        width_px: u32 = 640 => ("width".unit("px").range(1.0..=16384.0).typical(160.0..=1280.0).from_camera()),
        /// The point where the optical axis meets an image of that width; the first pixel's centre is at 0.5. `center` is
        /// the middle of each image.
        principal_point_px: Option<[f64; 2]> = None
            => ("principalPoint" as PrincipalPoint.unit("px").range(-65536.0..=65536.0).from_camera()),
        /// The two modulation frequencies, the lower first.
        frequencies_mhz: [f64; 2] = [80.0, 100.0] => ("modulationFrequencies" as Ascending.unit("MHz").range(1.0..=1000.0)),
        /// Whether phases are unwrapped; false is the same as level 0.
        enable_phase_unwrapping: bool = true => ("enablePhaseUnwrapping"),
        /// The range of phase unwrapping. 0: one period of the lower frequency, which alone is used (1.87 m at 80 MHz). n:
        /// n + 1 periods of the higher frequency (3, 4.5, 6, 7.5 m at 100 MHz), up to the common period of both, 7.5 m.
        /// The distances are `DepthAI`'s; that they are these periods is inferred from them.
        phase_unwrapping_level: u32 = 4 => ("phaseUnwrappingLevel".common(2).range(0.0..=5.0)),
        /// The largest disagreement of the two frequencies. `DepthAI` does not document the unit: millimetres are an
        /// estimate, by which its presets of 50 to 130 lie within the largest possible disagreement, 187 mm.
        phase_unwrap_error_threshold: u16 = 100
            => ("phaseUnwrapErrorThreshold".unit("mm").range(0.0..=65535.0).typical(0.0..=500.0)),
        /// Whether each frequency is measured twice, the second time with shuffled phases, and averaged: less noise, more
        /// motion blur.
        enable_phase_shuffle_temporal_filter: bool = true => ("enablePhaseShuffleTemporalFilter"),
        /// Whether no measurement is used in two frames. Without it, shuffled and plain measurements alternate, and a
        /// frame shares half of its noise with the previous one.
        enable_burst_mode: bool = false => ("enableBurstMode"),
        /// Whether distance along the ray is converted to depth along the optical axis.
        enable_optical_correction: bool = true => ("enableOpticalCorrection"),
        /// Whether the periodic error is corrected, down to `wigglingResidual`.
        enable_wiggle_correction: bool = true => ("enableWiggleCorrection"),
        /// The amplitude w of the correlation's harmonics relative to its own. The phase error is −atan(w·sin 4φ), the
        /// amplitude changes by the factor 1 + w·cos 4φ. 0.071 describes a triangle wave, 1/9 − 1/25: an estimate for
        /// square-wave modulation.
        wiggling: f64 = 0.071 => ("wiggling".range(0.0..=0.5).typical(0.0..=0.2).estimate()),
        /// The phase error that remains after the correction, as `wiggling`.
        wiggling_residual: f64 = 0.003 => ("wigglingResidual".range(0.0..=0.5).typical(0.0..=0.02).estimate()),
        /// Whether the constant errors of pixels are corrected.
        enable_fppn_correction: bool = true => ("enableFPPNCorrection"),
        /// The standard deviation of the constant errors of pixels where they are not corrected.
        fixed_pattern_m: f64 = 0.01 => ("fixedPattern".unit("m").range(0.0..=1.0).typical(0.0..=0.05).estimate()),
        /// The constant error of the unit. A positive bias makes depth too large.
        bias_m: f64 = 0.0 => ("bias".unit("m").range(-1.0..=1.0).typical(-0.1..=0.1).estimate()),
        /// The electrons that the camera's light adds to a sample of a white surface at 1 m that faces the camera. The
        /// signal falls with the cosine of the angle of incidence and the square of the distance.
        signal_e: f64 = 3000.0 => ("signal".unit("electrons").range(0.0..=1e6).typical(0.0..=20000.0).estimate()),
        /// The demodulation contrast.
        contrast: f64 = 0.8 => ("contrast".range(0.0..=1.0).estimate()),
        /// The electrons that ambient light on a white surface adds to a sample at any distance; `indoor` is 50 and
        /// `outdoor` 500.
        ambient_e: f64 = INDOOR_E => ("ambient" as Ambient.common(3).unit("electrons").range(0.0..=1e6).typical(0.0..=1000.0).estimate()),
        /// The standard deviation of the read noise of a sample.
        read_noise_e: f64 = 5.0 => ("readNoise".unit("electrons").range(0.0..=1e4).typical(0.0..=50.0).estimate()),
        /// The electrons that a sample can hold; a pixel with more is lost. With the default a white wall is lost below
        /// 0.2 m.
        full_well_e: f64 = 135_000.0 => ("fullWell".unit("electrons").range(1.0..=1e9).typical(1e4..=5e5).estimate()),
        /// The reflectance of all surfaces at 940 nm where there is no colour image.
        albedo: f64 = 0.5 => ("albedo".common(4).range(0.0..=1.0).estimate()),
        /// The weight of the neighbour on each side in a pixel. 1/8 is a pixel's whole area under linear interpolation.
        pixel_mixing: f64 = 0.125 => ("pixelMixing".range(0.0..=0.25).estimate()),
        /// The scale of multipath interference: 0 disables it, 1 is physical; larger values compensate for paths that the model leaves out.
        multipath: f64 = 0.0 => ("multipath".common(5).range(0.0..=10.0).typical(0.0..=2.0).estimate()),
        /// The velocity of all surfaces away from the camera, where the input has none for each pixel.
        radial_velocity_m_s: f64 = 0.0
            => ("radialVelocity".unit("m/s").range(-100.0..=100.0).typical(-3.0..=3.0).chosen("a still scene")),
        /// The time from one measurement to the next; a frame takes two.
        measurement_interval_s: f64 = 1.0 / 60.0 => ("measurementInterval".unit("s").range(0.0..=1.0).typical(0.0..=0.1)),
        /// The minimum amplitude; a pixel with less is lost. The default is twice the noise of darkness.
        min_amplitude_e: f64 = 5.0 => ("minAmplitude".unit("electrons").range(0.0..=65535.0).typical(0.0..=100.0).estimate()),
        /// The minimum confidence of `DepthAI`'s depth confidence filter.
        confidence_threshold: f32 = 0.1 => ("confidenceThreshold".common(1).range(0.0..=1e7).typical(0.0..=1.0)),
    }
    check frequencies_in_order
}

/// The number of electrons of indoor ambient light in a sample; an estimate.
pub const INDOOR_E: f64 = 50.0;

/// The number of electrons of outdoor ambient light in a sample; an estimate.
pub const OUTDOOR_E: f64 = 500.0;

/// The standard deviation of the constant error over units, m: an estimate, well within the 1 % at 0.2 m that the vendor
/// publishes.
pub const DEVICE_BIAS_SIGMA_M: f64 = 0.0005;

impl Parameters {
    /// Returns the defaults for a camera: `DepthAI`'s settings where it has them, estimates otherwise. With these the
    /// vendor's method finds errors below 1 % from 0.2 to 5 m, and below 2 % outdoors.
    #[must_use]
    pub fn new(focal_length_px: f64, width_px: u32) -> Self {
        Self {
            focal_length_px,
            width_px,
            ..Self::defaults(Platform::default())
        }
    }

    /// Returns the same parameters with the random constant error of one unit.
    #[must_use]
    pub fn of_device(mut self, device_seed: u64) -> Self {
        let plane = Stream::new(device_seed, "").plane(NoiseStage::DeviceBias, 0, 0);
        let [a, b, ..] = plane.words(0, 0);
        self.bias_m = DEVICE_BIAS_SIGMA_M * standard_normal(a, b)[0];
        self
    }

    fn frequencies_in_order(&self) -> Result<(), ParameterError> {
        let [low, high] = self.frequencies_mhz;
        if low < high {
            return Ok(());
        }
        Err(ParameterError::new(
            "modulationFrequencies",
            format!("{low},{high} are not in ascending order"),
            "give two different frequencies, the lower first",
        ))
    }
}

/// Two frequencies, the lower first.
struct Ascending;

impl FieldText<[f64; 2]> for Ascending {
    const KIND: Kind = Kind::Text("two numbers separated by a comma, the lower first");

    fn set(field: &mut [f64; 2], text: &str) -> Option<()> {
        *field = <[f64; 2]>::parse(text).filter(|[low, high]| low < high)?;
        Some(())
    }

    fn get(field: &[f64; 2]) -> String {
        field.text()
    }

    fn numbers(field: &[f64; 2]) -> Vec<f64> {
        field.numbers()
    }
}

/// A principal point, or `center`.
struct PrincipalPoint;

impl FieldText<Option<[f64; 2]>> for PrincipalPoint {
    const KIND: Kind = Kind::Text("center, or two numbers separated by a comma");

    fn set(field: &mut Option<[f64; 2]>, text: &str) -> Option<()> {
        *field = match text {
            "center" => None,
            pair => Some(<[f64; 2]>::parse(pair)?),
        };
        Some(())
    }

    fn get(field: &Option<[f64; 2]>) -> String {
        field.map_or_else(|| "center".to_owned(), |pair| pair.text())
    }

    fn numbers(field: &Option<[f64; 2]>) -> Vec<f64> {
        field.map(|pair| pair.to_vec()).unwrap_or_default()
    }
}

/// A number of electrons, or `indoor` or `outdoor`.
struct Ambient;

impl FieldText<f64> for Ambient {
    const KIND: Kind = Kind::Text("indoor, outdoor, or a number");

    fn set(field: &mut f64, text: &str) -> Option<()> {
        *field = match text {
            "indoor" => INDOOR_E,
            "outdoor" => OUTDOOR_E,
            number => number.parse().ok()?,
        };
        Some(())
    }

    fn get(field: &f64) -> String {
        field.text()
    }

    fn numbers(field: &f64) -> Vec<f64> {
        vec![*field]
    }
}
