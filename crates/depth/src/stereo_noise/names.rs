//! Parameters by name, for command lines and presets.

use super::parameters::Parameters;
use crate::named::{self, Named, field, flag, one_of, subpixel, subpixel_bits};

const TABLE: [Named<Parameters>; 19] = [
    field!("focalLength", stereo.focal_length_px, "give pixels, 800"),
    field!("baseline", stereo.baseline_m, "give metres, 0.075"),
    field!("width", width_px, "give whole pixels, 1280"),
    subpixel!("subpixel", subpixel),
    subpixel_bits!("subpixelFractionalBits", subpixel),
    flag!("extendedDisparity", extended_disparity),
    field!("disparityShift", disparity_shift_px, "give whole pixels"),
    flag!("occlusion", occlusion),
    flag!("leftRightCheck", left_right_check),
    field!(
        "leftRightCheckThreshold",
        left_right_check_threshold_px,
        "give whole pixels, 0 to 128"
    ),
    field!(
        "confidenceThreshold",
        confidence_threshold,
        "give a whole number, 0 (keep all) to 255"
    ),
    field!("numInvalidateEdgePixels", invalid_edge_px, "give whole pixels"),
    field!("edgeDilation", edge_dilation_px, "give pixels"),
    field!("dropout", dropout, "give a fraction, 0 to 1"),
    field!("bias", bias_px, "give pixels"),
    field!("pixelLocking", pixel_locking_px, "give pixels"),
    field!("jitter", jitter_px, "give pixels"),
    field!("window", window_px, "give an odd number of pixels, 7"),
    one_of!("depthRounding", depth_rounding, "give nearest or truncate"),
];

named::by_name!(Parameters, TABLE, |name| named::unknown(
    "stereo-noise",
    name,
    &NAMES
));

#[cfg(test)]
mod tests {
    use super::*;
    use crate::disparity::Subpixel;
    use oaktwin_camera::StereoGeometry;

    fn parameters() -> Parameters {
        let stereo = StereoGeometry {
            focal_length_px: 800.0,
            baseline_m: 0.075,
        };
        Parameters::new(stereo, 1280)
    }

    #[test]
    fn each_name_changes_what_it_reads() {
        let values = [
            "572.5", "0.15", "640", "false", "4", "true", "12", "false", "false", "5", "245", "3", "2.5",
            "0.25", "-0.22", "0.2", "0.08", "9", "truncate",
        ];
        for (name, value) in NAMES.iter().zip(values) {
            let mut p = parameters();
            assert_ne!(p.get(name).unwrap(), value, "{name}");
            p.set(name, value).unwrap();
            assert_eq!(p.get(name).unwrap(), value, "{name}");
            assert_ne!(p, parameters());
        }
    }

    #[test]
    fn names_forgive_hyphens_and_misspelt_ones_are_suggested() {
        let mut p = parameters();
        p.set("subpixel-fractional-bits", "3").unwrap();
        assert_eq!(p.subpixel, Subpixel::Bits3);
        p.set("subpixel", "true").unwrap();
        assert_eq!(p.subpixel, Subpixel::Bits3);
        p.set("subpixel", "0").unwrap();
        p.set("subpixel", "1").unwrap();
        assert_eq!(p.subpixel, Subpixel::Bits5);
        assert_eq!(
            p.set("jiter", "1").unwrap_err().to_string(),
            "jiter: stereo-noise has no such parameter; did you mean jitter?"
        );
        assert!(p.get("").is_err());
    }

    #[test]
    fn wrong_values_change_nothing() {
        let mut p = parameters();
        let wrong = [
            ("subpixelFractionalBits", "2"),
            ("subpixel", "maybe"),
            ("confidenceThreshold", "256"),
            ("window", "8"),
            ("baseline", "75"),
            ("jitter", "NaN"),
            ("jitter", "inf"),
            ("jitter", "-0.1"),
            ("dropout", ""),
            ("disparityShift", "-1"),
            ("depthRounding", "up"),
        ];
        for (name, value) in wrong {
            assert_eq!(p.set(name, value).unwrap_err().name, name, "{name}={value}");
        }
        assert_eq!(p, parameters());
        p.stereo.baseline_m = 0.0;
        p.set("jitter", "0.1").unwrap();
        assert!(p.check().is_err());
    }
}
