use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize};

use crate::{
    Accelerometer, Body, Camera, DepthSensor, Device, Gyroscope, Imu, InertialPart, Magnetometer, Projector,
    Sensor,
};

/// The source of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Source {
    /// Luxonis' parameter sheet of the OAK assets for Isaac Sim.
    Document,
    /// A manufacturer's datasheet.
    Datasheet,
    /// A page of the vendor's documentation.
    VendorPage,
    /// Factory or user calibrations of real units.
    CalibrationExport,
    /// A schema of OpenUSD or NVIDIA.
    Schema,
    /// Luxonis' board and housing files.
    BoardFile,
    /// A robot description (URDF) of the manufacturer or of a robot's.
    RobotDescription,
    /// Software or measurements of others, such as the driver of `RTAB-Map`.
    ThirdParty,
    /// Computed from other entries.
    Derived,
    /// An estimate in the absence of sources.
    Estimate,
    /// The user.
    User,
}

/// The keys of a table whose source differs from the table's.
pub type Sources = BTreeMap<String, Source>;

impl Source {
    /// Returns the name in catalog files, such as `vendor-page`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Document => "document",
            Self::Datasheet => "datasheet",
            Self::VendorPage => "vendor-page",
            Self::CalibrationExport => "calibration-export",
            Self::Schema => "schema",
            Self::BoardFile => "board-file",
            Self::RobotDescription => "robot-description",
            Self::ThirdParty => "third-party",
            Self::Derived => "derived",
            Self::Estimate => "estimate",
            Self::User => "user",
        }
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// A table of a catalog file whose values have sources.
pub trait Sourced {
    /// Returns the source of a key of this table.
    fn source_of(&self, key: &str) -> Source;
}

macro_rules! sourced {
    ($($table:ty),*) => {$(
        impl Sourced for $table {
            fn source_of(&self, key: &str) -> Source {
                self.sources.get(key).copied().unwrap_or(self.source)
            }
        }
    )*};
}

sourced!(
    Sensor,
    Device,
    Body,
    Imu,
    InertialPart,
    Accelerometer,
    Gyroscope,
    Magnetometer,
    Projector,
    Camera,
    DepthSensor
);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Catalog, DepthKind, Role};

    #[test]
    fn names_match_the_serialization() {
        fn spelt<T: Serialize>(value: T) -> String {
            serde_json::to_value(value).unwrap().as_str().unwrap().to_owned()
        }
        for source in [
            Source::Document,
            Source::Datasheet,
            Source::VendorPage,
            Source::CalibrationExport,
            Source::Schema,
            Source::BoardFile,
            Source::RobotDescription,
            Source::ThirdParty,
            Source::Derived,
            Source::Estimate,
            Source::User,
        ] {
            assert_eq!(source.to_string(), spelt(source));
        }
        for role in [Role::Rgb, Role::Left, Role::Right, Role::Tof] {
            assert_eq!(role.to_string(), spelt(role));
        }
        for kind in [DepthKind::Stereo, DepthKind::Tof] {
            assert_eq!(kind.to_string(), spelt(kind));
        }
    }

    #[test]
    fn keys_default_to_the_source_of_their_table() {
        let device = Catalog::builtin().device("OAK4-D").unwrap();
        let pro = Catalog::builtin().device("OAK-D Pro PoE").unwrap();
        assert_eq!(pro.body.source_of("mass_g"), Source::VendorPage);
        assert_eq!(device.body.source_of("mass_g"), Source::Estimate);
        let imu = device.imu.as_ref().unwrap();
        assert_eq!(imu.source_of("model"), Source::Document);
        assert_eq!(imu.source_of("rotation"), Source::Estimate);
        assert_eq!(device.cameras[0].source_of("position_mm"), Source::BoardFile);
        assert_eq!(device.cameras[0].source_of("hfov_deg"), Source::Document);
    }
}
