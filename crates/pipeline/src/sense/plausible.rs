//! Findings about depth that is valid but probably not what was meant.

use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};

/// The unit of a depth image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthUnit {
    /// Floating-point metres.
    Metres,
    /// Whole millimetres.
    Millimetres,
}

/// No depth image of a room or a yard is farther away everywhere, in metres.
const ALL_FAR_M: f32 = 100.0;
/// No depth camera sees a scene that is nearer everywhere, in metres.
const ALL_NEAR_M: f32 = 0.1;

/// Reports depth that looks as if it were in the other unit. Values are in metres; a sample of an image is enough.
#[must_use]
pub fn check_unit(metres: &[f32], unit: DepthUnit) -> Option<Finding> {
    let (nearest, farthest) = limits(metres.iter())?;
    let (what, remedy) = match unit {
        DepthUnit::Metres if nearest > ALL_FAR_M => (
            format!("depth from {nearest:?} to {farthest:?} m looks like millimetres"),
            "pass metres, or millimetres as uint16",
        ),
        DepthUnit::Millimetres if farthest < ALL_NEAR_M => (
            format!(
                "depth from {:.0} to {:.0} mm looks like metres",
                nearest * 1e3,
                farthest * 1e3
            ),
            "pass millimetres, or metres as float32",
        ),
        _ => return None,
    };
    Some(Finding::new("depth-unit", Level::Warning, "depth", what, remedy))
}

/// Reports an image with surfaces, none of which was measured. With a colour image, surfaces need texture.
#[must_use]
pub fn check_measured(exact: &[f32], measured: &[f32], has_rgb: bool) -> Option<Finding> {
    if measured.iter().any(|metres| *metres > 0.0) {
        return None;
    }
    let (nearest, farthest) = limits(exact.iter())?;
    let what = format!("no pixel was measured of surfaces from {nearest:?} to {farthest:?} m");
    let remedy = if has_rgb {
        "check the unit of depth, the range of the sensor, its filters, and the texture of the colour image"
    } else {
        "check the unit of depth, the range of the sensor and its filters"
    };
    Some(Finding::new(
        "nothing-measured",
        Level::Warning,
        "depth",
        what,
        remedy,
    ))
}

/// Reports a horizontal field of view in degrees that looks like radians.
#[must_use]
pub fn check_hfov(hfov_deg: f64) -> Option<Finding> {
    let is_suspicious = hfov_deg > 0.0 && hfov_deg <= std::f64::consts::PI;
    is_suspicious.then(|| {
        let what = format!("a field of view of {hfov_deg}° looks like radians");
        let remedy: Message = message![
            "pass degrees: ",
            opt("hfov").with(format!("{:.2}", hfov_deg.to_degrees()))
        ];
        Finding::new("field-of-view-unit", Level::Warning, "camera", what, remedy)
    })
}

/// The nearest and the farthest surface.
fn limits<'a>(metres: impl Iterator<Item = &'a f32>) -> Option<(f32, f32)> {
    let valid = metres
        .copied()
        .filter(|metres| metres.is_finite() && *metres > 0.0);
    valid.fold(None, |limits, metres| match limits {
        None => Some((metres, metres)),
        Some((nearest, farthest)) => Some((metres.min(nearest), metres.max(farthest))),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code(finding: Option<Finding>) -> Option<&'static str> {
        finding.map(|finding| finding.code)
    }

    #[test]
    fn the_other_unit_is_recognised() {
        let image = |metres: f32| vec![f32::INFINITY, metres, 2.0 * metres];
        assert_eq!(code(check_unit(&image(2.0), DepthUnit::Metres)), None);
        assert_eq!(
            code(check_unit(&image(2000.0), DepthUnit::Metres)),
            Some("depth-unit")
        );
        assert_eq!(code(check_unit(&image(2.0), DepthUnit::Millimetres)), None);
        assert_eq!(
            code(check_unit(&image(0.002), DepthUnit::Millimetres)),
            Some("depth-unit")
        );
        assert_eq!(code(check_unit(&[f32::NAN, 0.0], DepthUnit::Metres)), None);
    }

    #[test]
    fn lost_images_are_reported_if_they_have_a_surface() {
        assert_eq!(
            code(check_measured(&[1.0, 2.0], &[0.0, 0.0], false)),
            Some("nothing-measured")
        );
        assert_eq!(code(check_measured(&[1.0, 2.0], &[0.0, 2.0], false)), None);
        assert_eq!(
            code(check_measured(&[f32::INFINITY, 0.0], &[0.0, 0.0], false)),
            None
        );
    }

    #[test]
    fn radians_are_recognised() {
        assert_eq!(code(check_hfov(1.2)), Some("field-of-view-unit"));
        assert_eq!(code(check_hfov(69.0)), None);
    }
}
