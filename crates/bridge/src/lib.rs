//! A live filter between topics of ROS 2: a simulator publishes exact depth, and the bridge publishes what an OAK would report.
//!
//! * [`message`] has the messages, [`convert`] turns them into images and back, without a network;
//! * [`DepthFilter`] measures a frame with the engines, presets and filters of `oaktwin sense`;
//! * [`run`] connects both to topics, and reports what is missing, late or wrong.
//!
//! Messages are published best-effort by default, as sensor data: a subscription that requires reliable delivery does not match, which is
//! reported. A newer frame replaces the one that waits for the filter, so the bridge is never behind by more than one frame.

mod buffers;
pub mod convert;
mod delivery;
mod environment;
mod error;
mod event;
mod filter;
mod graph;
mod mailbox;
pub mod message;
mod node;
mod options;
mod output;
mod parameters;
mod process;
mod publishers;
mod receive;
mod run;
mod statistics;
mod transforms;
mod unicast;
mod watch;

pub use delivery::Delivery;
pub use environment::Network;
pub use error::BridgeError;
pub use event::{Event, Started, Status};
pub use filter::{DepthFilter, FilterInput, FilterOutput};
pub use options::{BridgeOptions, Topics};
pub use run::run;
pub use statistics::Percentiles;
pub use transforms::DeviceFrames;
