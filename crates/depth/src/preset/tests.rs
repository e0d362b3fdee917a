use super::*;
use crate::filter::Filter;
use crate::stereo_noise::Subpixel;

fn texts(filters: &[Filter]) -> Vec<String> {
    filters.iter().map(ToString::to_string).collect()
}

#[test]
fn the_default_of_rvc2() {
    let config = StereoConfig::preset(Platform::Rvc2, "default").unwrap();
    assert_eq!(config.subpixel, Subpixel::Bits3);
    assert_eq!(config.confidence_threshold, 15);
    assert_eq!(
        texts(&config.filters()),
        [
            "brightness:min=0,max=256",
            "decimation:factor=2,mode=PIXEL_SKIPPING",
            "median:size=7",
            "speckle:range=200,difference=2",
            "spatial:alpha=0.5,delta=3,radius=1,iterations=1",
            "temporal:alpha=0.5,delta=3,persistency=VALID_2_IN_LAST_4",
            "threshold:min=0,max=15000",
        ]
    );
}

#[test]
fn presets_match_depthai() {
    let rvc2 = |name: &str| StereoConfig::preset(Platform::Rvc2, name).unwrap();
    assert!(rvc2("FACE").extended_disparity && rvc2("HIGH_DETAIL").extended_disparity);
    assert_eq!(rvc2("HIGH_DETAIL").confidence_threshold, 55);
    assert_eq!(rvc2("HIGH_DETAIL").left_right_check_threshold, Some(5));
    assert_eq!(rvc2("ROBOTICS").temporal, None);
    assert_eq!(rvc2("FAST_ACCURACY"), rvc2("ACCURACY"));
    assert_eq!(rvc2("HIGH_DENSITY"), rvc2("FAST_DENSITY"));
    let rvc4 = |name: &str| StereoConfig::preset(Platform::Rvc4, name).unwrap();
    assert_eq!(rvc4("DEFAULT"), rvc4("FAST_DENSITY"));
    assert_eq!(
        texts(&rvc4("DEFAULT").filters()),
        ["median:size=5", "speckle:range=200,difference=2"]
    );
    assert_eq!(rvc4("FACE").confidence_threshold, 97);
    assert!(rvc4("FACE").extended_disparity && rvc4("DENSITY").extended_disparity);
}

#[test]
fn every_named_preset_has_valid_filters() {
    for platform in [Platform::Rvc2, Platform::Rvc4] {
        for name in Preset::names_on(platform) {
            let config = StereoConfig::preset(platform, name).unwrap();
            assert!(config.filters().iter().all(|filter| filter.check().is_ok()));
        }
    }
    for name in TIME_OF_FLIGHT_PRESETS {
        let filters = time_of_flight_filters(name).unwrap();
        assert!(!filters.is_empty() && filters.iter().all(|filter| filter.check().is_ok()));
    }
}

#[test]
fn unknown_names_are_reported_with_the_valid_ones() {
    let error = |platform, name| StereoConfig::preset(platform, name).unwrap_err().to_string();
    assert_eq!(
        error(Platform::Rvc4, "HIGH_ACCURACY"),
        "preset: HIGH_ACCURACY is a preset of RVC2, not of RVC4; use one of DEFAULT, FACE, HIGH_DETAIL, ROBOTICS, \
         ACCURACY, DENSITY, FAST_ACCURACY, FAST_DENSITY"
    );
    assert_eq!(
        error(Platform::Rvc2, "ROBOTIC"),
        "preset: unknown preset 'ROBOTIC' of RVC2; did you mean 'ROBOTICS'?"
    );
    assert!(error(Platform::Rvc2, "TOF_LOW_RANGE").contains("time-of-flight"));
    assert!(time_of_flight_filters("FACE").is_err());
}
