//! The name of a depth file: kind of depth, frame number, and the names of its results.

use std::path::Path;

use super::InputKind;

/// The names of ground truth, which are replaced in the names of results.
const GROUND_TRUTH: [&str; 3] = ["distance_to_image_plane", "distance_to_camera", "depth"];

/// The parts of a file's name: `scene_depth_0012.npy` is `scene_depth` and frame 12.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The stem without the frame number.
    pub base: String,
    /// The frame number, if there is one.
    pub number: Option<u64>,
    /// The digits of the frame number, leading zeros included.
    pub digits: String,
    /// The kind of depth, if the stem is the name of an annotator.
    pub kind: Option<InputKind>,
}

impl Name {
    /// Parses the name of a file.
    #[must_use]
    pub fn of(path: &Path) -> Self {
        /// The maximum number of digits; they fit into a `u64`.
        const MAX_DIGITS: usize = 19;
        let stem = path
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned())
            .unwrap_or_default();
        let base = stem.trim_end_matches(|c: char| c.is_ascii_digit());
        let digits = &stem[base.len()..];
        // `frame0001` has a number; `f32` and `cam2` do not.
        let is_apart = base.is_empty() || base.ends_with(['_', '-', '.']) || digits.len() > 2;
        let number = digits
            .parse()
            .ok()
            .filter(|_| is_apart && digits.len() <= MAX_DIGITS);
        let (base, digits) = match number {
            Some(_) => (base.trim_end_matches(['_', '-', '.']), digits),
            None => (stem.as_str(), ""),
        };
        Self {
            kind: kind(base),
            base: base.to_owned(),
            number,
            digits: digits.to_owned(),
        }
    }

    /// The part of an output's name before `depth_sensor_distance`.
    #[must_use]
    pub fn prefix(&self) -> String {
        let base = self.base.trim_end_matches("_millimetres");
        let base = base.strip_suffix("_depth").unwrap_or(base);
        if base.is_empty() || GROUND_TRUTH.contains(&base) {
            String::new()
        } else {
            format!("{base}_")
        }
    }

    /// The part of an output's name after `depth_sensor_distance`.
    #[must_use]
    pub fn suffix(&self) -> String {
        match self.number {
            Some(_) => format!("_{}", self.digits),
            None => String::new(),
        }
    }
}

fn kind(base: &str) -> Option<InputKind> {
    if base.contains("distance_to_camera") {
        return Some(InputKind::Range);
    }
    let mut words = base.split(|c: char| !c.is_ascii_alphanumeric());
    let is_depth = words.any(|word| word.eq_ignore_ascii_case("depth"));
    (is_depth || base.contains("distance_to_image_plane")).then_some(InputKind::Z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parses_names() {
        let of = |path: &str| {
            let name = Name::of(Path::new(path));
            (
                name.kind,
                name.number,
                format!("{}X{}", name.prefix(), name.suffix()),
            )
        };
        let (z, range) = (Some(InputKind::Z), Some(InputKind::Range));
        assert_eq!(
            of("a/distance_to_image_plane_0007.npy"),
            (z, Some(7), "X_0007".into())
        );
        assert_eq!(of("distance_to_camera_12.exr"), (range, Some(12), "X_12".into()));
        assert_eq!(
            of("distance_to_image_plane_millimetres_0000.png"),
            (z, Some(0), "X_0000".into())
        );
        assert_eq!(of("depth.npy"), (z, None, "X".into()));
        assert_eq!(of("left-Depth-3.png"), (z, Some(3), "left-Depth_X_3".into()));
        assert_eq!(of("envs_depth.npy"), (z, None, "envs_X".into()));
        assert_eq!(of("room.npy"), (None, None, "room_X".into()));
        assert_eq!(of("0012.png"), (None, Some(12), "X_0012".into()));
        assert_eq!(of("depths.npy").0, None);
        assert_eq!(of("f32.npy"), (None, None, "f32_X".into()));
        assert_eq!(of("frame0007.npy"), (None, Some(7), "frame_X_0007".into()));
        let long = "x_99999999999999999999.npy";
        assert_eq!(of(long), (None, None, "x_99999999999999999999_X".into()));
    }
}
