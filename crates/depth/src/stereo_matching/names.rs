//! Parameters by name, for command lines and presets.

use super::parameters::Parameters;
use crate::ParameterError;
use crate::named::{self, Named, field, flag, one_of, subpixel, subpixel_bits, text};
use crate::preset::Platform;

const TABLE: [Named<Parameters>; 57] = [
    field!("focalLength", stereo.focal_length_px, "give pixels, 800"),
    field!("baseline", stereo.baseline_m, "give metres, 0.075"),
    field!("width", width_px, "give whole pixels, 1280"),
    subpixel!("subpixel", subpixel),
    subpixel_bits!("subpixelFractionalBits", subpixel),
    one_of!(
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
    one_of!(
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
    one_of!(
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
    field!("blockSize", block_size_px, "give 1, 3, 5 or 7"),
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
    one_of!("depthRounding", depth_rounding, "give nearest or truncate"),
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

named::by_name!(Parameters, TABLE, unknown);

fn unknown(name: &str) -> ParameterError {
    named::unknown("stereo-matching", name, &NAMES)
}

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
    let own = named::find(&TABLE, name, unknown).ok()?.name;
    if RVC2_ONLY.contains(&own) {
        Some(Platform::Rvc2)
    } else if RVC4_ONLY.contains(&own) {
        Some(Platform::Rvc4)
    } else {
        None
    }
}
