use oaktwin::diagnostic::Finding;
use serde::Serialize;

use crate::options::Topics;
use crate::statistics::Percentiles;

/// What a running bridge reports.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum Event {
    /// The node was created.
    Started(Started),
    /// Something is missing, late, wrong or suspicious.
    Finding(Finding),
    /// The state, every few seconds.
    Status(Status),
    /// The state at the end.
    Stopped(Status),
}

/// What the bridge is connected to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Started {
    /// The name of the node, on which parameters are set.
    pub node: String,
    /// The domain.
    pub domain: u16,
    /// Whether only nodes of this machine are found.
    pub localhost: bool,
    /// The topics.
    pub topics: Topics,
}

/// The state of a bridge.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Status {
    /// The time since the start.
    pub seconds: f64,
    /// The depth images that arrived.
    pub received: u64,
    /// The depth images that were published.
    pub published: u64,
    /// The depth images that a newer one replaced while they waited.
    pub dropped: u64,
    /// The depth images that the publisher sent, but that did not arrive whole.
    pub lost: u64,
    /// The dropped images for which no colour image or camera info had arrived.
    pub incomplete: u64,
    /// The images that could not be used.
    pub rejected: u64,
    /// The measured images that were lost on their way, by the option `drop`.
    pub undelivered: u64,
    /// The subscribers of the measured depth.
    pub subscribers: u64,
    /// The time from the arrival of a depth image to the publication of the measured one, milliseconds; `None` before the first.
    pub latency_ms: Option<Percentiles>,
}
