//! A bar on standard error for what takes longer than a moment; none where that is no terminal.

use std::sync::Mutex;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// What is done sooner has no bar.
const MOMENT: Duration = Duration::from_secs(1);

pub(crate) struct Progress {
    start: Instant,
    bar: Option<ProgressBar>,
}

impl Progress {
    pub(crate) fn new() -> Self {
        Self {
            start: Instant::now(),
            bar: None,
        }
    }

    pub(crate) fn at(&mut self, done: u64, total: u64) {
        if self.bar.is_none() && self.start.elapsed() < MOMENT {
            return;
        }
        let bar = self.bar.get_or_insert_with(|| {
            let style = ProgressStyle::with_template("{bar:40} {pos}/{len} images, {eta} left");
            let bar = ProgressBar::new(total);
            style.map_or(bar.clone(), |style| bar.with_style(style))
        });
        // What there is to do may become known on the way.
        bar.set_length(total);
        bar.set_position(done);
    }
}

/// The bar of what several threads do.
pub(crate) struct SharedProgress(Mutex<Progress>);

impl SharedProgress {
    pub(crate) fn new() -> Self {
        Self(Mutex::new(Progress::new()))
    }

    pub(crate) fn at(&self, done: u64, total: u64) {
        if let Ok(mut progress) = self.0.lock() {
            progress.at(done, total);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
