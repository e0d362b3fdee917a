//! The sizes of objects.

use std::path::Path;

use oaktwin_base::diagnostic::{Finding, Level};

use crate::random::Numbers;
use crate::recipe::ObjectRule;
use crate::world::Asset;

/// The sizes that an OAK measures, metres: a few pixels of the nearest image, and the range of a stereo camera.
const USUAL_M: [f64; 2] = [0.002, 5.0];

/// Draws the scale of an object.
pub(super) fn scale(rule: &ObjectRule, asset: &Asset, numbers: &mut Numbers) -> f64 {
    let scale = rule.scale.draw(numbers);
    match &rule.size_m {
        Some(size_m) => scale * size_m.draw(numbers) / asset.hull.longest_edge().max(f64::MIN_POSITIVE),
        None => scale,
    }
}

/// Returns the finding that a file has an unlikely unit.
pub(super) fn unusual(rule: usize, file: &Path, size_m: f64) -> Option<Finding> {
    (!(USUAL_M[0]..=USUAL_M[1]).contains(&size_m)).then(|| {
        Finding::new(
            "object-size",
            Level::Warning,
            file.display().to_string(),
            format!("is {} long", metres(size_m)),
            format!("set objects.{rule}.scale, such as 0.001 for millimetres, or objects.{rule}.size_m for files of any unit"),
        )
    })
}

/// Returns a length with three digits.
pub(super) fn metres(length_m: f64) -> String {
    match length_m {
        0.1.. => format!("{length_m:.2} m"),
        _ => format!("{:.3} mm", length_m * 1000.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_in_other_units_are_named_with_their_size() {
        let file = Path::new("spider.obj");
        assert_eq!(unusual(0, file, 0.193), None);
        let text = unusual(1, file, 193.0)
            .map(|finding| finding.to_string())
            .unwrap_or_default();
        assert!(
            text.starts_with("warning[object-size]: spider.obj: is 193.00 m long; set objects.1.scale"),
            "{text}"
        );
        assert!(unusual(0, file, 0.0001).is_some_and(|finding| finding.message == "is 0.100 mm long"));
    }
}
