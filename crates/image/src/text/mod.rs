//! Letters in pictures: a plain font of strokes, smooth at every size.

mod glyphs;

use crate::Image;

/// What text looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Height of a capital letter, px.
    pub height: f32,
    /// sRGB.
    pub color: [u8; 3],
}

/// Width of a line of text, px.
#[must_use]
pub fn width(text: &str, height: f32) -> f32 {
    let units: u16 = text
        .chars()
        .map(|c| glyphs::glyph(c).advance())
        .fold(0, u16::saturating_add);
    f32::from(units.saturating_sub(glyphs::GAP)) * height / f32::from(glyphs::CAPITAL)
}

/// Draws a line of text whose capitals have their upper left corner at (`x`, `y`), px. What lies outside the image is
/// cut off; a character that the font does not have is a box.
pub fn draw(image: &mut Image<[u8; 3]>, text: &str, (x, y): (f32, f32), style: Style) {
    let scale = style.height / f32::from(glyphs::CAPITAL);
    // Half a stroke, px: never thinner than what a pixel can show.
    let radius = (scale * 0.8).max(0.6);
    let mut left = x;
    for c in text.chars() {
        let glyph = glyphs::glyph(c);
        let at = |[px, py]: [f32; 2]| [left + px * scale, y + py * scale];
        let segments: Vec<[[f32; 2]; 2]> = glyph
            .strokes()
            .iter()
            .flat_map(|stroke| stroke.windows(2).map(|ends| [at(ends[0]), at(ends[1])]))
            .collect();
        draw_segments(image, &segments, radius, style.color);
        left += f32::from(glyph.advance()) * scale;
    }
}

/// Draws all segments as one shape, so that where they meet nothing is painted twice.
fn draw_segments(image: &mut Image<[u8; 3]>, segments: &[[[f32; 2]; 2]], radius: f32, color: [u8; 3]) {
    let extent = |axis: usize| {
        let coordinates = segments.iter().flatten().map(|point| point[axis]);
        let (low, high) = coordinates.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), c| {
            (low.min(c), high.max(c))
        });
        (low - radius - 1.0, high + radius + 1.0)
    };
    // Saturating: outside the image, or nothing at all, is an empty range.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "saturates"
    )]
    let pixels = |(low, high): (f32, f32), end: u32| (low as u32)..(high.ceil() as u32).min(end);
    let (columns, rows) = (
        pixels(extent(0), image.width()),
        pixels(extent(1), image.height()),
    );
    let width = image.width() as usize;
    for row in rows {
        for column in columns.clone() {
            let centre = [column as f32 + 0.5, row as f32 + 0.5];
            let distance = segments
                .iter()
                .map(|segment| squared_distance(centre, *segment))
                .fold(f32::INFINITY, f32::min)
                .sqrt();
            let coverage = (radius - distance + 0.5).clamp(0.0, 1.0);
            if coverage > 0.0 {
                let pixel = &mut image.pixels_mut()[row as usize * width + column as usize];
                for (channel, ink) in pixel.iter_mut().zip(color) {
                    let (paper, ink) = (f32::from(*channel), f32::from(ink));
                    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
                    let mixed = (paper + (ink - paper) * coverage + 0.5) as u8;
                    *channel = mixed;
                }
            }
        }
    }
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

    const STYLE: Style = Style {
        height: 12.0,
        color: [255; 3],
    };

    #[test]
    fn text_has_its_width() {
        let mut image = Image::filled(200, 24, [0; 3]);
        draw(&mut image, "Hamburg 0.5 m", (10.0, 6.0), STYLE);
        let inked = |x: u32| (0..24).any(|y| image.get(x, y).unwrap()[0] > 60);
        let columns: Vec<u32> = (0..200).filter(|&x| inked(x)).collect();
        let (first, last) = (columns[0], *columns.last().unwrap());
        assert!((9..=10).contains(&first));
        let end = 10.0 + width("Hamburg 0.5 m", 12.0);
        assert!((last as f32 - end).abs() < 2.0, "{last} {end}");
        assert_eq!(width("", 12.0), 0.0);
    }

    #[test]
    fn text_outside_is_cut_off() {
        let mut image = Image::filled(8, 8, [9; 3]);
        for at in [(-1e9, 0.0), (1e9, 0.0), (0.0, -1e9), (0.0, 1e9), (f32::NAN, 0.0)] {
            draw(&mut image, "m", at, STYLE);
        }
        assert_eq!(image, Image::filled(8, 8, [9; 3]));
        draw(&mut image, "m", (-4.0, -4.0), STYLE);
        assert_ne!(image, Image::filled(8, 8, [9; 3]));
        draw(&mut Image::filled(0, 0, [0; 3]), "m", (0.0, 0.0), STYLE);
    }
}
