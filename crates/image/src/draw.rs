//! Smooth lines and areas in pictures. Places are px, the upper left corner of the image being (0, 0).

use std::ops::Range;

use crate::Image;

/// What a line or an area looks like.
#[derive(Clone, Debug, PartialEq)]
pub struct Paint {
    /// sRGB.
    pub color: [u8; 3],
    /// 0 to 1.
    pub opacity: f32,
    /// The columns and rows of the image that may be painted on.
    pub clip: [Range<u32>; 2],
}

impl Paint {
    /// Opaque, on all of an image.
    #[must_use]
    pub fn new(color: [u8; 3]) -> Self {
        Self {
            color,
            opacity: 1.0,
            clip: [0..u32::MAX, 0..u32::MAX],
        }
    }
}

/// Draws lines from each point to the next as one shape, `radius` px to each side, with round ends: where lines meet,
/// nothing is painted twice. A point that is not finite ends a line.
pub fn stroke(image: &mut Image<[u8; 3]>, points: &[[f32; 2]], radius: f32, paint: &Paint) {
    let is_finite = |point: &[f32; 2]| point.iter().all(|c| c.is_finite());
    let segments: Vec<[[f32; 2]; 2]> = points
        .windows(2)
        .filter(|ends| ends.iter().all(is_finite))
        .map(|ends| [ends[0], ends[1]])
        .collect();
    self::segments(image, &segments, radius, paint);
}

/// Draws lines between pairs of points as one shape.
pub(crate) fn segments(image: &mut Image<[u8; 3]>, segments: &[[[f32; 2]; 2]], radius: f32, paint: &Paint) {
    let reach = radius + 1.0;
    let Some(mut mask) = Mask::around(image, segments.iter().flatten(), reach, paint) else {
        return;
    };
    for segment in segments {
        let [columns, rows] = mask.pixels(segment.iter(), reach);
        for row in rows {
            for column in columns.clone() {
                let centre = [column as f32 + 0.5, row as f32 + 0.5];
                let distance = squared_distance(centre, *segment).sqrt();
                let covered = mask.at(column, row);
                *covered = covered.max((radius - distance + 0.5).clamp(0.0, 1.0));
            }
        }
    }
    mask.paint(image, paint);
}

/// Scan lines to a row of pixels.
const LINES: u32 = 5;

/// Fills the inside of a closed polygon; what it goes around twice is outside.
pub fn fill(image: &mut Image<[u8; 3]>, corners: &[[f32; 2]], paint: &Paint) {
    if !corners.iter().flatten().all(|c| c.is_finite()) {
        return;
    }
    let Some(mut mask) = Mask::around(image, corners.iter(), 1.0, paint) else {
        return;
    };
    let [columns, rows] = [mask.columns.clone(), mask.rows.clone()];
    let sides: Vec<[[f32; 2]; 2]> = corners
        .iter()
        .zip(corners.iter().cycle().skip(1))
        .map(|(a, b)| [*a, *b])
        .collect();
    let mut crossings: Vec<f32> = Vec::new();
    for row in rows {
        for line in 0..LINES {
            let y = row as f32 + (line as f32 + 0.5) / LINES as f32;
            crossings.clear();
            crossings.extend(sides.iter().filter_map(|[[ax, ay], [bx, by]]| {
                let crosses = (*ay <= y) != (*by <= y);
                crosses.then(|| ax + (bx - ax) * ((y - ay) / (by - ay)))
            }));
            crossings.sort_unstable_by(f32::total_cmp);
            for ends in crossings.chunks_exact(2) {
                let (from, to) = (ends[0].max(columns.start as f32), ends[1].min(columns.end as f32));
                if from >= to {
                    continue;
                }
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "within the columns"
                )]
                let touched = from as u32..(to.ceil() as u32).min(columns.end);
                for column in touched {
                    let part = (to.min(column as f32 + 1.0) - from.max(column as f32)).max(0.0);
                    *mask.at(column, row) += part / LINES as f32;
                }
            }
        }
    }
    mask.paint(image, paint);
}

/// How much of each pixel in a part of an image is covered, 0 to 1.
struct Mask {
    columns: Range<u32>,
    rows: Range<u32>,
    covered: Vec<f32>,
}

impl Mask {
    /// Of the pixels within reach of some points; `None` where there are none.
    fn around<'a>(
        image: &Image<[u8; 3]>,
        points: impl Iterator<Item = &'a [f32; 2]>,
        reach: f32,
        paint: &Paint,
    ) -> Option<Self> {
        let whole = [image.width(), image.height()];
        let limits: [Range<u32>; 2] =
            std::array::from_fn(|axis| paint.clip[axis].start..paint.clip[axis].end.min(whole[axis]));
        let [columns, rows] = pixels(points, reach, &limits);
        if columns.is_empty() || rows.is_empty() {
            return None;
        }
        let covered = vec![0.0; columns.len() * rows.len()];
        Some(Self {
            columns,
            rows,
            covered,
        })
    }

    fn pixels<'a>(&self, points: impl Iterator<Item = &'a [f32; 2]>, reach: f32) -> [Range<u32>; 2] {
        pixels(points, reach, &[self.columns.clone(), self.rows.clone()])
    }

    fn at(&mut self, column: u32, row: u32) -> &mut f32 {
        let (x, y) = (column - self.columns.start, row - self.rows.start);
        &mut self.covered[y as usize * self.columns.len() + x as usize]
    }

    fn paint(&self, image: &mut Image<[u8; 3]>, paint: &Paint) {
        let width = image.width() as usize;
        let covered = self.covered.chunks_exact(self.columns.len());
        for (covered, row) in covered.zip(self.rows.clone()) {
            let start = row as usize * width + self.columns.start as usize;
            let pixels = &mut image.pixels_mut()[start..start + self.columns.len()];
            for (pixel, covered) in pixels.iter_mut().zip(covered) {
                let opacity = covered.min(1.0) * paint.opacity;
                if opacity > 0.0 {
                    for (channel, ink) in pixel.iter_mut().zip(paint.color) {
                        let (paper, ink) = (f32::from(*channel), f32::from(ink));
                        #[expect(
                            clippy::cast_possible_truncation,
                            clippy::cast_sign_loss,
                            reason = "0 to 255"
                        )]
                        let mixed = (paper + (ink - paper) * opacity + 0.5) as u8;
                        *channel = mixed;
                    }
                }
            }
        }
    }
}

/// The pixels within reach of some points, and within limits. Saturating: outside of them, or of nothing at all, is an
/// empty range.
fn pixels<'a>(
    points: impl Iterator<Item = &'a [f32; 2]>,
    reach: f32,
    limits: &[Range<u32>; 2],
) -> [Range<u32>; 2] {
    let nothing = [[f32::INFINITY, f32::NEG_INFINITY]; 2];
    let extent = points.fold(nothing, |extent, point| {
        std::array::from_fn(|axis| [extent[axis][0].min(point[axis]), extent[axis][1].max(point[axis])])
    });
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "saturates"
    )]
    std::array::from_fn(|axis| {
        let [low, high] = [extent[axis][0] - reach, (extent[axis][1] + reach).ceil()];
        (low as u32).max(limits[axis].start)..(high as u32).min(limits[axis].end)
    })
}

fn squared_distance([x, y]: [f32; 2], [[ax, ay], [bx, by]]: [[f32; 2]; 2]) -> f32 {
    let (dx, dy) = (bx - ax, by - ay);
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 {
        (((x - ax) * dx + (y - ay) * dy) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let (ex, ey) = (x - ax - along * dx, y - ay - along * dy);
    ex * ex + ey * ey
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHITE: [u8; 3] = [255; 3];

    fn ink(image: &Image<[u8; 3]>) -> f64 {
        image
            .pixels()
            .iter()
            .map(|pixel| f64::from(pixel[0]) / 255.0)
            .sum()
    }

    #[test]
    fn a_line_has_its_area() {
        let mut image = Image::filled(60, 40, [0; 3]);
        stroke(&mut image, &[[10.0, 20.0], [50.0, 20.0]], 2.0, &Paint::new(WHITE));
        // A rectangle and two half disks.
        let area = 40.0 * 4.0 + std::f64::consts::PI * 4.0;
        assert!((ink(&image) - area).abs() < 0.02 * area, "{}", ink(&image));
        // The same again, back and forth: nothing is painted twice.
        let mut again = Image::filled(60, 40, [0; 3]);
        let there_and_back = [[10.0, 20.0], [50.0, 20.0], [10.0, 20.0]];
        stroke(&mut again, &there_and_back, 2.0, &Paint::new(WHITE));
        assert_eq!(image, again);
    }

    #[test]
    fn an_area_has_its_area() {
        let triangle = [[3.3, 2.1], [40.7, 9.4], [12.2, 31.9]];
        let mut image = Image::filled(48, 40, [0; 3]);
        fill(&mut image, &triangle, &Paint::new(WHITE));
        let [[ax, ay], [bx, by], [cx, cy]] = triangle.map(|point| point.map(f64::from));
        let area = ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2.0;
        assert!((ink(&image) - area).abs() < 0.5, "{} {area}", ink(&image));
        let mut half = Image::filled(48, 40, [0; 3]);
        let paint = Paint {
            opacity: 0.5,
            ..Paint::new(WHITE)
        };
        fill(&mut half, &triangle, &paint);
        assert!((ink(&half) - area / 2.0).abs() < 2.0);
    }

    #[test]
    fn a_clip_is_kept() {
        let paint = Paint {
            clip: [4..8, 2..3],
            ..Paint::new(WHITE)
        };
        let mut image = Image::filled(16, 16, [0; 3]);
        stroke(&mut image, &[[-9.0, 2.5], [99.0, 2.5]], 9.0, &paint);
        fill(
            &mut image,
            &[[0.0, 0.0], [16.0, 0.0], [16.0, 16.0], [0.0, 16.0]],
            &paint,
        );
        assert_eq!(ink(&image), 4.0);
    }

    #[test]
    fn what_is_no_place_is_not_drawn() {
        let mut image = Image::filled(8, 8, [7; 3]);
        let paint = Paint::new(WHITE);
        for wild in [f32::NAN, f32::INFINITY, 1e30, -1e30] {
            stroke(&mut image, &[[wild, 0.0], [wild, 1.0]], 1.0, &paint);
            fill(&mut image, &[[wild, 0.0], [wild, 1.0], [wild, 2.0]], &paint);
        }
        stroke(&mut image, &[], 1.0, &paint);
        fill(&mut image, &[], &paint);
        assert_eq!(image, Image::filled(8, 8, [7; 3]));
    }
}
