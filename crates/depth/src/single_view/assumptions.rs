use std::fmt;

use crate::ParameterError;
use crate::choice;
use oaktwin_parameter::choice;

/// What public sources leave open. The defaults are what fits NVIDIA's wording and the vendor's published pictures best;
/// each has the name that [`Assumptions::set`] knows it by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assumptions {
    /// `depth`
    pub depth: Depth,
    /// `max-disparity-unit`
    pub max_disparity_unit: MaxDisparityUnit,
    /// `max-disparity`
    pub max_disparity: MaxDisparity,
    /// `range-cut`
    pub range_cut: RangeCut,
    /// `direction`
    pub direction: Direction,
    /// `target-rounding`
    pub target_rounding: TargetRounding,
    /// `collision`
    pub collision: Collision,
    /// `confidence-at`
    pub confidence_at: ConfidenceAt,
    /// `confidence-comparison`
    pub confidence_comparison: ConfidenceComparison,
    /// `sobel-gain`: what Sobel's magnitude, of kernels (1 2 1) and (−1 0 1) on luma of 0 to 1, is multiplied by before it
    /// is saturated. The default is 255/8: luma that rises by one 8-bit level a pixel is full confidence. In the vendor's
    /// pictures smooth, plainly shaded faces are measured at thresholds that a gain of 1 would empty them at.
    pub sobel_gain: f64,
    /// `grain`: the standard deviation of noise that is added to luma before Sobel, 8-bit levels. A path tracer's pictures
    /// have some, which is why a lower threshold thins smooth faces gradually; those of a noise-free renderer have none,
    /// and an evenly lit face would be dropped whole. The default is 1, an estimate; 0 adds none.
    pub grain_levels: f64,
    /// `luma`
    pub luma: Luma,
    /// `quantizer`
    pub quantizer: Quantizer,
    /// `sigma-unit`
    pub sigma_unit: SigmaUnit,
    /// `invalid`
    pub invalid: Invalid,
    /// `outlier-neighbourhood`
    pub outlier_neighbourhood: OutlierNeighbourhood,
}

choice! {
    /// Where the reported depth comes from.
    Depth {
        /// a sample keeps the depth that was rendered, disparity only moves it: every valid pixel of a face at one depth
        /// has one value in the vendor's pictures.
        Carried = "carried",
        /// from the quantized and jittered disparity; a disparity of 0 or less is no measurement.
        Recomputed = "recomputed",
    }
}

choice! {
    /// Which pixels `maxDisparityPixel` counts.
    MaxDisparityUnit {
        /// those of the rendered image, as the noise does.
        Rendered = "rendered",
        /// those of the simulated sensor, `sensorSizePixel` wide.
        Sensor = "sensor",
    }
}

choice! {
    /// What happens to a disparity above `maxDisparityPixel`.
    MaxDisparity {
        /// no measurement: "higher values allow the sensor to resolve closer objects".
        Drop = "drop",
        /// it is that disparity.
        Clamp = "clamp",
    }
}

choice! {
    /// When depths outside `minDistance` to `maxDistance` are dropped.
    RangeCut {
        /// before samples move: what is out of range hides nothing.
        Before = "before",
        /// after they moved, by the depth that is reported.
        After = "after",
    }
}

choice! {
    /// Where a positive baseline moves samples.
    Direction {
        /// toward larger x: as in the vendor's pictures, holes open on the left.
        Right = "right",
        /// toward smaller x.
        Left = "left",
    }
}

choice! {
    /// The pixel that a shift of a fraction of a pixel leads to.
    TargetRounding {
        /// the shift is rounded to whole pixels, halves to even.
        Nearest = "nearest",
        /// the shift is rounded down.
        Floor = "floor",
    }
}

choice! {
    /// Which of several samples that land on one pixel stays.
    Collision {
        /// that of the least reported depth; of equal ones that with confidence, then the leftmost of the input.
        Nearest = "nearest",
        /// the rightmost of the input.
        Last = "last",
    }
}

choice! {
    /// Where the picture's edges are looked at.
    ConfidenceAt {
        /// where a sample comes from.
        Source = "source",
        /// where it lands, in the picture that nothing moved.
        Target = "target",
    }
}

choice! {
    /// Which samples are kept, by saturated Sobel magnitude s and `confidenceThreshold` t.
    ConfidenceComparison {
        /// s ≥ 1 − t: lower thresholds reject more of what is smooth, 1 keeps all.
        Complement = "complement",
        /// s > 1 − t.
        Strict = "strict",
        /// t·s ≥ t, the documentation's words: only saturated edges, whatever t is.
        Literal = "literal",
    }
}

choice! {
    /// The weights of red, green and blue in luma, of sRGB values as they are.
    Luma {
        /// ITU-R BT.709: 0.2126, 0.7152, 0.0722.
        Rec709 = "rec709",
        /// ITU-R BT.601: 0.299, 0.587, 0.114.
        Rec601 = "rec601",
        /// a third each.
        Mean = "mean",
    }
}

choice! {
    /// How disparity is quantized to steps of `noiseMean`.
    Quantizer {
        /// to the nearest step, halves to even.
        Round = "round",
        /// to the step below.
        Floor = "floor",
    }
}

choice! {
    /// The unit of `noiseSigma`.
    SigmaUnit {
        /// pixels of the rendered image.
        Px = "px",
        /// steps of `noiseMean`.
        Steps = "steps",
    }
}

choice! {
    /// Colour and position of pixels where nothing was measured.
    Invalid {
        /// 0.
        Zero = "zero",
        /// positions NaN, colours 0.
        Nan = "nan",
        /// what the input has at that pixel.
        Input = "input",
    }
}

choice! {
    /// The neighbours that outlier removal looks at, up to its range away.
    OutlierNeighbourhood {
        /// by the greater of the distances along x and y: a square.
        Eight = "8",
        /// by their sum: a diamond.
        Four = "4",
    }
}

impl Default for Assumptions {
    fn default() -> Self {
        Self {
            depth: Depth::default(),
            max_disparity_unit: MaxDisparityUnit::default(),
            max_disparity: MaxDisparity::default(),
            range_cut: RangeCut::default(),
            direction: Direction::default(),
            target_rounding: TargetRounding::default(),
            collision: Collision::default(),
            confidence_at: ConfidenceAt::default(),
            confidence_comparison: ConfidenceComparison::default(),
            sobel_gain: 255.0 / 8.0,
            grain_levels: 1.0,
            luma: Luma::default(),
            quantizer: Quantizer::default(),
            sigma_unit: SigmaUnit::default(),
            invalid: Invalid::default(),
            outlier_neighbourhood: OutlierNeighbourhood::default(),
        }
    }
}

impl Assumptions {
    /// What [`Assumptions::set`] knows.
    pub const NAMES: &[&str] = &[
        "depth",
        "max-disparity-unit",
        "max-disparity",
        "range-cut",
        "direction",
        "target-rounding",
        "collision",
        "confidence-at",
        "confidence-comparison",
        "sobel-gain",
        "grain",
        "luma",
        "quantizer",
        "sigma-unit",
        "invalid",
        "outlier-neighbourhood",
    ];

    /// Sets one by its name and its value's name.
    ///
    /// # Errors
    /// No such assumption; no such value.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), ParameterError> {
        match name {
            "depth" => self.depth = choice::parse(name, value)?,
            "max-disparity-unit" => self.max_disparity_unit = choice::parse(name, value)?,
            "max-disparity" => self.max_disparity = choice::parse(name, value)?,
            "range-cut" => self.range_cut = choice::parse(name, value)?,
            "direction" => self.direction = choice::parse(name, value)?,
            "target-rounding" => self.target_rounding = choice::parse(name, value)?,
            "collision" => self.collision = choice::parse(name, value)?,
            "confidence-at" => self.confidence_at = choice::parse(name, value)?,
            "confidence-comparison" => self.confidence_comparison = choice::parse(name, value)?,
            "sobel-gain" => self.sobel_gain = choice::number(name, value)?,
            "grain" => self.grain_levels = choice::number(name, value)?,
            "luma" => self.luma = choice::parse(name, value)?,
            "quantizer" => self.quantizer = choice::parse(name, value)?,
            "sigma-unit" => self.sigma_unit = choice::parse(name, value)?,
            "invalid" => self.invalid = choice::parse(name, value)?,
            "outlier-neighbourhood" => self.outlier_neighbourhood = choice::parse(name, value)?,
            _ => return Err(choice::unknown(name, "assumption of single-view", Self::NAMES)),
        }
        Ok(())
    }

    /// The value of one as [`Assumptions::set`] takes it; `None` where there is no such assumption.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<String> {
        let value = match name {
            "depth" => self.depth.name(),
            "max-disparity-unit" => self.max_disparity_unit.name(),
            "max-disparity" => self.max_disparity.name(),
            "range-cut" => self.range_cut.name(),
            "direction" => self.direction.name(),
            "target-rounding" => self.target_rounding.name(),
            "collision" => self.collision.name(),
            "confidence-at" => self.confidence_at.name(),
            "confidence-comparison" => self.confidence_comparison.name(),
            "sobel-gain" => return Some(self.sobel_gain.to_string()),
            "grain" => return Some(self.grain_levels.to_string()),
            "luma" => self.luma.name(),
            "quantizer" => self.quantizer.name(),
            "sigma-unit" => self.sigma_unit.name(),
            "invalid" => self.invalid.name(),
            "outlier-neighbourhood" => self.outlier_neighbourhood.name(),
            _ => return None,
        };
        Some(value.to_owned())
    }

    pub(super) fn check(&self) -> Result<(), ParameterError> {
        let (gain, grain) = (self.sobel_gain, self.grain_levels);
        if !(gain.is_finite() && gain > 0.0) {
            return Err(ParameterError::new(
                "sobel-gain",
                format!("{gain} is not above 0"),
                "give a positive number; 31.875 is the default",
            ));
        }
        if !(0.0..=255.0).contains(&grain) {
            return Err(ParameterError::new(
                "grain",
                format!("{grain} is not from 0 to 255"),
                "give a number of 8-bit levels; 1 is the default, 0 adds none",
            ));
        }
        Ok(())
    }
}

/// `name=value` of all, separated by spaces.
impl fmt::Display for Assumptions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, name) in Self::NAMES.iter().enumerate() {
            let space = if i == 0 { "" } else { " " };
            write!(f, "{space}{name}={}", self.get(name).unwrap_or_default())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_set_and_read() {
        let mut assumptions = Assumptions::default();
        for name in Assumptions::NAMES {
            let value = assumptions.get(name).unwrap();
            assumptions.set(name, &value).unwrap();
        }
        assert_eq!(assumptions, Assumptions::default());
        assumptions.set("depth", "recomputed").unwrap();
        assumptions.set("sobel-gain", "0.25").unwrap();
        assert_eq!(assumptions.depth, Depth::Recomputed);
        assert_eq!(assumptions.get("sobel-gain").as_deref(), Some("0.25"));
        assert!(
            assumptions
                .to_string()
                .starts_with("depth=recomputed max-disparity-unit=rendered ")
        );
    }

    #[test]
    fn errors_say_what_there_is() {
        let mut assumptions = Assumptions::default();
        let says = |error: Result<(), ParameterError>| error.unwrap_err().to_string();
        assert_eq!(
            says(assumptions.set("depht", "carried")),
            "depht: no such assumption of single-view; did you mean depth?"
        );
        assert_eq!(
            says(assumptions.set("depth", "carry")),
            "depth: 'carry' is none of its values; give one of carried, recomputed"
        );
        assert_eq!(
            says(assumptions.set("sobel-gain", "much")),
            "sobel-gain: 'much' is no number; give a number, 0.25 for one"
        );
        assumptions.set("sobel-gain", "NaN").unwrap();
        assert_eq!(
            says(assumptions.check()),
            "sobel-gain: NaN is not above 0; give a positive number; 31.875 is the default"
        );
    }
}
