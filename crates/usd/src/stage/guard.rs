use std::any::Any;
use std::io;
use std::thread::{self, JoinHandle};

use oaktwin_base::panics;

/// The stack size: sufficient for everything that `inspect` accepts, which bounds nesting.
const STACK_BYTES: usize = 256 << 20;

/// The payload of the error if the thread cannot be started.
#[derive(Debug)]
pub(super) struct NoThread(pub(super) io::Error);

/// The payload of a panic.
pub(super) type Payload = Box<dyn Any + Send>;

/// Starts `work` on a thread of its own, whose result is the payload of a panic.
pub(super) fn start(
    work: impl FnOnce() + Send + 'static,
) -> Result<JoinHandle<Result<(), Payload>>, Payload> {
    builder()
        .spawn(|| panics::contain(work))
        .map_err(|error| -> Payload { Box::new(NoThread(error)) })
}

fn builder() -> thread::Builder {
    thread::Builder::new()
        .name("usd".to_owned())
        .stack_size(STACK_BYTES)
}

/// Runs `work` on a separate thread and returns the payload of a panic as an error.
pub(super) fn contained<T: Send>(work: impl FnOnce() -> T + Send) -> Result<T, Payload> {
    // The fuzzer's own thread has such a stack; with a sanitizer, starting another takes longer than most stages.
    if cfg!(fuzzing) {
        return panics::contain(work);
    }
    thread::scope(|scope| {
        builder()
            .spawn_scoped(scope, || panics::contain(work))
            .map_err(|error| -> Payload { Box::new(NoThread(error)) })?
            .join()?
    })
}

/// Returns the message of a panic.
pub(super) fn message(payload: &(dyn Any + Send)) -> String {
    payload
        .downcast_ref::<&str>()
        .map(|text| (*text).to_owned())
        .or_else(|| payload.downcast_ref::<String>().cloned())
        .map_or_else(|| "panic".to_owned(), |text| super::error::one_line(&text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn returns_the_panic_message() {
        assert_eq!(contained(|| 7).unwrap(), 7);
        let index = [1, 2, 3].len();
        let payload = contained(|| [1, 2, 3][index]).unwrap_err();
        assert_eq!(
            message(payload.as_ref()),
            "index out of bounds: the len is 3 but the index is 3"
        );
    }
}
