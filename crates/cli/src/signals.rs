//! Signals that end the program, which removes its unfinished files first.
//!
//! A first signal asks the running task to stop, which keeps what is complete and reports it. The program ends without the
//! task if that takes longer than [`GRACE`], if there is no task, or on a second signal.

use std::process;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU8, AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use oaktwin::files;

use crate::context::Result;
use crate::output;

/// The time that a task has to stop: the program ends within a second.
const GRACE: Duration = Duration::from_millis(800);

/// The number of the first signal; 0 before it.
static SIGNAL: AtomicU8 = AtomicU8::new(0);
/// The number of running tasks that check [`is_received`].
static TASKS: AtomicUsize = AtomicUsize::new(0);

/// Handles signals from now on.
pub(crate) fn handle() -> Result<()> {
    static HANDLER: OnceLock<std::result::Result<(), String>> = OnceLock::new();
    let handler = HANDLER.get_or_init(|| listen().map_err(|error| error.to_string()));
    let handler = handler.clone();
    handler.map_err(|error| format!("signals cannot be handled ({error}); try again").into())
}

/// Whether a signal asks the program to end.
pub(crate) fn is_received() -> bool {
    SIGNAL.load(Ordering::SeqCst) != 0
}

/// Returns the exit code after a signal: what shells report for a program that was ended by it, 130 for Ctrl-C.
pub(crate) fn exit_code() -> Option<u8> {
    let signal = SIGNAL.load(Ordering::SeqCst);
    (signal != 0).then(|| 128 + signal)
}

/// Runs a task that stops soon after a signal.
pub(crate) fn while_checked<T>(task: impl FnOnce() -> T) -> T {
    struct Running;
    impl Drop for Running {
        fn drop(&mut self) {
            TASKS.fetch_sub(1, Ordering::SeqCst);
        }
    }
    TASKS.fetch_add(1, Ordering::SeqCst);
    let _running = Running;
    task()
}

/// Handles a signal, on its own thread.
fn receive(signal: u8) {
    let is_first = SIGNAL
        .compare_exchange(0, signal, Ordering::SeqCst, Ordering::SeqCst)
        .is_ok();
    if !is_first || TASKS.load(Ordering::SeqCst) == 0 {
        end(signal);
    }
    thread::spawn(move || {
        thread::sleep(GRACE);
        end(signal);
    });
}

fn end(signal: u8) -> ! {
    files::abandon();
    output::say("interrupted: unfinished files were removed");
    process::exit(i32::from(128 + signal));
}

#[cfg(unix)]
fn listen() -> std::io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
    use signal_hook::iterator::Signals;

    // With a handler, a file that exceeds the limit on sizes is an error of the write instead of the program's end.
    let mut signals = Signals::new([SIGINT, SIGTERM, SIGXFSZ])?;
    if !ignores_hangups() {
        signals.add_signal(SIGHUP)?;
    }
    let thread = thread::Builder::new().name("signals".to_owned());
    thread.spawn(move || {
        for signal in signals.forever().filter(|signal| *signal != SIGXFSZ) {
            receive(u8::try_from(signal).unwrap_or(1));
        }
    })?;
    Ok(())
}

/// Whether the program was started to outlive its terminal, by `nohup`; elsewhere than on Linux this cannot be known, and
/// hangups end the program without this module.
#[cfg(unix)]
fn ignores_hangups() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status
        .lines()
        .find_map(|line| line.strip_prefix("SigIgn:"))
        .and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    ignored.is_none_or(|mask| mask & 1 != 0)
}

#[cfg(not(unix))]
fn listen() -> std::result::Result<(), ctrlc::Error> {
    /// The number of SIGINT.
    const INTERRUPT: u8 = 2;
    ctrlc::set_handler(|| receive(INTERRUPT))
}
