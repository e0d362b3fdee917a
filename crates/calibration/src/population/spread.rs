use std::sync::LazyLock;

use oaktwin_catalog::{Role, Twin};
use serde::{Deserialize, Serialize};

/// The horizontal fields of view of the measured family, degrees.
const STANDARD_HFOV_DEG: std::ops::Range<f64> = 65.0..82.0;

/// The baseline of the measured family, mm.
const BASELINE_MM: f64 = 75.0;

/// The standard deviations of a family of models.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Spread {
    /// The family: `stereo pairs with lenses of about 72°`.
    pub about: String,
    /// The number of calibrations.
    pub units: u32,
    /// The number of models that they belong to.
    pub models: u32,
    /// The focal length of both cameras of the pair, relative.
    pub focal_length_pair: f64,
    /// The focal length of each camera of the pair, relative.
    pub focal_length: f64,
    /// The focal length of any other camera, relative.
    pub focal_length_color: f64,
    /// The principal point, as a share of the image's width: right, down.
    pub principal_point: [f64; 2],
    /// The radial distortion k1.
    pub k1: f64,
    /// The tangential distortion p1, p2.
    pub p: f64,
    /// The rotation of a camera about its x, y and z axes (right, down, forward), mrad.
    pub rotation_mrad: [f64; 3],
    /// The position of a camera, mm: right, down, forward.
    pub position_mm: [f64; 3],
}

/// Whether a spread was measured on the family that it is used for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Basis {
    /// It was computed from calibrations of the family.
    Measured,
    /// It belongs to another family.
    Estimate,
}

#[derive(Deserialize)]
struct Spreads {
    standard: Spread,
}

static SPREADS: LazyLock<Option<Spreads>> =
    LazyLock::new(|| toml::from_str(include_str!("../../data/spreads.toml")).ok());

impl Spread {
    /// Returns the spread of the family of a twin, and whether it was measured on that family.
    #[must_use]
    pub fn of(twin: &Twin) -> (Self, Basis) {
        let is_standard = twin.device.manufacturer == "Luxonis"
            && twin.device.stereo_baseline_mm == Some(BASELINE_MM)
            && twin.camera(Role::Left).is_some_and(|left| {
                STANDARD_HFOV_DEG.contains(&left.intrinsics.hfov().to_degrees())
                    && left.spec.fisheye_hfov_deg.is_none()
            });
        let basis = match is_standard {
            true => Basis::Measured,
            false => Basis::Estimate,
        };
        (Self::standard(), basis)
    }

    #[expect(
        clippy::expect_used,
        reason = "the file is part of the program, and a test reads it"
    )]
    fn standard() -> Self {
        let spreads = SPREADS.as_ref().expect("the spreads are valid");
        spreads.standard.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_catalog::Catalog;

    #[test]
    fn families_are_recognized() {
        let catalog = Catalog::builtin();
        let basis = |model: &str| Spread::of(&catalog.nominal(catalog.device(model).unwrap())).1;
        for model in ["OAK-D", "OAK-D Pro", "OAK-D Pro PoE", "OAK4-D", "OAK-D Lite"] {
            assert_eq!(basis(model), Basis::Measured, "{model}");
        }
        for model in [
            "OAK-D Pro W PoE",
            "OAK4-D Wide",
            "OAK-D SR",
            "RealSense D435i",
            "OAK-1",
        ] {
            assert_eq!(basis(model), Basis::Estimate, "{model}");
        }
    }
}
