use thiserror::Error;

use crate::usdz::UsdzError;

/// What keeps a twin from becoming an asset.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum AssetError {
    /// The fisheye lens was asked of a model without wide stereo lenses.
    #[error("{model}: lens: its stereo cameras have no fisheye field of view; use the pinhole lens")]
    NoFisheyeLens {
        /// The device's name.
        model: String,
    },
    /// The extended mode was asked of a model that lacks it.
    #[error("{model}: {sensor}: no extended disparity mode is known for it; leave the option out")]
    NoExtendedDisparity {
        /// The device's name.
        model: String,
        /// The depth sensor's camera prim.
        sensor: String,
    },
    /// A depth sensor stands on a camera that the device lacks.
    #[error("{model}: {sensor}: the device has no {role} camera; name one of its own")]
    MissingCamera {
        /// The device's name.
        model: String,
        /// The depth sensor's camera prim.
        sensor: String,
        /// The camera's role.
        role: String,
    },
    /// A number that no asset may hold.
    #[error("{model}: {property}: not a finite 32-bit number; correct the catalog or the calibration")]
    NotFinite {
        /// The device's name.
        model: String,
        /// The property's path.
        property: String,
    },
    /// A whole number beyond OpenUSD's `int`.
    #[error("{model}: {place}: {value} is more than OpenUSD's int holds; use a smaller one")]
    TooLarge {
        /// The device's name.
        model: String,
        /// What it is.
        place: String,
        /// The number.
        value: u32,
    },
    /// A name that no prim may have.
    #[error("{model}: {parent}: {name:?} is no prim name; use letters, digits and underscores")]
    Name {
        /// The device's name.
        model: String,
        /// The parent prim's path.
        parent: String,
        /// The name.
        name: String,
    },
    /// Two prims of one name.
    #[error("{model}: {path}: two prims have this path; rename one")]
    Duplicate {
        /// The device's name.
        model: String,
        /// The path.
        path: String,
    },
    /// An asset that the overrides of a model do not fit.
    #[error("{asset}: {what}, so it is no asset of an {model}; name the vendor's asset of that model")]
    NoBase {
        /// The asset's file.
        asset: String,
        /// The device's name.
        model: String,
        /// What is missing.
        what: String,
    },
    /// A layer of overrides was asked of a twin without a calibration.
    #[error("{model}: nothing to override: its numbers are the nominal ones; give a calibration")]
    NothingToOverride {
        /// The device's name.
        model: String,
    },
    /// The package could not be made.
    #[error(transparent)]
    Usdz(#[from] UsdzError),
}
