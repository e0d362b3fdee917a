//! The parts of an image that are rendered.

/// The number of columns and of rows of a block.
pub(crate) const BLOCK: u32 = 8;

/// Blocks of pixels, of which some are rendered. Their size is that in which both backends skip hidden surfaces.
#[derive(Clone, Debug)]
pub(crate) struct Blocks {
    across: u32,
    are_rendered: Vec<bool>,
}

impl Blocks {
    /// Returns the blocks of an image, of which none is rendered.
    pub(crate) fn none(width: u32, height: u32) -> Self {
        let (across, down) = (width.div_ceil(BLOCK), height.div_ceil(BLOCK));
        Self {
            across,
            are_rendered: vec![false; across as usize * down as usize],
        }
    }

    /// Adds the block of a pixel of the image.
    #[inline]
    pub(crate) fn add(&mut self, x: u32, y: u32) {
        let at = self.index(x / BLOCK, y / BLOCK);
        if let Some(is_rendered) = self.are_rendered.get_mut(at) {
            *is_rendered = true;
        }
    }

    /// Whether the block in a column and a row of blocks is rendered.
    #[inline]
    pub(crate) fn contains(&self, column: u32, row: u32) -> bool {
        column < self.across && self.are_rendered.get(self.index(column, row)) == Some(&true)
    }

    fn index(&self, column: u32, row: u32) -> usize {
        row as usize * self.across as usize + column as usize
    }
}
