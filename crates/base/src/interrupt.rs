//! Work that nobody wants any more.
//!
//! A program that answers changing requests, such as a page, gives a computation threads of its own and calls [`watch`] in each of
//! them. Loops over the rows of an image ask [`is_unwanted`] and end early. What they leave is arbitrary: whoever no longer wants the
//! result discards it, with everything that was made of it. Without [`watch`], no loop ever ends early.

use std::cell::RefCell;
use std::sync::Weak;

thread_local! {
    static WANTED: RefCell<Option<Weak<()>>> = const { RefCell::new(None) };
}

/// From now on, what this thread computes is wanted for as long as somebody holds the other end.
pub fn watch(wanted: Weak<()>) {
    WANTED.with(|own| *own.borrow_mut() = Some(wanted));
}

/// Whether nobody wants any more what this thread computes.
#[must_use]
pub fn is_unwanted() -> bool {
    WANTED.with(|own| (own.borrow().as_ref()).is_some_and(|wanted| wanted.strong_count() == 0))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::sync::mpsc::channel;

    use super::*;

    #[test]
    fn a_thread_works_until_its_result_is_dropped() {
        assert!(!is_unwanted());
        let result = Arc::new(());
        let wanted = Arc::downgrade(&result);
        let (to_worker, from_test) = channel::<()>();
        let (to_test, from_worker) = channel();
        let worker = std::thread::spawn(move || {
            watch(wanted);
            to_test.send(is_unwanted()).unwrap();
            from_test.recv().unwrap();
            is_unwanted()
        });
        assert!(!from_worker.recv().unwrap());
        drop(result);
        to_worker.send(()).unwrap();
        assert!(worker.join().unwrap());
        assert!(!is_unwanted());
    }
}
