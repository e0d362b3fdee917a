//! The layout of a figure: headings, legend, axes, layers.

use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::{
    Cartesian2d, ChartBuilder, ChartContext, Circle, DrawingArea, DrawingBackend, IntoFont, PathElement,
    Polygon, Rectangle, Text,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, RGBColor, ShapeStyle, TextStyle, WHITE};

use super::clip::{AxisRanges, runs};
use super::{Figure, FigureError, FigureLayer, FigureShape};

const INK: RGBColor = RGBColor(30, 33, 38);
const PALE_INK: RGBColor = RGBColor(95, 100, 108);
const GRID: RGBColor = RGBColor(226, 229, 233);

/// Font sizes, px.
const TITLE: u32 = 24;
const TEXT: u32 = 17;

/// Margins of the plot, px.
const LEFT: u32 = 76;
const RIGHT: u32 = 26;
const BOTTOM: u32 = 58;
/// Space outside the labels of the axes, px.
const EDGE_SPACE: u32 = 10;

/// The legend: the height of a row, the length of a sample, the gap after it, and that between entries, px.
const ROW: u32 = 22;
const SAMPLE: u32 = 30;
const GAP: u32 = 8;
const SPACE: u32 = 24;

/// Line widths and the radius of a dot, in tenths of a pixel.
const LINE: u32 = 18;
const EDGE: u32 = 14;
const DOT: u32 = 24;

const STEP_OPACITY: f64 = 0.22;
const AREA_OPACITY: f64 = 0.30;

type Area<'a, DB> = DrawingArea<DB, Shift>;
type Chart<'a, DB> = ChartContext<'a, DB, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// Draws figures one below the other. A pixel is `scale` units of the backend. Legends leave `text_percent` of the width that
/// their text has in the program's own font.
pub(super) fn draw<DB: DrawingBackend>(
    area: &Area<'_, DB>,
    figures: &[Figure],
    scale: u32,
    text_percent: u32,
) -> Result<(), FigureError> {
    area.fill(&WHITE).map_err(failed)?;
    for (figure, area) in figures.iter().zip(area.split_evenly((figures.len().max(1), 1))) {
        let page = Page {
            area: &area,
            scale,
            text_percent,
        };
        page.draw(figure)?;
    }
    area.present().map_err(failed)
}

fn failed(error: impl std::fmt::Display) -> FigureError {
    FigureError(error.to_string())
}

struct Page<'a, DB: DrawingBackend> {
    area: &'a Area<'a, DB>,
    scale: u32,
    text_percent: u32,
}

impl<DB: DrawingBackend> Page<'_, DB> {
    fn draw(&self, figure: &Figure) -> Result<(), FigureError> {
        self.text([LEFT, 28], TITLE, INK, &figure.title)?;
        self.text([LEFT, 57], TEXT, PALE_INK, &figure.subtitle)?;
        let heading = if figure.subtitle.is_empty() { 50 } else { 74 };
        let rows = self.legend_rows(figure)?;
        for (number, row) in (0..).zip(&rows) {
            self.legend_row(row, heading + ROW * number + ROW / 2)?;
        }
        let top = heading + ROW * u32::try_from(rows.len()).unwrap_or(0) + 8;
        self.plot(figure, top)
    }

    fn units(&self, px: u32) -> i32 {
        i32::try_from(px * self.scale).unwrap_or(i32::MAX)
    }

    /// Returns a length in tenths of a pixel in the backend's units.
    fn tenths(&self, tenths: u32) -> u32 {
        (tenths * self.scale).div_ceil(10)
    }

    fn style(&self, size: u32, color: RGBColor) -> TextStyle<'static> {
        ("sans-serif", size * self.scale).into_font().color(&color)
    }

    /// Writes a line of text; `y` is the middle of its height.
    fn text(&self, [x, y]: [u32; 2], size: u32, color: RGBColor, text: &str) -> Result<(), FigureError> {
        if text.is_empty() {
            return Ok(());
        }
        let at = (self.units(x), self.units(y));
        let style = self.style(size, color).pos(Pos::new(HPos::Left, VPos::Center));
        let text = Text::new(text.replace(char::is_control, " "), at, style);
        self.area.draw(&text).map_err(failed)
    }

    fn plot(&self, figure: &Figure, top: u32) -> Result<(), FigureError> {
        let frame = AxisRanges::of(figure);
        let mut chart = ChartBuilder::on(self.area)
            .margin_top(self.units(top))
            .margin_right(self.units(RIGHT))
            .margin_bottom(self.units(EDGE_SPACE))
            .margin_left(self.units(EDGE_SPACE))
            .x_label_area_size(self.units(BOTTOM - EDGE_SPACE))
            .y_label_area_size(self.units(LEFT - EDGE_SPACE))
            .build_cartesian_2d(frame.low[0]..frame.high[0], frame.low[1]..frame.high[1])
            .map_err(failed)?;
        chart
            .configure_mesh()
            .x_labels(12)
            .y_labels(8)
            .x_label_formatter(&|value| label(*value))
            .y_label_formatter(&|value| label(*value))
            .x_desc(figure.x.label.replace(char::is_control, " "))
            .y_desc(figure.y.label.replace(char::is_control, " "))
            .label_style(self.style(TEXT, INK))
            .axis_desc_style(self.style(TEXT, INK))
            .bold_line_style(GRID.stroke_width(self.tenths(10)))
            .max_light_lines(1)
            .light_line_style(WHITE.mix(0.0))
            .axis_style(INK.stroke_width(self.tenths(12)))
            .set_all_tick_mark_size(self.units(4))
            .draw()
            .map_err(failed)?;
        for layer in &figure.layers {
            self.layer(&mut chart, frame, layer)?;
        }
        Ok(())
    }

    fn layer(
        &self,
        chart: &mut Chart<'_, DB>,
        frame: AxisRanges,
        layer: &FigureLayer,
    ) -> Result<(), FigureError> {
        let color = color(layer);
        match &layer.shape {
            FigureShape::Steps(steps) => {
                for &[from, to, low, high] in steps {
                    let corners = vec![[from, low], [from, high], [to, high], [to, low]];
                    fill(chart, frame, corners, color.mix(STEP_OPACITY))?;
                    // An edge at 0 coincides with the axis.
                    for edge in [low, high].into_iter().filter(|edge| *edge != 0.0) {
                        let style = color.stroke_width(self.tenths(EDGE));
                        stroke(chart, frame, &[[from, edge], [to, edge]], style)?;
                    }
                }
            }
            FigureShape::Area(points) => {
                for run in runs(points) {
                    let there = run.iter().map(|&[x, _, high]| [x, high]);
                    let back = run.iter().rev().map(|&[x, low, _]| [x, low]);
                    fill(chart, frame, there.chain(back).collect(), color.mix(AREA_OPACITY))?;
                }
            }
            FigureShape::Line(points) => {
                for run in runs(points) {
                    stroke(chart, frame, run, color.stroke_width(self.tenths(LINE)))?;
                }
            }
            FigureShape::Dots(points) => {
                let dots = points.iter().filter(|point| frame.contains(**point));
                let radius = self.tenths(DOT);
                let dots = dots.map(|&[x, y]| Circle::new((x, y), radius, color.filled()));
                chart.draw_series(dots).map_err(failed)?;
            }
        }
        Ok(())
    }

    /// Returns the entries of the legend, in rows that fit the width.
    fn legend_rows<'f>(&self, figure: &'f Figure) -> Result<Vec<Vec<(&'f FigureLayer, u32)>>, FigureError> {
        let (width, _) = self.area.dim_in_pixel();
        let available = width / self.scale - LEFT;
        let mut rows: Vec<Vec<(&FigureLayer, u32)>> = Vec::new();
        let mut used = 0;
        for layer in figure.layers.iter().filter(|layer| !layer.label.is_empty()) {
            let style = self.style(TEXT, INK);
            let (length, _) = self
                .area
                .estimate_text_size(&layer.label, &style)
                .map_err(failed)?;
            let length = (length * self.text_percent).div_ceil(100 * self.scale);
            let length = SAMPLE + GAP + length + SPACE;
            match rows.last_mut() {
                Some(row) if used + length <= available => row.push((layer, used)),
                _ => {
                    used = 0;
                    rows.push(vec![(layer, 0)]);
                }
            }
            used += length;
        }
        Ok(rows)
    }

    fn legend_row(&self, row: &[(&FigureLayer, u32)], y: u32) -> Result<(), FigureError> {
        for (layer, offset) in row {
            let x = LEFT + offset;
            self.sample(layer, [x, y])?;
            self.text([x + SAMPLE + GAP, y], TEXT, INK, &layer.label)?;
        }
        Ok(())
    }

    /// Draws a sample of a layer's style, 30 px long.
    fn sample(&self, layer: &FigureLayer, [x, y]: [u32; 2]) -> Result<(), FigureError> {
        let color = color(layer);
        let at = |dx: u32, dy: i32| (self.units(x + dx), self.units(y) + dy * self.units(1));
        let bar = |opacity: f64| Rectangle::new([at(0, -6), at(SAMPLE, 6)], color.mix(opacity).filled());
        let line = |dy: i32, width: u32| {
            PathElement::new(
                [at(0, dy), at(SAMPLE, dy)],
                color.stroke_width(self.tenths(width)),
            )
        };
        match layer.shape {
            FigureShape::Steps(_) => {
                self.area.draw(&bar(STEP_OPACITY)).map_err(failed)?;
                self.area.draw(&line(-6, EDGE)).map_err(failed)
            }
            FigureShape::Area(_) => self.area.draw(&bar(AREA_OPACITY)).map_err(failed),
            FigureShape::Line(_) => self.area.draw(&line(0, LINE)).map_err(failed),
            FigureShape::Dots(_) => [5, 15, 25].into_iter().try_for_each(|dx| {
                let dot = Circle::new(at(dx, 0), self.tenths(DOT), color.filled());
                self.area.draw(&dot).map_err(failed)
            }),
        }
    }
}

fn color(layer: &FigureLayer) -> RGBColor {
    let [r, g, b] = layer.color;
    RGBColor(r, g, b)
}

fn fill<DB: DrawingBackend>(
    chart: &mut Chart<'_, DB>,
    frame: AxisRanges,
    corners: Vec<[f64; 2]>,
    color: plotters::style::RGBAColor,
) -> Result<(), FigureError> {
    if corners.iter().flatten().any(|c| !c.is_finite()) {
        return Ok(());
    }
    let corners: Vec<(f64, f64)> = frame.polygon(corners).into_iter().map(Into::into).collect();
    if corners.is_empty() {
        return Ok(());
    }
    let polygon = Polygon::new(corners, color.filled());
    chart.draw_series([polygon]).map_err(failed).map(|_| ())
}

fn stroke<DB: DrawingBackend>(
    chart: &mut Chart<'_, DB>,
    frame: AxisRanges,
    points: &[[f64; 2]],
    style: ShapeStyle,
) -> Result<(), FigureError> {
    let pieces = frame.line(points).into_iter().map(|piece| {
        let piece: Vec<(f64, f64)> = piece.into_iter().map(Into::into).collect();
        PathElement::new(piece, style)
    });
    chart.draw_series(pieces).map_err(failed).map(|_| ())
}

/// Returns a tick's number without trailing zeros.
fn label(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}
