use super::{Parameters, STEREO};
use crate::disparity::Subpixel;
use crate::preset::Platform;

fn parameters() -> Parameters {
    Parameters::new(Platform::Rvc2, STEREO, 1280)
}

#[test]
fn each_name_changes_what_it_reads() {
    let values = [
        "572.5", "0.15", "640", "false", "4", "true", "12", "false", "false", "5", "245", "3", "0.1", "3",
        "2.5", "0.25", "-0.22", "0.2", "0.08", "0.5", "9", "truncate",
    ];
    for (name, value) in Parameters::names().into_iter().zip(values) {
        let mut p = parameters();
        assert_ne!(p.get(name).unwrap(), value, "{name}");
        p.set(name, value).unwrap();
        assert_eq!(p.get(name).unwrap(), value, "{name}");
        assert_ne!(p, parameters());
    }
}

#[test]
fn names_ignore_hyphens_and_misspelt_ones_are_suggested() {
    let mut p = parameters();
    p.set("subpixel-fractional-bits", "3").unwrap();
    assert_eq!(p.subpixel, Subpixel::Bits3);
    p.set("subpixel", "true").unwrap();
    assert_eq!(p.subpixel, Subpixel::Bits3);
    p.set("subpixel", "0").unwrap();
    p.set("subpixel", "1").unwrap();
    assert_eq!(p.subpixel, Subpixel::Bits5);
    assert_eq!(
        p.set("jiter", "1").unwrap_err().to_string(),
        "jiter: unknown parameter of stereo-noise; did you mean 'jitter'?"
    );
    assert!(p.get("").is_err());
}

#[test]
fn invalid_values_change_nothing() {
    let mut p = parameters();
    let invalid = [
        ("subpixelFractionalBits", "2"),
        ("subpixel", "maybe"),
        ("confidenceThreshold", "256"),
        ("window", "8"),
        ("baseline", "75"),
        ("jitter", "NaN"),
        ("jitter", "inf"),
        ("jitter", "-0.1"),
        ("dropout", ""),
        ("disparityShift", "-1"),
        ("depthRounding", "up"),
    ];
    for (name, value) in invalid {
        assert_eq!(p.set(name, value).unwrap_err().name, name, "{name}={value}");
    }
    assert_eq!(p, parameters());
    p.stereo.baseline_m = 0.0;
    p.set("jitter", "0.1").unwrap();
    assert!(p.check().is_err());
}

#[test]
fn the_range_of_disparities() {
    let mut p = parameters();
    assert_eq!((p.max_disparity_px(), p.max_fixed_disparity()), (95, 3040));
    p.disparity_shift_px = 10;
    assert_eq!((p.max_disparity_px(), p.max_fixed_disparity()), (105, 3040));
    p.extended_disparity = true;
    assert_eq!((p.max_disparity_px(), p.max_fixed_disparity()), (210, 6400));
    p.disparity_shift_px = 1024;
    assert!(p.check().is_ok() && p.max_fixed_disparity() < 1 << 16);
}

#[test]
fn rejects_parameters_out_of_range() {
    let error = |change: fn(&mut Parameters)| {
        let mut p = parameters();
        change(&mut p);
        p.check().unwrap_err().to_string()
    };
    assert!(parameters().check().is_ok());
    assert_eq!(
        error(|p| p.stereo.focal_length_px = 0.0),
        "focalLength: 0 is out of range; expected a number from 1 to 100000 px"
    );
    assert_eq!(
        error(|p| p.stereo.baseline_m = 75.0),
        "baseline: 75 is out of range; expected a number from 0.0001 to 2 m"
    );
    assert_eq!(
        error(|p| p.jitter_px = f64::NAN),
        "jitter: must not be NaN; expected a number from 0 to 10 px"
    );
    assert_eq!(
        error(|p| p.bias_px = f64::NEG_INFINITY),
        "bias: -inf is out of range; expected a number from -10 to 10 px"
    );
    assert_eq!(
        error(|p| p.window_px = 6),
        "window: invalid value '6'; expected 1, 3, … 63 px"
    );
    assert!(error(|p| p.stereo.baseline_m = -0.075).starts_with("baseline: -0.075 is out of range"));
    assert!(error(|p| p.dropout = 1.01).starts_with("dropout: 1.01 is out of range"));
    assert!(error(|p| p.width_px = 0).starts_with("width: 0 is out of range"));
    assert!(error(|p| p.left_right_check_threshold_px = 129).starts_with("leftRightCheckThreshold"));
}
