//! Figures of curves over an axis, as SVG and as images.
//!
//! ```
//! use oaktwin_evaluate::figure::{self, FigureAxis, Figure, FigureLayer, FigureShape};
//!
//! let figure = Figure {
//!     title: "Error over distance".to_owned(),
//!     subtitle: String::new(),
//!     x: FigureAxis { label: "distance [m]".to_owned(), range: [0.0, 10.0] },
//!     y: FigureAxis { label: "error [%]".to_owned(), range: [0.0, 6.0] },
//!     layers: vec![FigureLayer {
//!         label: "a unit".to_owned(),
//!         color: [40, 90, 180],
//!         shape: FigureShape::Line(vec![[1.0, 0.5], [5.0, 2.0], [10.0, 4.5]]),
//!     }],
//! };
//! assert!(figure::svg(&[figure.clone()])?.starts_with("<svg"));
//! let image = figure::image(&[figure])?;
//! assert!(image.width() > image.height());
//! # Ok::<(), figure::FigureError>(())
//! ```

mod chart;
mod clip;
mod render;
#[cfg(test)]
mod tests;

pub use render::{image, svg};

/// A figure: layers over a pair of axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// The heading.
    pub title: String,
    /// A smaller line below the title; may be empty.
    pub subtitle: String,
    /// The horizontal axis.
    pub x: FigureAxis,
    /// The vertical axis.
    pub y: FigureAxis,
    /// The layers from back to front, clipped to the ranges of the axes.
    pub layers: Vec<FigureLayer>,
}

/// An axis of a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureAxis {
    /// The quantity and its unit.
    pub label: String,
    /// The first and the last value.
    pub range: [f64; 2],
}

/// A set of values drawn in one style.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureLayer {
    /// The name in the legend; an empty one is not listed.
    pub label: String,
    /// The sRGB colour.
    pub color: [u8; 3],
    /// The values, and the style in which they are drawn.
    pub shape: FigureShape,
}

/// Values and the style in which they are drawn. Values that are not finite are skipped, and interrupt a line.
#[derive(Clone, Debug, PartialEq)]
pub enum FigureShape {
    /// Rectangles `[from, to, low, high]`: a range of x and a range of y.
    Steps(Vec<[f64; 4]>),
    /// The area between two curves: `[x, low, high]`.
    Area(Vec<[f64; 3]>),
    /// A line through `[x, y]`.
    Line(Vec<[f64; 2]>),
    /// A dot at each `[x, y]`.
    Dots(Vec<[f64; 2]>),
}

/// The error of a figure that cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the figure cannot be drawn: {0}")]
pub struct FigureError(String);
