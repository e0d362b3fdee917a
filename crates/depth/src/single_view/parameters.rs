use crate::ParameterError;
use crate::choice;
use oaktwin_parameter::choice;

/// The attributes of `OmniSensorDepthSensorSingleViewAPI`, in their units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// `baselineMM`: between the imagers, mm. Its sign is the side.
    pub baseline_mm: f64,
    /// `confidenceThreshold`, 0 to 1: lower drops more of what has no texture. Without a picture nothing is dropped.
    pub confidence_threshold: f64,
    /// `enabled`: whether a stage asks for the sensor. Whoever calls the sensor has decided; it changes nothing here.
    pub enabled: bool,
    /// `focalLengthPixel`: px of a sensor that is `sensor_size_px` wide.
    pub focal_length_px: f64,
    /// `maxDisparityPixel`: farther shifts are dropped, px of the rendered image.
    pub max_disparity_px: f64,
    /// `minDistance`, m.
    pub min_distance_m: f64,
    /// `maxDistance`, m.
    pub max_distance_m: f64,
    /// `noiseMean`: the step to which disparity is quantized, px of the rendered image. 0 switches the step and the
    /// jitter off.
    pub noise_mean_px: f64,
    /// `noiseSigma`: the jitter of disparity, px of the rendered image.
    pub noise_sigma_px: f64,
    /// `noiseDownscaleFactorPixel`: the side of a patch that shares its jitter, px, 1 or more.
    pub noise_downscale_factor_px: f64,
    /// `outlierRemovalEnabled`: how far a lone pixel looks for others, px, up to [`MAX_OUTLIER_RANGE_PX`]; 0 switches
    /// the removal off. The switch of Isaac Sim 6 is 1.
    pub outlier_removal_range_px: u32,
    /// `rgbDepthOutputMode`.
    pub rgb_depth_output_mode: OutputMode,
    /// `sensorSizePixel`: the width of the sensor that `focal_length_px` belongs to, px.
    pub sensor_size_px: f64,
    /// `showDistance`: whether to tell the distance at the middle pixel: [`Output::center_m`](super::Output::center_m).
    pub show_distance: bool,
}

/// The farthest that outlier removal looks, px.
pub const MAX_OUTLIER_RANGE_PX: u32 = 63;

choice! {
    /// `rgbDepthOutputMode`: the picture that takes the colour image's place.
    ///
    /// Where the documentation gives a title and no formula, the picture is this program's reading of the title. Grey
    /// over the range is 0 at `minDistance` and 255 at `maxDistance`. Black is where nothing was measured.
    OutputMode {
        /// 0: the colour image as it came.
        Color = "color",
        /// 1: reported depth, grey: rising from 0 at every whole metre.
        Sawtooth = "sawtooth",
        /// 2: reported depth, grey over the range.
        Grayscale = "grayscale",
        /// 3: reported depth over the range, from red (near) over yellow, green and cyan to blue (far).
        Rainbow = "rainbow",
        /// 4: the depth that came in, grey over the range.
        InputDepth = "input-depth",
        /// 5: depth where it was moved to, without what lacks confidence, before outlier removal; grey over the range.
        Reprojected = "reprojected",
        /// 6: of the samples where they were moved to, red is confidence, green disparity as in 7.
        Confidence = "confidence",
        /// 7: disparity where samples were moved to, before any is dropped for confidence, grey from 0 to
        /// `maxDisparityPixel`.
        Disparity = "disparity",
    }
}

impl Parameters {
    /// The schema's attributes, without `omni:rtx:post:depthSensor:`.
    pub const NAMES: &[&str] = &[
        "baselineMM",
        "confidenceThreshold",
        "enabled",
        "focalLengthPixel",
        "maxDisparityPixel",
        "maxDistance",
        "minDistance",
        "noiseDownscaleFactorPixel",
        "noiseMean",
        "noiseSigma",
        "outlierRemovalEnabled",
        "rgbDepthOutputMode",
        "sensorSizePixel",
        "showDistance",
    ];

    /// The schema's defaults in Isaac Sim 5.0 and 5.1.
    pub const ISAAC_5_1: Self = Self {
        baseline_mm: 55.0,
        confidence_threshold: 0.95,
        enabled: false,
        focal_length_px: 897.0,
        max_disparity_px: 110.0,
        min_distance_m: 0.5,
        max_distance_m: 1e7,
        noise_mean_px: 0.25,
        noise_sigma_px: 0.25,
        noise_downscale_factor_px: 1.0,
        outlier_removal_range_px: 3,
        rgb_depth_output_mode: OutputMode::Color,
        sensor_size_px: 1280.0,
        show_distance: false,
    };

    /// The schema's defaults in Isaac Sim 6.
    pub const ISAAC_6: Self = Self {
        confidence_threshold: 0.70,
        outlier_removal_range_px: 1,
        ..Self::ISAAC_5_1
    };

    /// Sets an attribute by its name. `outlierRemovalEnabled` takes a range or `true` and `false`, and
    /// `outlierRemovalRange`, its name in the vendor's parameter sheet; `rgbDepthOutputMode` takes its number or the
    /// name of an [`OutputMode`]. Ranges are looked at by [`Parameters::check`], when all are set.
    ///
    /// # Errors
    /// No such attribute; a value that is not of its type.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), ParameterError> {
        if let Some(place) = self.number(name) {
            *place = choice::number(name, value)?;
            return Ok(());
        }
        match name {
            "enabled" => self.enabled = switch(name, value)?,
            "showDistance" => self.show_distance = switch(name, value)?,
            "outlierRemovalEnabled" | "outlierRemovalRange" => {
                self.outlier_removal_range_px = match value {
                    "true" => 1,
                    "false" => 0,
                    _ => whole(name, value, "give a range in pixels, or true or false")?,
                };
            }
            "rgbDepthOutputMode" => {
                self.rgb_depth_output_mode = match value.parse::<usize>() {
                    Ok(number) => *OutputMode::ALL.get(number).ok_or_else(|| {
                        ParameterError::new(name, format!("{number} is none of its modes"), "give 0 to 7")
                    })?,
                    Err(_) => choice::parse(name, value)?,
                };
            }
            _ => {
                return Err(choice::unknown(
                    name,
                    "attribute of the depth sensor",
                    Self::NAMES,
                ));
            }
        }
        Ok(())
    }

    /// The value of an attribute as [`Parameters::set`] takes it; `None` where there is no such attribute.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<String> {
        let mut copy = *self;
        if let Some(value) = copy.number(name) {
            return Some(value.to_string());
        }
        match name {
            "enabled" => Some(self.enabled.to_string()),
            "showDistance" => Some(self.show_distance.to_string()),
            "outlierRemovalEnabled" | "outlierRemovalRange" => {
                Some(self.outlier_removal_range_px.to_string())
            }
            "rgbDepthOutputMode" => Some((self.rgb_depth_output_mode as u8).to_string()),
            _ => None,
        }
    }

    fn number(&mut self, name: &str) -> Option<&mut f64> {
        match name {
            "baselineMM" => Some(&mut self.baseline_mm),
            "confidenceThreshold" => Some(&mut self.confidence_threshold),
            "focalLengthPixel" => Some(&mut self.focal_length_px),
            "maxDisparityPixel" => Some(&mut self.max_disparity_px),
            "maxDistance" => Some(&mut self.max_distance_m),
            "minDistance" => Some(&mut self.min_distance_m),
            "noiseDownscaleFactorPixel" => Some(&mut self.noise_downscale_factor_px),
            "noiseMean" => Some(&mut self.noise_mean_px),
            "noiseSigma" => Some(&mut self.noise_sigma_px),
            "sensorSizePixel" => Some(&mut self.sensor_size_px),
            _ => None,
        }
    }

    /// Disparity times depth in an image `width` pixels wide, px·m; negative with a negative baseline.
    #[must_use]
    pub fn disparity_times_depth(&self, width: u32) -> f64 {
        self.baseline_mm / 1000.0 * self.focal_length_px * f64::from(width) / self.sensor_size_px
    }

    /// Whether they make a sensor.
    ///
    /// # Errors
    /// The first that is out of its range.
    pub fn check(&self) -> Result<(), ParameterError> {
        let wrong = |name: &str, what: String, remedy: &str| Err(ParameterError::new(name, what, remedy));
        for name in Self::NAMES {
            let mut copy = *self;
            if let Some(value) = copy.number(name).filter(|value| !value.is_finite()) {
                return wrong(name, format!("{value} is not finite"), "give a finite number");
            }
        }
        if self.baseline_mm == 0.0 {
            return wrong(
                "baselineMM",
                "0 has no disparity: nothing would move or be measured".to_owned(),
                "give the distance between the imagers in mm, 75 for an OAK-D",
            );
        }
        if !(0.0..=1.0).contains(&self.confidence_threshold) {
            return wrong(
                "confidenceThreshold",
                format!("{} is not from 0 to 1", self.confidence_threshold),
                "give 1 to keep all, less to drop more",
            );
        }
        for (name, value) in [
            ("focalLengthPixel", self.focal_length_px),
            ("maxDisparityPixel", self.max_disparity_px),
            ("sensorSizePixel", self.sensor_size_px),
        ] {
            if value <= 0.0 {
                return wrong(
                    name,
                    format!("{value} is not above 0"),
                    "give a positive number of pixels",
                );
            }
        }
        if self.min_distance_m < 0.0 {
            return wrong(
                "minDistance",
                format!("{} m is below 0", self.min_distance_m),
                "give 0 or more",
            );
        }
        if self.max_distance_m < self.min_distance_m {
            let (min, max) = (self.min_distance_m, self.max_distance_m);
            return wrong(
                "maxDistance",
                format!("{max} m is less than the minDistance of {min} m"),
                "give a greater one",
            );
        }
        if self.noise_mean_px < 0.0 {
            return wrong(
                "noiseMean",
                format!(
                    "{} is below 0, and it is the step of disparity",
                    self.noise_mean_px
                ),
                "give a positive step, or 0 for neither steps nor jitter",
            );
        }
        if self.noise_sigma_px < 0.0 {
            return wrong(
                "noiseSigma",
                format!(
                    "{} is below 0, and it is a standard deviation",
                    self.noise_sigma_px
                ),
                "give 0 or more",
            );
        }
        if self.noise_downscale_factor_px < 1.0 {
            return wrong(
                "noiseDownscaleFactorPixel",
                format!("{} is below 1", self.noise_downscale_factor_px),
                "give the side of a patch of noise in pixels, 1 or more",
            );
        }
        if self.outlier_removal_range_px > MAX_OUTLIER_RANGE_PX {
            return wrong(
                "outlierRemovalEnabled",
                format!(
                    "{} px is over {MAX_OUTLIER_RANGE_PX}",
                    self.outlier_removal_range_px
                ),
                "give a smaller range; 3 is Isaac Sim 5.1's default",
            );
        }
        Ok(())
    }
}

fn switch(name: &str, value: &str) -> Result<bool, ParameterError> {
    match value {
        "true" | "1" => Ok(true),
        "false" | "0" => Ok(false),
        _ => Err(ParameterError::new(
            name,
            format!("'{value}' is not true or false"),
            "give true or false",
        )),
    }
}

fn whole(name: &str, value: &str, remedy: &str) -> Result<u32, ParameterError> {
    let wrong = |_| ParameterError::new(name, format!("'{value}' is no whole number from 0"), remedy);
    value.trim().parse().map_err(wrong)
}

#[cfg(test)]
mod tests;
