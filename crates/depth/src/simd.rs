//! One loop, compiled for several instruction sets; the processor's best is chosen at run time.
//!
//! A [`Kernel`] is plain code over slices, marked `#[inline(always)]` down to its last loop, so that each copy is
//! vectorized with the widest registers there are. Nothing is fused or reordered: all copies give the same bits.

#![allow(
    unsafe_code,
    reason = "functions for an instruction set are called after asking for it"
)]

/// Work to do with the best instructions. `run` must be `#[inline(always)]`, and all it calls in its loops.
pub(crate) trait Kernel {
    type Output;
    fn run(self) -> Self::Output;
}

/// Instructions to use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Level {
    /// What every processor of the target has.
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Level {
    /// The best that this processor has.
    pub(crate) fn detect() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            if Self::has_avx512() {
                return Self::Avx512;
            }
            if std::arch::is_x86_feature_detected!("avx2") {
                return Self::Avx2;
            }
        }
        Self::Baseline
    }

    /// All that this processor has.
    #[cfg(test)]
    pub(crate) fn available() -> Vec<Self> {
        let mut levels = vec![Self::Baseline];
        #[cfg(target_arch = "x86_64")]
        {
            if std::arch::is_x86_feature_detected!("avx2") {
                levels.push(Self::Avx2);
            }
            if Self::has_avx512() {
                levels.push(Self::Avx512);
            }
        }
        levels
    }

    /// That of processors since Ice Lake and Zen 4, which count bits too.
    #[cfg(target_arch = "x86_64")]
    fn has_avx512() -> bool {
        std::arch::is_x86_feature_detected!("avx2")
            && std::arch::is_x86_feature_detected!("avx512f")
            && std::arch::is_x86_feature_detected!("avx512bw")
            && std::arch::is_x86_feature_detected!("avx512dq")
            && std::arch::is_x86_feature_detected!("avx512vl")
            && std::arch::is_x86_feature_detected!("avx512bitalg")
    }
}

/// A whole number; what no `i32` can be becomes the nearest that single precision has, and not a number the least. Unlike
/// `as`, lanes of it stay lanes.
#[inline(always)]
pub(crate) fn whole(value: f32) -> i32 {
    /// 2³¹ less a step.
    const MOST: f32 = 2_147_483_520.0;
    let value = if value > -MOST { value } else { -MOST };
    let value = if value < MOST { value } else { MOST };
    // SAFETY: it is a number from −2³¹ to 2³¹, neither with it.
    unsafe { value.to_int_unchecked() }
}

/// Runs a kernel with the best instructions of this processor.
pub(crate) fn run<K: Kernel>(kernel: K) -> K::Output {
    run_at(Level::detect(), kernel)
}

/// Runs a kernel with the given instructions, which this processor must have: those of [`Level::detect`] or
/// [`Level::available`].
pub(crate) fn run_at<K: Kernel>(level: Level, kernel: K) -> K::Output {
    match level {
        Level::Baseline => kernel.run(),
        // SAFETY: a level is made only where the processor was found to have its features.
        #[cfg(target_arch = "x86_64")]
        Level::Avx2 => unsafe { avx2(kernel) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Level::Avx512 => unsafe { avx512(kernel) },
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,avx512f,avx512bw,avx512dq,avx512vl,avx512bitalg")]
fn avx512<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}
