//! What the room is built of. All of these repeat.

use super::noise::{rough, smooth, white};
use super::{Color, Picture, dimmed, mixed, painted};

/// A wooden board's colour; the grain runs along x. `kind` tells boards apart.
fn grain(x: f32, y: f32, period: [i32; 2], kind: u32, dark: Color, light: Color) -> Color {
    let wave = rough(
        x * 0.5,
        y * 4.0,
        [period[0].div_euclid(2).max(1), period[1] * 4],
        kind,
    );
    let rings = (wave * 9.0).fract();
    let ring = if rings < 0.75 {
        rings / 0.75
    } else {
        (1.0 - rings) / 0.25
    };
    let pores = smooth(
        x * 6.0,
        y * 64.0,
        [period[0] * 6, period[1] * 64],
        kind.wrapping_add(77),
    );
    dimmed(mixed(light, dark, 0.25 + 0.5 * ring), 0.88 + 0.16 * pores)
}

/// A board of oak.
pub(super) fn wood() -> Picture {
    painted(512, 512, |x, y| {
        grain(
            x / 128.0,
            y / 128.0,
            [4, 4],
            11,
            [0.47, 0.31, 0.17],
            [0.74, 0.56, 0.36],
        )
    })
}

/// A floor of four rows of planks.
pub(super) fn planks() -> Picture {
    painted(1024, 512, |x, y| {
        let row = (y / 128.0).floor();
        #[expect(clippy::cast_possible_truncation, reason = "0 to 3")]
        let row_number = row as i32;
        let shifted = x + white(row_number, 0, 3) * 1024.0;
        let plank = (shifted / 512.0).floor();
        #[expect(clippy::cast_possible_truncation, reason = "0 to 3")]
        let plank_number = (plank as i32).rem_euclid(2);
        let (u, v) = (shifted - plank * 512.0, y - row * 128.0);
        let tone = white(plank_number, row_number, 4);
        let dark = mixed([0.36, 0.21, 0.11], [0.45, 0.29, 0.16], tone);
        let light = mixed([0.58, 0.38, 0.22], [0.70, 0.50, 0.31], tone);
        let kind = 20 + plank_number.unsigned_abs() * 5 + row_number.unsigned_abs() * 16;
        let color = grain(u / 128.0, v / 128.0, [64, 64], kind, dark, light);
        let to_edge = u.min(512.0 - u).min(v).min(128.0 - v);
        dimmed(color, 0.35 + 0.65 * (to_edge / 3.0).min(1.0))
    })
}

/// A plastered wall, not quite white.
pub(super) fn plaster() -> Picture {
    painted(512, 512, |x, y| {
        let patches = rough(x / 128.0, y / 128.0, [4, 4], 31);
        let bumps = rough(x / 16.0, y / 16.0, [32, 32], 37);
        let specks = smooth(x / 3.0, y / 3.0, [170, 170], 41);
        let value = 0.80 + 0.08 * (patches - 0.5) + 0.12 * (bumps - 0.5) + 0.07 * (specks - 0.5);
        dimmed([1.0, 0.975, 0.93], value)
    })
}

/// A wall of bricks in a running bond, eight courses.
pub(super) fn bricks() -> Picture {
    let (length, height, joint) = (128.0, 64.0, 5.0);
    painted(512, 512, |x, y| {
        // Hands laid it.
        let x = x + 3.0 * (smooth(x / 32.0, y / 32.0, [16, 16], 51) - 0.5);
        let y = y + 3.0 * (smooth(x / 32.0, y / 32.0, [16, 16], 52) - 0.5);
        let course = (y / height).floor();
        #[expect(clippy::cast_possible_truncation, reason = "a few")]
        let course_number = (course as i32).rem_euclid(8);
        let shifted = x + if course_number % 2 == 1 { length / 2.0 } else { 0.0 };
        let brick = (shifted / length).floor();
        #[expect(clippy::cast_possible_truncation, reason = "a few")]
        let brick_number = (brick as i32).rem_euclid(4);
        let (u, v) = (shifted - brick * length, y - course * height);
        let to_edge = u.min(length - u).min(v).min(height - v);
        let sand = rough(x / 8.0, y / 8.0, [64, 64], 53);
        let mortar = dimmed([0.72, 0.69, 0.64], 0.75 + 0.35 * sand);
        let tone = white(brick_number, course_number, 54);
        let burnt = mixed([0.47, 0.20, 0.14], [0.70, 0.37, 0.25], tone);
        let clay = dimmed(burnt, 0.72 + 0.5 * rough(x / 12.0, y / 12.0, [43, 43], 55));
        mixed(mortar, clay, (to_edge - joint) / 2.5)
    })
}

/// Corrugated cardboard with a strip of tape.
pub(super) fn carton() -> Picture {
    painted(256, 256, |x, y| {
        let fibres = rough(x / 6.0, y / 40.0, [43, 7], 61);
        let waves = 0.5 - (x / 8.0 - (x / 8.0).floor() - 0.5).abs();
        let board = dimmed([0.73, 0.56, 0.38], 0.84 + 0.2 * fibres + 0.08 * waves);
        if (y - 128.0).abs() < 22.0 {
            return mixed(board, [0.82, 0.74, 0.55], 0.6);
        }
        let arrow = (x - 60.0).abs() < 4.0 && (180.0..225.0).contains(&y)
            || (x - 60.0).abs() < y - 168.0 && (168.0..186.0).contains(&y);
        if arrow {
            dimmed([0.2, 0.16, 0.14], 1.0)
        } else {
            board
        }
    })
}
