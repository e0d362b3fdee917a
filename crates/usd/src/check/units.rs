use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::UsdOptics;

use super::rule::Rule;
use super::scene::CheckedCamera;
use super::{brief, num};

pub(super) const UNITS_SLIP: Rule = Rule {
    code: "units-slip",
    level: Level::Warning,
    what: "focal length or apertures are off by a factor of 10, 100 or 1000: millimetres, centimetres and tenths of a \
           stage unit are confused",
    remedy: "author focal length, apertures and offsets in millimetres, like vendors' assets for Isaac Sim",
};
pub(super) const IMPLAUSIBLE_FOV: Rule = Rule {
    code: "implausible-fov",
    level: Level::Warning,
    what: "the field of view is narrower than a telephoto lens's or wider than a pinhole allows",
    remedy: "check that focalLength and horizontalAperture have the same unit",
};

/// The tolerance around a power of ten, in decades: a calibrated focal length is within 10 % of the nominal.
const NEAR_A_POWER: f64 = 0.05;
/// The range of image sensor widths, mm: phone modules to medium format, including renderers' film backs.
const SENSOR_WIDTHS_MM: (f64, f64) = (0.9, 80.0);
/// The range of plausible horizontal fields of view, degrees.
const PLAUSIBLE_HFOV_DEG: (f64, f64) = (4.0, 160.0);
/// The range of common horizontal fields of view, to which a unit error is corrected.
const USUAL_HFOV_DEG: (f64, f64) = (15.0, 130.0);

/// Reports values that are off by a power of ten compared with the catalog or with plausible sensors.
pub(super) fn rules(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    if let Some(known) = camera.known {
        against(camera, &known.optics(), findings);
    } else {
        by_plausibility(camera, findings);
    }
}

/// Returns the power of ten by which `value` is off, ±1 to ±3.
pub(super) fn slip(value: f64, expected: f64) -> Option<i32> {
    let exponent = (value / expected).log10();
    let power = exponent.round();
    let slipped = power != 0.0 && power.abs() <= 3.0 && (exponent - power).abs() < NEAR_A_POWER;
    #[expect(clippy::cast_possible_truncation, reason = "a whole number between −3 and 3")]
    slipped.then_some(power as i32)
}

fn against(camera: &CheckedCamera<'_>, expected: &UsdOptics, findings: &mut Vec<Finding>) {
    let mut slips: Vec<(i32, Vec<String>)> = Vec::new();
    for (name, value, expected) in [
        (
            "focalLength",
            camera.camera.focal_length(),
            expected.focal_length_mm,
        ),
        (
            "horizontalAperture",
            camera.camera.horizontal_aperture(),
            expected.horizontal_aperture_mm,
        ),
        (
            "verticalAperture",
            camera.camera.vertical_aperture(),
            expected.vertical_aperture_mm,
        ),
    ] {
        if let Some(power) = slip(value, expected) {
            let text = format!("{name} {} (catalog: {} mm)", num(value), brief(expected));
            match slips.iter_mut().find(|(known, _)| *known == power) {
                Some((_, names)) => names.push(text),
                None => slips.push((power, vec![text])),
            }
        }
    }
    for (power, names) in slips {
        findings.push(UNITS_SLIP.at(
            camera.path(),
            format!("{}: {}", names.join(", "), describe(power)),
        ));
    }
}

fn by_plausibility(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    let optics = camera.camera.optics();
    let hfov_deg = optics.hfov().to_degrees();
    let width = optics.horizontal_aperture_mm;
    if !within(hfov_deg, PLAUSIBLE_HFOV_DEG) {
        // Find the power of ten of the focal length that gives a common field of view.
        let scaled = |power: i32| UsdOptics {
            focal_length_mm: optics.focal_length_mm * 10f64.powi(-power),
            ..optics
        };
        let fits = |power: &i32| within(scaled(*power).hfov().to_degrees(), USUAL_HFOV_DEG);
        findings.push(match [1, -1, 2, -2, 3, -3].into_iter().find(fits) {
            Some(power) => UNITS_SLIP.at(
                camera.path(),
                format!(
                    "focalLength {} and horizontalAperture {} give a field of view of {hfov_deg:.2}°; it would be \
                     {:.1}° if the focal length is {}",
                    num(optics.focal_length_mm),
                    num(width),
                    scaled(power).hfov().to_degrees(),
                    describe(power),
                ),
            ),
            None => IMPLAUSIBLE_FOV.at(
                camera.path(),
                format!("the horizontal field of view is {hfov_deg:.2}°"),
            ),
        });
    } else if !within(width, SENSOR_WIDTHS_MM) {
        findings.push(UNITS_SLIP.at(
            camera.path(),
            format!(
                "horizontalAperture {} is not a plausible sensor width in millimetres, but the field of view of \
                 {hfov_deg:.1}° is plausible: focal length and apertures have another unit",
                num(width)
            ),
        ));
    }
}

fn within(value: f64, (min, max): (f64, f64)) -> bool {
    value >= min && value <= max
}

fn describe(power: i32) -> String {
    let factor = 10_u32.pow(power.unsigned_abs());
    let like = match power {
        -1 => ", as if in centimetres",
        -2 => ", as if in tenths of a metre",
        -3 => ", as if in metres",
        3 => ", as if in micrometres",
        _ => "",
    };
    if power < 0 {
        format!("{factor} times too small{like}")
    } else {
        format!("{factor} times too large{like}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn detects_powers_of_ten_only() {
        assert_eq!(slip(24.138, 2.4138), Some(1));
        assert_eq!(slip(0.0024, 2.4138), Some(-3));
        assert_eq!(slip(2.45, 2.4138), None);
        assert_eq!(slip(12.0, 2.4138), None);
        assert_eq!(slip(f64::INFINITY, 2.4138), None);
    }
}
