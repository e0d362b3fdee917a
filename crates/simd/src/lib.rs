//! Pixel loops that run with the best vector instructions of the processor.
//!
//! - A [`Kernel`] is plain code over slices. It is compiled once for each [`Level`] and vectorized by the compiler.
//! - A [`LaneKernel`] is written with explicit operations on eight [`Lanes`].
//!
//! No operation is fused or reordered, so a kernel gives the same bits at every level: AVX2 and AVX-512 on x86-64, NEON on
//! 64-bit Arm. The feature `portable` leaves only [`Level::BASELINE`], which is all there is on other processors.
//!
//! # Safety
//! This is the only crate with vector instructions. Its invariant: a [`Level`] above the baseline exists only on a
//! processor that has the level's features, because detection alone creates it; and the vector types of a level reach a
//! kernel only through [`run_lanes_at`] with that level.

mod kernel;
mod lanes;
#[cfg(all(target_arch = "aarch64", not(feature = "portable")))]
mod neon;
#[cfg(any(
    not(any(target_arch = "aarch64", target_arch = "x86_64")),
    feature = "portable"
))]
mod portable;
mod scalar;
#[cfg(test)]
mod tests;
mod unchecked;
#[cfg(all(target_arch = "x86_64", not(feature = "portable")))]
mod x86;

pub use kernel::{Kernel, LaneKernel, Level, run, run_at, run_lanes_at};
pub use lanes::{F64Lanes, I32Lanes, Lanes, PackedVertex};
pub use scalar::round_ties_even;
pub use unchecked::{Weight, saturating_trunc};

#[cfg(all(target_arch = "aarch64", not(feature = "portable")))]
use neon::Extension;
#[cfg(any(
    not(any(target_arch = "aarch64", target_arch = "x86_64")),
    feature = "portable"
))]
use portable::Extension;
#[cfg(all(target_arch = "x86_64", not(feature = "portable")))]
use x86::Extension;
