//! Processor time and memory of this process; zero if the system does not report them.

use std::fs;

/// Returns the processor time in seconds of all threads so far, including those that have ended.
#[must_use]
pub fn cpu_s() -> f64 {
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
        #[expect(clippy::cast_precision_loss, reason = "a time in double precision")]
        let seconds = time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9;
        seconds
    }
    #[cfg(not(unix))]
    0.0
}

/// Returns the resident memory in bytes.
#[must_use]
pub fn resident_bytes() -> u64 {
    status("VmRSS:")
}

/// Returns the peak resident memory in bytes.
#[must_use]
pub fn peak_bytes() -> u64 {
    status("VmHWM:")
}

fn status(field: &str) -> u64 {
    let text = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix(field));
    let kilobytes = line.and_then(|rest| rest.split_whitespace().next()?.parse::<u64>().ok());
    kilobytes.unwrap_or(0) * 1024
}
