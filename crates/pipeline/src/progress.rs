//! Progress and interruption of long tasks: one protocol for all of them.

use std::ops::ControlFlow;

/// The progress of a task, in images, pairs or captures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Progress {
    /// The number of items that are done.
    pub done: u64,
    /// The number of items known so far.
    pub total: u64,
}

/// Receives the progress before and after each item, from any thread; [`ControlFlow::Break`] interrupts the task.
pub type Watch<'a> = dyn Fn(Progress) -> ControlFlow<()> + Sync + 'a;
