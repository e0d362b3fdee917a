//! Progress bars.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use oaktwin::progress::{Progress, Watch};

use crate::signals;

/// Shorter tasks have no bar.
const DELAY: Duration = Duration::from_secs(1);

/// Runs a task with a progress bar on standard error if that is a terminal. A signal such as Ctrl-C interrupts the task.
pub(crate) fn watched<T>(task: impl FnOnce(&Watch<'_>) -> T) -> T {
    let bar = Mutex::new(Bar {
        start: Instant::now(),
        bar: None,
    });
    signals::while_checked(|| {
        task(&|progress| {
            if let Ok(mut bar) = bar.lock() {
                bar.set(progress);
            }
            if signals::is_received() {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        })
    })
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
