use oaktwin_simd::Level;

use super::census::Census;
use super::plan::PassPlan;

/// The input of both scans.
#[derive(Clone, Copy)]
pub(super) struct ScanInput<'a> {
    pub(super) level: Level,
    pub(super) plan: &'a PassPlan,
    /// The left image, and the right one mirrored.
    pub(super) census: [&'a Census; 2],
    pub(super) width: usize,
}
