//! The pictures and patterns of the room's objects.

use super::noise::{rough, smooth, white};
use super::{Color, Picture, dimmed, mixed, painted};

/// Whether a place is on the letters of a text; each has 5 × 7 cells of `cell` pixels, and one between.
fn is_text(text: &[[u8; 7]], x: f32, y: f32, cell: f32) -> bool {
    if x < 0.0 || y < 0.0 {
        return false;
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "not negative, and small"
    )]
    let (column, row) = ((x / cell) as usize, (y / cell) as usize);
    let Some(letter) = text.get(column / 6) else {
        return false;
    };
    let within = column % 6;
    within < 5 && letter.get(row).is_some_and(|line| line >> (4 - within) & 1 == 1)
}

const O: [u8; 7] = [14, 17, 17, 17, 17, 17, 14];
const A: [u8; 7] = [14, 17, 17, 31, 17, 17, 17];
const K: [u8; 7] = [17, 18, 20, 24, 20, 18, 17];
const T: [u8; 7] = [31, 4, 4, 4, 4, 4, 4];
const W: [u8; 7] = [17, 17, 17, 21, 21, 27, 17];
const I: [u8; 7] = [14, 4, 4, 4, 4, 4, 14];
const N: [u8; 7] = [17, 25, 25, 21, 19, 19, 17];

/// A poster: hills under the sun, an oak, and a name.
pub(super) fn poster() -> Picture {
    painted(480, 672, |x, y| {
        let paper = 0.96 + 0.04 * smooth(x / 2.0, y / 2.0, [512, 512], 71);
        let border = x.min(480.0 - x).min(y).min(672.0 - y);
        let picture = if border < 14.0 {
            [0.95, 0.93, 0.88]
        } else if border < 18.0 {
            [0.15, 0.2, 0.25]
        } else if y > 560.0 {
            let name = is_text(&[O, A, K, T, W, I, N], x - 72.0, y - 588.0, 8.0);
            if name {
                [0.95, 0.85, 0.5]
            } else {
                [0.13, 0.2, 0.28]
            }
        } else {
            hills(x, y)
        };
        dimmed(picture, paper)
    })
}

fn hills(x: f32, y: f32) -> Color {
    let distance = |cx: f32, cy: f32| ((x - cx) * (x - cx) + (y - cy) * (y - cy)).sqrt();
    // The oak: a trunk and a crown of balls.
    let crown = [
        (300.0, 330.0, 62.0),
        (250.0, 362.0, 46.0),
        (352.0, 360.0, 50.0),
        (300.0, 392.0, 52.0),
    ];
    let in_crown = crown.iter().any(|(cx, cy, r)| distance(*cx, *cy) < *r);
    if in_crown {
        let leaves = smooth(x / 7.0, y / 7.0, [512, 512], 72);
        return mixed([0.1, 0.3, 0.16], [0.35, 0.55, 0.2], leaves * 1.2 - 0.1);
    }
    if (x - 300.0).abs() < 11.0 + (y - 500.0).max(0.0) * 0.4 && (380.0..535.0).contains(&y) {
        return dimmed(
            [0.33, 0.2, 0.12],
            0.7 + 0.6 * smooth(x / 4.0, y / 40.0, [512, 64], 73),
        );
    }
    let ridge =
        |base: f32, height: f32, wide: f32, kind: u32| base - height * rough(x / wide, 0.3, [64, 64], kind);
    let grass = |color: Color, kind| dimmed(color, 0.8 + 0.4 * rough(x / 20.0, y / 6.0, [64, 256], kind));
    if y > ridge(560.0, 90.0, 200.0, 74) {
        grass([0.42, 0.58, 0.24], 75)
    } else if y > ridge(500.0, 150.0, 150.0, 76) {
        grass([0.24, 0.45, 0.36], 77)
    } else if y > ridge(430.0, 230.0, 110.0, 78) {
        grass([0.32, 0.42, 0.55], 79)
    } else if distance(140.0, 150.0) < 62.0 {
        [0.98, 0.72, 0.28]
    } else {
        let cloud = rough(x / 90.0, y / 40.0, [64, 64], 80);
        mixed(
            mixed([0.95, 0.62, 0.42], [0.45, 0.68, 0.86], 1.0 - y / 420.0),
            [1.0, 0.95, 0.9],
            (cloud - 0.55) * 4.0,
        )
    }
}

/// An old map of islands.
pub(super) fn map() -> Picture {
    painted(640, 400, |x, y| {
        let border = x.min(640.0 - x).min(y).min(400.0 - y);
        let height = rough(x / 110.0 + 0.4, y / 110.0, [64, 64], 90);
        let line = |value: f32| value.fract().min(1.0 - value.fract());
        let color = if border < 10.0 {
            [0.25, 0.17, 0.1]
        } else if border < 22.0 {
            [0.88, 0.8, 0.62]
        } else if height > 0.52 {
            let contour = line(height * 40.0);
            let land = mixed([0.8, 0.78, 0.5], [0.6, 0.42, 0.26], (height - 0.52) * 6.0);
            dimmed(land, if contour < 0.12 { 0.65 } else { 1.0 })
        } else if line(x / 64.0).min(line(y / 64.0)) < 0.02 {
            [0.42, 0.56, 0.6]
        } else {
            mixed([0.62, 0.76, 0.76], [0.5, 0.67, 0.7], (0.52 - height) * 8.0)
        };
        dimmed(color, 0.88 + 0.16 * rough(x / 30.0, y / 30.0, [64, 64], 91))
    })
}

/// A woven carpet with a border and rows of diamonds.
pub(super) fn carpet() -> Picture {
    painted(640, 448, |x, y| {
        let border = x.min(640.0 - x).min(y).min(448.0 - y);
        let diamond = |size: f32| {
            let fold = |value: f32| ((value / size).fract() - 0.5).abs();
            fold(x) + fold(y)
        };
        let (red, blue, cream, gold) = (
            [0.55, 0.1, 0.11],
            [0.1, 0.16, 0.34],
            [0.85, 0.78, 0.63],
            [0.72, 0.52, 0.22],
        );
        let color = if border < 8.0 {
            cream
        } else if border < 52.0 {
            let inner = diamond(22.0);
            if inner < 0.25 {
                gold
            } else if inner < 0.4 {
                cream
            } else {
                blue
            }
        } else if border < 58.0 {
            cream
        } else {
            let (large, small) = (diamond(96.0), diamond(24.0));
            if large < 0.14 {
                cream
            } else if large < 0.3 {
                blue
            } else if large < 0.36 || (large > 0.8 && small < 0.3) {
                gold
            } else {
                red
            }
        };
        // Knots in rows.
        let knots = smooth(x / 2.0, y / 3.0, [512, 512], 95);
        let wear = rough(x / 80.0, y / 80.0, [64, 64], 96);
        dimmed(color, 0.72 + 0.3 * knots + 0.2 * wear)
    })
}

/// Squares of chance, coarse and fine, for matching.
pub(super) fn target() -> Picture {
    painted(256, 256, |x, y| {
        #[expect(clippy::cast_possible_truncation, reason = "small")]
        let cell = |size: f32| ((x / size) as i32, (y / size) as i32);
        let border = x.min(256.0 - x).min(y).min(256.0 - y);
        let (coarse, fine) = (cell(32.0), cell(8.0));
        let black = if white(coarse.0, coarse.1, 100) < 0.3 {
            (coarse.0 + coarse.1) % 2 == 0
        } else {
            white(fine.0, fine.1, 101) < 0.5
        };
        if border < 8.0 {
            [0.93; 3]
        } else if black {
            [0.09, 0.1, 0.12]
        } else {
            [0.9, 0.9, 0.88]
        }
    })
}

/// A leaf that grows along x, with veins.
pub(super) fn leaf() -> Picture {
    painted(256, 256, |x, y| {
        let across = (y - 128.0).abs();
        let vein = ((x - across * 0.8) / 26.0).fract();
        let blade = mixed(
            [0.08, 0.3, 0.1],
            [0.2, 0.47, 0.16],
            rough(x / 24.0, y / 24.0, [16, 16], 110),
        );
        if across < 3.5 {
            [0.5, 0.66, 0.32]
        } else if vein < 0.09 {
            mixed(blade, [0.42, 0.6, 0.28], 0.7)
        } else {
            blade
        }
    })
}

/// The cloth of a book, to be tinted: bands, a label, and what might be a title.
pub(super) fn spine() -> Picture {
    painted(128, 512, |x, y| {
        let cloth = 0.7
            + 0.2 * smooth(x / 2.0, y / 2.0, [64, 256], 120)
            + 0.1 * rough(x / 40.0, y / 40.0, [4, 13], 121);
        let band = [34.0, 48.0, 452.0, 470.0].iter().any(|at| (y - at).abs() < 4.0);
        if band {
            return [1.0, 0.98, 0.8];
        }
        let on_label = (24.0..104.0).contains(&x) && (96.0..300.0).contains(&y);
        if on_label {
            // A line of a title runs along the spine.
            #[expect(clippy::cast_possible_truncation, reason = "small")]
            let (line, letter) = ((x / 20.0) as i32, (y / 9.0) as i32);
            let is_ink = (x % 20.0) < 9.0 && (34.0..96.0).contains(&x) && (108.0..288.0).contains(&y);
            let ink = is_ink && white(line, letter, 122) < 0.62;
            return if ink { [0.25; 3] } else { [1.0, 0.99, 0.94] };
        }
        dimmed([1.0; 3], cloth)
    })
}
