//! What is wrong with a pair, as far as the images show it.

use oaktwin_diagnostic::{Finding, Level};

use super::pair::Pair;
use super::parameters::Parameters;

/// Columns and rows around a point that are compared.
const WINDOW: [usize; 2] = [6, 3];

/// Rows that a point is looked for above and below, px.
const MOST_ROWS: usize = 16;

/// Cells of a row and of a column of the image, each of which gives one point.
const CELLS: [usize; 2] = [24, 14];

/// Grey levels that a point's neighbours differ by, along and across, at least.
const TEXTURE: u32 = 10;

/// Fewer points say nothing.
const FEWEST: usize = 12;

/// A place is another if points differ this many times less there.
const BETTER: f64 = 1.5;

/// What fits by chance differs by so much of what it differs from any other row, and of its own contrast, at least.
const CHANCE: [f64; 2] = [0.75, 0.5];

/// A mean difference of no more grey levels may be all of noise, in dim light.
const NOISE: f64 = 4.0;

/// Grey levels that are noise.
const FLOOR: f64 = 1.0;

/// The share of pixels that may be as bright as can be.
const SATURATED: f64 = 0.4;

/// What about a pair, or about what is searched in it, makes depth wrong or none. Each finding is a warning:
/// `range-beyond-image`, `saturated`, `no-texture`, `same-image`, `pair-swapped`, `vertical-offset`, `unrelated`.
#[must_use]
pub fn inspect(pair: &Pair<'_>, parameters: &Parameters) -> Vec<Finding> {
    let warn =
        |code, place: &str, message, remedy: &str| Finding::new(code, Level::Warning, place, message, remedy);
    let mut findings = Vec::new();
    let (width, height) = (pair.width() as usize, pair.height() as usize);
    let last = parameters.max_disparity_px() as usize;
    if last >= width {
        findings.push(warn(
            "range-beyond-image",
            "disparity range",
            format!("disparities up to {last} px exceed the image width of {width} px"),
            "use larger images, or a smaller disparityShift",
        ));
    }
    let more = pair.left().bits() - 8;
    let grey = [pair.left(), pair.right()].map(|image| {
        let levels = image.levels().into_iter();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "8 bits")]
        let levels: Vec<u8> = levels.map(|level| (level >> more) as u8).collect();
        levels
    });
    for (name, grey) in ["left image", "right image"].into_iter().zip(&grey) {
        let bright = grey.iter().filter(|&&level| level >= 254).count();
        #[expect(clippy::cast_precision_loss, reason = "a share")]
        let share = bright as f64 / grey.len().max(1) as f64;
        if share > SATURATED {
            findings.push(warn(
                "saturated",
                name,
                format!("{:.0} % of the pixels are saturated", share * 100.0),
                "reduce the exposure",
            ));
        }
    }
    let look = Look {
        width,
        height,
        left: &grey[0],
        right: &grey[1],
        reach: last.min(width / 3),
    };
    let points = look.points(look.left);
    for (name, count) in [
        ("left image", points.len()),
        ("right image", look.points(look.right).len()),
    ] {
        if count < FEWEST {
            findings.push(warn(
                "no-texture",
                name,
                format!("too little texture: {count} matchable points"),
                "add light, enable the dot projector, or use a textured scene",
            ));
            return findings;
        }
    }
    if look.left == look.right {
        findings.push(warn(
            "same-image",
            "stereo pair",
            "the left and the right image are identical".to_owned(),
            "give the images of both cameras",
        ));
        return findings;
    }
    let most = MOST_ROWS.cast_signed();
    let by_rows = |is_swapped| {
        let rows = -most..=most;
        let all = rows.map(|rows| (look.difference(&points, rows, is_swapped), rows));
        // Of equal ones the nearest row.
        let least = all.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.abs().cmp(&b.1.abs())));
        least.unwrap_or((f64::MAX, 0))
    };
    let (given, swapped) = (by_rows(false), by_rows(true));
    let is_swapped = given.0 > BETTER * swapped.0.max(FLOOR);
    if is_swapped {
        findings.push(warn(
            "pair-swapped",
            "stereo pair",
            "points of the left image are farther right in the right image".to_owned(),
            "swap the left and the right image",
        ));
    }
    let (least, rows) = if is_swapped { swapped } else { given };
    if !is_swapped && look.is_by_chance(&points, least) {
        findings.push(warn(
            "unrelated",
            "stereo pair",
            "the images do not match, or all surfaces are nearer than the search range".to_owned(),
            "give both images of the same moment; for near objects enable the extended disparity",
        ));
    } else if rows != 0 && look.difference(&points, 0, is_swapped) > BETTER * least.max(FLOOR) {
        let to = if rows > 0 { "lower" } else { "higher" };
        findings.push(warn(
            "vertical-offset",
            "stereo pair",
            format!(
                "the right image is about {} px {to} than the left one",
                rows.abs()
            ),
            "rectify both with this unit's calibration",
        ));
    }
    findings
}

struct Look<'a> {
    width: usize,
    height: usize,
    left: &'a [u8],
    right: &'a [u8],
    /// Columns that a point is looked for sideways.
    reach: usize,
}

impl Look<'_> {
    fn at(&self, image: &[u8], x: usize, y: usize) -> u32 {
        image.get(y * self.width + x).copied().unwrap_or_default().into()
    }

    /// The most textured place of each cell of an image, where it has any.
    fn points(&self, image: &[u8]) -> Vec<[usize; 2]> {
        let [side, up] = [WINDOW[0] + 1, WINDOW[1] + 1];
        let (left, top) = (self.reach + side, MOST_ROWS.min(self.height / 8) + up);
        let mut points = Vec::new();
        let (Some(columns), Some(rows)) = (
            self.width.checked_sub(2 * left).filter(|&columns| columns > 0),
            self.height.checked_sub(2 * top).filter(|&rows| rows > 0),
        ) else {
            return points;
        };
        let (cell_width, cell_height) = (columns.div_ceil(CELLS[0]), rows.div_ceil(CELLS[1]));
        for y0 in (top..top + rows).step_by(cell_height) {
            for x0 in (left..left + columns).step_by(cell_width) {
                let mut best = (TEXTURE, None);
                for y in y0..(y0 + cell_height).min(top + rows) {
                    for x in x0..(x0 + cell_width).min(left + columns) {
                        let along = self.at(image, x + 1, y).abs_diff(self.at(image, x - 1, y));
                        let across = self.at(image, x, y + 1).abs_diff(self.at(image, x, y - 1));
                        let texture = along.min(across);
                        if texture > best.0 {
                            best = (texture, Some([x, y]));
                        }
                    }
                }
                points.extend(best.1);
            }
        }
        points
    }

    /// Whether points that differ so much fit no better than where they cannot be, half an image above or below. A pattern
    /// that repeats fits there too, but well.
    fn is_by_chance(&self, points: &[[usize; 2]], least: f64) -> bool {
        let far = self.height.cast_signed() / 2;
        if far <= 2 * MOST_ROWS.cast_signed() || least <= NOISE {
            return false;
        }
        let elsewhere = self
            .difference(points, far, false)
            .min(self.difference(points, -far, false));
        least > CHANCE[0] * elsewhere && least > CHANCE[1] * self.contrast(points)
    }

    /// The mean grey levels by which the pixels around points differ from their mean.
    fn contrast(&self, points: &[[usize; 2]]) -> f64 {
        let [side, up] = WINDOW;
        let area = ((2 * side + 1) * (2 * up + 1)) as f64;
        let all = points.iter().map(|&[x, y]| {
            let levels = || {
                let rows = y - up..=y + up;
                rows.flat_map(|y| (x - side..=x + side).map(move |x| f64::from(self.at(self.left, x, y))))
            };
            let mean = levels().sum::<f64>() / area;
            levels().map(|level| (level - mean).abs()).sum::<f64>() / area
        });
        all.sum::<f64>() / points.len().max(1) as f64
    }

    /// The mean grey levels by which points differ from where they fit best, so many rows below; to the left, or swapped
    /// to the right.
    fn difference(&self, points: &[[usize; 2]], rows: isize, is_swapped: bool) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for &[x, y] in points {
            let Some(there) = y.checked_add_signed(rows) else {
                continue;
            };
            if there < WINDOW[1] || there + WINDOW[1] >= self.height {
                continue;
            }
            let least = (0..=self.reach).map(|d| {
                let to = if is_swapped { x + d } else { x - d };
                let mut total = 0;
                for dy in 0..=2 * WINDOW[1] {
                    let own = (y + dy - WINDOW[1]) * self.width + x - WINDOW[0];
                    let other = (there + dy - WINDOW[1]) * self.width + to - WINDOW[0];
                    let own = self.left.get(own..own + 2 * WINDOW[0] + 1).unwrap_or_default();
                    let other = self
                        .right
                        .get(other..other + 2 * WINDOW[0] + 1)
                        .unwrap_or_default();
                    total += own
                        .iter()
                        .zip(other)
                        .map(|(a, b)| u32::from(a.abs_diff(*b)))
                        .sum::<u32>();
                }
                total
            });
            sum += f64::from(least.min().unwrap_or(0));
            count += 1.0;
        }
        let area = (2.0 * 6.0 + 1.0) * (2.0 * 3.0 + 1.0);
        if count > 0.0 { sum / count / area } else { f64::MAX }
    }
}
