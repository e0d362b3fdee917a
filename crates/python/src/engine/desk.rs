//! Where threads that measure ask for the measurements of an engine in Python.
//!
//! Python handles signals on its main thread alone, and libraries such as CUDA's expect to be called on one thread. So the thread that
//! called oaktwin waits while others work, and calls the engine for them: Ctrl-C interrupts the engine as it interrupts any other code in
//! Python.

use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};
use std::thread;

use oaktwin::sensor::ParameterError;
use pyo3::prelude::*;

use super::{Answer, PythonEngine, Request};
use crate::error::{text, wrong};
use crate::progress::{ProgressCallback, Task};
use crate::threads::{self, POLL};

/// The number of an engine among those that a thread serves, what it is to measure, and the place for its answer; none if the work has been
/// cancelled.
type Question = (usize, Request, Sender<Option<Answer>>);

/// The desk of an engine; one thread at a time serves it.
#[derive(Debug, Default)]
pub(super) struct Desk {
    turn: Mutex<()>,
    questions: Mutex<Option<(usize, Sender<Question>)>>,
}

impl PythonEngine {
    /// Asks for a measurement, on any thread, with the interpreter released.
    pub(super) fn ask(&self, request: Request) -> Result<Answer, ParameterError> {
        let open = lock(&self.desk.questions).clone();
        let Some((number, sender)) = open else {
            // Nobody serves the desk.
            let answer = Python::attach(|py| self.answer(py, request));
            return answer.map_err(|failed| {
                let what = format!("{} failed: {}", self.name, text(&failed));
                ParameterError::new("engine", what, "correct the engine")
            });
        };
        let (reply, answer) = mpsc::channel();
        let asked = sender.send((number, request, reply)).ok();
        drop(sender);
        asked.and_then(|()| answer.recv().ok().flatten()).ok_or_else(|| {
            let what = format!("{} was interrupted", self.name);
            ParameterError::new("engine", what, "call it again")
        })
    }

    /// Waits until no other thread serves the desk; signals are handled.
    fn turn(&self, py: Python<'_>) -> PyResult<MutexGuard<'_, ()>> {
        loop {
            match self.desk.turn.try_lock() {
                Ok(turn) => return Ok(turn),
                Err(TryLockError::Poisoned(turn)) => return Ok(turn.into_inner()),
                Err(TryLockError::WouldBlock) if threads::is_answering(self.key()) => {
                    let is = "calls a sensor whose engine it is itself";
                    return Err(wrong(
                        "engine",
                        format!("{} {is}", self.name),
                        "call another sensor",
                    ));
                }
                Err(TryLockError::WouldBlock) => {
                    py.detach(|| thread::sleep(POLL));
                    py.check_signals()?;
                }
            }
        }
    }

    fn key(&self) -> usize {
        std::ptr::from_ref(self).addr()
    }
}

/// Runs work with the interpreter released, and serves the desk of an engine meanwhile if there is one. Without one, the work runs on this
/// thread.
pub(crate) fn away<T: Send>(
    py: Python<'_>,
    engine: Option<&Arc<PythonEngine>>,
    work: impl FnOnce() -> PyResult<T> + Send,
) -> PyResult<T> {
    match engine {
        None => py.detach(work),
        Some(engine) => serve_all(
            py,
            std::slice::from_ref(engine),
            ProgressCallback::default(),
            |_| work(),
        )?,
    }
}

/// Runs work on the pool, with the interpreter released, and serves the desks of engines meanwhile. Raises the exception of an engine or of
/// a signal: the work is then cancelled and its result dropped.
pub(crate) fn serve_all<T: Send>(
    py: Python<'_>,
    engines: &[Arc<PythonEngine>],
    report: ProgressCallback,
    work: impl FnOnce(&Task) -> T + Send,
) -> PyResult<T> {
    if engines.is_empty() {
        return threads::interruptible(py, report, work);
    }
    // Every thread takes its turns in this order, so that none waits for another one in a circle.
    let mut engines: Vec<&PythonEngine> = engines.iter().map(Arc::as_ref).collect();
    engines.sort_by_key(|engine| engine.key());
    engines.dedup_by_key(|engine| engine.key());
    let turns = engines.iter().map(|engine| engine.turn(py));
    let _turns = turns.collect::<PyResult<Vec<_>>>()?;
    let pool = threads::pool()?;
    let task = Task::new(report);
    let (sender, mut questions) = mpsc::channel();
    for (number, engine) in engines.iter().enumerate() {
        *lock(&engine.desk.questions) = Some((number, sender.clone()));
    }
    drop(sender);
    let (result, raised) = thread::scope(|scope| {
        let (task, engines) = (&task, &engines[..]);
        let worker = scope.spawn(move || {
            let _closing = Closing(engines);
            pool.install(|| work(task))
        });
        let raised = answer_all(py, engines, &mut questions, task);
        (py.detach(|| worker.join()), raised)
    });
    match (result, raised) {
        (_, Some(error)) => Err(error),
        (Ok(result), None) => task.report(py).map(|()| result),
        (Err(panic), None) => std::panic::resume_unwind(panic),
    }
}

/// Answers questions until the desks close. Returns the first exception, after which the others get no answer.
fn answer_all(
    py: Python<'_>,
    engines: &[&PythonEngine],
    questions: &mut Receiver<Question>,
    task: &Task,
) -> Option<PyErr> {
    let mut raised = None;
    loop {
        let waiting = &mut *questions;
        let done = match py.detach(move || waiting.recv_timeout(POLL)) {
            Ok((number, request, reply)) if raised.is_none() => {
                let engine = engines[number];
                let answer = threads::answering(engine.key(), || engine.answer(py, request));
                answer.map(|answer| drop(reply.send(Some(answer))))
            }
            Ok(_) => Ok(()),
            Err(RecvTimeoutError::Timeout) => task.check(py),
            Err(RecvTimeoutError::Disconnected) => return raised,
        };
        if let Err(error) = done {
            task.stop();
            raised.get_or_insert(error);
        }
    }
}

/// Closes desks, so that nobody waits for further questions.
struct Closing<'a>(&'a [&'a PythonEngine]);

impl Drop for Closing<'_> {
    fn drop(&mut self) {
        for engine in self.0 {
            *lock(&engine.desk.questions) = None;
        }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
