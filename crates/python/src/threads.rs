//! Runs work on a thread pool with the interpreter released and Ctrl-C handled.

use std::cell::RefCell;
use std::process;
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::progress::{ProgressCallback, Task};

/// The maximum delay of Ctrl-C.
pub(crate) const POLL: Duration = Duration::from_millis(50);

/// The pools of a process; a forked process creates its own, because it inherits no threads.
static POOLS: Mutex<Option<(u32, Vec<&'static ThreadPool>)>> = Mutex::new(None);

thread_local! {
    /// The engines in Python that this thread is calling, from the outermost on.
    static ANSWERING: RefCell<Vec<usize>> = const { RefCell::new(Vec::new()) };
}

/// Calls an engine in Python, for whose answer threads of the pool may be waiting: what it calls of oaktwin has another pool.
pub(crate) fn answering<T>(engine: usize, call: impl FnOnce() -> T) -> T {
    struct Leave;
    impl Drop for Leave {
        fn drop(&mut self) {
            ANSWERING.with_borrow_mut(Vec::pop);
        }
    }
    ANSWERING.with_borrow_mut(|all| all.push(engine));
    let _leave = Leave;
    call()
}

/// Whether this thread is calling an engine in Python.
pub(crate) fn is_answering(engine: usize) -> bool {
    ANSWERING.with_borrow(|all| all.contains(&engine))
}

/// The pool for the work of this thread: another one in each engine in Python that it is calling.
pub(crate) fn pool() -> PyResult<&'static ThreadPool> {
    let level = ANSWERING.with_borrow(Vec::len);
    let own = process::id();
    let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
    let (maker, pools) = pools.get_or_insert_with(|| (own, Vec::new()));
    if *maker != own {
        (*maker, *pools) = (own, Vec::new());
    }
    if let Some(pool) = pools.get(level) {
        return Ok(pool);
    }
    let made = ThreadPoolBuilder::new().build().map_err(|error| {
        PyRuntimeError::new_err(format!("cannot start threads ({error}); increase the limit"))
    })?;
    // Never dropped: a pool inherited from a parent process has no threads to end.
    let made: &'static ThreadPool = Box::leak(Box::new(made));
    // Each level is reached from the one before it, which may not have had a pool.
    pools.resize(level + 1, made);
    Ok(made)
}

/// Runs work on the pool, with the interpreter released.
pub(crate) fn run<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let pool = pool()?;
    Ok(py.detach(|| pool.install(work)))
}

/// Runs work on the pool if the interpreter is released already. A thread of a pool stays in it.
pub(crate) fn install<T: Send>(work: impl FnOnce() -> T + Send) -> PyResult<T> {
    if rayon::current_thread_index().is_some() {
        return Ok(work());
    }
    Ok(pool()?.install(work))
}

/// The number of threads of the pool.
pub(crate) fn count() -> PyResult<usize> {
    Ok(pool()?.current_num_threads().max(1))
}

/// Runs work on the pool, with the interpreter released, and raises the exception of a signal: the work is then
/// cancelled and its result dropped.
pub(crate) fn interruptible<T: Send>(
    py: Python<'_>,
    report: ProgressCallback,
    work: impl FnOnce(&Task) -> T + Send,
) -> PyResult<T> {
    let pool = pool()?;
    let task = Task::new(report);
    let (result, raised) = py.detach(|| {
        thread::scope(|scope| {
            let waiting = thread::current();
            let worker = scope.spawn({
                let task = &task;
                move || {
                    let result = pool.install(|| work(task));
                    waiting.unpark();
                    result
                }
            });
            let mut raised = None;
            while !worker.is_finished() {
                thread::park_timeout(POLL);
                if raised.is_none()
                    && let Err(error) = Python::attach(|py| task.check(py))
                {
                    raised = Some(error);
                }
            }
            (worker.join(), raised)
        })
    });
    match (result, raised) {
        (_, Some(error)) => Err(error),
        (Ok(result), None) => task.report(py).map(|()| result),
        (Err(panic), None) => std::panic::resume_unwind(panic),
    }
}
