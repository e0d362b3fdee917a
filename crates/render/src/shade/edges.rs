//! Antialiased outlines.

use glam::Vec3;
use oaktwin_camera::{Intrinsics, Usd};
use oaktwin_image::Image;
use rayon::prelude::*;

use super::ShadingContext;
use super::targets::Target;
use crate::rays::Rays;
use crate::{Hit, View, Visibility};

/// The minimum difference from a neighbour, of 255, that is antialiased.
const MIN_CONTRAST: u8 = 10;

/// The minimum second difference of 1/z over three pixels at an edge, relative to 1/z.
const MIN_BEND: f32 = 1e-3;

/// The surfaces that the corners of a view's pixels see.
#[derive(Debug)]
pub(crate) struct Corners<'a> {
    /// The rays of the view that [`corners_of`] returns.
    pub(crate) rays: Rays<'a>,
    pub(crate) seen: Visibility,
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

/// Finds the pixels at outlines, row by row, from the surfaces and sRGB with coverage.
pub(super) fn outlines_of(seen: &Visibility, rgb: &Image<[u8; 4]>) -> Vec<Vec<u32>> {
    (0..rgb.height())
        .into_par_iter()
        .map(|y| outlines(seen, rgb, y))
        .collect()
}

/// At outlines a pixel becomes the mean of its centre's colour and the mean of its four corners' colours; `put` writes it into the
/// image. Coverage remains that of the centre, as in all other annotations.
pub(super) fn smooth<T: Send>(
    context: &ShadingContext<'_>,
    corners: &Corners<'_>,
    seen: &Visibility,
    colors: &Image<[f32; 3]>,
    outlines: &[Vec<u32>],
    image: &mut Image<T>,
    put: impl Fn(&mut T, Vec3) + Sync,
) {
    let row_length = (image.width() as usize).max(1);
    let corner_rows = corner_rows(context, corners, seen, colors, outlines);
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
}

/// Returns the columns and colours of the corners of outlines, row by row: those of an adjacent pixel that sees the same triangle,
/// else their own.
fn corner_rows(
    context: &ShadingContext<'_>,
    corners: &Corners<'_>,
    seen: &Visibility,
    colors: &Image<[f32; 3]>,
    outlines: &[Vec<u32>],
) -> Vec<Vec<(u32, Vec3)>> {
    (0..=colors.height())
        .into_par_iter()
        .map_init(
            || context.workspace(&corners.rays),
            |workspace, y| {
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
                        own.push(Target {
                            tag: index,
                            place: [*x, y],
                            hit,
                            z,
                        });
                    }
                }
                context.colors(&mut own, workspace, |index, color| {
                    if let Some((_, corner)) = row.get_mut(index) {
                        *corner = color;
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

/// A row of colours and visible surfaces.
#[derive(Clone, Copy)]
struct Row<'a> {
    rgb: &'a [[u8; 4]],
    hits: &'a [Hit],
    depths: &'a [f32],
}

impl<'a> Row<'a> {
    fn new(seen: &'a Visibility, rgb: &'a Image<[u8; 4]>, y: u32) -> Option<Self> {
        let width = rgb.width() as usize;
        let first = y as usize * width;
        let range = first..first + width;
        Some(Self {
            rgb: rgb.pixels().get(range.clone())?,
            hits: seen.hits.pixels().get(range.clone())?,
            depths: seen.z.0.pixels().get(range)?,
        })
    }

    #[inline]
    fn pixel(&self, x: usize) -> Option<Pixel> {
        let (hit, z) = (self.hits.get(x)?, *self.depths.get(x)?);
        Some(Pixel {
            instance: hit.instance,
            z,
        })
    }
}

#[derive(Clone, Copy)]
struct Pixel {
    instance: u32,
    z: f32,
}

/// Finds the pixels of a row at outlines and creases with enough contrast.
fn outlines(seen: &Visibility, rgb: &Image<[u8; 4]>, y: u32) -> Vec<u32> {
    let Some(row) = Row::new(seen, rgb, y) else {
        return Vec::new();
    };
    let above = y.checked_sub(1).and_then(|y| Row::new(seen, rgb, y));
    let below = y.checked_add(1).and_then(|y| Row::new(seen, rgb, y));
    (0..rgb.width())
        .filter(|x| {
            let x = *x as usize;
            let Some(pixel) = row.pixel(x) else {
                return false;
            };
            // Colours are compared last because there are few edges.
            let differs = |row: Option<Row<'_>>, other: usize, mine: Row<'_>| {
                let other = row.and_then(|row| row.rgb.get(other));
                (mine.rgb.get(x).zip(other)).is_some_and(|(a, b)| contrast(*a, *b) >= MIN_CONTRAST)
            };
            let (left, right) = (x.wrapping_sub(1), x + 1);
            (pixel.is_edge_between(row.pixel(left), row.pixel(right))
                && (differs(Some(row), left, row) || differs(Some(row), right, row)))
                || (pixel.is_edge_between(
                    above.and_then(|row| row.pixel(x)),
                    below.and_then(|row| row.pixel(x)),
                ) && (differs(above, x, row) || differs(below, x, row)))
        })
        .collect()
}

impl Pixel {
    #[inline]
    fn is_edge_between(&self, before: Option<Self>, after: Option<Self>) -> bool {
        let is_other = |other: Self| other.instance != self.instance;
        let bends = before.zip(after).is_some_and(|(a, b)| {
            let product = a.z * b.z;
            (self.z * (a.z + b.z) - 2.0 * product).abs() > MIN_BEND * product
        });
        bends || before.is_some_and(is_other) || after.is_some_and(is_other)
    }
}

#[inline]
fn contrast(a: [u8; 4], b: [u8; 4]) -> u8 {
    (a.iter().zip(b)).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}
