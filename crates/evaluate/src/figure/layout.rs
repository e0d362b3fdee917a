//! From what a figure shows to marks on paper.

use oaktwin_image::text;

use super::axis::{label, ticks};
use super::{Figure, Layer, Shape};

/// The paper, px.
pub(super) const WIDTH: f32 = 960.0;
pub(super) const HEIGHT: f32 = 560.0;

/// Heights of capital letters, px.
const TITLE: f32 = 14.0;
const TEXT: f32 = 10.0;

const INK: [u8; 3] = [30, 33, 38];
const PALE_INK: [u8; 3] = [95, 100, 108];
const GRID: [u8; 3] = [226, 229, 233];

/// Everything that is drawn, from the back to the front; px from the upper left corner.
#[derive(Debug)]
pub(super) struct Marks {
    /// What shapes are cut to: left, top, right, bottom.
    pub(super) frame: [f32; 4],
    pub(super) marks: Vec<Mark>,
}

#[derive(Debug)]
pub(super) enum Mark {
    Area {
        corners: Vec<[f32; 2]>,
        color: [u8; 3],
        opacity: f32,
        is_cut: bool,
    },
    Line {
        points: Vec<[f32; 2]>,
        color: [u8; 3],
        width: f32,
        is_cut: bool,
    },
    Text {
        /// Where the left end, middle or right end of the baseline is.
        at: [f32; 2],
        /// Of a capital, px.
        height: f32,
        color: [u8; 3],
        anchor: Anchor,
        /// Reads upwards.
        is_turned: bool,
        text: String,
    },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Left,
    Middle,
    Right,
}

pub(super) fn marks(figure: &Figure) -> Marks {
    let named: Vec<&Layer> = figure
        .layers
        .iter()
        .filter(|layer| !layer.label.is_empty())
        .collect();
    let legend = rows_of_legend(&named);
    let heading = if figure.subtitle.is_empty() { 50.0 } else { 72.0 };
    let top = heading + LEGEND_ROW * legend.len() as f32 + 8.0;
    let frame = [78.0, top, WIDTH - 26.0, HEIGHT - 62.0];
    let mut page = Page {
        figure,
        marks: Marks {
            frame,
            marks: Vec::new(),
        },
    };
    page.text([frame[0], 36.0], TITLE, INK, Anchor::Left, &figure.title);
    page.text([frame[0], 60.0], TEXT, PALE_INK, Anchor::Left, &figure.subtitle);
    page.axes();
    for layer in &figure.layers {
        page.layer(layer);
    }
    page.frame();
    page.legend(&legend);
    page.marks
}

struct Page<'a> {
    figure: &'a Figure,
    marks: Marks,
}

const LEGEND_ROW: f32 = 22.0;
/// Of a sample in the legend, px.
const SAMPLE: f32 = 30.0;
/// Between a sample and its label, and between labels.
const SPACE: [f32; 2] = [8.0, 26.0];

/// Which layers stand side by side.
fn rows_of_legend<'a>(named: &[&'a Layer]) -> Vec<Vec<&'a Layer>> {
    let mut rows: Vec<Vec<&Layer>> = Vec::new();
    let mut right = 0.0;
    for layer in named {
        let width = SAMPLE + SPACE[0] + text::width(&layer.label, TEXT) + SPACE[1];
        match rows.last_mut() {
            Some(row) if right + width <= WIDTH - 78.0 => row.push(layer),
            _ => {
                rows.push(vec![layer]);
                right = 0.0;
            }
        }
        right += width;
    }
    rows
}

#[expect(clippy::cast_possible_truncation, reason = "places on paper")]
impl Page<'_> {
    fn x(&self, value: f64) -> f32 {
        let [low, high] = self.figure.x.range;
        let [left, _, right, _] = self.marks.frame;
        left + (right - left) * limited((value - low) / (high - low)) as f32
    }

    fn y(&self, value: f64) -> f32 {
        let [low, high] = self.figure.y.range;
        let [_, top, _, bottom] = self.marks.frame;
        bottom - (bottom - top) * limited((value - low) / (high - low)) as f32
    }

    fn push(&mut self, mark: Mark) {
        self.marks.marks.push(mark);
    }

    fn line(&mut self, points: Vec<[f32; 2]>, color: [u8; 3], width: f32, is_cut: bool) {
        self.push(Mark::Line {
            points,
            color,
            width,
            is_cut,
        });
    }

    fn text(&mut self, at: [f32; 2], height: f32, color: [u8; 3], anchor: Anchor, text: &str) {
        if text.is_empty() {
            return;
        }
        self.push(Mark::Text {
            at,
            height,
            color,
            anchor,
            is_turned: false,
            text: text.to_owned(),
        });
    }

    fn axes(&mut self) {
        let [left, top, right, bottom] = self.marks.frame;
        for tick in ticks(self.figure.x.range, 12) {
            let x = self.x(tick);
            self.line(vec![[x, top], [x, bottom]], GRID, 1.0, true);
            self.text([x, bottom + 20.0], TEXT, INK, Anchor::Middle, &label(tick));
        }
        for tick in ticks(self.figure.y.range, 8) {
            let y = self.y(tick);
            self.line(vec![[left, y], [right, y]], GRID, 1.0, true);
            self.text(
                [left - 10.0, y + TEXT / 2.0],
                TEXT,
                INK,
                Anchor::Right,
                &label(tick),
            );
        }
        let (x_label, y_label) = (self.figure.x.label.clone(), self.figure.y.label.clone());
        let middle = [f32::midpoint(left, right), f32::midpoint(top, bottom)];
        self.text([middle[0], bottom + 44.0], TEXT, INK, Anchor::Middle, &x_label);
        self.push(Mark::Text {
            at: [left - 50.0, middle[1]],
            height: TEXT,
            color: INK,
            anchor: Anchor::Middle,
            is_turned: true,
            text: y_label,
        });
    }

    fn frame(&mut self) {
        let [left, top, right, bottom] = self.marks.frame;
        self.line(
            vec![[left, top], [left, bottom], [right, bottom]],
            INK,
            1.2,
            false,
        );
    }

    fn layer(&mut self, layer: &Layer) {
        let color = layer.color;
        match &layer.shape {
            Shape::Steps(steps) => {
                for &[from, to, bottom, top] in steps {
                    let (from, to) = (self.x(from), self.x(to));
                    let (low, high) = (self.y(bottom), self.y(top));
                    let corners = vec![[from, low], [from, high], [to, high], [to, low]];
                    self.area(corners, color, STEP);
                    for (edge, value) in [(low, bottom), (high, top)] {
                        // An edge on the axis is the axis.
                        if value != 0.0 {
                            self.line(vec![[from, edge], [to, edge]], color, 1.4, true);
                        }
                    }
                }
            }
            Shape::Area(points) => {
                for run in runs(points) {
                    let there = run.iter().map(|&[x, _, high]| [self.x(x), self.y(high)]);
                    let back = run.iter().rev().map(|&[x, low, _]| [self.x(x), self.y(low)]);
                    let corners = there.chain(back).collect();
                    self.area(corners, color, SPREAD);
                }
            }
            Shape::Line(points) => {
                for run in runs(points) {
                    let run = run.iter().map(|&[x, y]| [self.x(x), self.y(y)]).collect();
                    self.line(run, color, 1.8, true);
                }
            }
            Shape::Dashes(points) => {
                for run in runs(points) {
                    let run: Vec<[f32; 2]> = run.iter().map(|&[x, y]| [self.x(x), self.y(y)]).collect();
                    for dash in dashes(&run) {
                        self.line(dash, color, 1.4, true);
                    }
                }
            }
            Shape::Dots(points) => {
                for &[x, y] in points.iter().filter(|point| point.iter().all(|c| c.is_finite())) {
                    let at = [self.x(x), self.y(y)];
                    // A line without length is a dot.
                    self.line(vec![at, at], color, DOT, true);
                }
            }
        }
    }

    fn area(&mut self, corners: Vec<[f32; 2]>, color: [u8; 3], opacity: f32) {
        self.push(Mark::Area {
            corners,
            color,
            opacity,
            is_cut: true,
        });
    }

    fn legend(&mut self, rows: &[Vec<&Layer>]) {
        let [left, top, ..] = self.marks.frame;
        let mut y = top - LEGEND_ROW * rows.len() as f32 - 2.0;
        for row in rows {
            let mut x = left;
            for layer in row {
                self.sample(layer, [x, y]);
                self.text(
                    [x + SAMPLE + SPACE[0], y + TEXT / 2.0],
                    TEXT,
                    INK,
                    Anchor::Left,
                    &layer.label,
                );
                x += SAMPLE + SPACE[0] + text::width(&layer.label, TEXT) + SPACE[1];
            }
            y += LEGEND_ROW;
        }
    }

    fn sample(&mut self, layer: &Layer, [x, y]: [f32; 2]) {
        let (color, ends) = (layer.color, vec![[x, y], [x + SAMPLE, y]]);
        let box_of = |half: f32| {
            [[0.0, -half], [SAMPLE, -half], [SAMPLE, half], [0.0, half]]
                .map(|[dx, dy]| [x + dx, y + dy])
                .to_vec()
        };
        match layer.shape {
            Shape::Steps(_) | Shape::Area(_) => {
                let opacity = if matches!(layer.shape, Shape::Steps(_)) {
                    STEP
                } else {
                    SPREAD
                };
                self.push(Mark::Area {
                    corners: box_of(6.0),
                    color,
                    opacity,
                    is_cut: false,
                });
                if matches!(layer.shape, Shape::Steps(_)) {
                    self.line(vec![[x, y - 6.0], [x + SAMPLE, y - 6.0]], color, 1.4, false);
                }
            }
            Shape::Line(_) => self.line(ends, color, 1.8, false),
            Shape::Dashes(_) => {
                for dash in dashes(&ends) {
                    self.line(dash, color, 1.4, false);
                }
            }
            Shape::Dots(_) => {
                for part in [0.15, 0.5, 0.85] {
                    let at = [x + SAMPLE * part, y];
                    self.line(vec![at, at], color, DOT, false);
                }
            }
        }
    }
}

const STEP: f32 = 0.22;
const SPREAD: f32 = 0.30;
const DOT: f32 = 4.4;

/// Far outside is as good as farther; an axis without length has one place.
fn limited(part: f64) -> f64 {
    if part.is_nan() {
        0.0
    } else {
        part.clamp(-50.0, 50.0)
    }
}

/// The longest runs of points that are finite.
fn runs<const N: usize>(points: &[[f64; N]]) -> impl Iterator<Item = &[[f64; N]]> {
    points
        .split(|point| point.iter().any(|c| !c.is_finite()))
        .filter(|run| !run.is_empty())
}

/// Px of ink and of paper.
const DASH: [f32; 2] = [6.0, 4.0];

/// The inked pieces of a line.
fn dashes(points: &[[f32; 2]]) -> Vec<Vec<[f32; 2]>> {
    let mut pieces: Vec<Vec<[f32; 2]>> = Vec::new();
    let (mut left, mut is_ink) = (0.0f32, false);
    for ends in points.windows(2) {
        let [[ax, ay], [bx, by]] = [ends[0], ends[1]];
        let length = (bx - ax).hypot(by - ay);
        let at = |along: f32| {
            [
                ax + (bx - ax) * (along / length),
                ay + (by - ay) * (along / length),
            ]
        };
        let mut along = 0.0;
        while along < length {
            if left <= 0.0 {
                is_ink = !is_ink;
                left = DASH[usize::from(!is_ink)];
                if is_ink {
                    pieces.push(vec![at(along)]);
                }
            }
            let step = left.min(length - along);
            along += step;
            left -= step;
            // A step that rounding swallows ends the dash.
            if step <= 1e-3 {
                (along, left) = (along + 1e-2, 0.0);
            }
            if let (true, Some(piece)) = (is_ink, pieces.last_mut()) {
                piece.push(at(along.min(length)));
            }
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_cover_their_share() {
        let points = [[0.0, 0.0], [30.0, 0.0], [30.0, 70.0]];
        let length = |piece: &Vec<[f32; 2]>| -> f32 {
            let steps = piece
                .windows(2)
                .map(|e| (e[1][0] - e[0][0]).hypot(e[1][1] - e[0][1]));
            steps.sum()
        };
        let pieces = dashes(&points);
        assert_eq!(pieces.len(), 10);
        let ink: f32 = pieces.iter().map(length).sum();
        assert!((ink - 60.0).abs() < 0.5, "{ink}");
        assert!(dashes(&[[1.0, 1.0], [1.0, 1.0]]).is_empty());
    }

    #[test]
    fn gaps_end_runs() {
        let points = [[0.0, 1.0], [1.0, f64::NAN], [2.0, 1.0], [3.0, 1.0]];
        let lengths: Vec<usize> = runs(&points).map(<[_]>::len).collect();
        assert_eq!(lengths, [1, 2]);
    }
}
