//! Runs work on a thread pool with the interpreter released and Ctrl-C handled.

use std::process;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// The maximum delay of Ctrl-C.
const POLL: Duration = Duration::from_millis(50);

/// The pool of this process; a forked process creates its own, because it inherits no threads.
static POOL: Mutex<Option<(u32, &'static ThreadPool)>> = Mutex::new(None);

fn pool() -> PyResult<&'static ThreadPool> {
    let own = process::id();
    let mut pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((maker, pool)) = *pool
        && maker == own
    {
        return Ok(pool);
    }
    let made = ThreadPoolBuilder::new().build().map_err(|error| {
        PyRuntimeError::new_err(format!("cannot start threads ({error}); increase the limit"))
    })?;
    // Never dropped: a pool inherited from a parent process has no threads to end.
    let made: &'static ThreadPool = Box::leak(Box::new(made));
    *pool = Some((own, made));
    Ok(made)
}

/// Runs work on the pool, with the interpreter released.
pub(crate) fn run<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let pool = pool()?;
    Ok(py.detach(|| pool.install(work)))
}

/// Runs work on the pool if the interpreter is released already.
pub(crate) fn install<T: Send>(work: impl FnOnce() -> T + Send) -> PyResult<T> {
    Ok(pool()?.install(work))
}

fn signals(py: Python<'_>) -> PyResult<()> {
    py.check_signals()
}

/// Runs work on the pool, with the interpreter released, and raises the exception of a signal: the work is then
/// cancelled and its result dropped.
pub(crate) fn interruptible<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) -> T + Send,
) -> PyResult<T> {
    let pool = pool()?;
    let stop = AtomicBool::new(false);
    let (result, raised) = py.detach(|| {
        thread::scope(|scope| {
            let waiting = thread::current();
            let worker = scope.spawn({
                let stop = &stop;
                move || {
                    let result = pool.install(|| work(stop));
                    waiting.unpark();
                    result
                }
            });
            let mut raised = None;
            while !worker.is_finished() {
                thread::park_timeout(POLL);
                if raised.is_none()
                    && let Err(error) = Python::attach(signals)
                {
                    stop.store(true, Ordering::Relaxed);
                    raised = Some(error);
                }
            }
            (worker.join(), raised)
        })
    });
    match (result, raised) {
        (_, Some(error)) => Err(error),
        (Ok(result), None) => Ok(result),
        (Err(panic), None) => std::panic::resume_unwind(panic),
    }
}
