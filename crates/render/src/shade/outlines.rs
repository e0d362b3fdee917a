//! The pixels at outlines and creases.

use oaktwin_image::Image;
use oaktwin_simd::{Kernel, Level, run_at};
use rayon::prelude::*;

use crate::{Hit, Visibility};

/// The minimum difference from a neighbour, of 255, that is antialiased.
const MIN_CONTRAST: u8 = 10;

/// The minimum second difference of 1/z over three pixels at an edge, relative to 1/z.
const MIN_BEND: f32 = 1e-3;

/// Finds the pixels at outlines, row by row, from the surfaces and sRGB with coverage.
pub(super) fn outlines_of(seen: &Visibility, rgb: &Image<[u8; 4]>, level: Level) -> Vec<Vec<u32>> {
    (0..rgb.height())
        .into_par_iter()
        .map_init(Vec::new, |marks, y| outlines(seen, rgb, y, level, marks))
        .collect()
}

/// A row of colours and visible surfaces.
#[derive(Clone, Copy)]
struct SurfaceRow<'a> {
    rgb: &'a [[u8; 4]],
    hits: &'a [Hit],
    depths: &'a [f32],
}

impl<'a> SurfaceRow<'a> {
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
        (x < self.hits.len()).then(|| pixel((self.hits, self.depths), x))
    }

    /// Returns the surfaces of `count` pixels from a column on.
    #[inline(always)]
    fn part(&self, first: usize, count: usize) -> (&'a [Hit], &'a [f32]) {
        (&self.hits[first..][..count], &self.depths[first..][..count])
    }
}

/// Finds the pixels of a row at outlines and creases with enough contrast. `marks` is reused memory.
fn outlines(
    seen: &Visibility,
    rgb: &Image<[u8; 4]>,
    y: u32,
    level: Level,
    marks: &mut Vec<bool>,
) -> Vec<u32> {
    let Some(row) = SurfaceRow::new(seen, rgb, y) else {
        return Vec::new();
    };
    let above = y.checked_sub(1).and_then(|y| SurfaceRow::new(seen, rgb, y));
    let below = y.checked_add(1).and_then(|y| SurfaceRow::new(seen, rgb, y));
    marks.clear();
    marks.resize(rgb.width() as usize, true);
    if let (Some(above), Some(below)) = (above, below) {
        let rows = [above, row, below];
        run_at(level, Marking { rows, marks });
    }
    let is_outline = |x: usize| {
        let pixel = row.pixel(x)?;
        let differs = |row: Option<SurfaceRow<'_>>, other: usize, mine: SurfaceRow<'_>| {
            let other = row.and_then(|row| row.rgb.get(other));
            (mine.rgb.get(x).zip(other)).is_some_and(|(a, b)| contrast(*a, *b) >= MIN_CONTRAST)
        };
        let (left, right) = (x.wrapping_sub(1), x + 1);
        let is_across = pixel.is_edge_between(row.pixel(left), row.pixel(right))
            && (differs(Some(row), left, row) || differs(Some(row), right, row));
        let is_along = || {
            pixel.is_edge_between(
                above.and_then(|row| row.pixel(x)),
                below.and_then(|row| row.pixel(x)),
            ) && (differs(above, x, row) || differs(below, x, row))
        };
        Some(is_across || is_along())
    };
    (0..rgb.width())
        .zip(&*marks)
        .filter(|(x, mark)| **mark && is_outline(*x as usize) == Some(true))
        .map(|(x, _)| x)
        .collect()
}

/// Clears the marks of pixels that are at no edge, whatever their colours. Those at the border of the image stay.
struct Marking<'a> {
    /// The row above, the row itself and the row below.
    rows: [SurfaceRow<'a>; 3],
    marks: &'a mut [bool],
}

impl Kernel for Marking<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Some(inner) = self.marks.len().checked_sub(2) else {
            return;
        };
        let [above, row, below] = self.rows;
        let [left, own, right] = [0, 1, 2].map(|first| row.part(first, inner));
        let (above, below) = (above.part(1, inner), below.part(1, inner));
        for (x, mark) in self.marks[1..][..inner].iter_mut().enumerate() {
            let own = pixel(own, x);
            let (left, right) = (pixel(left, x), pixel(right, x));
            let (above, below) = (pixel(above, x), pixel(below, x));
            *mark = own.is_other(left)
                | own.is_other(right)
                | own.is_other(above)
                | own.is_other(below)
                | own.bends_between(left, right)
                | own.bends_between(above, below);
        }
    }
}

#[inline(always)]
fn pixel((hits, depths): (&[Hit], &[f32]), x: usize) -> Pixel {
    Pixel {
        instance: hits[x].instance,
        z: depths[x],
    }
}

#[derive(Clone, Copy)]
struct Pixel {
    instance: u32,
    z: f32,
}

impl Pixel {
    #[inline]
    fn is_edge_between(self, before: Option<Self>, after: Option<Self>) -> bool {
        let bends = before.zip(after).is_some_and(|(a, b)| self.bends_between(a, b));
        let is_other = |other| self.is_other(other);
        bends || before.is_some_and(is_other) || after.is_some_and(is_other)
    }

    #[inline(always)]
    fn is_other(self, other: Self) -> bool {
        other.instance != self.instance
    }

    #[inline(always)]
    fn bends_between(self, a: Self, b: Self) -> bool {
        let product = a.z * b.z;
        (self.z * (a.z + b.z) - 2.0 * product).abs() > MIN_BEND * product
    }
}

#[inline]
fn contrast(a: [u8; 4], b: [u8; 4]) -> u8 {
    (a.iter().zip(b)).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use oaktwin_image::ZDepth;

    use super::*;

    #[test]
    fn marks_are_the_edges() {
        let (width, height) = (70, 3);
        // Columns of one surface each, some of them misses, with steps and single pixels of others.
        let number = |i: u32| i.wrapping_mul(0x9e37_79b1).rotate_left(7) % 11;
        let hit = |i: u32| match number(i % width / 12) {
            0..3 => Hit::MISS,
            n => Hit {
                instance: n + number(i) / 10,
                triangle: i,
            },
        };
        let hits: Vec<Hit> = (0..width * height).map(hit).collect();
        let depth = |(hit, i): (&Hit, u32)| match hit.is_miss() {
            true => f32::INFINITY,
            false => 2.0 + 0.01 * f32::from(u8::from(number(i % width / 5) > 6)),
        };
        let depths: Vec<f32> = hits.iter().zip(0..).map(depth).collect();
        let seen = Visibility {
            z: ZDepth(Image::new(width, height, depths).unwrap()),
            hits: Image::new(width, height, hits).unwrap(),
        };
        let rgb = Image::filled(width, height, [0; 4]);
        let rows = [0, 1, 2].map(|y| SurfaceRow::new(&seen, &rgb, y).unwrap());
        let expected = |x: usize| {
            let [above, row, below] = rows;
            let own = row.pixel(x).unwrap();
            x == 0
                || x == width as usize - 1
                || own.is_edge_between(row.pixel(x - 1), row.pixel(x + 1))
                || own.is_edge_between(above.pixel(x), below.pixel(x))
        };
        let expected: Vec<bool> = (0..width as usize).map(expected).collect();
        let edges = expected.iter().filter(|is_edge| **is_edge).count();
        assert!((9..61).contains(&edges), "{edges}");
        for level in Level::available() {
            let mut marks = vec![true; width as usize];
            let marks_of_row = &mut marks[..];
            run_at(
                level,
                Marking {
                    rows,
                    marks: marks_of_row,
                },
            );
            assert_eq!(marks, expected);
        }
    }
}
