//! Panics of other libraries on corrupt input, as values.

use std::any::Any;
use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

thread_local! {
    static IS_CONTAINED: Cell<bool> = const { Cell::new(false) };
}

/// Runs work on this thread and returns the payload of a panic as an error. Nothing that the work has changed may be used after a panic.
///
/// The panic hook prints the panic, unless the program has called [`hide_contained`].
///
/// # Errors
/// Returns the payload of a panic.
pub fn contain<T>(work: impl FnOnce() -> T) -> Result<T, Box<dyn Any + Send>> {
    let outer = IS_CONTAINED.replace(true);
    let result = panic::catch_unwind(AssertUnwindSafe(work));
    IS_CONTAINED.set(outer);
    result
}

/// Wraps the current panic hook, once per process, by one that prints no [contained](contain) panics. This is for programs: libraries
/// leave the hook alone.
pub fn hide_contained() {
    static WRAP: Once = Once::new();
    WRAP.call_once(|| {
        let previous = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if !IS_CONTAINED.get() {
                previous(info);
            }
        }));
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn returns_the_payload_and_leaves_other_panics_alone() {
        hide_contained();
        assert_eq!(contain(|| 7).unwrap(), 7);
        let payload = contain(|| contain(|| 1).map(|one| assert_eq!(one, 2, "not two"))).unwrap_err();
        assert!(payload.downcast_ref::<String>().unwrap().contains("not two"));
        assert!(!IS_CONTAINED.get());
    }
}
