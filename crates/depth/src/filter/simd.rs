//! The inner loops with the best instructions that the processor has.
//!
//! Each loop is written once, in plain Rust, and compiled three times; nothing is contracted or reordered, so that all
//! copies give the same bits.

#![allow(unsafe_code)]

use super::{DecimationMode, Pixel, decimation, median, spatial, speckle, temporal};

/// Instructions to use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Level {
    /// What every processor of the target has.
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Level {
    /// The best that this processor has.
    pub(super) fn detect() -> Self {
        Self::available().last().copied().unwrap_or(Self::Baseline)
    }

    /// All that this processor has.
    pub(super) fn available() -> Vec<Self> {
        let mut levels = vec![Self::Baseline];
        #[cfg(target_arch = "x86_64")]
        {
            if std::arch::is_x86_feature_detected!("avx2") {
                levels.push(Self::Avx2);
                if std::arch::is_x86_feature_detected!("avx512f")
                    && std::arch::is_x86_feature_detected!("avx512bw")
                    && std::arch::is_x86_feature_detected!("avx512dq")
                    && std::arch::is_x86_feature_detected!("avx512vl")
                {
                    levels.push(Self::Avx512);
                }
            }
        }
        levels
    }
}

/// Two weights whose sum is 1, in `DepthAI`'s single precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Weight {
    /// From 0 to 1.
    alpha: f32,
    /// From 0 to 1.
    rest: f32,
}

impl Weight {
    /// Of the first of two. What is not from 0 to 1 becomes the nearest that is, NaN 0.
    pub(super) fn new(alpha: f32) -> Self {
        let alpha = if alpha > 0.0 { alpha.min(1.0) } else { 0.0 };
        Self {
            alpha,
            rest: 1.0 - alpha,
        }
    }

    /// Mixes two; a half is rounded up.
    #[inline(always)]
    pub(super) fn mix_rounded<P: Pixel>(&self, first: P, second: P) -> P {
        // SAFETY: as below, and at most 0.5 more.
        P::cut(unsafe { (self.mix(first, second) + 0.5).to_int_unchecked() })
    }

    /// Mixes two and cuts off the fraction.
    #[inline(always)]
    pub(super) fn mix_truncated<P: Pixel>(&self, first: P, second: P) -> P {
        // SAFETY: pixels are from 0 to 65 535 and weights from 0 to 1, so that the number is from 0 to 131 070.
        P::cut(unsafe { self.mix(first, second).to_int_unchecked() })
    }

    #[inline(always)]
    fn mix<P: Pixel>(&self, first: P, second: P) -> f32 {
        Into::<f32>::into(first) * self.alpha + Into::<f32>::into(second) * self.rest
    }
}

macro_rules! at_every_level {
    ($($(#[$doc:meta])* fn $name:ident = $body:path => ($($argument:ident: $type:ty),*);)*) => {$(
        $(#[$doc])*
        pub(super) fn $name<P: Pixel>(level: Level, $($argument: $type),*) {
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2")]
            fn avx2<P: Pixel>($($argument: $type),*) {
                $body($($argument),*);
            }

            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl")]
            fn avx512<P: Pixel>($($argument: $type),*) {
                $body($($argument),*);
            }

            match level {
                Level::Baseline => $body($($argument),*),
                // SAFETY: this level exists only where `available` found the processor to have its features.
                #[cfg(target_arch = "x86_64")]
                Level::Avx2 => unsafe { avx2($($argument),*) },
                // SAFETY: as above.
                #[cfg(target_arch = "x86_64")]
                Level::Avx512 => unsafe { avx512($($argument),*) },
            }
        }
    )*};
}

at_every_level! {
    /// [`decimation::row`]
    fn decimation = decimation::row => (factor: usize, mode: DecimationMode, rows: &[&[P]], out: &mut [P]);
    /// [`median::row3`]
    fn median3 = median::row3 => (rows: [&[P]; 3], sorted: &mut [Vec<P>], out: &mut [P]);
    /// [`median::row5`]
    fn median5 = median::row5 => (rows: [&[P]; 5], sorted: &mut [Vec<P>], out: &mut [P]);
    /// [`median::row7`]
    fn median7 = median::row7 => (rows: [&[P]; 7], sorted: &mut [Vec<P>], out: &mut [P]);
    /// [`spatial::along`]
    fn spatial_along = spatial::along => (settings: &spatial::Settings<P>, rows: &mut [P], tile: &mut [P]);
    /// [`spatial::down`]
    fn spatial_down = spatial::down => (settings: &spatial::Settings<P>, above: &[P], row: &mut [P]);
    /// [`spatial::up`]
    fn spatial_up = spatial::up => (settings: &spatial::Settings<P>, below: &[P], row: &mut [P]);
    /// [`temporal::update`]
    fn temporal = temporal::update => (settings: &temporal::Settings<P>, pixels: &mut [P], last: &mut [P], history: &mut [u8]);
    /// [`speckle::links`]
    fn speckle_links = speckle::links => (threshold: P, rows: [&[P]; 2], links: &mut speckle::Links<'_>);
}
