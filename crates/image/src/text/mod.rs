//! Letters in pictures: a plain font of strokes, smooth at every size.

mod glyphs;

use crate::Image;
use crate::draw::{self, Paint};

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
    draw_along(image, text, style, |right, down| [x + right, y + down]);
}

/// Draws a line of text that reads upwards: (`x`, `y`) is where the first letter's upper left corner is, which lies to
/// the lower left.
pub fn draw_upwards(image: &mut Image<[u8; 3]>, text: &str, (x, y): (f32, f32), style: Style) {
    draw_along(image, text, style, |right, down| [x + down, y - right]);
}

/// Draws text of which `place` says where what is so far to the right and down lies.
fn draw_along(image: &mut Image<[u8; 3]>, text: &str, style: Style, place: impl Fn(f32, f32) -> [f32; 2]) {
    let scale = style.height / f32::from(glyphs::CAPITAL);
    // Half a stroke, px: never thinner than what a pixel can show.
    let radius = (scale * 0.8).max(0.6);
    let mut left = 0.0;
    for c in text.chars() {
        let glyph = glyphs::glyph(c);
        let at = |[px, py]: [f32; 2]| place(left + px * scale, py * scale);
        let segments: Vec<[[f32; 2]; 2]> = glyph
            .strokes()
            .iter()
            .flat_map(|stroke| stroke.windows(2).map(|ends| [at(ends[0]), at(ends[1])]))
            .collect();
        draw::segments(image, &segments, radius, &Paint::new(style.color));
        left += f32::from(glyph.advance()) * scale;
    }
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
