use super::super::parameters::{ConfidenceMetrics, HoleFilling, Parameters};
use crate::preset::Platform;

/// The steps of RVC4.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Steps {
    pub(super) metrics: ConfidenceMetrics,
    pub(super) holes: Option<HoleFilling>,
    /// The confidence below which pixels are filtered.
    pub(super) median: Option<u8>,
    /// The number of fractional bits of a disparity.
    pub(super) bits: u32,
    /// The minimum confidence of a valid pixel.
    pub(super) kept_from: u8,
}

impl Steps {
    /// Returns the steps, or `None` on another platform.
    pub(in super::super) fn new(p: &Parameters) -> Option<Self> {
        (p.platform == Platform::Rvc4).then_some(Self {
            metrics: p.confidence_metrics,
            holes: p.hole_filling.enable.then_some(p.hole_filling),
            median: p
                .adaptive_median
                .enable
                .then_some(p.adaptive_median.confidence_threshold),
            bits: p.subpixel.bits(),
            kept_from: p.confidence_threshold,
        })
    }

    /// Whether the steps need the disparities of the right image.
    pub(in super::super) fn look_back(&self) -> bool {
        self.metrics.occlusion_weight > 0
    }
}
