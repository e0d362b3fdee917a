//! The shapes of the letters.
//!
//! Strokes are lists of points, each two hexadecimal digits: x to the right, y down, a capital from 0 to `c`. `|` begins
//! another stroke, `~` one whose points are the control points of a smooth curve (a quadratic B-spline).

/// Height of a capital letter, units.
pub(super) const CAPITAL: u8 = 12;

/// Between letters, units.
pub(super) const GAP: u16 = 4;

/// Width of a space without its gap, units.
const SPACE: u16 = 2;

/// The shape of a character; a box where the font has none.
pub(super) fn glyph(c: char) -> Glyph {
    Glyph(match c {
        ' ' => "",
        '0' => "~40 80 8c 0c 00 40",
        '1' => "03 40 4c",
        '2' => "~03 00 80 86 0c|0c 8c",
        '3' => "~02 00 70 76 36|~36 86 8c 0c 0a",
        '4' => "6c 60 09 89",
        '5' => "70 10 06|~06 04 84 8c 0c 0a",
        '6' => "~72 70 00 09|~45 85 8c 0c 05 45",
        '7' => "00 80 2c",
        '8' => "~40 70 76 16 10 40|~46 86 8c 0c 06 46",
        '9' => "~1a 1c 8c 83|~40 80 87 07 00 40",
        'A' => "0c 40 8c|18 78",
        'B' => "00 0c|~00 40 70 76 46 06|~06 46 86 8c 4c 0c",
        'C' => "~82 80 00 0c 8c 8a",
        'D' => "00 0c|~00 30 80 8c 3c 0c",
        'E' => "80 00 0c 8c|06 66",
        'F' => "80 00 0c|06 66",
        'G' => "~82 80 00 0c 8c 87|87 57",
        'H' => "00 0c|80 8c|06 86",
        'I' => "00 0c",
        'J' => "~60 66 6c 0c 09",
        'K' => "00 0c|80 08|35 8c",
        'L' => "00 0c 7c",
        'M' => "0c 00 48 80 8c",
        'N' => "0c 00 8c 80",
        'O' => "~40 80 8c 0c 00 40",
        'P' => "00 0c|~00 40 80 87 47 07",
        'Q' => "~40 80 8c 0c 00 40|59 8d",
        'R' => "00 0c|~00 40 80 87 47 07|47 8c",
        'S' => "~82 80 00 06 46 86 8c 0c 0a",
        'T' => "00 80|40 4c",
        'U' => "~00 06 0c 8c 86 80",
        'V' => "00 4c 80",
        'W' => "00 2c 53 8c a0",
        'X' => "00 8c|80 0c",
        'Y' => "00 46 80|46 4c",
        'Z' => "00 80 0c 8c",
        'a' => "~34 64 6c 3c 0c 04 34|64 6c",
        'b' => "~34 64 6c 3c 0c 04 34|00 0c",
        'c' => "~66 64 04 0c 6c 6a",
        'd' => "~34 64 6c 3c 0c 04 34|60 6c",
        'e' => "08 68|~68 64 04 0c 6c 6b",
        'f' => "~50 20 26 2c|04 54",
        'g' => "~34 64 6c 3c 0c 04 34|~64 6c 6f 0f 0e",
        'h' => "00 0c|~08 04 64 68 6c",
        'i' => "04 0c|01 01",
        'j' => "~24 2c 2f 0f|21 21",
        'k' => "00 0c|54 09|27 6c",
        'l' => "00 0c",
        'm' => "04 0c|~08 04 54 58 5c|~58 54 a4 a8 ac",
        'n' => "04 0c|~08 04 64 68 6c",
        'o' => "~34 64 6c 3c 0c 04 34",
        'p' => "~34 64 6c 3c 0c 04 34|04 0f",
        'q' => "~34 64 6c 3c 0c 04 34|64 6f",
        'r' => "04 0c|~09 04 44",
        's' => "~65 64 04 08 68 6c 0c 0b",
        't' => "~21 28 2c 5c|04 54",
        'u' => "~04 08 0c 6c 68 64|64 6c",
        'v' => "04 3c 64",
        'w' => "04 2c 46 6c 84",
        'x' => "04 6c|64 0c",
        'y' => "04 3c|64 1f",
        'z' => "04 64 0c 6c",
        '.' => "0c 0c",
        ',' => "1b 0e",
        ':' => "05 05|0c 0c",
        '\'' => "00 03",
        '!' => "00 08|0c 0c",
        '?' => "~02 00 80 86 46 48|4c 4c",
        '-' => "07 67",
        '+' => "07 87|43 4b",
        '=' => "05 75|09 79",
        '<' => "72 07 7c",
        '>' => "02 77 0c",
        '/' => "0e 70",
        '_' => "0d 8d",
        '(' => "~30 00 0d 3d",
        ')' => "~00 30 3d 0d",
        '[' => "30 00 0d 3d",
        ']' => "00 30 3d 0d",
        '|' => "00 0d",
        '%' => "80 0c|~20 40 44 04 00 20|~68 88 8c 4c 48 68",
        '°' => "~20 40 44 04 00 20",
        '×' => "04 7b|74 0b",
        _ => "00 80 8c 0c 00",
    })
}

/// The shape of one character.
#[derive(Clone, Copy)]
pub(super) struct Glyph(&'static str);

impl Glyph {
    /// To the next character's left edge, units.
    pub(super) fn advance(self) -> u16 {
        let points = self.0.split(['|', '~', ' ']).filter_map(point);
        let right = points
            .map(|[x, _]| x)
            .fold(None, |most: Option<u8>, x| most.max(Some(x)));
        right.map_or(SPACE, u16::from) + GAP
    }

    /// Lines through points, units.
    pub(super) fn strokes(self) -> Vec<Vec<[f32; 2]>> {
        self.0
            .split('|')
            .map(|stroke| {
                let smooth = stroke.strip_prefix('~');
                let points: Vec<[f32; 2]> = smooth
                    .unwrap_or(stroke)
                    .split(' ')
                    .filter_map(point)
                    .map(|point| point.map(f32::from))
                    .collect();
                if smooth.is_some() { curve(points) } else { points }
            })
            .collect()
    }
}

fn point(digits: &str) -> Option<[u8; 2]> {
    let digit = |i: usize| u8::from_str_radix(digits.get(i..=i)?, 16).ok();
    Some([digit(0)?, digit(1)?])
}

/// The B-spline of control points, by cutting corners (Chaikin's algorithm); it begins and ends where they do.
fn curve(mut points: Vec<[f32; 2]>) -> Vec<[f32; 2]> {
    for _ in 0..4 {
        let mix = |a: [f32; 2], b: [f32; 2], t: f32| [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
        let (Some(&first), Some(&last)) = (points.first(), points.last()) else {
            return points;
        };
        let last_edge = points.len().saturating_sub(2);
        let mut finer = vec![first];
        for (i, ends) in points.windows(2).enumerate() {
            // The ends stay where they are.
            if i > 0 {
                finer.push(mix(ends[0], ends[1], 0.25));
            }
            if i < last_edge {
                finer.push(mix(ends[0], ends[1], 0.75));
            }
        }
        finer.push(last);
        points = finer;
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_of_every_glyph_is_two_digits() {
        for c in (' '..='~').chain(['°', '×']) {
            for stroke in glyph(c).0.split('|') {
                let points: Vec<&str> = stroke.trim_start_matches('~').split(' ').collect();
                assert!(
                    c == ' ' || points.iter().all(|p| p.len() == 2 && point(p).is_some()),
                    "{c}: {stroke}"
                );
                assert!(c == ' ' || points.len() >= 2, "{c}: {stroke}");
            }
        }
    }

    #[test]
    fn a_curve_stays_within_its_control_points() {
        let smooth = curve(vec![[4.0, 0.0], [8.0, 0.0], [8.0, 12.0], [4.0, 12.0]]);
        assert_eq!((smooth[0], smooth[smooth.len() - 1]), ([4.0, 0.0], [4.0, 12.0]));
        assert!(smooth.iter().all(|p| (4.0..=8.0).contains(&p[0])));
        // It touches the middle edge half way.
        assert!(smooth.iter().any(|p| p[0] > 7.9));
        assert_eq!(curve(vec![]), Vec::<[f32; 2]>::new());
    }
}
