//! Progress bars, and Ctrl-C.

use std::ops::ControlFlow;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, OnceLock};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use oaktwin::progress::{Progress, Watch};

use crate::context::{Exit, Result};

/// Shorter tasks have no bar.
const DELAY: Duration = Duration::from_secs(1);

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Runs a task with a progress bar on standard error if that is a terminal. The first Ctrl-C interrupts the task, the second
/// one ends the program.
pub(crate) fn watched<T>(task: impl FnOnce(&Watch<'_>) -> T) -> Result<T> {
    handle_interrupts()?;
    let bar = Mutex::new(Bar {
        start: Instant::now(),
        bar: None,
    });
    Ok(task(&|progress| {
        if let Ok(mut bar) = bar.lock() {
            bar.set(progress);
        }
        if INTERRUPTED.load(Ordering::SeqCst) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }))
}

/// From now on, Ctrl-C interrupts tasks instead of killing the program.
pub(crate) fn handle_interrupts() -> Result<()> {
    static HANDLER: OnceLock<std::result::Result<(), String>> = OnceLock::new();
    let set = || {
        let handler = || {
            if INTERRUPTED.swap(true, Ordering::SeqCst) {
                process::exit(Exit::Interrupted.code().into());
            }
        };
        ctrlc::set_handler(handler).map_err(|error| error.to_string())
    };
    let handler = HANDLER.get_or_init(set).clone();
    handler.map_err(|error| format!("Ctrl-C cannot be handled ({error}); try again").into())
}

struct Bar {
    start: Instant,
    bar: Option<ProgressBar>,
}

impl Bar {
    fn set(&mut self, Progress { done, total }: Progress) {
        if self.bar.is_none() && self.start.elapsed() < DELAY {
            return;
        }
        let bar = self.bar.get_or_insert_with(|| {
            let style = ProgressStyle::with_template("{bar:40} {pos}/{len}, {eta} left");
            let bar = ProgressBar::new(total);
            style.map_or(bar.clone(), |style| bar.with_style(style))
        });
        bar.set_length(total);
        bar.set_position(done);
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
