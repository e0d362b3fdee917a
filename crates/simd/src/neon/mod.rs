//! NEON, which every processor of a 64-bit Arm target has.
//!
//! SAFETY of every `unsafe` block of this module: the target's baseline has the instructions. Loads and stores are unaligned
//! and cover whole arrays behind references.

#![expect(unsafe_code, reason = "vector instructions of the baseline")]

/// Calls an intrinsic. Its safety is explained at the top of the module.
macro_rules! intrinsic {
    ($call:expr) => {
        unsafe { $call }
    };
}

/// Implements operators by intrinsics, for each register of a vector.
macro_rules! operators {
    ($vector:ident: $($operator:ident::$method:ident = $intrinsic:ident),*) => {$(
        impl std::ops::$operator for $vector {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| intrinsic!($intrinsic(a, b)))
            }
        }
    )*};
}

mod f32;
mod f64;
mod i32;

use self::f32::F32;
use crate::{Kernel, LaneKernel};

/// The vector types of this module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Extension;

impl Extension {
    #[inline]
    pub(crate) fn detect() -> Option<Self> {
        Some(Self)
    }

    pub(crate) fn available() -> Vec<Self> {
        vec![Self]
    }

    pub(crate) fn run<K: Kernel>(self, kernel: K) -> K::Output {
        kernel.run()
    }

    #[inline]
    pub(crate) fn run_lanes<K: LaneKernel>(self, kernel: K) -> K::Output {
        kernel.run::<F32>()
    }
}
