//! Processor time and memory of this process; zero if the system does not report them.

use std::fs;
use std::time::Instant;

/// The time that work took, in seconds.
#[derive(Clone, Copy, Debug)]
pub struct Elapsed {
    /// By the clock.
    pub wall_s: f64,
    /// Of the processor, summed over all threads of this process.
    pub cpu_s: f64,
}

/// Does work and measures its time.
pub fn timed<T>(work: impl FnOnce() -> T) -> (T, Elapsed) {
    let (start, cpu) = (Instant::now(), cpu_s());
    let value = work();
    let elapsed = Elapsed {
        wall_s: start.elapsed().as_secs_f64(),
        cpu_s: cpu_s() - cpu,
    };
    (value, elapsed)
}

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
