use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use oaktwin::diagnostic::{Opt, with_style};

use crate::protocol::Failure;

/// Runs a computation without blocking other requests. Options in its messages are spelled as on the command line.
pub(crate) async fn blocking<T: Send + 'static>(
    compute: impl FnOnce() -> Result<T, Failure> + Send + 'static,
) -> Result<T, Failure> {
    let task = tokio::task::spawn_blocking(|| with_style(flag, compute));
    let failed = "the computation failed; please report this";
    task.await
        .unwrap_or_else(|_| Err(Failure::from(failed.to_owned())))
}

fn flag(option: &Opt) -> String {
    match option.is_command() {
        true => format!("`oaktwin {}`", option.name()),
        false => format!("--{}", option.name()),
    }
}

/// Exists while a client waits for its answer.
pub(crate) struct Presence(Arc<AtomicBool>);

impl Presence {
    /// Also returns what is true once the client has left.
    pub(crate) fn new() -> (Self, Arc<AtomicBool>) {
        let has_left = Arc::new(AtomicBool::new(false));
        (Self(Arc::clone(&has_left)), has_left)
    }
}

impl Drop for Presence {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}
