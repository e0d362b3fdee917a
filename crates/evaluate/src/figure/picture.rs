//! Marks as pixels.

use oaktwin_image::Image;
use oaktwin_image::draw::{self, Paint};
use oaktwin_image::text::{self, Style};

use super::layout::{Anchor, HEIGHT, Mark, Marks, WIDTH};

/// Pixels of the picture to one of the figure's.
const SCALE: f32 = 2.0;

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "places on paper"
)]
pub(super) fn painted(marks: &Marks) -> Image<[u8; 3]> {
    let mut image = Image::filled((WIDTH * SCALE) as u32, (HEIGHT * SCALE) as u32, [255; 3]);
    let [left, top, right, bottom] = marks.frame.map(|edge| (edge * SCALE).round() as u32);
    let paint = |color: [u8; 3], opacity: f32, is_cut: bool| {
        let whole = Paint {
            opacity,
            ..Paint::new(color)
        };
        let clip = [left..right, top..bottom];
        if is_cut { Paint { clip, ..whole } } else { whole }
    };
    let scaled = |points: &[[f32; 2]]| -> Vec<[f32; 2]> {
        points.iter().map(|point| point.map(|c| c * SCALE)).collect()
    };
    for mark in &marks.marks {
        match mark {
            Mark::Area {
                corners,
                color,
                opacity,
                is_cut,
            } => draw::fill(&mut image, &scaled(corners), &paint(*color, *opacity, *is_cut)),
            Mark::Line {
                points,
                color,
                width,
                is_cut,
            } => draw::stroke(
                &mut image,
                &scaled(points),
                width * SCALE / 2.0,
                &paint(*color, 1.0, *is_cut),
            ),
            Mark::Text {
                at,
                height,
                color,
                anchor,
                is_turned,
                text,
            } => write(&mut image, text, *at, *height, *color, *anchor, *is_turned),
        }
    }
    image
}

fn write(
    image: &mut Image<[u8; 3]>,
    text: &str,
    [x, y]: [f32; 2],
    height: f32,
    color: [u8; 3],
    anchor: Anchor,
    is_turned: bool,
) {
    let height = height * SCALE;
    let before = text::width(text, height)
        * match anchor {
            Anchor::Left => 0.0,
            Anchor::Middle => 0.5,
            Anchor::Right => 1.0,
        };
    let style = Style { height, color };
    if is_turned {
        let start = [x * SCALE - height, y * SCALE + before];
        text::draw_upwards(image, text, (start[0], start[1]), style);
    } else {
        text::draw(image, text, (x * SCALE - before, y * SCALE - height), style);
    }
}
