//! Calibrations of ROS, Kalibr and OpenCV.

use oaktwin_calibration::export::{Format, export};
use oaktwin_calibration::import::{CalibrationImportOptions, InputFile, LengthUnit, import};
use oaktwin_calibration::{Calibration, EXAMPLE, Raw};

use crate::calibration::has_other_numbers;

/// What separates the files of an input.
const SEPARATOR: &[u8] = b"\n%%%\n";

/// The first byte selects the options, the others are files.
pub(crate) fn check(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    let options = CalibrationImportOptions {
        unit: [
            LengthUnit::Metres,
            LengthUnit::Centimetres,
            LengthUnit::Millimetres,
        ][usize::from(first) % 3],
        is_fisheye: first & 64 != 0,
        ..CalibrationImportOptions::default()
    };
    let Ok(imported) = import(&files(rest), &options, None) else {
        return;
    };
    let text = imported.raw.to_text();
    assert!(!has_other_numbers(&text), "a number is not finite:\n{text}");
    let again =
        Raw::parse(text.as_bytes(), "calibration.json").unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert!(
        again.root.same_as(&imported.raw.root),
        "the document does not round-trip"
    );
    if let Ok((_, findings)) = Calibration::from_raw(&again) {
        for finding in findings {
            let _ = imported.located(finding).finding.to_string();
        }
    }
}

fn files(mut rest: &[u8]) -> Vec<InputFile> {
    let mut files = Vec::new();
    loop {
        let end = rest
            .windows(SEPARATOR.len())
            .position(|window| window == SEPARATOR);
        files.push(InputFile {
            name: format!("camera{}.yaml", files.len()),
            bytes: rest[..end.unwrap_or(rest.len())].to_vec(),
        });
        match end {
            Some(end) => rest = &rest[end + SEPARATOR.len()..],
            None => return files,
        }
    }
}

/// What we export of the example.
pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let raw = Raw::parse(EXAMPLE.as_bytes(), "example").unwrap_or_else(|error| panic!("{error}"));
    let (calibration, _) = Calibration::from_raw(&raw).unwrap_or_else(|error| panic!("{error}"));
    let formats = Format::ALL.iter().filter(|format| **format != Format::DepthAi);
    let exports = formats.filter_map(|format| export(&raw, &calibration, *format).ok());
    exports
        .map(|export| {
            let texts: Vec<&[u8]> = export.files.iter().map(|(_, text)| text.as_bytes()).collect();
            [&b"\0"[..], &texts.join(SEPARATOR)].concat()
        })
        .collect()
}
