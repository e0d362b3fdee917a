//! The order in which pixels are shaded.

/// The rows and columns of a tile. Its pixels see mostly the same surfaces, which therefore
/// stay in the cache.
pub(super) const TILE: u32 = 16;

/// Returns the columns and rows of some rows, tile by tile.
pub(super) fn in_tiles(
    width: u32,
    rows: impl Iterator<Item = u32> + Clone,
) -> impl Iterator<Item = [u32; 2]> {
    (0..width).step_by(TILE as usize).flat_map(move |left| {
        let columns = left..(left + TILE).min(width);
        rows.clone()
            .flat_map(move |y| columns.clone().map(move |x| [x, y]))
    })
}
