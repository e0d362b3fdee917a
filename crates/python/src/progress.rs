//! The progress and the interruption of long calls.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use oaktwin::progress::Progress;
use pyo3::prelude::*;
use pyo3::types::PyBool;
use pyo3::{Borrowed, FromPyObject};

use crate::settings::mistyped;

/// `progress`: a callable that gets the progress of a call, if there is one.
#[derive(Default)]
pub(crate) struct ProgressCallback(Option<Py<PyAny>>);

impl FromPyObject<'_, '_> for ProgressCallback {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        let py = object.py();
        Ok(Self(match object.cast::<PyBool>() {
            Ok(switch) if switch.is_true() => {
                Some(py.import("oaktwin._progress")?.getattr("Bar")?.call0()?.unbind())
            }
            Ok(_) => None,
            Err(_) if object.is_callable() => Some(object.to_owned().unbind()),
            Err(_) => {
                let kinds = "True, False or a callable with the numbers of items that are done and in total";
                return Err(mistyped("progress", &object, kinds));
            }
        }))
    }
}

/// Work of a call: threads that do it tell the thread that waits for it how far they are, and are told to stop.
#[derive(Default)]
pub(crate) struct Task {
    stop: AtomicBool,
    done: AtomicU64,
    total: AtomicU64,
    report: ProgressCallback,
    reported: AtomicU64,
}

impl Task {
    pub(crate) fn new(report: ProgressCallback) -> Self {
        Self {
            report,
            // No progress has this number.
            reported: AtomicU64::new(u64::MAX),
            ..Self::default()
        }
    }

    /// Notes the progress, on any thread, and interrupts work that is to stop.
    pub(crate) fn watch(&self, progress: Progress) -> ControlFlow<()> {
        self.total.store(progress.total, Ordering::Relaxed);
        self.done.fetch_max(progress.done, Ordering::Relaxed);
        match self.stop.load(Ordering::Relaxed) {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    }

    /// Handles signals and reports the progress, with the interpreter held. An exception stops the work.
    pub(crate) fn check(&self, py: Python<'_>) -> PyResult<()> {
        let checked = py.check_signals().and_then(|()| self.report(py));
        if checked.is_err() {
            self.stop();
        }
        checked
    }

    /// Whether the work is to stop.
    pub(crate) fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Stops the work.
    pub(crate) fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// Reports the progress if it has changed.
    pub(crate) fn report(&self, py: Python<'_>) -> PyResult<()> {
        let Some(report) = &self.report.0 else {
            return Ok(());
        };
        let [done, total] = [&self.done, &self.total].map(|number| number.load(Ordering::Relaxed));
        if total > 0 && self.reported.swap(done, Ordering::Relaxed) != done {
            report.call1(py, (done, total))?;
        }
        Ok(())
    }
}
