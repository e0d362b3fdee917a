//! How well points of the left image match the rows of the right one.

use super::difference::AREA;
use super::{COMPACT, MATCHED, NEAR, NOISE, PairInspection, UNIQUE};

/// The difference of each point to its best match in each row near it.
pub(super) struct Profiles {
    /// The number of rows above and below the points' own rows.
    most: usize,
    /// For each point, the differences in grey levels from the row `most` above it to the row `most` below.
    rows: Vec<Vec<f64>>,
    /// The difference below which each point has a match, in grey levels.
    limits: Vec<f64>,
}

impl Profiles {
    /// Compares points with their rows and `most` above and below, to the left, or to the right if the images are swapped.
    pub(super) fn new(
        inspection: &PairInspection<'_>,
        points: &[[usize; 2]],
        is_swapped: bool,
        most: usize,
    ) -> Self {
        let profile = |&[x, y]: &[usize; 2]| {
            let rows = y - most..=y + most;
            rows.map(|there| f64::from(inspection.least([x, y], there, is_swapped)) / AREA)
                .collect()
        };
        Self {
            most,
            rows: points.iter().map(profile).collect(),
            limits: points
                .iter()
                .map(|&point| NOISE.max(MATCHED * inspection.contrast(point)))
                .collect(),
        }
    }

    /// Returns the difference of a point to its best match `rows` rows below it.
    pub(super) fn difference(&self, point: usize, rows: isize) -> f64 {
        let there = self.most.checked_add_signed(rows);
        let found = self
            .rows
            .get(point)
            .zip(there)
            .and_then(|(profile, there)| profile.get(there));
        found.copied().unwrap_or(f64::MAX)
    }

    /// Returns the share of points with a match in their own row.
    pub(super) fn matched_in_row(&self) -> f64 {
        let matched = (0..self.rows.len())
            .zip(&self.limits)
            .filter(|(point, limit)| self.difference(*point, 0) < **limit);
        matched.count() as f64 / self.rows.len().max(1) as f64
    }

    /// Returns the least mean difference over all vertical offsets, and its offset; of equal ones, the smallest.
    pub(super) fn least(&self) -> (f64, isize) {
        let mean = |rows| {
            let all = (0..self.rows.len()).map(|point| self.difference(point, rows));
            all.sum::<f64>() / self.rows.len().max(1) as f64
        };
        let most = self.most.cast_signed();
        let mut best = (mean(0), 0);
        for rows in (1..=most).flat_map(|rows| [-rows, rows]) {
            let found = mean(rows);
            if found < best.0 {
                best = (found, rows);
            }
        }
        best
    }

    /// Returns the points with a unique match and its vertical offset, without those far from the median offset.
    pub(super) fn offsets(&self) -> Vec<(usize, isize)> {
        let mut found: Vec<(usize, isize)> = self
            .rows
            .iter()
            .zip(&self.limits)
            .enumerate()
            .filter_map(|(point, (profile, limit))| Some((point, self.unique(profile, *limit)?)))
            .collect();
        found.sort_unstable_by_key(|(_, rows)| *rows);
        let Some(&(_, median)) = found.get(found.len() / 2) else {
            return found;
        };
        found.retain(|(_, rows)| (rows - median).abs() <= COMPACT);
        found
    }

    /// Returns the offset of the best row of a profile, if it is a match and the rows away from it are not.
    fn unique(&self, profile: &[f64], limit: f64) -> Option<isize> {
        let (best, least) = profile.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
        let elsewhere = profile
            .iter()
            .enumerate()
            .filter(|(row, _)| row.abs_diff(best) > NEAR);
        let is_unique = elsewhere.fold(f64::MAX, |least, (_, found)| least.min(*found)) * UNIQUE > *least;
        (*least < limit && is_unique).then_some(best.cast_signed() - self.most.cast_signed())
    }
}
