use super::parameters;
use crate::preset::{Platform, StereoConfig};
use crate::stereo_matching::{Parameters, platform_of};

#[test]
fn sets_and_reads_every_parameter() {
    for name in Parameters::names() {
        let mut p = parameters();
        let now = p.get(name).unwrap();
        let other = match now.as_str() {
            "true" => "false".to_owned(),
            "false" => "true".to_owned(),
            "rvc2" => "rvc4".to_owned(),
            "nearest" => "truncate".to_owned(),
            "AUTO" => "KERNEL_7x9".to_owned(),
            "LINES" => "PARABOLA_5".to_owned(),
            "DISPARITY_96" => "DISPARITY_64".to_owned(),
            "0x0" => "0xA82415".to_owned(),
            _ if name == "subpixelFractionalBits" => "3".to_owned(),
            _ if name == "baseline" => "0.15".to_owned(),
            _ if name == "linearEquationParameters.threshold" => "64".to_owned(),
            _ if name == "blockSize" => "3".to_owned(),
            number => (number.parse::<u32>().unwrap() + 1).to_string(),
        };
        p.set(name, &other).unwrap();
        assert_eq!(p.get(name).unwrap(), other, "{name}");
        assert_ne!(p, parameters(), "{name}");
        p.set(name, &now).unwrap();
        assert_eq!(p, parameters(), "{name}");
    }
}

#[test]
fn rejects_invalid_values() {
    let mut p = parameters();
    let wrong = [
        ("paths", "7"),
        ("baseline", "75"),
        ("focalLength", "NaN"),
        ("leftRightCheckThreshold", "129"),
        ("linearEquationParameters.threshold", "128"),
        ("divisionFactor", "0"),
        ("blockSize", "4"),
        ("p2Config.defaultValue", "9000"),
        ("kernelMask", "0xG"),
        ("platform", "RVC3"),
        ("kernelSize", "KERNEL_9x9"),
        ("occlusionConfidenceWeight", "33"),
        ("motionVectorConfidenceThreshold", "4"),
        ("flatnessConfidenceThreshold", "0"),
        ("flatnessConfidenceThreshold", "8"),
        ("holeFilling.highConfidenceThreshold", "0"),
        ("holeFilling.minValidDisparity", "4"),
        ("adaptiveMedianFilter.confidenceThreshold", "256"),
    ];
    for (name, value) in wrong {
        assert_eq!(p.set(name, value).unwrap_err().name, name, "{name}={value}");
    }
    assert_eq!(p, parameters());
    assert_eq!(
        p.set("path", "4").unwrap_err().to_string(),
        "path: unknown parameter of stereo-matching; did you mean 'paths' or 'penaltyShift'?"
    );
    p.set("penaltyShift", "0").unwrap();
    p.set("verticalPenaltyCostP2", "60000").unwrap();
    assert_eq!(p.check().unwrap_err().name, "verticalPenaltyCostP2");
}

#[test]
fn depthai_2_inverts_the_confidence_threshold() {
    let mut p = parameters();
    assert_eq!(p.confidence_threshold_v2(), 200);
    p.set_confidence_threshold_v2(245);
    assert_eq!(p.confidence_threshold, 10);
}

#[test]
fn presets_set_the_parameters() {
    let mut p = parameters();
    let preset = |platform, name| StereoConfig::preset(platform, name).unwrap();
    preset(Platform::Rvc2, "HIGH_DETAIL").apply_to_matching(&mut p);
    assert!(p.extended_disparity && p.left_right_check_threshold_px == 5 && p.platform == Platform::Rvc2);
    preset(Platform::Rvc4, "DEFAULT").apply_to_matching(&mut p);
    assert_eq!(
        (p.noise_threshold_scale, p.p1.default, p.p2.default),
        (-40, 20, 85)
    );
    assert!(p.platform == Platform::Rvc4 && !p.p1.adaptive && p.check().is_ok());
    let values = |p: &Parameters| {
        let names = [
            "occlusionConfidenceWeight",
            "motionVectorConfidenceWeight",
            "motionVectorConfidenceThreshold",
            "flatnessConfidenceWeight",
            "flatnessConfidenceThreshold",
            "holeFilling.enable",
            "holeFilling.highConfidenceThreshold",
            "holeFilling.fillConfidenceThreshold",
            "holeFilling.minValidDisparity",
            "adaptiveMedianFilter.enable",
        ];
        names.map(|name| p.get(name).unwrap()).join(" ")
    };
    assert_eq!(values(&p), "28 0 1 4 4 false 210 200 1 true");
    preset(Platform::Rvc4, "ROBOTICS").apply_to_matching(&mut p);
    assert_eq!(values(&p), "14 16 1 2 4 true 240 251 1 true");
    assert_eq!(values(&parameters()), "20 4 1 8 2 true 210 200 1 true");
}

#[test]
fn maximum_disparity_follows_depthai() {
    let most = |settings: &[(&str, &str)]| super::changed(settings).max_disparity_px();
    assert_eq!(most(&[]), 95);
    assert_eq!(most(&[("disparityWidth", "DISPARITY_64")]), 63);
    assert_eq!(most(&[("enableCompanding", "true")]), 175);
    assert_eq!(
        most(&[("extendedDisparity", "true"), ("disparityShift", "5")]),
        200
    );
}

#[test]
fn parameters_of_another_platform_have_no_effect() {
    let images = super::step(130, 24, 3.0, 9.5, 40.0, 60.0);
    let found = |p| {
        crate::stereo_matching::StereoMatching::new(p)
            .unwrap()
            .disparity(&super::pair(&images))
    };
    for platform in [Platform::Rvc2, Platform::Rvc4] {
        let own = Parameters::new(platform, super::STEREO, 1280);
        let plain = found(own);
        for name in Parameters::names()
            .into_iter()
            .filter(|name| platform_of(name).is_some_and(|other| other != platform))
        {
            let mut p = own;
            let now = p.get(name).unwrap();
            let other = match now.as_str() {
                "true" => "false".to_owned(),
                "false" => "true".to_owned(),
                number => (number.parse::<u32>().unwrap() + 1).to_string(),
            };
            p.set(name, &other).unwrap();
            assert!(found(p) == plain, "{name}");
        }
    }
    assert_eq!(platform_of("flatness-override"), Some(Platform::Rvc4));
    assert_eq!(platform_of("penaltyShift"), Some(Platform::Rvc2));
    assert_eq!((platform_of("paths"), platform_of("bias")), (None, None));
}

#[test]
fn a_block_has_an_odd_number_of_rows() {
    let mut p = parameters();
    p.set("blockRows", "1").unwrap();
    assert!(p.check().is_ok());
    p.block_rows_px = 2;
    assert_eq!(p.check().unwrap_err().name, "blockRows");
}
