//! Detects problems of a pair from its images.

use oaktwin_diagnostic::{Finding, Level};

use super::pair::{Luminance, Pair};
use super::parameters::Parameters;

/// The number of columns and rows compared on each side of a point.
const WINDOW: [usize; 2] = [6, 3];

/// The maximum vertical offset that is searched in both directions, px.
const MOST_ROWS: usize = 16;

/// The number of cells along a row and along a column of the image; each cell gives one point.
const CELLS: [usize; 2] = [24, 14];

/// The minimum difference of a point's neighbours, horizontally and vertically, in grey levels.
const TEXTURE: u32 = 10;

/// The minimum number of points for a finding.
const FEWEST: usize = 12;

/// The factor by which the difference must be smaller at another position.
const BETTER: f64 = 1.5;

/// A match is by chance if its difference exceeds these shares of the difference at an unrelated row and of the
/// contrast.
const CHANCE: [f64; 2] = [0.75, 0.5];

/// The mean difference in grey levels that noise in dim light can explain.
const NOISE: f64 = 4.0;

/// The minimum difference for comparisons, in grey levels: the level of noise.
const FLOOR: f64 = 1.0;

/// The maximum share of saturated pixels.
const SATURATED: f64 = 0.4;

/// Returns the problems of a pair, or of its search range, that make depth wrong or invalid. All findings are warnings:
/// `range-beyond-image`, `saturated`, `no-texture`, `same-image`, `pair-swapped`, `vertical-offset`, `unrelated`.
#[must_use]
pub fn inspect(pair: &Pair<'_>, parameters: &Parameters) -> Vec<Finding> {
    let (width, height) = (pair.width() as usize, pair.height() as usize);
    let last = parameters.max_disparity_px() as usize;
    let grey = [pair.left(), pair.right()].map(grey_levels);
    let look = Look {
        width,
        height,
        left: &grey[0],
        right: &grey[1],
        reach: last.min(width / 3),
    };
    let mut findings = Vec::new();
    if last >= width {
        findings.push(warning(
            "range-beyond-image",
            "disparity range",
            format!("disparities up to {last} px exceed the image width of {width} px"),
            "use larger images, or a smaller disparityShift",
        ));
    }
    findings.extend(saturated("left image", look.left));
    findings.extend(saturated("right image", look.right));
    let points = look.points(look.left);
    match look.unmatchable(&points) {
        Some(finding) => findings.push(finding),
        None => findings.extend(look.misplaced(&points)),
    }
    findings
}

fn warning(code: &'static str, place: &str, message: String, remedy: &'static str) -> Finding {
    Finding::new(code, Level::Warning, place, message, remedy)
}

/// Returns the 8-bit grey levels of an image.
fn grey_levels(image: Luminance<'_>) -> Vec<u8> {
    let more = image.bits() - 8;
    let levels = image.levels().into_iter();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "8 bits")]
    let levels = levels.map(|level| (level >> more) as u8).collect();
    levels
}

fn saturated(name: &str, grey: &[u8]) -> Option<Finding> {
    let bright = grey.iter().filter(|&&level| level >= 254).count();
    #[expect(clippy::cast_precision_loss, reason = "a share")]
    let share = bright as f64 / grey.len().max(1) as f64;
    (share > SATURATED).then(|| {
        warning(
            "saturated",
            name,
            format!("{:.0} % of the pixels are saturated", share * 100.0),
            "reduce the exposure",
        )
    })
}

struct Look<'a> {
    width: usize,
    height: usize,
    left: &'a [u8],
    right: &'a [u8],
    /// The number of columns searched to one side of a point.
    reach: usize,
}

impl Look<'_> {
    /// Returns why the images cannot be compared: too little texture, or no difference.
    fn unmatchable(&self, points: &[[usize; 2]]) -> Option<Finding> {
        let counts = [
            ("left image", points.len()),
            ("right image", self.points(self.right).len()),
        ];
        if let Some((name, count)) = counts.into_iter().find(|&(_, count)| count < FEWEST) {
            return Some(warning(
                "no-texture",
                name,
                format!("too little texture: {count} matchable points"),
                "add light, enable the dot projector, or use a textured scene",
            ));
        }
        (self.left == self.right).then(|| {
            warning(
                "same-image",
                "stereo pair",
                "the left and the right image are identical".to_owned(),
                "give the images of both cameras",
            )
        })
    }

    /// Returns the problems of how the images correspond.
    fn misplaced(&self, points: &[[usize; 2]]) -> Vec<Finding> {
        let most = MOST_ROWS.cast_signed();
        let by_rows = |is_swapped| {
            let all = (-most..=most).map(|rows| (self.difference(points, rows, is_swapped), rows));
            // Of equal differences, the smallest offset.
            let least = all.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.abs().cmp(&b.1.abs())));
            least.unwrap_or((f64::MAX, 0))
        };
        let (given, swapped) = (by_rows(false), by_rows(true));
        let is_swapped = given.0 > BETTER * swapped.0.max(FLOOR);
        let (least, rows) = if is_swapped { swapped } else { given };
        let mut findings = Vec::new();
        if is_swapped {
            findings.push(warning(
                "pair-swapped",
                "stereo pair",
                "points of the left image are farther right in the right image".to_owned(),
                "swap the left and the right image",
            ));
        }
        if !is_swapped && self.is_by_chance(points, least) {
            findings.push(warning(
                "unrelated",
                "stereo pair",
                "the images do not match, or all surfaces are nearer than the search range".to_owned(),
                "give both images of the same moment; for near objects enable the extended disparity",
            ));
        } else if rows != 0 && self.difference(points, 0, is_swapped) > BETTER * least.max(FLOOR) {
            let to = if rows > 0 { "lower" } else { "higher" };
            findings.push(warning(
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

    fn at(&self, image: &[u8], x: usize, y: usize) -> u32 {
        image.get(y * self.width + x).copied().unwrap_or_default().into()
    }

    /// Returns the point with the most texture in each cell of an image, if it has enough.
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

    /// Whether points with the mean difference `least` match no better than half an image above or below, where they
    /// cannot correspond. A repeating pattern matches there too, but with a small difference.
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

    /// Returns the mean absolute deviation around the points, in grey levels.
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

    /// Returns the mean difference in grey levels between the points and their best match `rows` rows below: to the
    /// left, or to the right if the images are swapped.
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
