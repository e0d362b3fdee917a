//! Parameters by name, for command lines and presets.

use super::parameters::Parameters;
use crate::ParameterError;
use crate::choice::Choice;
use crate::disparity::{DepthRounding, Subpixel};
use crate::named::{self, Named, field, flag, text};
use crate::preset::Platform;

/// One of a few names.
macro_rules! named {
    ($name:literal, $field:ident, $values:literal) => {
        Named {
            name: $name,
            get: |p| p.$field.text().to_owned(),
            set: |p, value| pick(value).map(|value| p.$field = value),
            values: $values,
        }
    };
}

const TABLE: [Named<Parameters>; 56] = [
    field!("focalLength", stereo.focal_length_px, "give pixels, 800"),
    field!("baseline", stereo.baseline_m, "give metres, 0.075"),
    field!("width", width_px, "give whole pixels, 1280"),
    Named {
        name: "subpixel",
        get: |p| text(&(p.subpixel != Subpixel::Off)),
        set: |p, value| {
            match (named::switch(value)?, p.subpixel) {
                (false, _) => p.subpixel = Subpixel::Off,
                (true, Subpixel::Off) => p.subpixel = Subpixel::default(),
                (true, _) => {}
            }
            Some(())
        },
        values: "give true or false",
    },
    Named {
        name: "subpixelFractionalBits",
        get: |p| text(&p.subpixel.bits()),
        set: |p, value| {
            p.subpixel = match value.parse().ok()? {
                0 => Subpixel::Off,
                3 => Subpixel::Bits3,
                4 => Subpixel::Bits4,
                5 => Subpixel::Bits5,
                _ => return None,
            };
            Some(())
        },
        values: "give 0, 3, 4 or 5",
    },
    named!(
        "subpixelInterpolation",
        interpolation,
        "give LINES, PARABOLA_5 or PARABOLA"
    ),
    flag!("extendedDisparity", extended_disparity),
    field!("disparityShift", disparity_shift_px, "give whole pixels"),
    flag!("leftRightCheck", left_right_check),
    field!(
        "leftRightCheckThreshold",
        left_right_check_threshold_px,
        "give whole pixels, 0 to 128"
    ),
    field!(
        "confidenceThreshold",
        confidence_threshold,
        "give a whole number, 0 (keep all) to 255"
    ),
    field!("numInvalidateEdgePixels", invalid_edge_px, "give whole pixels"),
    named!(
        "kernelSize",
        kernel_size,
        "give AUTO, KERNEL_5x5, KERNEL_7x7 or KERNEL_7x9"
    ),
    Named {
        name: "kernelMask",
        get: |p| format!("{:#X}", p.kernel_mask),
        set: |p, value| {
            let digits = value.strip_prefix("0x").or_else(|| value.strip_prefix("0X"));
            p.kernel_mask = match digits {
                Some(digits) => u64::from_str_radix(digits, 16).ok()?,
                None => value.parse().ok()?,
            };
            Some(())
        },
        values: "give bits, 0xA82415, or 0 for DepthAI's choice",
    },
    flag!("enableMeanMode", mean_mode),
    field!(
        "censusTransform.threshold",
        census_threshold,
        "give whole grey levels"
    ),
    field!(
        "noiseThresholdOffset",
        noise_threshold_offset,
        "give whole grey levels"
    ),
    field!(
        "noiseThresholdScale",
        noise_threshold_scale,
        "give a whole number"
    ),
    named!(
        "disparityWidth",
        disparity_width,
        "give DISPARITY_64 or DISPARITY_96"
    ),
    flag!("enableCompanding", companding),
    field!("alpha", alpha, "give a whole number, 0 to 255"),
    field!("beta", beta, "give a whole number, 0 to 255"),
    field!(
        "linearEquationParameters.threshold",
        cost_threshold,
        "give a whole number, 1 to 127"
    ),
    field!("divisionFactor", division_factor, "give a whole number, 1 to 255"),
    Named {
        name: "platform",
        get: |p| p.platform.name().to_owned(),
        set: |p, value| {
            let known = [Platform::Rvc2, Platform::Rvc4];
            p.platform = known.into_iter().find(|known| known.name() == value)?;
            Some(())
        },
        values: "give RVC2 or RVC4",
    },
    field!("horizontalPenaltyCostP1", horizontal_p1, "give a whole number"),
    field!("horizontalPenaltyCostP2", horizontal_p2, "give a whole number"),
    field!("verticalPenaltyCostP1", vertical_p1, "give a whole number"),
    field!("verticalPenaltyCostP2", vertical_p2, "give a whole number"),
    field!("penaltyShift", penalty_shift, "give whole bits, 0 to 15"),
    flag!("p1Config.enableAdaptive", p1.adaptive),
    field!("p1Config.defaultValue", p1.default, "give a whole number"),
    field!("p1Config.edgeValue", p1.edge, "give a whole number"),
    field!("p1Config.smoothValue", p1.smooth, "give a whole number"),
    flag!("p2Config.enableAdaptive", p2.adaptive),
    field!("p2Config.defaultValue", p2.default, "give a whole number"),
    field!("p2Config.edgeValue", p2.edge, "give a whole number"),
    field!("p2Config.smoothValue", p2.smooth, "give a whole number"),
    field!("edgeThreshold", edge_threshold, "give whole grey levels"),
    field!("smoothThreshold", smooth_threshold, "give whole grey levels"),
    field!(
        "occlusionConfidenceWeight",
        confidence_metrics.occlusion_weight,
        "give a whole number, 0 to 32"
    ),
    field!(
        "motionVectorConfidenceWeight",
        confidence_metrics.motion_vector_weight,
        "give a whole number, 0 to 32"
    ),
    field!(
        "motionVectorConfidenceThreshold",
        confidence_metrics.motion_vector_threshold,
        "give a whole number, 0 to 3"
    ),
    field!(
        "flatnessConfidenceWeight",
        confidence_metrics.flatness_weight,
        "give a whole number, 0 to 32"
    ),
    field!(
        "flatnessConfidenceThreshold",
        confidence_metrics.flatness_threshold,
        "give a whole number, 1 to 7"
    ),
    flag!("flatnessOverride", confidence_metrics.flatness_override),
    flag!("holeFilling.enable", hole_filling.enable),
    field!(
        "holeFilling.highConfidenceThreshold",
        hole_filling.high_confidence_threshold,
        "give a whole number, 1 to 255"
    ),
    field!(
        "holeFilling.fillConfidenceThreshold",
        hole_filling.fill_confidence_threshold,
        "give a whole number, 1 to 255"
    ),
    field!(
        "holeFilling.minValidDisparity",
        hole_filling.min_valid_disparity,
        "give 1 (a half), 2 (a quarter) or 3 (an eighth)"
    ),
    flag!(
        "holeFilling.invalidateDisparities",
        hole_filling.invalidate_disparities
    ),
    flag!("adaptiveMedianFilter.enable", adaptive_median.enable),
    field!(
        "adaptiveMedianFilter.confidenceThreshold",
        adaptive_median.confidence_threshold,
        "give a whole number, 0 to 255"
    ),
    field!("paths", paths, "give 3, 4, 5, 6 or 8"),
    Named {
        name: "depthRounding",
        get: |p| {
            match p.depth_rounding {
                DepthRounding::Nearest => "nearest",
                DepthRounding::Truncate => "truncate",
            }
            .to_owned()
        },
        set: |p, value| {
            p.depth_rounding = match value {
                "nearest" => DepthRounding::Nearest,
                "truncate" => DepthRounding::Truncate,
                _ => return None,
            };
            Some(())
        },
        values: "give nearest or truncate",
    },
    Named {
        name: "confidenceThresholdV2",
        get: |p| text(&p.confidence_threshold_v2()),
        set: |p, value| {
            p.set_confidence_threshold_v2(value.parse().ok()?);
            Some(())
        },
        values: "give a whole number, 0 to 255 (keep all)",
    },
];

/// The names of all parameters: `DepthAI`'s where it has one.
pub const NAMES: [&str; TABLE.len()] = named::names(&TABLE);

/// Those that count on one platform only.
const RVC2_ONLY: [&str; 5] = [
    "horizontalPenaltyCostP1",
    "horizontalPenaltyCostP2",
    "verticalPenaltyCostP1",
    "verticalPenaltyCostP2",
    "penaltyShift",
];
const RVC4_ONLY: [&str; 23] = [
    "p1Config.enableAdaptive",
    "p1Config.defaultValue",
    "p1Config.edgeValue",
    "p1Config.smoothValue",
    "p2Config.enableAdaptive",
    "p2Config.defaultValue",
    "p2Config.edgeValue",
    "p2Config.smoothValue",
    "edgeThreshold",
    "smoothThreshold",
    "occlusionConfidenceWeight",
    "motionVectorConfidenceWeight",
    "motionVectorConfidenceThreshold",
    "flatnessConfidenceWeight",
    "flatnessConfidenceThreshold",
    "flatnessOverride",
    "holeFilling.enable",
    "holeFilling.highConfidenceThreshold",
    "holeFilling.fillConfidenceThreshold",
    "holeFilling.minValidDisparity",
    "holeFilling.invalidateDisparities",
    "adaptiveMedianFilter.enable",
    "adaptiveMedianFilter.confidenceThreshold",
];

/// The platform that a parameter counts on, by its name; none where it counts on all.
#[must_use]
pub fn platform_of(name: &str) -> Option<Platform> {
    let own = find(name).ok()?.name;
    if RVC2_ONLY.contains(&own) {
        Some(Platform::Rvc2)
    } else if RVC4_ONLY.contains(&own) {
        Some(Platform::Rvc4)
    } else {
        None
    }
}

impl Parameters {
    /// Changes one of [`NAMES`]; case, hyphens and underscores in the name do not matter.
    ///
    /// # Errors
    /// No such name, a value that is none of its kind, or out of its range. Then nothing is changed.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), ParameterError> {
        find(name)?.change(self, value, Self::check)
    }

    /// One of [`NAMES`], as [`Parameters::set`] takes it.
    ///
    /// # Errors
    /// No such name.
    pub fn get(&self, name: &str) -> Result<String, ParameterError> {
        find(name).map(|named| (named.get)(self))
    }
}

fn find(name: &str) -> Result<&'static Named<Parameters>, ParameterError> {
    named::find(&TABLE, name, || named::unknown("stereo-matching", name, &NAMES))
}

fn pick<C: Choice>(value: &str) -> Option<C> {
    C::CHOICES.iter().copied().find(|choice| choice.text() == value)
}
