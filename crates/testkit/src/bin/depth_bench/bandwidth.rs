//! The machine's memory bandwidth: a lower bound for the time of a frame.

use std::hint::black_box;
use std::time::Instant;

/// Larger than any cache.
const BYTES: usize = 256 << 20;
const RUNS: usize = 5;

/// Bytes read and written per second when copying with this many threads: the best of several runs.
pub(crate) fn copying(threads: usize) -> f64 {
    let from = vec![1u64; BYTES / 8];
    let mut to = vec![0u64; BYTES / 8];
    let chunk = from.len().div_ceil(threads);
    let mut best = f64::INFINITY;
    for _ in 0..RUNS {
        let start = Instant::now();
        std::thread::scope(|scope| {
            for (from, to) in from.chunks(chunk).zip(to.chunks_mut(chunk)) {
                scope.spawn(move || to.copy_from_slice(black_box(from)));
            }
        });
        best = best.min(start.elapsed().as_secs_f64());
        black_box(&mut to);
    }
    2.0 * BYTES as f64 / best
}
