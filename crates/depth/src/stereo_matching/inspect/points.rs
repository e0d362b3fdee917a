//! The points of an image that are compared with the other image.

use std::ops::Range;

use oaktwin_simd::{Kernel, run};

/// The minimum difference of a point's neighbours, horizontally and vertically, in grey levels.
const TEXTURE: u8 = 10;

/// Returns the point with the most texture in each cell of a part of an image, if it has enough. The part does not touch
/// the border of the image.
pub(super) fn points(
    image: &[u8],
    width: usize,
    [columns, rows]: [Range<usize>; 2],
    cell: [usize; 2],
) -> Vec<[usize; 2]> {
    let [cell_width, cell_height] = cell.map(|side| side.max(1));
    let mut points = Vec::new();
    let mut textures = vec![0; columns.len()];
    let row = |y: usize, columns: Range<usize>| image.get(y * width..).and_then(|row| row.get(columns));
    for top in rows.clone().step_by(cell_height) {
        let mut best = vec![(TEXTURE, None); columns.len().div_ceil(cell_width)];
        for y in top..(top + cell_height).min(rows.end) {
            let (Some(above), Some(own), Some(below)) = (
                row(y - 1, columns.clone()),
                row(y, columns.start - 1..columns.end + 1),
                row(y + 1, columns.clone()),
            ) else {
                continue;
            };
            let textures = &mut textures[..];
            run(Textures {
                above,
                own,
                below,
                textures,
            });
            let cells = textures
                .chunks(cell_width)
                .zip(columns.clone().step_by(cell_width));
            for ((textures, left), best) in cells.zip(&mut best) {
                let most = run(Most(textures));
                if most > best.0 {
                    let x = textures.iter().position(|&texture| texture == most);
                    *best = (most, x.map(|x| [left + x, y]));
                }
            }
        }
        points.extend(best.into_iter().filter_map(|(_, point)| point));
    }
    points
}

/// Computes the texture of the pixels of a row. `own` has one more pixel on each side.
struct Textures<'a> {
    above: &'a [u8],
    own: &'a [u8],
    below: &'a [u8],
    textures: &'a mut [u8],
}

impl Kernel for Textures<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let vertical = self.above.iter().zip(self.below);
        let horizontal = self.own.iter().zip(self.own.get(2..).unwrap_or_default());
        let pixels = self.textures.iter_mut().zip(vertical).zip(horizontal);
        for ((texture, (above, below)), (left, right)) in pixels {
            *texture = left.abs_diff(*right).min(above.abs_diff(*below));
        }
    }
}

/// Returns the maximum of values.
struct Most<'a>(&'a [u8]);

impl Kernel for Most<'_> {
    type Output = u8;

    #[inline(always)]
    fn run(self) -> u8 {
        let mut most = 0;
        for &value in self.0 {
            most = most.max(value);
        }
        most
    }
}
