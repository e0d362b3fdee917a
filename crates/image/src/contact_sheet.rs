//! Contact sheets: a column of colour, depth and measured depth for each camera, or panels with titles.

use crate::preview::{self, Marks};
use crate::text::{self, TextStyle};
use crate::{Image, ZDepth};

/// The images of a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The title above the images.
    pub title: String,
    /// The colour image: sRGB and coverage.
    pub rgb: Image<[u8; 4]>,
    /// Ground-truth depth of the same size.
    pub depth: ZDepth,
    /// Measured depth of the same size.
    pub measured: ZDepth,
}

/// The background of a sheet, sRGB.
pub const PAPER: [u8; 3] = [24, 24, 24];
/// The colour of text on a sheet, sRGB.
pub const INK: [u8; 3] = [235, 235, 235];
/// The gap around images, px.
pub const GAP: u32 = 8;
/// The height of titles, px.
const TITLE: u32 = 14;

/// Draws all columns at half size, with a common depth range (minimum and maximum, metres).
#[must_use]
pub fn contact_sheet(columns: &[Column], range_m: (f32, f32)) -> Image<[u8; 3]> {
    let options = preview::PreviewOptions { range: Some(range_m) };
    let cells: Vec<[Image<[u8; 3]>; 3]> = columns
        .iter()
        .map(|column| {
            let [depth, measured] =
                [&column.depth, &column.measured].map(|depth| halved(depth).preview(&options));
            [averaged(&column.rgb), depth, measured]
        })
        .collect();
    let widest = |cell: &[Image<[u8; 3]>; 3]| cell.iter().map(Image::width).max().unwrap_or(0);
    let tallest = |row: usize| {
        let heights = cells.iter().filter_map(|cell| Some(cell.get(row)?.height()));
        heights.max().unwrap_or(0)
    };
    let first = TITLE + 2 * GAP;
    let second = first + tallest(0) + GAP;
    let tops = [first, second, second + tallest(1) + GAP];
    let width = cells.iter().map(|cell| widest(cell) + GAP).sum::<u32>() + GAP;
    let mut sheet = Image::filled(width, tops[2] + tallest(2) + GAP, PAPER);
    let mut left = GAP;
    for (column, cell) in columns.iter().zip(&cells) {
        let style = TextStyle {
            height: TITLE as f32,
            color: INK,
        };
        text::draw(&mut sheet, &column.title, (left as f32, GAP as f32), style);
        for (picture, top) in cell.iter().zip(tops) {
            paste(&mut sheet, picture, left, top);
        }
        left += widest(cell) + GAP;
    }
    sheet
}

/// The image of a panel.
#[derive(Clone, Copy, Debug)]
pub enum Picture<'a> {
    /// A colour image: sRGB and coverage.
    Rgb(&'a Image<[u8; 4]>),
    /// The image of a monochrome camera.
    Grey(&'a Image<u8>),
    /// Depth, metres; invalid pixels are grey.
    Depth(&'a ZDepth),
}

/// An image with its title.
type Titled<'a> = (&'a str, Image<[u8; 3]>);

/// Draws panels at half size below their titles, `in_a_row` per row, with a legend of the common depth range (minimum and
/// maximum, metres) below.
#[must_use]
pub fn panels(panels: &[(&str, Picture<'_>)], in_a_row: usize, range_m: (f32, f32)) -> Image<[u8; 3]> {
    let mut marks = Marks::default();
    let pictures: Vec<Titled<'_>> = panels
        .iter()
        .map(|&(title, picture)| {
            let picture = match picture {
                Picture::Rgb(rgb) => averaged(rgb),
                Picture::Grey(grey) => averaged(&grey.map(|&level| [level, level, level, u8::MAX])),
                Picture::Depth(depth) => {
                    let (picture, more) = preview::colors(&halved(depth).0, range_m);
                    marks |= more;
                    picture
                }
            };
            (title, picture)
        })
        .collect();
    let rows: Vec<&[Titled<'_>]> = pictures.chunks(in_a_row.max(1)).collect();
    let across = |row: &&[Titled<'_>]| row.iter().map(|(_, picture)| picture.width() + GAP).sum::<u32>();
    let down = |row: &[Titled<'_>]| row.iter().map(|(_, picture)| picture.height()).max().unwrap_or(0);
    let width = rows.iter().map(across).max().unwrap_or(0) + GAP;
    let height = rows.iter().map(|row| down(row) + TITLE + 3 * GAP).sum::<u32>() + GAP;
    let legend = preview::legend(width.saturating_sub(2 * GAP), range_m, marks);
    let mut sheet = Image::filled(width, height + legend.height() + GAP, PAPER);
    let style = TextStyle {
        height: TITLE as f32,
        color: INK,
    };
    let mut top = GAP;
    for row in rows {
        let mut left = GAP;
        for (title, picture) in row {
            text::draw(&mut sheet, title, (left as f32, top as f32), style);
            paste(&mut sheet, picture, left, top + TITLE + GAP);
            left += picture.width() + GAP;
        }
        top += down(row) + TITLE + 3 * GAP;
    }
    paste(&mut sheet, &legend, GAP, height);
    sheet
}

/// Halves an image by averaging blocks of 2 × 2 pixels, ignoring coverage: the background has the colour of the sky.
fn averaged(rgb: &Image<[u8; 4]>) -> Image<[u8; 3]> {
    let (width, height) = (rgb.width() / 2, rgb.height() / 2);
    let mut half = Image::filled(width, height, PAPER);
    for (y, row) in half
        .pixels_mut()
        .chunks_exact_mut((width as usize).max(1))
        .enumerate()
    {
        for (x, pixel) in row.iter_mut().enumerate() {
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| {
                #[expect(clippy::cast_possible_truncation, reason = "an image's sides are u32")]
                let at = (2 * x as u32 + dx, 2 * y as u32 + dy);
                *rgb.get(at.0, at.1).unwrap_or(&[0; 4])
            });
            for (channel, value) in pixel.iter_mut().enumerate() {
                let sum: u16 = four.iter().map(|one| u16::from(one[channel])).sum();
                #[expect(clippy::cast_possible_truncation, reason = "a mean of bytes")]
                let mean = ((sum + 2) / 4) as u8;
                *value = mean;
            }
        }
    }
    half
}

/// Halves an image by taking each second pixel of each second row, since depth must not be averaged over edges.
fn halved(depth: &ZDepth) -> ZDepth {
    let (width, height) = (depth.0.width() / 2, depth.0.height() / 2);
    let rows = depth.0.rows().step_by(2).take(height as usize);
    let pixels = rows
        .flat_map(|row| row.iter().step_by(2).take(width as usize))
        .copied()
        .collect();
    ZDepth(Image::new(width, height, pixels).unwrap_or_else(|| Image::filled(0, 0, 0.0)))
}

/// Copies an image onto a sheet, clipped to the sheet.
pub fn paste(sheet: &mut Image<[u8; 3]>, picture: &Image<[u8; 3]>, left: u32, top: u32) {
    let width = sheet.width() as usize;
    for (row, y) in picture.rows().zip(top as usize..) {
        let start = y * width + left as usize;
        if let Some(place) = sheet.pixels_mut().get_mut(start..start + row.len()) {
            place.copy_from_slice(row);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_images_in_columns() {
        let column = |width: u32, height: u32| Column {
            title: "OAK".to_owned(),
            rgb: Image::filled(width, height, [200, 100, 50, 255]),
            depth: ZDepth(Image::filled(width, height, 1.0)),
            measured: ZDepth(Image::filled(width, height, 0.0)),
        };
        let sheet = contact_sheet(&[column(80, 40), column(60, 80)], (0.5, 2.0));
        assert_eq!(sheet.width(), 40 + 30 + 3 * GAP);
        let top = TITLE + 2 * GAP;
        assert_eq!(sheet.get(GAP, top), Some(&[200, 100, 50]));
        assert_eq!(sheet.get(GAP + 39, top + 19), Some(&[200, 100, 50]));
        assert_eq!(sheet.get(GAP + 40, top), Some(&PAPER));
        assert_eq!(sheet.get(2 * GAP + 40, top + 39), Some(&[200, 100, 50]));
        let depth_top = top + 40 + GAP;
        let colour = sheet.get(GAP, depth_top).unwrap();
        assert!(colour != &PAPER && sheet.get(2 * GAP + 40 + 29, depth_top) == Some(colour));
        assert_eq!(contact_sheet(&[], (0.5, 2.0)).width(), GAP);
    }

    #[test]
    fn places_panels_below_titles() {
        let grey = Image::filled(80, 40, 77);
        let depth = ZDepth(Image::filled(80, 40, 0.0));
        let three = [
            ("left", Picture::Grey(&grey)),
            ("depth", Picture::Depth(&depth)),
            ("left", Picture::Grey(&grey)),
        ];
        let sheet = panels(&three, 2, (0.5, 2.0));
        assert_eq!(sheet.width(), 2 * (40 + GAP) + GAP);
        let top = GAP + TITLE + GAP;
        let second = top + 20 + TITLE + 3 * GAP;
        for (x, y) in [(GAP, top), (GAP + 39, top + 19), (GAP, second)] {
            assert_eq!(sheet.get(x, y), Some(&[77; 3]));
        }
        assert_eq!(sheet.get(2 * GAP + 40, top), Some(&preview::NONE));
        assert!(panels(&[], 2, (0.5, 2.0)).height() > GAP);
    }

    #[test]
    fn averages_four_pixels() {
        let mut rgb = Image::filled(2, 2, [0, 0, 0, 255]);
        rgb.pixels_mut()[0] = [255, 4, 0, 255];
        assert_eq!(averaged(&rgb).pixels(), [[64, 1, 0]]);
    }
}
