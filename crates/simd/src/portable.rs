//! No extensions: only the baseline is available.

use crate::{Kernel, LaneKernel};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extension {}

impl Extension {
    #[inline]
    pub(crate) fn detect() -> Option<Self> {
        None
    }

    pub(crate) fn available() -> Vec<Self> {
        Vec::new()
    }

    pub(crate) fn run<K: Kernel>(self, _kernel: K) -> K::Output {
        match self {}
    }

    pub(crate) fn run_lanes<K: LaneKernel>(self, _kernel: K) -> K::Output {
        match self {}
    }
}
