//! Units of a model, drawn around its nominal values with the spread of real calibrations.
//!
//! A [`Population`] draws any number of [`Unit`]s: each has its own focal lengths, principal points, distortion, poses and
//! boresight. A unit is a function of the model, the seed and its number. It can be used like any twin, and exported as a
//! calibration for `DepthAI`. Where the [`Spread`] comes from is written down with the number of calibrations; for families with
//! fewer than three, it is the measured family's, as an estimate.

mod draw;
mod spread;
mod summary;

pub use draw::{Population, Unit};
pub use spread::{Basis, Spread};
pub use summary::{Statistics, UnitPairSummary, UnitSummary};
