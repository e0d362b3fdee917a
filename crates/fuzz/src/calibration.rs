//! Calibrations of `DepthAI`.

use std::sync::LazyLock;

use oaktwin_base::diagnostic::Level;
use oaktwin_calibration::export::{Format, export};
use oaktwin_calibration::{Calibration, EXAMPLE, Raw, check_against, nominal_calibration, summary, twin};
use oaktwin_catalog::{Catalog, Twin};
use serde_json::Value;

use crate::json;
use crate::random::Random;

/// The models whose calibrations are changed: an ordinary pair, wide cameras, and a time-of-flight camera.
const MODELS: [&str; 3] = ["OAK-D Pro PoE", "OAK-D Pro W PoE", "OAK-D ToF"];

struct Model {
    nominal: Twin,
    document: Value,
}

static KNOWN: LazyLock<Vec<Model>> = LazyLock::new(|| {
    let catalog = Catalog::builtin();
    let model = |name: &str| {
        let device = catalog.device(name).unwrap_or_else(|error| panic!("{error}"));
        let nominal = catalog.nominal(device);
        let text = nominal_calibration(&nominal).to_text();
        let document = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}"));
        Model { nominal, document }
    };
    MODELS.map(model).into()
});

/// The first byte selects: a document in the remaining bytes, or changes to the calibration of a model.
pub(crate) fn check(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    let model = &KNOWN[usize::from(first / 2) % KNOWN.len()];
    if first % 2 == 0 {
        document(rest, &model.nominal);
    } else {
        let mut changed = model.document.clone();
        json::change(&mut changed, &mut Random::new(rest));
        document(changed.to_string().as_bytes(), &model.nominal);
    }
}

fn document(bytes: &[u8], nominal: &Twin) {
    let Ok(raw) = Raw::parse(bytes, "calibration.json") else {
        return;
    };
    let text = raw.to_text();
    let again = Raw::parse(text.as_bytes(), "calibration.json").unwrap_or_else(|error| panic!("{error}"));
    assert!(again.root.same_as(&raw.root), "the document does not round-trip");
    assert_eq!(again.to_text(), text);
    let Ok((calibration, mut findings)) = Calibration::from_raw(&raw) else {
        return;
    };
    let _ = summary(&calibration, &findings);
    // One format for each input: exports take most of the time.
    let format = Format::ALL[bytes.len() % Format::ALL.len()];
    if format != Format::DepthAi
        && let Ok(export) = export(&raw, &calibration, format)
    {
        for (name, text) in &export.files {
            assert!(
                !has_other_numbers(text),
                "{name} has a number that is not finite:\n{text}"
            );
        }
    }
    findings.extend(check_against(&calibration, nominal, Catalog::builtin()));
    if findings.iter().any(|finding| finding.level == Level::Error) {
        return;
    }
    let Ok((twin, _)) = twin(&calibration, nominal, "calibration.json") else {
        return;
    };
    for camera in &twin.cameras {
        let pose = camera.body_from_camera;
        assert!(
            pose.rotation.is_finite() && pose.translation.is_finite(),
            "{camera:?}"
        );
        let k = camera.intrinsics.matrix();
        assert!(k.is_finite(), "{camera:?}");
    }
    for sensor in &twin.depth_sensors {
        let Some(camera) = twin.depth_camera(sensor) else {
            continue;
        };
        assert!(camera.body_from_camera.rotation.is_finite(), "{camera:?}");
        assert!(sensor.focal_length_px.is_finite(), "{sensor:?}");
    }
    let export = nominal_calibration(&twin).to_text();
    Raw::parse(export.as_bytes(), "nominal").unwrap_or_else(|error| panic!("{error}\n{export}"));
}

/// Whether a number in a text is not finite, found by its letters.
pub(crate) fn has_other_numbers(text: &str) -> bool {
    let numbers = text.lines().filter(|line| !line.contains("name"));
    let mut words = numbers.flat_map(|line| line.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')));
    words.any(|word| ["nan", "inf", "infinity"].contains(&word.to_lowercase().as_str()))
}

pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let mut all = vec![[b"\0", EXAMPLE.as_bytes()].concat()];
    for (at, model) in (0u8..).zip(KNOWN.iter()) {
        all.push([&[2 * at], model.document.to_string().as_bytes()].concat());
        all.push(vec![2 * at + 1]);
    }
    all
}
