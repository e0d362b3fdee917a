use thiserror::Error;

use crate::usdz::UsdzError;

/// The reason why an asset cannot be made of a twin.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum AssetError {
    /// The fisheye lens was requested for a model without wide stereo lenses.
    #[error("{model}: lens: its stereo cameras have no fisheye field of view; use the pinhole lens")]
    NoFisheyeLens {
        /// The device's name.
        model: String,
    },
    /// Extended disparity was requested for a model that lacks it.
    #[error("{model}: {sensor}: extended disparity is not supported; omit the option")]
    NoExtendedDisparity {
        /// The device's name.
        model: String,
        /// The depth sensor's camera prim.
        sensor: String,
    },
    /// A depth sensor refers to a camera that the device lacks.
    #[error("{model}: {sensor}: the device has no {role} camera; name an existing camera")]
    MissingCamera {
        /// The device's name.
        model: String,
        /// The depth sensor's camera prim.
        sensor: String,
        /// The camera's role.
        role: String,
    },
    /// A number is infinite or NaN, or too large for 32 bits.
    #[error("{model}: {property}: not a finite 32-bit number; correct the catalog or the calibration")]
    NotFinite {
        /// The device's name.
        model: String,
        /// The property's path.
        property: String,
    },
    /// An integer exceeds OpenUSD's `int`.
    #[error("{model}: {place}: {value} exceeds OpenUSD's int; use a smaller value")]
    TooLarge {
        /// The device's name.
        model: String,
        /// The quantity.
        place: String,
        /// The number.
        value: u32,
    },
    /// A name is not a valid prim name.
    #[error("{model}: {parent}: invalid prim name {name:?}; use letters, digits and underscores")]
    Name {
        /// The device's name.
        model: String,
        /// The parent prim's path.
        parent: String,
        /// The name.
        name: String,
    },
    /// Two prims have the same path.
    #[error("{model}: {path}: duplicate prim path; rename one of the two prims")]
    Duplicate {
        /// The device's name.
        model: String,
        /// The path.
        path: String,
    },
    /// The overrides of a model do not fit the asset.
    #[error("{asset}: {what}, so it is not an asset of the {model}; give the vendor's asset of that model")]
    NoBase {
        /// The asset's file.
        asset: String,
        /// The device's name.
        model: String,
        /// The missing part.
        what: String,
    },
    /// Overrides were requested for a twin without a calibration.
    #[error("{model}: nothing to override without a calibration; give one")]
    NothingToOverride {
        /// The device's name.
        model: String,
    },
    /// The package could not be written.
    #[error(transparent)]
    Usdz(#[from] UsdzError),
}
