use oaktwin_simd::Level;

use super::census::Census;
use super::plan::Plan;

/// The input of both scans.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    pub(super) level: Level,
    pub(super) plan: &'a Plan,
    /// The left image, and the right one mirrored.
    pub(super) census: [&'a Census; 2],
    pub(super) width: usize,
}
