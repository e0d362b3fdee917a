use std::ops::ControlFlow;
use std::sync::Weak;

use tokio::sync::watch;

use crate::protocol::Failure;

/// A computation that runs. A request that was answered, with a result or without, has none.
#[derive(Debug)]
pub(crate) struct Job {
    /// Whether the request still waits: its other end is dropped with the request.
    pub(crate) waits: Weak<()>,
    /// Whether the server stops.
    pub(crate) stop: watch::Receiver<bool>,
}

impl Job {
    /// Returns an error if nobody waits for the result any more. Long loops call this.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        match self.waits.strong_count() == 0 || *self.stop.borrow() {
            true => Err(Failure::from("interrupted; ask again".to_owned())),
            false => Ok(()),
        }
    }

    /// The same for loops of the library.
    pub(crate) fn watch(&self) -> ControlFlow<()> {
        match self.check() {
            Ok(()) => ControlFlow::Continue(()),
            Err(_) => ControlFlow::Break(()),
        }
    }
}
