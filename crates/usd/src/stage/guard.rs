use std::any::Any;
use std::cell::Cell;
use std::panic;
use std::sync::Once;
use std::thread;

/// Deep enough for everything that `inspect` lets through (nesting is bounded there).
const STACK_BYTES: usize = 256 << 20;

thread_local! {
    static CONTAINED: Cell<bool> = const { Cell::new(false) };
}

/// Runs `work` on a thread of its own and returns its panic message as an error.
///
/// The panic is not printed: the hook that was in place is wrapped, once per process, by one that keeps quiet on
/// threads that this function made. Every other thread's panics go to that hook as before.
pub(super) fn contained<T: Send>(work: impl FnOnce() -> T + Send) -> Result<T, String> {
    static WRAP_HOOK: Once = Once::new();
    if !thread::panicking() {
        WRAP_HOOK.call_once(|| {
            let previous = panic::take_hook();
            panic::set_hook(Box::new(move |info| {
                if !CONTAINED.with(Cell::get) {
                    previous(info);
                }
            }));
        });
    }
    thread::scope(|scope| {
        thread::Builder::new()
            .name("usd".to_owned())
            .stack_size(STACK_BYTES)
            .spawn_scoped(scope, || {
                CONTAINED.with(|flag| flag.set(true));
                work()
            })
            .map_err(|error| format!("no thread to read it on: {error}"))?
            .join()
            .map_err(|payload| message(payload.as_ref()))
    })
}

fn message(payload: &(dyn Any + Send)) -> String {
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
    fn a_panic_becomes_its_message() {
        assert_eq!(contained(|| 7), Ok(7));
        let index = [1, 2, 3].len();
        assert_eq!(
            contained(|| [1, 2, 3][index]).unwrap_err(),
            "index out of bounds: the len is 3 but the index is 3"
        );
    }
}
