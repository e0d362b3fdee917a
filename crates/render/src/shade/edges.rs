//! Antialiased outlines.

use glam::Vec3;
use oaktwin_base::interrupt;
use oaktwin_camera::{Intrinsics, Usd};
use oaktwin_image::Image;
use rayon::prelude::*;

use super::ShadingContext;
use super::visible_pixels::VisiblePixel;
use crate::blocks::Blocks;
use crate::rays::Rays;
use crate::visibility::SpareVisibility;
use crate::{Hit, View, Visibility};

/// The corners of a view's pixels.
pub(crate) struct Corners<'a> {
    /// The view that [`corners_of`] returns.
    pub(crate) view: View,
    /// Renders the surfaces that it sees in some blocks.
    pub(crate) render: Box<dyn Fn(&Blocks) -> Visibility + 'a>,
    /// The memory for them.
    pub(crate) spare: &'a SpareVisibility,
}

/// The surfaces that corners see, where there are outlines, and the rays of all corners.
struct SeenCorners<'a> {
    seen: Visibility,
    rays: Rays<'a>,
}

/// Returns a view whose pixel centres are the corners of a view's pixels: it has one column and one row more.
pub(crate) fn corners_of(view: &View) -> View {
    let mut corners = *view;
    let of = &view.camera.intrinsics;
    let mut centre = of.principal_point::<Usd>();
    centre.x += 0.5;
    centre.y += 0.5;
    let mut size = of.size;
    size.width += 1;
    size.height += 1;
    corners.camera.intrinsics = Intrinsics::new(size, of.fx, of.fy, centre);
    corners
}

/// At outlines a pixel becomes the mean of its centre's colour and the mean of its four corners' colours; `put` writes it into the
/// image. Coverage remains the centre's, as in all other annotations.
pub(super) fn smooth<T: Send>(
    context: &ShadingContext<'_>,
    corners: &Corners<'_>,
    seen: &Visibility,
    colors: &Image<[f32; 3]>,
    outlines: &[Vec<u32>],
    image: &mut Image<T>,
    put: impl Fn(&mut T, Vec3) + Sync,
) {
    if outlines.iter().all(Vec::is_empty) {
        return;
    }
    let row_length = (image.width() as usize).max(1);
    let at_corners = SeenCorners {
        seen: (corners.render)(&blocks_with(outlines, image.width(), image.height())),
        rays: Rays::new(&corners.view),
    };
    let corner_rows = corner_rows(context, &at_corners, seen, colors, outlines);
    let rows = image.pixels_mut().par_chunks_mut(row_length);
    rows.zip(outlines)
        .zip(corner_rows.par_windows(2))
        .zip(0..colors.height())
        .for_each(|(((row, outlines), corner_rows), y)| {
            let mut corner_rows = [corner_rows[0].as_slice(), corner_rows[1].as_slice()];
            for &x in outlines {
                let mut around = Vec3::ZERO;
                for corners in &mut corner_rows {
                    while corners.first().is_some_and(|(column, _)| *column < x) {
                        *corners = &corners[1..];
                    }
                    around += corners.iter().take(2).map(|(_, color)| *color).sum::<Vec3>();
                }
                let centre = colors.get(x, y).copied().map_or(Vec3::ZERO, Vec3::from);
                if let Some(pixel) = row.get_mut(x as usize) {
                    put(pixel, centre * 0.5 + around * 0.125);
                }
            }
        });
    let Visibility { z, hits } = at_corners.seen;
    corners.spare.keep(Some(z), hits);
}

/// Returns the blocks with the corners of outlines in an image of a size.
fn blocks_with(outlines: &[Vec<u32>], width: u32, height: u32) -> Blocks {
    let mut blocks = Blocks::none(width + 1, height + 1);
    for (row, y) in outlines.iter().zip(0..) {
        for &x in row {
            for [x, y] in [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]] {
                blocks.add(x, y);
            }
        }
    }
    blocks
}

/// Returns the columns and colours of the corners of outlines, row by row: an adjacent pixel's if it sees the same triangle,
/// else their own.
fn corner_rows(
    context: &ShadingContext<'_>,
    corners: &SeenCorners<'_>,
    seen: &Visibility,
    colors: &Image<[f32; 3]>,
    outlines: &[Vec<u32>],
) -> Vec<Vec<(u32, Vec3)>> {
    (0..=colors.height())
        .into_par_iter()
        .map_init(
            || context.workspace(&corners.rays),
            |workspace, y| {
                if interrupt::is_unwanted() {
                    return Vec::new();
                }
                workspace.stack.forget();
                let of_pixels = |row: u32| outlines.get(row as usize).map_or(&[][..], Vec::as_slice);
                let above = y.checked_sub(1).map_or(&[][..], of_pixels);
                let mut columns: Vec<u32> = (above.iter().chain(of_pixels(y)))
                    .flat_map(|x| [*x, x + 1])
                    .collect();
                columns.sort_unstable();
                columns.dedup();
                let mut row: Vec<(u32, Vec3)> = columns.into_iter().map(|x| (x, Vec3::ZERO)).collect();
                let mut own = Vec::new();
                for (index, (x, color)) in row.iter_mut().enumerate() {
                    let hit = corners.seen.hits.get(*x, y).copied().unwrap_or(Hit::MISS);
                    if let Some(adjacent) = adjacent_color(seen, colors, hit, [*x, y]) {
                        *color = adjacent;
                    } else {
                        let z = corners.seen.z.0.get(*x, y).copied().unwrap_or(f32::INFINITY);
                        own.push(VisiblePixel {
                            tag: index,
                            place: [*x, y],
                            hit,
                            z,
                        });
                    }
                }
                context.colors(&mut own, workspace, |index, seen| {
                    if let Some((_, corner)) = row.get_mut(index) {
                        *corner = seen.color;
                    }
                });
                row
            },
        )
        .collect()
}

/// Returns the colour of a pixel at a corner that sees the same triangle as the corner.
fn adjacent_color(seen: &Visibility, colors: &Image<[f32; 3]>, hit: Hit, [x, y]: [u32; 2]) -> Option<Vec3> {
    let around = [
        [x, y],
        [x.wrapping_sub(1), y],
        [x, y.wrapping_sub(1)],
        [x.wrapping_sub(1), y.wrapping_sub(1)],
    ];
    around
        .into_iter()
        .find(|[x, y]| seen.hits.get(*x, *y) == Some(&hit))
        .and_then(|[x, y]| colors.get(x, y).copied().map(Vec3::from))
}
