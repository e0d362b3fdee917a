//! The commands, one per module.

pub(crate) mod accuracy;
pub(crate) mod asset;
#[cfg(feature = "bridge")]
pub(crate) mod bridge;
pub(crate) mod calibration;
pub(crate) mod check;
pub(crate) mod compare;
pub(crate) mod coverage;
pub(crate) mod demo;
pub(crate) mod export;
pub(crate) mod fit;
pub(crate) mod generate;
pub(crate) mod manual;
pub(crate) mod models;
pub(crate) mod params;
pub(crate) mod population;
pub(crate) mod render;
pub(crate) mod sense;
pub(crate) mod show;
pub(crate) mod stereo;
pub(crate) mod studio;
