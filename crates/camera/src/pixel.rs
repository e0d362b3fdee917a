use std::fmt;
use std::marker::PhantomData;

use glam::DVec2;

/// The position of the centre of an image's first pixel.
pub trait PixelConvention: Copy + fmt::Debug + PartialEq + 'static {
    /// Both coordinates of the centre of the first pixel.
    const FIRST_CENTRE: f64;
}

/// OpenCV, DepthAI and ROS: the centre of the first pixel is (0, 0), and the centre of an image of width W is
/// (W − 1)/2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OpenCv;

/// OpenUSD, Isaac Sim, COLMAP and nerfstudio: the centre of the first pixel is (0.5, 0.5), and the centre of an
/// image of width W is W/2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Usd;

impl PixelConvention for OpenCv {
    const FIRST_CENTRE: f64 = 0.0;
}

impl PixelConvention for Usd {
    const FIRST_CENTRE: f64 = 0.5;
}

/// A position in an image, in pixels: x to the right, y down, with its convention in the type.
#[derive(Clone, Copy, PartialEq)]
pub struct PixelPoint<C> {
    /// The distance to the right.
    pub x: f64,
    /// The distance down.
    pub y: f64,
    convention: PhantomData<C>,
}

impl<C: PixelConvention> PixelPoint<C> {
    /// Creates the position (x, y) in this convention.
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self {
            x,
            y,
            convention: PhantomData,
        }
    }

    /// Converts to another convention.
    #[must_use]
    #[inline]
    pub fn to<D: PixelConvention>(self) -> PixelPoint<D> {
        let shift = D::FIRST_CENTRE - C::FIRST_CENTRE;
        PixelPoint::new(self.x + shift, self.y + shift)
    }

    /// Returns the coordinates without their convention.
    #[must_use]
    pub const fn xy(self) -> DVec2 {
        DVec2::new(self.x, self.y)
    }
}

impl<C: PixelConvention> From<DVec2> for PixelPoint<C> {
    fn from(xy: DVec2) -> Self {
        Self::new(xy.x, xy.y)
    }
}

impl<C: PixelConvention> fmt::Debug for PixelPoint<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{:?}({}, {})",
            std::any::type_name::<C>().rsplit("::").next().unwrap_or(""),
            self.x,
            self.y
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn converts_the_centre_of_an_image() {
        let centre = PixelPoint::<Usd>::new(640.0, 400.0);
        assert_eq!(centre.to::<OpenCv>(), PixelPoint::new(639.5, 399.5));
        assert_eq!(centre.to::<OpenCv>().to::<Usd>(), centre);
    }
}
