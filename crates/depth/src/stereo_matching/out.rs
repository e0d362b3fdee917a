/// The outputs of a pass, or of a row.
#[derive(Debug)]
pub(super) struct Out<'a> {
    /// Disparities in steps from the shift, 0 for invalid.
    pub(super) disparity: &'a mut [u16],
    pub(super) confidence: &'a mut [u8],
    /// The codes of the [reasons](crate::Reason) that depend on the position of a match; empty if they are not needed.
    pub(super) lost: &'a mut [u8],
}
