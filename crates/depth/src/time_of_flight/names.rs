//! Parameters by name, for command lines and presets.

use super::parameters::{INDOOR_E, OUTDOOR_E, Parameters};
use crate::choice;
use crate::named::{self, Named, field, flag, put, text};

const TABLE: [Named<Parameters>; 28] = [
    field!("focalLength", focal_length_px, "give pixels, 457"),
    field!("width", width_px, "give whole pixels, 640"),
    Named {
        name: "principalPoint",
        get: |p| {
            p.principal_point_px
                .map_or_else(|| "center".to_owned(), |[x, y]| format!("{x},{y}"))
        },
        set: |p, value| {
            p.principal_point_px = match value {
                "center" => None,
                pair => Some(numbers(pair)?),
            };
            Some(())
        },
        values: "give center, or two numbers of pixels, 320,240",
    },
    Named {
        name: "modulationFrequencies",
        get: |p| {
            let [low, high] = p.frequencies_mhz;
            format!("{low},{high}")
        },
        set: |p, value| numbers(value).map(|pair| p.frequencies_mhz = pair),
        values: "give two numbers of MHz, 80,100",
    },
    flag!("enablePhaseUnwrapping", enable_phase_unwrapping),
    field!(
        "phaseUnwrappingLevel",
        phase_unwrapping_level,
        "give a whole number, 0 to 5"
    ),
    field!(
        "phaseUnwrapErrorThreshold",
        phase_unwrap_error_threshold,
        "give whole millimetres, 100"
    ),
    flag!(
        "enablePhaseShuffleTemporalFilter",
        enable_phase_shuffle_temporal_filter
    ),
    flag!("enableBurstMode", enable_burst_mode),
    flag!("enableOpticalCorrection", enable_optical_correction),
    flag!("enableWiggleCorrection", enable_wiggle_correction),
    field!("wiggling", wiggling, "give a fraction, 0 to 0.5"),
    field!("wigglingResidual", wiggling_residual, "give a fraction, 0 to 0.5"),
    flag!("enableFPPNCorrection", enable_fppn_correction),
    field!("fixedPattern", fixed_pattern_m, "give metres, 0.01"),
    field!("bias", bias_m, "give metres, 0.001"),
    field!("signal", signal_e, "give electrons, 3000"),
    field!("contrast", contrast, "give a fraction, 0 to 1"),
    Named {
        name: "ambient",
        get: |p| text(&p.ambient_e),
        set: |p, value| match value {
            "indoor" => put(&mut p.ambient_e, &INDOOR_E.to_string()),
            "outdoor" => put(&mut p.ambient_e, &OUTDOOR_E.to_string()),
            _ => put(&mut p.ambient_e, value),
        },
        values: "give indoor, outdoor, or electrons",
    },
    field!("readNoise", read_noise_e, "give electrons, 5"),
    field!("fullWell", full_well_e, "give electrons, 135000"),
    field!("albedo", albedo, "give a fraction, 0 to 1"),
    field!("pixelMixing", pixel_mixing, "give a fraction, 0 to 0.25"),
    field!("multipath", multipath, "give a factor, 0 to 10"),
    field!("radialVelocity", radial_velocity_m_s, "give metres a second"),
    field!(
        "measurementInterval",
        measurement_interval_s,
        "give seconds, 0.0167"
    ),
    field!("minAmplitude", min_amplitude_e, "give electrons, 5"),
    field!("confidenceThreshold", confidence_threshold, "give a number, 0.1"),
];

named::by_name!(Parameters, TABLE, |name| {
    choice::unknown(name, "parameter of time-of-flight", &NAMES)
});

/// Two numbers with a comma between.
fn numbers(pair: &str) -> Option<[f64; 2]> {
    let (a, b) = pair.split_once(',')?;
    Some([a.trim().parse().ok()?, b.trim().parse().ok()?])
}
