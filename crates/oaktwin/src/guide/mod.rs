//! Five tasks, a page each, with programs that are tests.
//!
//! * [`assets`]: the numbers of a model, and its USD asset;
//! * [`ground_truth`]: exact depth and colour of a scene, as frames or as a data set;
//! * [`sensor`]: what the depth sensor reports, of a scene or of images that another program rendered;
//! * [`own_unit`]: all of that for one device, from its calibration;
//! * [`own_engine`]: an error model or a matcher of your own in the sensor.
//!
//! The types of the programs are in the [prelude](crate::prelude).

#[doc = include_str!("assets.md")]
pub mod assets {}
#[doc = include_str!("ground_truth.md")]
pub mod ground_truth {}
#[doc = include_str!("sensor.md")]
pub mod sensor {}
#[doc = include_str!("own_unit.md")]
pub mod own_unit {}
#[doc = include_str!("own_engine.md")]
pub mod own_engine {}
