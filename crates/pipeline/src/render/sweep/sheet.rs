//! The sheet of a sweep.

use super::thumbnail::{Thumbnail, averaged};
use super::{Sweep, SweepAxis};
use oaktwin_image::Image;
use oaktwin_image::annotation::Frame;
use oaktwin_image::contact_sheet::{GAP, INK, PAPER, paste};
use oaktwin_image::preview::{self, Marks};
use oaktwin_image::text::{self, TextStyle};

/// The maximum width of a row and of a cell, px.
const ROW: u32 = 1640;
const WIDEST: u32 = 640;
/// The height of capitals, px.
const TITLE: u32 = 14;
/// The distance from the top of a label to its image, px.
const LINE: u32 = TITLE + 10;

/// The reduction factor of images of this width.
pub(super) fn factor(sweep: &Sweep, width: u32) -> u32 {
    let columns = u32::try_from(sweep.columns.values.len()).unwrap_or(1);
    let in_a_row = match sweep.rows {
        Some(_) => columns + 1,
        None => columns.max(2),
    };
    width.div_ceil((ROW / in_a_row).clamp(1, WIDEST)).max(1)
}

/// The cells of a sweep, row by row, with the colour image and the ground truth: above the single row of one parameter, beside the
/// table of two. All share one depth scale.
pub(super) fn sheet(sweep: &Sweep, frame: &Frame, factor: u32, cells: &[Thumbnail]) -> Image<[u8; 3]> {
    let truth = frame.distance_to_image_plane.as_ref();
    let truth = truth.map(|depth| Thumbnail::new(depth, factor));
    let range = cells
        .iter()
        .filter_map(Thumbnail::range)
        .reduce(|(near, far), (n, f)| (near.min(n), far.max(f)))
        .or_else(|| truth.as_ref()?.range())
        .unwrap_or((1.0, 2.0));
    let mut marks = Marks::default();
    let mut paint = |thumbnail: &Thumbnail| {
        let (picture, more) = thumbnail.paint(range);
        marks |= more;
        picture
    };
    let rgb = frame.rgb.as_ref().map(|rgb| ("rgb", averaged(rgb, factor)));
    let truth = truth.map(|truth| ("ground truth", paint(&truth)));
    let references: Vec<(&str, Image<[u8; 3]>)> = rgb.into_iter().chain(truth).collect();
    let pictures: Vec<Image<[u8; 3]>> = cells.iter().map(&mut paint).collect();

    let columns = sweep.columns.values.len().max(1);
    let layout = Layout::new(
        sweep,
        references.len(),
        pictures.first().or(references.first().map(|(_, p)| p)),
    );
    let (width, height) = layout.size;
    let legend = preview::legend(width - 2 * GAP, range, marks);
    let mut sheet = Image::filled(width, height + legend.height() + GAP, PAPER);
    for (at, (title, picture)) in references.iter().enumerate() {
        let (left, top) = layout.reference(at);
        paste(&mut sheet, picture, left, top);
        write(&mut sheet, title, (left, top - LINE), layout.cell.0);
    }
    for (column, value) in sweep.columns.values.iter().enumerate() {
        let (left, top) = layout.cell(0, column);
        write(
            &mut sheet,
            &label(&sweep.columns, value),
            (left, top - LINE),
            layout.cell.0,
        );
    }
    for (row, value) in sweep.rows.iter().flat_map(|rows| rows.values.iter().enumerate()) {
        let (left, top) = layout.cell(row, 0);
        let rows = sweep
            .rows
            .as_ref()
            .map(|rows| label(rows, value))
            .unwrap_or_default();
        write_upwards(&mut sheet, &rows, (left - LINE, top), layout.cell.1);
    }
    for (at, (picture, thumbnail)) in pictures.iter().zip(cells).enumerate() {
        let (left, top) = layout.cell(at / columns, at % columns);
        paste(&mut sheet, picture, left, top);
        let percent = thumbnail.measured * 100.0;
        let digits = usize::from(percent < 10.0);
        let share = format!("{percent:.digits$} % measured");
        write(&mut sheet, &share, (left, top + layout.cell.1 + 6), layout.cell.0);
    }
    paste(&mut sheet, &legend, GAP, height);
    sheet
}

fn label(axis: &SweepAxis, value: &str) -> String {
    format!("{} = {value}", axis.name)
}

/// The layout, px.
struct Layout {
    /// The size of a cell.
    cell: (u32, u32),
    size: (u32, u32),
    /// The position of the first cell.
    first: (u32, u32),
    /// Whether the references are stacked.
    is_table: bool,
}

impl Layout {
    fn new(sweep: &Sweep, references: usize, picture: Option<&Image<[u8; 3]>>) -> Self {
        let count = |values: usize| u32::try_from(values).unwrap_or(0);
        let cell = picture.map_or((1, 1), |picture| (picture.width(), picture.height()));
        let (across, down) = (cell.0 + GAP, cell.1 + LINE + GAP);
        let top = GAP + LINE;
        let columns = count(sweep.columns.values.len());
        let references = count(references);
        let (first, columns, rows) = match &sweep.rows {
            Some(rows) => {
                let beside = references.min(1);
                let left = GAP + beside * (across + 2 * GAP) + LINE;
                ((left, top), columns, count(rows.values.len()).max(references))
            }
            None => {
                let above = references.min(1);
                ((GAP, top + above * down), columns.max(references), 1)
            }
        };
        Self {
            cell,
            size: (first.0 + columns * across, first.1 + rows * down),
            first,
            is_table: sweep.rows.is_some(),
        }
    }

    fn cell(&self, row: usize, column: usize) -> (u32, u32) {
        self.at(self.first, row, column)
    }

    fn reference(&self, at: usize) -> (u32, u32) {
        let (row, column) = if self.is_table { (at, 0) } else { (0, at) };
        self.at((GAP, GAP + LINE), row, column)
    }

    fn at(&self, (left, top): (u32, u32), row: usize, column: usize) -> (u32, u32) {
        let steps = |count: usize, step: u32| u32::try_from(count).unwrap_or(0) * step;
        (
            left + steps(column, self.cell.0 + GAP),
            top + steps(row, self.cell.1 + LINE + GAP),
        )
    }
}

/// The height of capitals that fits a line into `length`.
fn fitting(line: &str, length: u32) -> f32 {
    let full = TITLE as f32;
    full.min(full * length as f32 / text::width(line, full).max(1.0))
}

fn write(sheet: &mut Image<[u8; 3]>, line: &str, (left, top): (u32, u32), length: u32) {
    let style = TextStyle {
        height: fitting(line, length),
        color: INK,
    };
    text::draw(sheet, line, (left as f32, top as f32), style);
}

/// Draws a line upwards, centred in `length` rows from `top`.
fn write_upwards(sheet: &mut Image<[u8; 3]>, line: &str, (left, top): (u32, u32), length: u32) {
    let mut lying = Image::filled(length, LINE, PAPER);
    let height = fitting(line, length.saturating_sub(GAP));
    let start = (length as f32 - text::width(line, height)) / 2.0;
    text::draw(&mut lying, line, (start, 0.0), TextStyle { height, color: INK });
    let mut standing = Image::filled(LINE, length, PAPER);
    for (at, pixel) in standing.pixels_mut().iter_mut().enumerate() {
        let at = u32::try_from(at).unwrap_or(0);
        let (x, y) = (at % LINE, at / LINE);
        *pixel = lying.get(length - 1 - y, x).copied().unwrap_or(PAPER);
    }
    paste(sheet, &standing, left, top);
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_image::ZDepth;

    fn frame(width: u32, height: u32) -> Frame {
        Frame {
            rgb: Some(Image::filled(width, height, [200, 100, 50, 255])),
            distance_to_image_plane: Some(ZDepth(Image::filled(width, height, 9.0))),
            ..Frame::default()
        }
    }

    fn sweep(axes: &[&str]) -> Sweep {
        Sweep::new(axes.iter().map(|axis| axis.parse().unwrap()).collect()).unwrap()
    }

    fn cells(count: usize, width: u32, height: u32) -> Vec<Thumbnail> {
        let depth = |at| ZDepth(Image::filled(width, height, at as f32));
        (1..=count).map(|at| Thumbnail::new(&depth(at), 1)).collect()
    }

    #[test]
    fn draws_a_cell_for_each_value() {
        let picture = sheet(
            &sweep(&["maxDistance=1,2,3", "b=1,2"]),
            &frame(40, 20),
            1,
            &cells(6, 40, 20),
        );
        let left = GAP + 40 + GAP + 2 * GAP + LINE;
        let color = |metres: f32| {
            preview::colors(&Image::filled(1, 1, metres), (1.0, 6.0))
                .0
                .pixels()[0]
        };
        for (row, column, metres) in [(0, 0, 1.0), (0, 2, 3.0), (1, 0, 4.0), (1, 2, 6.0)] {
            let x = left + column * (40 + GAP);
            let y = GAP + LINE + row * (20 + LINE + GAP);
            for (x, y) in [(x, y), (x + 39, y + 19)] {
                assert_eq!(picture.get(x, y), Some(&color(metres)), "{row} {column}");
            }
        }
        assert_eq!(picture.get(GAP, GAP + LINE), Some(&[200, 100, 50]));
        // The depth is beyond the scale and has the colour of its end.
        assert_eq!(picture.get(GAP, GAP + 2 * LINE + 20 + GAP), Some(&color(6.0)));
        assert_eq!(picture.width(), left + 3 * (40 + GAP));
    }

    #[test]
    fn one_parameter_makes_a_row() {
        let picture = sheet(&sweep(&["maxDistance=1"]), &frame(40, 20), 1, &cells(1, 40, 20));
        assert_eq!(picture.width(), GAP + 2 * (40 + GAP));
        assert_eq!(picture.get(GAP, GAP + LINE), Some(&[200, 100, 50]));
        let cell = preview::colors(&Image::filled(1, 1, 1.0), (1.0, 2.0)).0.pixels()[0];
        assert_eq!(picture.get(GAP, GAP + LINE + 20 + LINE + GAP), Some(&cell));
    }

    #[test]
    fn draws_empty_images() {
        for (width, height) in [(1, 1), (3, 200), (200, 1)] {
            let empty = Thumbnail::new(&ZDepth(Image::filled(width, height, 0.0)), 1);
            let picture = sheet(&sweep(&["a=1", "b=2"]), &Frame::default(), 1, &[empty]);
            assert!(picture.width() > width && picture.height() > height);
        }
    }
}
