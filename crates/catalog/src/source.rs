use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where a number comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Source {
    /// Luxonis' parameter sheet of the OAK assets for Isaac Sim.
    Document,
    /// A maker's datasheet.
    Datasheet,
    /// A page of the vendor's documentation.
    VendorPage,
    /// The factory or user calibration of real units.
    CalibrationExport,
    /// A schema of OpenUSD or of NVIDIA's.
    Schema,
    /// Luxonis' board and housing files.
    BoardFile,
    /// Computed from other entries.
    Derived,
    /// A judgement where no source speaks.
    Estimate,
    /// The user's own.
    User,
}

/// The keys of a table whose source differs from the table's.
pub type Sources = BTreeMap<String, Source>;
