//! Figures of numbers over numbers: one description, written as SVG or painted as a picture.
//!
//! ```
//! use crate::figure::{Axis, Figure, Layer, Shape};
//!
//! let figure = Figure {
//!     title: "Error over distance".to_owned(),
//!     subtitle: String::new(),
//!     x: Axis { label: "distance [m]".to_owned(), range: [0.0, 10.0] },
//!     y: Axis { label: "error [%]".to_owned(), range: [0.0, 6.0] },
//!     layers: vec![Layer {
//!         label: "a device".to_owned(),
//!         color: [40, 90, 180],
//!         shape: Shape::Line(vec![[1.0, 0.5], [5.0, 2.0], [10.0, 4.5]]),
//!     }],
//! };
//! assert!(figure.svg().starts_with("<svg"));
//! assert!(figure.picture().width() > figure.picture().height());
//! ```

mod axis;
mod layout;
mod picture;
mod svg;

use oaktwin_image::Image;

/// What a figure shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Above it.
    pub title: String,
    /// Below the title, smaller.
    pub subtitle: String,
    /// To the right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// From the back to the front; what lies outside the axes' ranges is cut off.
    pub layers: Vec<Layer>,
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it measures, and in what.
    pub label: String,
    /// From where to where.
    pub range: [f64; 2],
}

/// Numbers that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Its name in the legend; without one it has no place there.
    pub label: String,
    /// sRGB.
    pub color: [u8; 3],
    /// How it is drawn.
    pub shape: Shape,
}

/// How numbers are drawn. What is not finite is left out; a line has a gap there.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Rectangles from one x to another, over a range of y: `[from, to, low, high]`.
    Steps(Vec<[f64; 4]>),
    /// The area between two curves: `[x, low, high]`.
    Area(Vec<[f64; 3]>),
    /// A line through `[x, y]`.
    Line(Vec<[f64; 2]>),
    /// A thin broken line through `[x, y]`.
    Dashes(Vec<[f64; 2]>),
    /// A dot at each `[x, y]`.
    Dots(Vec<[f64; 2]>),
}

impl Figure {
    /// An SVG document.
    #[must_use]
    pub fn svg(&self) -> String {
        svg::written(&layout::marks(self))
    }

    /// A picture, at twice the size of the SVG.
    #[must_use]
    pub fn picture(&self) -> Image<[u8; 3]> {
        picture::painted(&layout::marks(self))
    }
}

/// An SVG document of figures one below the other.
#[must_use]
pub fn svg_of(figures: &[Figure]) -> String {
    match figures {
        [one] => one.svg(),
        all => svg::stacked(&all.iter().map(layout::marks).collect::<Vec<_>>()),
    }
}

/// A picture of figures one below the other, at twice the size of the SVG.
#[must_use]
pub fn picture_of(figures: &[Figure]) -> Image<[u8; 3]> {
    let pictures: Vec<Image<[u8; 3]>> = figures.iter().map(Figure::picture).collect();
    let width = pictures.first().map_or(0, Image::width);
    let height = pictures.iter().map(Image::height).sum();
    let pixels = pictures.iter().flat_map(Image::pixels).copied().collect();
    Image::new(width, height, pixels).unwrap_or_else(|| Image::filled(width, height, [255; 3]))
}
