use crate::BatchEngine as _;

use super::*;

#[test]
fn each_name_changes_what_it_reads() {
    let values = [
        "572.5", "320", "100,120", "60,90", "false", "2", "130", "false", "true", "false", "false", "0.1",
        "0.01", "false", "0.02", "-0.01", "2000", "0.7", "500", "12", "50000", "0.8", "0", "1", "1.5",
        "0.03", "0", "0.3",
    ];
    let default = Parameters::new(457.0, 640);
    for (name, value) in Parameters::names().into_iter().zip(values) {
        let mut p = default;
        assert_ne!(p.get(name).unwrap(), value, "{name}");
        p.set(name, value).unwrap();
        assert_eq!(p.get(name).unwrap(), value, "{name}");
        assert_ne!(p, default);
        // What is read can be written.
        p.set(name, default.get(name).unwrap()).unwrap();
        assert_eq!(p, default);
    }
}

#[test]
fn accepts_words_for_ambient_light_and_loose_names() {
    let mut p = Parameters::new(457.0, 640);
    p.set("ambient", "outdoor").unwrap();
    assert_eq!(p.ambient_e, 500.0);
    p.set("enable-fppn-correction", "0").unwrap();
    assert!(!p.enable_fppn_correction);
    assert_eq!(
        p.set("ambiance", "1").unwrap_err().to_string(),
        "ambiance: unknown parameter of time-of-flight; did you mean 'ambient'?"
    );
}

#[test]
fn wrong_values_change_nothing() {
    let mut p = Parameters::new(457.0, 640);
    let wrong = [
        ("focalLength", "0"),
        ("focalLength", "nan"),
        ("width", "-1"),
        ("principalPoint", "320"),
        ("principalPoint", "inf,0"),
        ("modulationFrequencies", "100"),
        ("modulationFrequencies", "100,80"),
        ("modulationFrequencies", "0,80"),
        ("phaseUnwrappingLevel", "6"),
        ("phaseUnwrapErrorThreshold", "1.5"),
        ("enableBurstMode", "maybe"),
        ("wiggling", "2"),
        ("albedo", "1.1"),
        ("pixelMixing", "0.3"),
        ("multipath", "-0.1"),
        ("multipath", "10.5"),
        ("multipath", "nan"),
        ("multipath", "on"),
        ("confidenceThreshold", "-1"),
        ("ambient", "sunny"),
        ("readNoise", ""),
    ];
    for (name, value) in wrong {
        assert_eq!(p.set(name, value).unwrap_err().name, name, "{name}={value}");
    }
    assert_eq!(p, Parameters::new(457.0, 640));
    p.contrast = f64::NAN;
    assert_eq!(
        TimeOfFlight::new(p).unwrap_err().to_string(),
        "contrast: must not be NaN; expected a number from 0 to 1"
    );
}

#[test]
fn a_batch_that_does_not_fit() {
    let sensor = sensor(Parameters::new(457.0, 640));
    let mut out = [1.0; 11];
    let error = sensor
        .sense_batch(&[2.0; 12], [1, 3, 4], 0, 0, &random(), &mut out)
        .unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("the result of a batch of shape [1, 3, 4]")
    );
    assert_eq!(out, [1.0; 11]);
    for empty in [[0, 3, 4], [3, 0, 4], [3, 4, 0]] {
        sensor.sense_batch(&[], empty, 0, 0, &random(), &mut []).unwrap();
    }
}

#[test]
fn devices_differ_by_their_seed_alone() {
    let of = |seed| Parameters::new(457.0, 640).of_device(seed).bias_m;
    assert_eq!(of(3), of(3));
    assert_ne!(of(3), of(4));
    assert!((0..100).all(|seed| of(seed).abs() < 0.002));
}
