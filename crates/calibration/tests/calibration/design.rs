//! The baseline with which a unit converts disparity to depth.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fs;
use std::path::Path;

use oaktwin_base::diagnostic::Finding;
use oaktwin_calibration::{Calibration, CalibrationError, Raw, twin};
use oaktwin_catalog::{Catalog, Role, Twin};

const PAIR: (Role, Role) = (Role::Left, Role::Right);
/// The distance between the cameras and its design in the fixture, m.
const CALIBRATED_M: f64 = 0.074_584_48;
const DESIGN_M: f64 = 0.075;

/// The unit of a fixture in which texts are replaced.
fn unit(replacements: &[(&str, &str)]) -> Result<(Twin, Vec<Finding>), CalibrationError> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/example-oak-d-pro-poe.json");
    let mut text = fs::read_to_string(path).unwrap();
    for (from, to) in replacements {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    let (calibration, _) = Calibration::from_raw(&Raw::parse(text.as_bytes(), "cal.json")?)?;
    let catalog = Catalog::builtin();
    let nominal = catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap());
    twin(&calibration, &nominal, "cal.json")
}

fn close(found: Option<f64>, expected: f64) -> bool {
    found.is_some_and(|found| (found - expected).abs() < 1e-8)
}

#[test]
fn is_the_designs_by_default() {
    for replacements in [&[][..], &[("\"stereoUseSpecTranslation\": true,\n", "")]] {
        let (twin, findings) = unit(replacements).unwrap();
        assert!(close(twin.baseline_m(PAIR), CALIBRATED_M));
        assert!(close(twin.depth_baseline_m(PAIR), DESIGN_M));
        assert_eq!(
            findings[0].to_string(),
            "note[design-baseline]: stereoUseSpecTranslation: as on the device, depth is computed with the baseline of the \
             board's design, 75.00 mm, not with the calibrated 74.58 mm, so it is 0.6 % too large"
        );
    }
}

#[test]
fn a_large_difference_is_a_warning() {
    let (_, findings) = unit(&[("\"x\": -7.4583", "\"x\": -7.3803")]).unwrap();
    assert_eq!(findings[0].code, "design-baseline");
    assert!(findings[0].to_string().starts_with("warning"), "{}", findings[0]);
    assert!(
        findings[0].to_string().contains("1.6 % too large"),
        "{}",
        findings[0]
    );
}

#[test]
fn is_the_calibrated_one_if_the_file_says_so() {
    let (twin, findings) = unit(&[(
        "\"stereoUseSpecTranslation\": true",
        "\"stereoUseSpecTranslation\": false",
    )])
    .unwrap();
    assert!(close(twin.depth_baseline_m(PAIR), CALIBRATED_M));
    assert!(
        !findings.iter().any(|finding| finding.code.contains("design")),
        "{findings:?}"
    );
}

#[test]
fn is_the_calibrated_one_without_a_design() {
    let (twin, findings) = unit(&[("\"x\": -7.5,", "\"x\": 0.0,")]).unwrap();
    assert!(close(twin.depth_baseline_m(PAIR), CALIBRATED_M));
    assert!(findings.is_empty(), "{findings:?}");
}

#[test]
fn rejects_flags_of_another_type() {
    let error = unit(&[(
        "\"stereoUseSpecTranslation\": true",
        "\"stereoUseSpecTranslation\": \"yes\"",
    )])
    .unwrap_err()
    .to_string();
    assert!(
        error.contains("stereoUseSpecTranslation") && error.contains("true or false"),
        "{error}"
    );
}
