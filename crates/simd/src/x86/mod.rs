//! AVX2 and AVX-512.
//!
//! SAFETY of every `unsafe` block of this module: see the invariant of the crate. A type of this module reaches a kernel only
//! through [`Extension::run`], so the processor has the instructions that its operations use. Loads and stores are
//! unaligned and cover whole arrays behind references.

#![expect(unsafe_code, reason = "vector instructions that were detected at run time")]

/// Calls an intrinsic. Its safety is explained at the top of the module.
macro_rules! intrinsic {
    ($call:expr) => {
        unsafe { $call }
    };
}

/// Implements an operator by an intrinsic.
macro_rules! operator {
    ([$($generics:tt)*] $vector:ty, $operator:ident::$method:ident, $intrinsic:ident) => {
        impl<$($generics)*> std::ops::$operator for $vector {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self::new(intrinsic!($intrinsic(self.0, other.0)))
            }
        }
    };
}

mod f32;
mod f64;
mod i32;

use self::f32::F32;
use self::f64::{Double, RegisterPair};
use crate::{Kernel, LaneKernel};

/// Instructions beyond the baseline that this processor has. Only this module creates values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Extension(Instructions);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Instructions {
    Avx2,
    Avx512,
}

impl Extension {
    #[inline]
    pub(crate) fn detect() -> Option<Self> {
        if has_avx512() {
            Some(Self(Instructions::Avx512))
        } else if has_avx2() {
            Some(Self(Instructions::Avx2))
        } else {
            None
        }
    }

    pub(crate) fn available() -> Vec<Self> {
        let all = [
            (has_avx2(), Instructions::Avx2),
            (has_avx512(), Instructions::Avx512),
        ];
        all.into_iter()
            .filter_map(|(is_available, instructions)| is_available.then_some(Self(instructions)))
            .collect()
    }

    pub(crate) fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self.0 {
            Instructions::Avx2 => unsafe { avx2(kernel) },
            Instructions::Avx512 => unsafe { avx512(kernel) },
        }
    }

    #[inline]
    pub(crate) fn run_lanes<K: LaneKernel>(self, kernel: K) -> K::Output {
        match self.0 {
            Instructions::Avx2 => unsafe { avx2_lanes(kernel) },
            Instructions::Avx512 => unsafe { avx512_lanes(kernel) },
        }
    }
}

#[inline]
fn has_avx2() -> bool {
    std::arch::is_x86_feature_detected!("avx2")
}

/// The subset of AVX-512 since Ice Lake and Zen 4, which includes counting of bits.
#[inline]
fn has_avx512() -> bool {
    has_avx2()
        && std::arch::is_x86_feature_detected!("avx512f")
        && std::arch::is_x86_feature_detected!("avx512bw")
        && std::arch::is_x86_feature_detected!("avx512dq")
        && std::arch::is_x86_feature_detected!("avx512vl")
        && std::arch::is_x86_feature_detected!("avx512bitalg")
}

#[target_feature(enable = "avx2")]
fn avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}

#[target_feature(enable = "avx2,avx512f,avx512bw,avx512dq,avx512vl,avx512bitalg")]
fn avx512<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}

#[target_feature(enable = "avx2")]
fn avx2_lanes<K: LaneKernel>(kernel: K) -> K::Output {
    kernel.run::<F32<RegisterPair>>()
}

#[target_feature(enable = "avx2,avx512f,avx512bw,avx512dq,avx512vl,avx512bitalg")]
fn avx512_lanes<K: LaneKernel>(kernel: K) -> K::Output {
    kernel.run::<F32<Double>>()
}
