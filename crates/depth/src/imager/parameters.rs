use oaktwin_base::parameter::{Platform, choice, parameters};

choice! {
    /// The number of bits of a recorded value.
    Bits {
        /// 0 to 255, the input of an OAK's stereo.
        Eight = "8",
        /// 0 to 1023, the range of an OV9282.
        Ten = "10",
    }
}

impl Bits {
    /// The number of bits.
    #[must_use]
    pub const fn count(self) -> u32 {
        match self {
            Self::Eight => 8,
            Self::Ten => 10,
        }
    }

    /// The largest value.
    #[must_use]
    pub const fn max(self) -> u16 {
        match self {
            Self::Eight => 255,
            Self::Ten => 1023,
        }
    }
}

parameters! {
    /// An image sensor. The defaults describe an OAK's mono camera, an OV9282.
    pub struct Parameters("imager", platform) {
        /// Whether exposure follows the mean of the images.
        auto_exposure: bool = true => ("autoExposure".chosen("a camera's default")),
        /// The mean that automatic exposure aims at, as a share of the largest value.
        exposure_target: f64 = 0.35 => ("exposureTarget".range(0.001..=0.95).estimate()),
        /// Exposure time times gain without automatic exposure; at 1, white has the largest value.
        exposure: f64 = 0.8 => ("exposure".range(1e-6..=1e6).typical(0.01..=4.0).estimate()),
        /// The longest exposure time, as a multiple of the one at which white has the largest value. A value of 2 corresponds to
        /// 33 ms, `DepthAI`'s longest at 30 frames per second, under office lighting.
        max_exposure_time: f64 = 2.0 => ("maxExposureTime".range(1e-6..=1e6).typical(0.1..=4.0).estimate()),
        /// The largest gain: `DepthAI`'s ISO 1600 over its ISO 100.
        max_gain: f64 = 16.0 => ("maxGain".range(1.0..=1000.0).typical(1.0..=32.0)),
        /// The electrons of the largest value at a gain of 1. The default gives a maximum signal-to-noise ratio of 38 dB,
        /// usual for pixels of 3 µm with a global shutter.
        full_well_e: f64 = 6300.0 => ("fullWell".unit("electrons").range(10.0..=1e7).typical(1e3..=5e4).estimate()),
        /// The standard deviation of the read noise. The default gives a dynamic range of 68 dB.
        read_noise_e: f64 = 2.5 => ("readNoise".unit("electrons").range(0.0..=1e4).typical(0.0..=20.0).estimate()),
        /// Whether noise is added.
        noise: bool = true => ("noise".chosen("a real sensor")),
        /// The standard deviation of the lens's point spread function. The vendor's lens (2.35 mm, f/2.0, sharp from
        /// 19.6 cm, so sharpest at 39 cm) blurs a point at 2.5 m to a disk of 2 px, whose standard deviation is a quarter
        /// of that.
        lens_blur_px: f64 = 0.5 => ("lensBlur".unit("px").range(0.0..=8.0).typical(0.0..=3.0).estimate()),
        /// The share of cos⁴ falloff. The rest after a device's own correction is not published.
        vignetting: f64 = 0.0 => ("vignetting".range(0.0..=1.0).estimate()),
        /// The number of bits.
        bits: Bits = Bits::default() => ("bits"),
    }
}

impl Default for Parameters {
    fn default() -> Self {
        Self::defaults(Platform::default())
    }
}
