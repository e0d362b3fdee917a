use crate::ParameterError;
use crate::single_view::Parameters;

fn set(name: &str, value: &str) -> Result<Parameters, ParameterError> {
    let mut parameters = Parameters::isaac_5_1();
    parameters.set(name, value)?;
    parameters.check()?;
    Ok(parameters)
}

fn says(name: &str, value: &str) -> String {
    set(name, value).unwrap_err().to_string()
}

#[test]
fn sets_and_reads_every_parameter() {
    assert_eq!(Parameters::names().len(), 14);
    for defaults in [Parameters::isaac_5_1(), Parameters::isaac_6()] {
        defaults.check().unwrap();
        let mut copy = Parameters {
            baseline_mm: -1.0,
            enabled: true,
            show_distance: true,
            ..defaults
        };
        for name in Parameters::names() {
            copy.set(name, defaults.get(name).unwrap()).unwrap();
        }
        assert_eq!(copy, defaults);
    }
    for (name, value, read) in [
        ("outlierRemovalEnabled", "true", "1"),
        ("outlierRemovalEnabled", "false", "0"),
        ("outlierRemovalRange", "3", "3"),
        ("rgbDepthOutputMode", "rainbow", "3"),
        ("rgbDepthOutputMode", "7", "7"),
        ("baselineMM", "-75", "-75"),
        ("enabled", "1", "true"),
        ("maxDistance", "12.5", "12.5"),
    ] {
        let parameters = set(name, value).unwrap();
        assert_eq!(parameters.get(name).unwrap(), read);
    }
    assert_eq!(Parameters::isaac_5_1().get("baseline").ok(), None);
}

#[test]
fn errors_name_the_attribute_and_a_remedy() {
    assert_eq!(
        says("baselin", "3"),
        "baselin: unknown parameter of single-view; did you mean 'baselineMM'?"
    );
    assert_eq!(
        says("baselineMM", "0"),
        "baselineMM: 0 gives no disparity; set the distance between the imagers in mm, 75 for an OAK-D"
    );
    assert_eq!(
        says("noiseSigma", "nan"),
        "noiseSigma: must not be NaN; expected a number from 0 to 1000000 px"
    );
    assert_eq!(
        says("maxDistance", "0.25"),
        "maxDistance: 0.25 m is below the minDistance of 0.5 m; set a larger maxDistance"
    );
    assert_eq!(
        says("rgbDepthOutputMode", "8"),
        "rgbDepthOutputMode: invalid value '8'; expected color, sawtooth, grayscale, rainbow, input-depth, reprojected, \
         confidence or disparity"
    );
    assert_eq!(
        says("outlierRemovalEnabled", "-1"),
        "outlierRemovalEnabled: invalid value '-1'; expected a whole number from 0 to 63 px"
    );
    for (name, value) in [
        ("confidenceThreshold", "1.01"),
        ("confidenceThreshold", "-0.1"),
        ("focalLengthPixel", "0"),
        ("focalLengthPixel", "inf"),
        ("focalLengthPixel", "wide"),
        ("maxDisparityPixel", "0"),
        ("sensorSizePixel", "-1280"),
        ("minDistance", "-1"),
        ("maxDistance", "inf"),
        ("noiseMean", "-0.25"),
        ("noiseSigma", "-0.25"),
        ("noiseDownscaleFactorPixel", "0.5"),
        ("outlierRemovalRange", "64"),
        ("enabled", "2"),
    ] {
        let error = set(name, value).unwrap_err();
        assert!(error.name.starts_with(&name[..6]), "{error}");
    }
}
