//! Clipping of curves and areas to the ranges of the axes, since the plotting library does not clip.

use super::Figure;

type Point = [f64; 2];

/// The ranges of a figure's axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxisRanges {
    pub(super) low: Point,
    pub(super) high: Point,
}

impl AxisRanges {
    /// Returns the ranges of a figure; one that is empty or not finite gets a length of 1.
    pub(super) fn of(figure: &Figure) -> Self {
        let [x, y] = [&figure.x, &figure.y].map(|axis| {
            let [low, high] = axis.range;
            match (low.is_finite(), high - low) {
                (true, length) if length.is_finite() && length > 0.0 => [low, high],
                (true, _) => [low, low + 1.0],
                (false, _) => [0.0, 1.0],
            }
        });
        Self {
            low: [x[0], y[0]],
            high: [x[1], y[1]],
        }
    }

    pub(super) fn contains(&self, point: Point) -> bool {
        (0..2).all(|i| self.low[i] <= point[i] && point[i] <= self.high[i])
    }

    /// Returns the pieces of a line inside the ranges.
    pub(super) fn line(&self, points: &[Point]) -> Vec<Vec<Point>> {
        let mut pieces: Vec<Vec<Point>> = Vec::new();
        for ends in points.windows(2) {
            let Some([from, to]) = self.segment(ends[0], ends[1]) else {
                continue;
            };
            match pieces.last_mut() {
                Some(piece) if piece.last() == Some(&from) => piece.push(to),
                _ => pieces.push(vec![from, to]),
            }
        }
        pieces
    }

    /// Clips a segment after Liang and Barsky.
    fn segment(&self, a: Point, b: Point) -> Option<[Point; 2]> {
        let (mut start, mut end) = (0.0f64, 1.0f64);
        for i in 0..2 {
            let step = b[i] - a[i];
            if step == 0.0 {
                if a[i] < self.low[i] || a[i] > self.high[i] {
                    return None;
                }
                continue;
            }
            let ends = [(self.low[i] - a[i]) / step, (self.high[i] - a[i]) / step];
            start = start.max(ends[0].min(ends[1]));
            end = end.min(ends[0].max(ends[1]));
        }
        let at = |t: f64| {
            if t == 1.0 {
                b
            } else {
                [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
            }
        };
        (start <= end).then(|| [at(start), at(end)])
    }

    /// Clips a polygon after Sutherland and Hodgman.
    pub(super) fn polygon(&self, corners: Vec<Point>) -> Vec<Point> {
        let edges = [
            (0, self.low[0], 1.0),
            (0, self.high[0], -1.0),
            (1, self.low[1], 1.0),
            (1, self.high[1], -1.0),
        ];
        edges.into_iter().fold(corners, |corners, (axis, limit, sign)| {
            let inside = |point: &Point| sign * (point[axis] - limit) >= 0.0;
            let mut clipped = Vec::with_capacity(corners.len() + 4);
            for (i, point) in corners.iter().enumerate() {
                let before = &corners[(i + corners.len() - 1) % corners.len()];
                if inside(before) != inside(point) {
                    let t = (limit - before[axis]) / (point[axis] - before[axis]);
                    let mut crossing = [0, 1].map(|i| before[i] + t * (point[i] - before[i]));
                    crossing[axis] = limit;
                    clipped.push(crossing);
                }
                if inside(point) {
                    clipped.push(*point);
                }
            }
            clipped
        })
    }
}

/// Returns the longest runs of finite points.
pub(super) fn runs<const N: usize>(points: &[[f64; N]]) -> impl Iterator<Item = &[[f64; N]]> {
    points
        .split(|point| point.iter().any(|c| !c.is_finite()))
        .filter(|run| !run.is_empty())
}
