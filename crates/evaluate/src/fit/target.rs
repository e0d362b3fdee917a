//! The evaluation of a target, frame by frame.

use std::collections::BTreeMap;

use crate::measure::{Autocovariance, ImageRegion, median};

use super::FitError;
use super::error_domain::ErrorDomain;
use super::recording::{Files, TargetRecording};
use oaktwin_camera::ImageSize;
use oaktwin_files::FileError;
use oaktwin_image::Image;
use oaktwin_pipeline::input::reader::DepthImageReader;

/// The depths of a measurement and of its ground truth, m: others are no measurements.
const MEASURABLE_M: std::ops::RangeInclusive<f32> = 1e-3..=1e4;

/// The maximum lag of covariances in pixels.
const MAX_LAGS: usize = 48;

/// The distance from the region's median, as a multiple of the median deviation, above which a value is a mismatch.
const MISMATCH: f64 = 6.0;

/// The maximum number of separate cells of a region; larger regions are averaged over squares.
const MAX_CELLS: f64 = 4096.0;

/// The settings of an evaluation.
#[derive(Clone, Copy, Debug)]
pub(super) struct EvaluationSettings {
    /// The quantity in which errors are counted.
    pub(super) error_domain: ErrorDomain,
    /// The smallest significant step: values within it are not mismatches.
    pub(super) step: f64,
    /// The focal length divided by the width.
    pub(super) focal_of_width: f64,
    /// The side of the region as a share of the image's side.
    pub(super) region: f64,
    /// Metres per unit of integer images.
    pub(super) unit_m: f64,
    /// Whether depth is rounded down to whole units rather than to the nearest.
    pub(super) is_truncated: bool,
}

/// Sums of values in one cell or of one true value.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sum {
    pub(super) truth: f64,
    pub(super) measured: f64,
    pub(super) values: u64,
}

impl Sum {
    pub(super) fn mean_truth(&self) -> f64 {
        self.truth / self.values as f64
    }

    pub(super) fn mean_measured(&self) -> f64 {
        self.measured / self.values as f64
    }
}

/// A part of the region, and its position at depth 1 relative to the centre of the region.
#[derive(Clone, Copy, Debug)]
pub(super) struct RegionCell {
    pub(super) at: [f64; 2],
    pub(super) sum: Sum,
}

/// The measurements of one target.
#[derive(Clone, Debug)]
pub(super) struct Observation {
    pub(super) name: String,
    pub(super) distance_m: Option<f64>,
    pub(super) size: ImageSize,
    pub(super) frames: usize,
    /// The share of the region's pixels that are valid.
    pub(super) fill_rate: f64,
    /// The share of the valid pixels that are mismatches.
    pub(super) mismatch_rate: f64,
    /// The mean over time of each cell; empty if there are images of the ground truth.
    pub(super) cells: Vec<RegionCell>,
    /// The sums by true value; empty without images of the ground truth.
    pub(super) by_truth: Vec<Sum>,
    /// The covariance of half of the differences of consecutive frames.
    pub(super) pairs: Vec<Autocovariance>,
    /// The variance of half of the differences of frames two apart.
    pub(super) apart: Autocovariance,
    /// The side of the averaged squares in pixels.
    pub(super) square: u32,
    /// The mean depth in metres.
    pub(super) depth_m: f64,
    /// The size of a unit of depth at the centre; 0 if depth is not in whole units.
    pub(super) unit: f64,
}

impl Observation {
    /// Returns half of the variance of a pixel's differences, including the effect of steps.
    pub(super) fn variance(&self) -> Option<f64> {
        self.noise()?.at(0)
    }

    /// Returns the covariance over all pairs of frames.
    pub(super) fn noise(&self) -> Option<Autocovariance> {
        let mut pairs = self.pairs.iter();
        let mut all = pairs.next()?.clone();
        pairs.for_each(|pair| all.merge(pair));
        Some(all)
    }

    /// Returns the variance that rounding to steps and units adds to a pixel.
    pub(super) fn rounding(&self, step: f64) -> f64 {
        (step * step + self.unit * self.unit) / 12.0
    }

    /// Fits a plane to the values: its value at the centre, its slopes to the right and down per unit at depth 1, and the root
    /// mean square of the residuals.
    pub(super) fn plane(&self) -> Option<([f64; 3], f64)> {
        let cells = || self.cells.iter().filter(|cell| cell.sum.values > 0);
        let (mut weight, mut mean) = (0.0, [0.0; 3]);
        for cell in cells() {
            let w = cell.sum.values as f64;
            weight += w;
            for (sum, value) in mean
                .iter_mut()
                .zip([cell.at[0], cell.at[1], cell.sum.mean_measured()])
            {
                *sum += w * value;
            }
        }
        let mean = mean.map(|sum| sum / weight);
        let (mut xx, mut xy, mut yy, mut xd, mut yd, mut dd) = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        for cell in cells() {
            let w = cell.sum.values as f64;
            let (x, y) = (cell.at[0] - mean[0], cell.at[1] - mean[1]);
            let d = cell.sum.mean_measured() - mean[2];
            xx += w * x * x;
            xy += w * x * y;
            yy += w * y * y;
            xd += w * x * d;
            yd += w * y * d;
            dd += w * d * d;
        }
        let determinant = xx * yy - xy * xy;
        if determinant.is_nan() || determinant <= 1e-12 * (xx + yy).powi(2) {
            return None;
        }
        let right = (yy * xd - xy * yd) / determinant;
        let down = (xx * yd - xy * xd) / determinant;
        let rest = (dd - right * xd - down * yd).max(0.0) / weight;
        let middle = mean[2] - right * mean[0] - down * mean[1];
        Some(([middle, right, down], rest.sqrt()))
    }

    /// Returns the mean squares of the cells' offsets to the right and down.
    pub(super) fn extent(&self) -> [f64; 2] {
        let weight = self.cells.iter().map(|cell| cell.sum.values as f64).sum::<f64>();
        [0, 1].map(|axis| {
            let squares = self
                .cells
                .iter()
                .map(|cell| cell.sum.values as f64 * cell.at[axis].powi(2));
            squares.sum::<f64>() / weight
        })
    }

    /// Returns the number of valid values in all frames.
    pub(super) fn values(&self) -> u64 {
        let cells = self.cells.iter().map(|cell| cell.sum.values);
        cells.chain(self.by_truth.iter().map(|sum| sum.values)).sum()
    }
}

/// Evaluates all images of a target.
pub(super) fn observe(
    recording: &TargetRecording,
    settings: &EvaluationSettings,
) -> Result<Observation, FitError> {
    let mut observer: Option<Observer> = None;
    for files in &recording.files {
        let mut sensed = files.open(settings.unit_m)?;
        let mut truth = files
            .truth
            .as_ref()
            .map(|path| DepthImageReader::open(path, settings.unit_m))
            .transpose()?;
        while let Some(image) = sensed.next_image()? {
            let size = ImageSize::new(image.width(), image.height());
            let observer = observer.get_or_insert_with(|| Observer::new(*settings, size, recording));
            if size != observer.size {
                return Err(differs(files, size, observer.size, &recording.files[0]).into());
            }
            let truth = match &mut truth {
                Some(source) => match source.next_image()? {
                    Some(truth) if ImageSize::new(truth.width(), truth.height()) == size => Some(truth),
                    _ => return Err(no_truth(files).into()),
                },
                None => None,
            };
            observer.add(&image, truth.as_ref());
        }
    }
    let observer = observer.ok_or_else(|| {
        FitError::Option(format!("{}: contains no images; remove it", recording.name).into())
    })?;
    Ok(observer.observation(recording))
}

fn differs(files: &Files, size: ImageSize, first: ImageSize, before: &Files) -> FileError {
    FileError::new(
        &files.sensed,
        format!("it is {size}, but {} is {first}", before.sensed.display()),
        "give images of one camera in one mode",
    )
}

fn no_truth(files: &Files) -> FileError {
    let truth = files.truth.as_deref().unwrap_or(&files.sensed);
    FileError::new(
        truth,
        format!(
            "contains no image of the same size as the one in {}",
            files.sensed.display()
        ),
        "give the ground truth of each image in its size",
    )
}

struct Observer {
    settings: EvaluationSettings,
    size: ImageSize,
    region: ImageRegion,
    lags: usize,
    frames: usize,
    valid: u64,
    mismatches: u64,
    unit_m: f64,
    square: u32,
    cells: Vec<RegionCell>,
    by_truth: BTreeMap<i64, Sum>,
    /// The two previous frames.
    before: [Option<(Vec<f32>, Vec<f32>)>; 2],
    apart: Autocovariance,
    pairs: Vec<Autocovariance>,
}

impl Observer {
    fn new(settings: EvaluationSettings, size: ImageSize, recording: &TargetRecording) -> Self {
        let region = ImageRegion::centred(size.width, size.height, settings.region);
        let [columns, rows] = [region.columns.len(), region.rows.len()];
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "below an image's side"
        )]
        let square = ((region.pixels() as f64 / MAX_CELLS).sqrt().ceil() as u32).max(1);
        let has_truth = recording.files.iter().any(|files| files.truth.is_some());
        let focal_px = settings.focal_of_width * f64::from(size.width);
        let side = |pixels: usize| pixels.div_ceil(square as usize);
        let cell = |i: usize| {
            let off = |at: usize, pixels: usize| {
                let first = at * square as usize;
                let last = (first + square as usize).min(pixels);
                ((first + last) as f64 / 2.0 - pixels as f64 / 2.0) / focal_px
            };
            let (x, y) = (i % side(columns).max(1), i / side(columns).max(1));
            RegionCell {
                at: [off(x, columns), off(y, rows)],
                sum: Sum::default(),
            }
        };
        let count = if has_truth { 0 } else { side(columns) * side(rows) };
        Self {
            settings,
            size,
            lags: (columns.min(rows) / 2 + 1).min(MAX_LAGS),
            region,
            frames: 0,
            valid: 0,
            mismatches: 0,
            unit_m: settings.unit_m,
            square,
            cells: (0..count).map(cell).collect(),
            by_truth: BTreeMap::new(),
            before: [None, None],
            apart: Autocovariance::new(1),
            pairs: Vec::new(),
        }
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "values are single precision here, bins below 2⁶³"
    )]
    fn add(&mut self, image: &Image<f32>, truth: Option<&Image<f32>>) {
        self.frames += 1;
        let below = if self.settings.is_truncated {
            self.unit_m / 2.0
        } else {
            0.0
        };
        let error_domain = self.settings.error_domain;
        let depths = |image: &Image<f32>| -> Vec<f32> {
            self.region.rows_of(image.into()).flatten().copied().collect()
        };
        let seen = depths(image);
        for &z in &seen {
            let units = f64::from(z) / self.settings.unit_m;
            // Single precision has about seven digits.
            if z.is_finite() && z > 0.0 && (units - units.round()).abs() > 2e-3 + units * 3e-7 {
                self.unit_m = 0.0;
            }
        }
        let value = |z: f32, below: f64| {
            if MEASURABLE_M.contains(&z) {
                error_domain.of_depth(f64::from(z) + below)
            } else {
                f64::NAN
            }
        };
        let truths: Vec<f64> = match truth {
            Some(truth) => depths(truth).iter().map(|&z| value(z, 0.0)).collect(),
            None => vec![0.0; seen.len()],
        };
        let mut offs: Vec<f32> = seen
            .iter()
            .zip(&truths)
            .map(|(&z, &truth)| (value(z, below) - truth) as f32)
            .collect();
        self.valid += offs.iter().filter(|off| off.is_finite()).count() as u64;
        self.mismatches += drop_mismatches(&mut offs, self.settings.step);
        let shift: Vec<f32> = truths.iter().map(|&truth| truth as f32).collect();
        let differences = |(before, old_shift): &(Vec<f32>, Vec<f32>)| -> Vec<f32> {
            let half = std::f32::consts::FRAC_1_SQRT_2;
            let pairs = offs.iter().zip(before).zip(shift.iter().zip(old_shift));
            pairs
                .map(|((&new, &old), (&a, &b))| {
                    // A moving surface has another periodic error.
                    let is_same = f64::from((a - b).abs()) <= error_domain.still();
                    if is_same { (new - old) * half } else { f32::NAN }
                })
                .collect()
        };
        let width = self.region.columns.len();
        if let [Some(last), _] = &self.before {
            let mut pair = Autocovariance::new(self.lags);
            pair.add(&differences(last), width);
            if pair.values() > 0 {
                self.pairs.push(pair);
            }
        }
        if let [_, Some(older)] = &self.before {
            self.apart.add(&differences(older), width);
        }
        let columns = self.region.columns.len().max(1);
        let square = self.square as usize;
        for (i, (&off, &truth)) in offs.iter().zip(&truths).enumerate() {
            if !off.is_finite() {
                continue;
            }
            let sum = if self.cells.is_empty() {
                self.by_truth
                    .entry((truth / error_domain.bin()) as i64)
                    .or_default()
            } else {
                let at = (i / columns / square) * columns.div_ceil(square) + i % columns / square;
                match self.cells.get_mut(at) {
                    Some(cell) => &mut cell.sum,
                    None => continue,
                }
            };
            sum.truth += truth;
            sum.measured += truth + f64::from(off);
            sum.values += 1;
        }
        let [last, older] = &mut self.before;
        *older = last.replace((offs, shift));
    }

    fn observation(self, recording: &TargetRecording) -> Observation {
        let pixels = (self.region.pixels() * self.frames).max(1);
        let sums = || {
            self.cells
                .iter()
                .map(|cell| cell.sum)
                .chain(self.by_truth.values().copied())
        };
        let values = sums().map(|sum| sum.values).sum::<u64>();
        let mean = sums().map(|sum| sum.measured).sum::<f64>() / values as f64;
        let depth_m = self.settings.error_domain.depth_m(mean);
        Observation {
            name: recording.name.clone(),
            distance_m: recording.distance_m,
            size: self.size,
            frames: self.frames,
            fill_rate: self.valid as f64 / pixels as f64,
            mismatch_rate: self.mismatches as f64 / (self.valid as f64).max(1.0),
            by_truth: self.by_truth.into_values().collect(),
            cells: self.cells,
            pairs: self.pairs,
            apart: self.apart,
            square: self.square,
            depth_m,
            unit: self.settings.error_domain.of_unit(self.unit_m, depth_m),
        }
    }
}

/// Replaces mismatches, which differ from the median by several times the median deviation, by NaN, and returns their
/// number.
fn drop_mismatches(offs: &mut [f32], step: f64) -> u64 {
    let finite: Vec<f64> = offs
        .iter()
        .map(|&off| f64::from(off))
        .filter(|off| off.is_finite())
        .collect();
    let Some(middle) = median(&finite) else { return 0 };
    let deviations: Vec<f64> = finite.iter().map(|off| (off - middle).abs()).collect();
    let usual = 1.4826 * median(&deviations).unwrap_or_default();
    let limit = MISMATCH * usual.max(step);
    let mut dropped = 0;
    for off in offs {
        if (f64::from(*off) - middle).abs() > limit {
            *off = f32::NAN;
            dropped += 1;
        }
    }
    dropped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mismatches_are_dropped() {
        let mut offs: Vec<f32> = (0..100u8).map(|i| f32::from(i % 5) * 0.01).collect();
        offs[7] = 3.0;
        offs[8] = f32::NAN;
        assert_eq!(drop_mismatches(&mut offs, 0.03), 1);
        assert!(offs[7].is_nan() && offs[9].is_finite());
        assert_eq!(drop_mismatches(&mut [], 0.03), 0);
    }
}
