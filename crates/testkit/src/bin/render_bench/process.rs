//! What a process knows of itself: processor time and memory. Zeros where the system does not say.

use std::fs;

/// The processor time of all its threads so far, seconds.
pub(crate) fn cpu_s() -> f64 {
    let Ok(threads) = fs::read_dir("/proc/self/task") else {
        return 0.0;
    };
    let nanoseconds: u64 = threads
        .flatten()
        .filter_map(|thread| fs::read_to_string(thread.path().join("schedstat")).ok())
        .filter_map(|text| text.split_whitespace().next()?.parse::<u64>().ok())
        .sum();
    #[expect(clippy::cast_precision_loss, reason = "a time in double precision")]
    let seconds = nanoseconds as f64 * 1e-9;
    seconds
}

/// What it holds in memory now, bytes.
pub(crate) fn resident_bytes() -> u64 {
    status("VmRSS:")
}

/// The most that it ever held, bytes.
pub(crate) fn peak_bytes() -> u64 {
    status("VmHWM:")
}

fn status(field: &str) -> u64 {
    let text = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix(field));
    let kilobytes = line.and_then(|rest| rest.split_whitespace().next()?.parse::<u64>().ok());
    kilobytes.unwrap_or(0) * 1024
}
