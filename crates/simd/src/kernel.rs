use crate::scalar::F32;
use crate::{Extension, Lanes};

/// Work that the compiler vectorizes for each [`Level`].
pub trait Kernel {
    /// The result.
    type Output;

    /// Does the work. This function and everything that its loops call must be `#[inline(always)]`; closures are
    /// compiled without the level's instructions.
    fn run(self) -> Self::Output;
}

/// Work that is written with [`Lanes`].
pub trait LaneKernel {
    /// The result.
    type Output;

    /// Does the work, as in [`Kernel::run`].
    fn run<L: Lanes>(self) -> Self::Output;
}

/// A set of vector instructions that this processor has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Level(Option<Extension>);

impl Level {
    /// The instructions that every processor of the target has.
    pub const BASELINE: Self = Self(None);

    /// Returns the best level of this processor.
    #[inline]
    #[must_use]
    pub fn detect() -> Self {
        Self(Extension::detect())
    }

    /// Returns all levels of this processor, the baseline first.
    #[must_use]
    pub fn available() -> Vec<Self> {
        let extensions = Extension::available().into_iter().map(Some);
        std::iter::once(None).chain(extensions).map(Self).collect()
    }
}

/// Runs a kernel at the best level of this processor.
pub fn run<K: Kernel>(kernel: K) -> K::Output {
    run_at(Level::detect(), kernel)
}

/// Runs a kernel at a level.
pub fn run_at<K: Kernel>(level: Level, kernel: K) -> K::Output {
    match level.0 {
        None => kernel.run(),
        Some(extension) => extension.run(kernel),
    }
}

/// Runs a kernel with the vector types of a level.
#[inline]
pub fn run_lanes_at<K: LaneKernel>(level: Level, kernel: K) -> K::Output {
    match level.0 {
        None => kernel.run::<F32>(),
        Some(extension) => extension.run_lanes(kernel),
    }
}
