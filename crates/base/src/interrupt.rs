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

    use super::*;

    #[test]
    fn a_thread_works_until_its_result_is_dropped() {
        assert!(!is_unwanted());
        let result = Arc::new(());
        std::thread::scope(|scope| {
            let wanted = Arc::downgrade(&result);
            let (first, second) = (std::sync::Barrier::new(2), std::sync::Barrier::new(2));
            let (first, second) = (&first, &second);
            let worker = scope.spawn(move || {
                watch(wanted);
                let before = is_unwanted();
                first.wait();
                second.wait();
                (before, is_unwanted())
            });
            first.wait();
            drop(result);
            second.wait();
            assert_eq!(worker.join().unwrap(), (false, true));
        });
        assert!(!is_unwanted());
    }
}
