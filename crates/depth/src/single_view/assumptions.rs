use std::fmt;

use oaktwin_base::parameter::{Platform, choice, parameters};

choice! {
    /// The source of the reported depth.
    Depth {
        /// The rendered depth; disparity only moves the sample. In the vendor's images every valid pixel of a face at one
        /// depth has one value.
        Carried = "carried",
        /// The depth of the quantized and jittered disparity; a disparity of 0 or less is invalid.
        Recomputed = "recomputed",
    }
}

choice! {
    /// The pixels that `maxDisparityPixel` is measured in.
    MaxDisparityUnit {
        /// Pixels of the rendered image, as for the noise.
        Rendered = "rendered",
        /// Pixels of the simulated sensor, `sensorSizePixel` wide.
        Sensor = "sensor",
    }
}

choice! {
    /// The treatment of a disparity above `maxDisparityPixel`.
    MaxDisparity {
        /// It is invalid: "higher values allow the sensor to resolve closer objects".
        Drop = "drop",
        /// It is clamped.
        Clamp = "clamp",
    }
}

choice! {
    /// The step that drops depths outside `minDistance` to `maxDistance`.
    RangeCut {
        /// Before samples move: surfaces out of range hide nothing.
        Before = "before",
        /// After samples have moved, by the reported depth.
        After = "after",
    }
}

choice! {
    /// The direction in which a positive baseline moves samples.
    Direction {
        /// Toward larger x: holes open on the left, as in the vendor's images.
        Right = "right",
        /// Toward smaller x.
        Left = "left",
    }
}

choice! {
    /// The rounding of a sample's shift to whole pixels.
    TargetRounding {
        /// To the nearest, halves to even.
        Nearest = "nearest",
        /// Down.
        Floor = "floor",
    }
}

choice! {
    /// The sample that stays where several land on one pixel.
    Collision {
        /// The nearest by reported depth; of equal ones one with confidence, then the leftmost of the input.
        Nearest = "nearest",
        /// The rightmost of the input.
        Last = "last",
    }
}

choice! {
    /// The pixel at which confidence is computed.
    ConfidenceAt {
        /// The pixel that the sample comes from.
        Source = "source",
        /// The pixel that the sample lands on, in the unmoved colour image.
        Target = "target",
    }
}

choice! {
    /// The samples that are kept, by saturated Sobel magnitude s and `confidenceThreshold` t.
    ConfidenceComparison {
        /// s ≥ 1 − t: lower thresholds reject more smooth surface, 1 keeps all.
        Complement = "complement",
        /// s > 1 − t.
        Strict = "strict",
        /// t·s ≥ t, as the documentation words it: only saturated edges for any t.
        Literal = "literal",
    }
}

choice! {
    /// The weights of red, green and blue in luma, of non-linear sRGB values.
    Luma {
        /// ITU-R BT.709: 0.2126, 0.7152, 0.0722.
        Rec709 = "rec709",
        /// ITU-R BT.601: 0.299, 0.587, 0.114.
        Rec601 = "rec601",
        /// One third each.
        Mean = "mean",
    }
}

choice! {
    /// The rounding of luma before Sobel.
    LumaRounding {
        /// To whole levels of 8 bits: surfaces whose shade changes slowly have contour lines, and nothing between them.
        EightBit = "8-bit",
        /// None: a step of one colour channel is a step of luma.
        None = "none",
    }
}

choice! {
    /// The quantization of disparity to steps of `noiseMean`.
    Quantizer {
        /// To the nearest step, halves to even.
        Round = "round",
        /// Down.
        Floor = "floor",
    }
}

choice! {
    /// The unit of `noiseSigma`.
    SigmaUnit {
        /// Pixels of the rendered image.
        Px = "px",
        /// Steps of `noiseMean`.
        Steps = "steps",
    }
}

choice! {
    /// The colour and the position of invalid pixels.
    Invalid {
        /// 0.
        Zero = "zero",
        /// Positions are NaN, colours 0.
        Nan = "nan",
        /// The input's values at that pixel.
        Input = "input",
    }
}

choice! {
    /// The neighbourhood of outlier removal.
    OutlierNeighbourhood {
        /// A square: the greater of the distances along x and y is within the range.
        Eight = "8",
        /// A diamond: the sum of both distances is within the range.
        Four = "4",
    }
}

parameters! {
    /// The choices that public documentation leaves open. The defaults fit NVIDIA's wording and the vendor's published images
    /// best.
    pub struct Assumptions("the single-view assumptions", platform) {
        /// The source of the reported depth.
        depth: Depth = Depth::default() => ("depth".chosen("NVIDIA's wording and the vendor's images")),
        /// The pixels that `maxDisparityPixel` is measured in.
        max_disparity_unit: MaxDisparityUnit = MaxDisparityUnit::default() => ("max-disparity-unit".chosen("NVIDIA's wording and the vendor's images")),
        /// The treatment of a disparity above `maxDisparityPixel`.
        max_disparity: MaxDisparity = MaxDisparity::default() => ("max-disparity".chosen("NVIDIA's wording and the vendor's images")),
        /// The step that drops depths outside `minDistance` to `maxDistance`.
        range_cut: RangeCut = RangeCut::default() => ("range-cut".chosen("NVIDIA's wording and the vendor's images")),
        /// The direction in which a positive baseline moves samples.
        direction: Direction = Direction::default() => ("direction".chosen("NVIDIA's wording and the vendor's images")),
        /// The rounding of a sample's shift to whole pixels.
        target_rounding: TargetRounding = TargetRounding::default() => ("target-rounding".chosen("NVIDIA's wording and the vendor's images")),
        /// The sample that stays where several land on one pixel.
        collision: Collision = Collision::default() => ("collision".chosen("NVIDIA's wording and the vendor's images")),
        /// The pixel at which confidence is computed.
        confidence_at: ConfidenceAt = ConfidenceAt::default() => ("confidence-at".chosen("NVIDIA's wording and the vendor's images")),
        /// The samples that are kept, by saturated Sobel magnitude s and `confidenceThreshold` t.
        confidence_comparison: ConfidenceComparison = ConfidenceComparison::default() => ("confidence-comparison".chosen("NVIDIA's wording and the vendor's images")),
        /// The factor of Sobel's magnitude, of kernels (1 2 1) and (−1 0 1) on luma from 0 to 1, before it saturates. With the
        /// default of 255/8, luma that rises by one 8-bit level per pixel has full confidence. In the vendor's images, a step
        /// of one level is measured along edges at the sheet's threshold of 0.8, and also at its corners at Isaac Sim's
        /// 0.95, which requires 17 to 36.
        sobel_gain: f64 = 255.0 / 8.0 => ("sobel-gain".range(1e-3..=1e6).typical(1.0..=128.0).chosen("the vendor's images")),
        /// The standard deviation of noise that is added to luma before Sobel, in 8-bit levels. 1 fills smooth faces, as in
        /// an image with the grain of a path tracer; the vendor's images have none.
        grain_levels: f64 = 0.0 => ("grain".unit("8-bit levels").range(0.0..=255.0).typical(0.0..=8.0).chosen("the vendor's images")),
        /// The weights of red, green and blue in luma, of non-linear sRGB values.
        luma: Luma = Luma::default() => ("luma".chosen("NVIDIA's wording and the vendor's images")),
        /// The rounding of luma before Sobel.
        luma_rounding: LumaRounding = LumaRounding::default() => ("luma-rounding".chosen("the vendor's images")),
        /// The quantization of disparity to steps of `noiseMean`.
        quantizer: Quantizer = Quantizer::default() => ("quantizer".chosen("NVIDIA's wording and the vendor's images")),
        /// The unit of `noiseSigma`.
        sigma_unit: SigmaUnit = SigmaUnit::default() => ("sigma-unit".chosen("NVIDIA's wording and the vendor's images")),
        /// The colour and the position of invalid pixels.
        invalid: Invalid = Invalid::default() => ("invalid".chosen("NVIDIA's wording and the vendor's images")),
        /// The neighbourhood of outlier removal.
        outlier_neighbourhood: OutlierNeighbourhood = OutlierNeighbourhood::default() => ("outlier-neighbourhood".chosen("NVIDIA's wording and the vendor's images")),
    }
}

impl Default for Assumptions {
    fn default() -> Self {
        Self::defaults(Platform::default())
    }
}

/// `name=value` of all, separated by spaces.
impl fmt::Display for Assumptions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all: Vec<String> = self
            .by_name()
            .map(|(name, value)| format!("{name}={value}"))
            .collect();
        f.write_str(&all.join(" "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_and_reads_every_assumption() {
        let mut assumptions = Assumptions::default();
        for (name, value) in Assumptions::default().by_name() {
            assumptions.set(name, &value).unwrap();
        }
        assert_eq!(assumptions, Assumptions::default());
        assumptions.set("depth", "recomputed").unwrap();
        assumptions.set("sobel-gain", "0.25").unwrap();
        assert_eq!(assumptions.depth, Depth::Recomputed);
        assert_eq!(assumptions.get("sobel-gain").unwrap(), "0.25");
        assert!(
            assumptions
                .to_string()
                .starts_with("depth=recomputed max-disparity-unit=rendered ")
        );
    }

    #[test]
    fn errors_list_the_expected_values() {
        let mut assumptions = Assumptions::default();
        let mut error = |name, value| assumptions.set(name, value).unwrap_err().to_string();
        assert_eq!(
            error("depht", "carried"),
            "depht: unknown parameter of the single-view assumptions; did you mean 'depth'?"
        );
        assert_eq!(
            error("depth", "carry"),
            "depth: invalid value 'carry'; expected carried or recomputed"
        );
        assert_eq!(
            error("sobel-gain", "much"),
            "sobel-gain: invalid value 'much'; expected a number from 0.001 to 1000000"
        );
        assert_eq!(
            error("sobel-gain", "NaN"),
            "sobel-gain: must not be NaN; expected a number from 0.001 to 1000000"
        );
    }
}
