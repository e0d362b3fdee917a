//! Detects problems of a pair from its images.

mod difference;
mod points;
mod profiles;

use std::array::from_fn;
use std::borrow::Cow;

use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};
use oaktwin_simd::run;

use super::pair::{LuminanceImage, RectifiedPair};
use super::parameters::Parameters;
use difference::{AREA, LeastDifference, SIDES, WINDOW};
use profiles::Profiles;

/// The maximum vertical offset that is searched in both directions, px: raw images of real pairs differ by up to 40.
const MOST_ROWS: usize = 48;

/// The number of cells along a row and along a column of the image; each cell gives one point.
const CELLS: [usize; 2] = [24, 14];

/// The minimum number of points for a finding.
const FEWEST: usize = 12;

/// The factor by which the difference must be smaller at another position.
const BETTER: f64 = 1.5;

/// A point has a match if its difference is below this share of its contrast, or explained by noise.
const MATCHED: f64 = 0.5;

/// A match is unique if its difference is below this share of the least one more than `NEAR` rows away.
const UNIQUE: f64 = 0.7;
const NEAR: usize = 3;

/// The share of points with a match in their row from which a pair is not searched further. In rectified pairs of real cameras 57 to
/// 63 % have one, and in unrectified ones or with another unit's calibration 15 to 37 %.
const ALIGNED: f64 = 0.5;

/// The offsets of true matches are within this many rows of their median; those by chance are spread over the whole search.
const COMPACT: isize = 12;

/// A match is by chance if its difference exceeds these shares of the difference at an unrelated row and of the
/// contrast.
const CHANCE: [f64; 2] = [0.75, 0.5];

/// The mean difference in grey levels that noise in dim light can explain.
const NOISE: f64 = 4.0;

/// The minimum difference for comparisons, in grey levels: the level of noise.
const FLOOR: f64 = 1.0;

/// The maximum share of saturated pixels.
const SATURATED: f64 = 0.4;

/// The code of the finding about rows that do not correspond, whose remedy depends on how the images were rectified.
pub const VERTICAL_OFFSET: &str = "vertical-offset";

/// Returns the problems of a pair, or of its search range, that make depth wrong or invalid. All findings are warnings:
/// `range-beyond-image`, `saturated`, `no-texture`, `same-image`, `pair-swapped`, `vertical-offset`, `unrelated`.
#[must_use]
pub fn inspect(pair: &RectifiedPair<'_>, parameters: &Parameters) -> Vec<Finding> {
    let (width, height) = (pair.width() as usize, pair.height() as usize);
    let last = parameters.max_disparity_px() as usize;
    let (left, right) = (pair.left(), pair.right());
    let grey = [&left, &right].map(grey_levels);
    let inspection = PairInspection {
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
    findings.extend(saturated("left image", inspection.left));
    findings.extend(saturated("right image", inspection.right));
    let points = inspection.points(inspection.left);
    match inspection.unmatchable(&points) {
        Some(finding) => findings.push(finding),
        None => findings.extend(inspection.misplaced(&points)),
    }
    findings
}

fn warning(code: &'static str, place: &str, message: String, remedy: impl Into<Message>) -> Finding {
    Finding::new(code, Level::Warning, place, message, remedy)
}

/// Returns the 8-bit grey levels of an image.
fn grey_levels<'a>(image: &LuminanceImage<'a>) -> Cow<'a, [u8]> {
    match image {
        LuminanceImage::Bits8(image) => Cow::Borrowed(image.pixels()),
        LuminanceImage::Bits10(image) => image
            .pixels()
            .iter()
            .map(|&level| (level.min(1023) >> 2) as u8)
            .collect(),
    }
}

fn saturated(name: &str, grey: &[u8]) -> Option<Finding> {
    // Sums of few pixels fit into 8 bits, with which the compiler counts many at once.
    let bright = grey
        .chunks(128)
        .map(|some| usize::from(some.iter().map(|&level| u8::from(level >= 254)).sum::<u8>()))
        .sum::<usize>();
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

/// Reports matches above or below their points, if they are clearly better than those in the same row.
fn vertical_offset(profiles: &Profiles, offsets: &[(usize, isize)]) -> Option<Finding> {
    let mut rows: Vec<isize> = offsets.iter().map(|(_, rows)| *rows).collect();
    rows.sort_unstable();
    let at = |tenths: usize| {
        rows.get((rows.len() - 1) * tenths / 10)
            .copied()
            .unwrap_or_default()
    };
    let mean = |of: &dyn Fn(usize, isize) -> f64| {
        offsets.iter().map(|&(point, rows)| of(point, rows)).sum::<f64>() / offsets.len() as f64
    };
    let in_row = mean(&|point, _| profiles.difference(point, 0));
    let best = mean(&|point, rows| profiles.difference(point, rows));
    if in_row <= BETTER * best.max(FLOOR) {
        return None;
    }
    let (least, most) = (at(1), at(9));
    let message = if most - least <= 2 {
        let to = if at(5) > 0 { "lower" } else { "higher" };
        format!(
            "the right image is about {} px {to} than the left one",
            at(5).abs()
        )
    } else {
        format!("points of the right image are {least} to {most} px below those of the left one")
    };
    Some(warning(
        VERTICAL_OFFSET,
        "stereo pair",
        message,
        "rectify both with this unit's calibration",
    ))
}

struct PairInspection<'a> {
    width: usize,
    height: usize,
    left: &'a [u8],
    right: &'a [u8],
    /// The number of columns searched to one side of a point.
    reach: usize,
}

impl<'a> PairInspection<'a> {
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
        let most = self.most_rows();
        let beside = Profiles::new(self, points, false, most.min(2));
        if beside.matched_in_row() >= ALIGNED && beside.least().1 == 0 {
            return Vec::new();
        }
        let given = Profiles::new(self, points, false, most);
        let swapped = Profiles::new(self, points, true, most);
        let [in_order, in_swapped] = [&given, &swapped].map(Profiles::offsets);
        let is_swapped = in_swapped.len() >= FEWEST && in_swapped.len() > 2 * in_order.len();
        let (profiles, offsets) = if is_swapped {
            (&swapped, in_swapped)
        } else {
            (&given, in_order)
        };
        let mut findings = Vec::new();
        if is_swapped {
            findings.push(warning(
                "pair-swapped",
                "stereo pair",
                "points of the left image are farther right in the right image".to_owned(),
                "swap the left and the right image",
            ));
        }
        if offsets.len() >= FEWEST {
            findings.extend(vertical_offset(profiles, &offsets));
        } else if self.is_by_chance(points, given.least().0) {
            findings.push(warning(
                "unrelated",
                "stereo pair",
                "the images do not match, or all surfaces are nearer than the search range".to_owned(),
                message![
                    "give both images of the same moment; for near objects enable ",
                    opt("extended-disparity")
                ],
            ));
        }
        findings
    }

    fn at(&self, image: &[u8], x: usize, y: usize) -> u32 {
        image.get(y * self.width + x).copied().unwrap_or_default().into()
    }

    /// Returns the number of rows searched above and below a point.
    fn most_rows(&self) -> usize {
        MOST_ROWS.min(self.height / 8)
    }

    /// Returns the point with the most texture in each cell of an image, if it has enough.
    fn points(&self, image: &[u8]) -> Vec<[usize; 2]> {
        let [side, up] = [WINDOW[0] + 1, WINDOW[1] + 1];
        let (left, top) = (self.reach + side, self.most_rows() + up);
        let (Some(columns), Some(rows)) = (
            self.width.checked_sub(2 * left).filter(|&columns| columns > 0),
            self.height.checked_sub(2 * top).filter(|&rows| rows > 0),
        ) else {
            return Vec::new();
        };
        let cell = [columns.div_ceil(CELLS[0]), rows.div_ceil(CELLS[1])];
        points::points(image, self.width, [left..left + columns, top..top + rows], cell)
    }

    /// Whether points with the mean difference `least` match no better than half an image above or below, where they
    /// cannot correspond. A repeating pattern matches there too, but with a small difference.
    fn is_by_chance(&self, points: &[[usize; 2]], least: f64) -> bool {
        let far = self.height.cast_signed() / 2;
        if far <= 2 * self.most_rows().cast_signed() || least <= NOISE {
            return false;
        }
        let elsewhere = [far, -far].map(|rows| self.difference(points, rows));
        let elsewhere = elsewhere.into_iter().flatten().fold(f64::MAX, f64::min);
        let contrast =
            points.iter().map(|&point| self.contrast(point)).sum::<f64>() / points.len().max(1) as f64;
        least > CHANCE[0] * elsewhere && least > CHANCE[1] * contrast
    }

    /// Returns the mean absolute deviation around a point, in grey levels.
    fn contrast(&self, [x, y]: [usize; 2]) -> f64 {
        let [side, up] = WINDOW;
        let levels = || {
            let rows = y - up..=y + up;
            rows.flat_map(|y| (x - side..=x + side).map(move |x| f64::from(self.at(self.left, x, y))))
        };
        let mean = levels().sum::<f64>() / AREA;
        levels().map(|level| (level - mean).abs()).sum::<f64>() / AREA
    }

    /// Returns the mean difference in grey levels between the points and their best match `rows` rows below.
    fn difference(&self, points: &[[usize; 2]], rows: isize) -> Option<f64> {
        let inside = WINDOW[1]..self.height.saturating_sub(WINDOW[1]);
        let there = |y: usize| y.checked_add_signed(rows).filter(|there| inside.contains(there));
        let sums: Vec<u32> = points
            .iter()
            .filter_map(|&[x, y]| Some(self.least([x, y], there(y)?, false)))
            .collect();
        (!sums.is_empty()).then(|| f64::from(sums.iter().sum::<u32>()) / (sums.len() as f64 * AREA))
    }

    /// Returns the minimum sum of differences between a point's window and the windows of a row of the right image.
    fn least(&self, [x, y]: [usize; 2], there: usize, is_swapped: bool) -> u32 {
        let [side, up] = WINDOW;
        let row = |image: &'a [u8], y: usize, from: usize, length: usize| {
            let from = y * self.width + from;
            image.get(from..from + length).unwrap_or_default()
        };
        let from = if is_swapped { x } else { x - self.reach } - side;
        let window = |dy| row(self.left, y - up + dy, x - side, SIDES[0]);
        let strip = |dy| row(self.right, there - up + dy, from, self.reach + SIDES[0]);
        run(LeastDifference {
            window: from_fn(|dy| window(dy).first_chunk().unwrap_or(&[0; SIDES[0]])),
            strip: from_fn(strip),
        })
        .into()
    }
}
