use std::sync::Arc;

use oaktwin_camera::{Camera, RigidTransform};
use oaktwin_image::Image;

/// An object in a frame.
#[derive(Clone, Debug)]
pub struct Object {
    /// Its geometry.
    pub model: Arc<Model>,
    /// The path of its prim.
    pub path: String,
    /// Its pose in the world, metres.
    pub world_from_model: RigidTransform,
    /// The pixels that it covers, regardless of occlusion.
    pub silhouette: ObjectMask,
    /// The area that it covers in the image and around it.
    pub extent: Extent,
    /// The pixels in which it is visible.
    pub visible: ObjectMask,
}

/// The area that an object covers, regardless of occlusion, in an image that is extended by its own size on all sides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extent {
    /// The number of pixels.
    pub count: u64,
    /// The first column and row, relative to the image, and the width and height.
    pub rectangle: [i64; 4],
}

/// The geometry of an object, which others may share.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// The number of the model, from 1, the same in all frames.
    pub id: u32,
    /// The name.
    pub name: String,
    /// The class.
    pub label: String,
    /// Positions in the model's frame, metres.
    pub positions: Vec<[f32; 3]>,
    /// The three positions of each triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The colours.
    pub paint: Paint,
}

/// The colours of a model.
#[derive(Clone, Debug, PartialEq)]
pub enum Paint {
    /// The sRGB colours of each triangle's corners; empty if they are not known.
    Corners(Vec<[[u8; 3]; 3]>),
    /// A texture.
    Texture {
        /// The coordinates of each triangle's corners, (0, 0) at the lower left of the image.
        uvs: Vec<[[f32; 2]; 3]>,
        /// The image in sRGB.
        image: Arc<Image<[u8; 4]>>,
    },
}

impl Default for Paint {
    fn default() -> Self {
        Self::Corners(Vec::new())
    }
}

/// The images of a rectified stereo pair.
#[derive(Clone, Debug)]
pub struct StereoImages {
    /// The left and the right image, 8 bits.
    pub images: [Image<u8>; 2],
    /// The rectified cameras.
    pub cameras: [Camera; 2],
    /// The baseline in metres.
    pub baseline_m: f64,
    /// The exact disparity of each image, px: the column in the left image minus that in the right; `+inf` for a miss.
    pub disparities: [Image<f32>; 2],
    /// Whether the surface in a pixel of each image is visible in the other one.
    pub is_matched: [Image<bool>; 2],
}

/// A set of pixels within a rectangle of an image.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ObjectMask {
    /// The first column and row.
    pub origin: [u32; 2],
    /// The width and height.
    pub size: [u32; 2],
    /// Whether each pixel of the rectangle belongs to the set, by rows.
    pub pixels: Vec<bool>,
}

impl ObjectMask {
    /// Creates the set of some pixels, in any order and possibly repeated.
    #[must_use]
    pub fn from_places(places: &[[u32; 2]]) -> Self {
        let corners = places
            .iter()
            .fold(None, |corners: Option<[[u32; 2]; 2]>, [x, y]| {
                let [low, high] = corners.unwrap_or([[*x, *y]; 2]);
                Some([
                    [low[0].min(*x), low[1].min(*y)],
                    [high[0].max(*x), high[1].max(*y)],
                ])
            });
        let Some([origin, last]) = corners else {
            return Self::default();
        };
        let size = [last[0] - origin[0] + 1, last[1] - origin[1] + 1];
        let mut pixels = vec![false; size[0] as usize * size[1] as usize];
        for [x, y] in places {
            pixels[(y - origin[1]) as usize * size[0] as usize + (x - origin[0]) as usize] = true;
        }
        Self { origin, size, pixels }
    }

    /// Creates the set of the pixels of an image that fulfil a condition.
    #[cfg(test)]
    pub(crate) fn of(width: u32, height: u32, contains: impl Fn(u32, u32) -> bool) -> Self {
        let places = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        let places: Vec<[u32; 2]> = places.filter(|[x, y]| contains(*x, *y)).collect();
        Self::from_places(&places)
    }

    /// Returns the number of pixels.
    #[must_use]
    pub fn count(&self) -> usize {
        self.pixels.iter().filter(|pixel| **pixel).count()
    }

    /// Whether the set contains a pixel of the image.
    #[must_use]
    pub fn contains(&self, x: u32, y: u32) -> bool {
        let (Some(x), Some(y)) = (x.checked_sub(self.origin[0]), y.checked_sub(self.origin[1])) else {
            return false;
        };
        x < self.size[0] && y < self.size[1] && self.pixels[y as usize * self.size[0] as usize + x as usize]
    }

    /// Returns the pixels of the set.
    pub fn places(&self) -> impl Iterator<Item = [u32; 2]> {
        let [width, _] = self.size;
        let [left, top] = self.origin;
        let inside = (0u32..).zip(&self.pixels).filter(|(_, pixel)| **pixel);
        inside.map(move |(index, _)| [left + index % width, top + index / width])
    }

    /// Returns x, y, width and height of the smallest rectangle around the set; `None` if it is empty.
    #[must_use]
    pub fn bounding_box(&self) -> Option<[u32; 4]> {
        let corners = self.places().fold(None, |corners: Option<[u32; 4]>, [x, y]| {
            let [x0, y0, x1, y1] = corners.unwrap_or([x, y, x, y]);
            Some([x0.min(x), y0.min(y), x1.max(x), y1.max(y)])
        });
        corners.map(|[x0, y0, x1, y1]| [x0, y0, x1 - x0 + 1, y1 - y0 + 1])
    }

    /// Returns the mask as an image with 255 in its pixels.
    #[must_use]
    pub fn image(&self, width: u32, height: u32) -> Image<u8> {
        let mut image = Image::filled(width, height, 0);
        for [x, y] in self.places() {
            if let Some(pixel) = image
                .pixels_mut()
                .get_mut(y as usize * width as usize + x as usize)
            {
                *pixel = 255;
            }
        }
        image
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn masks_know_their_pixels() {
        let mask = ObjectMask::of(9, 7, |x, y| (2..5).contains(&x) && y == 3 || (x, y) == (4, 5));
        assert_eq!((mask.origin, mask.size, mask.count()), ([2, 3], [3, 3], 4));
        assert_eq!(mask.bounding_box(), Some([2, 3, 3, 3]));
        assert!(mask.contains(4, 5) && !mask.contains(3, 5) && !mask.contains(0, 0) && !mask.contains(8, 6));
        assert_eq!(
            mask.image(9, 7)
                .pixels()
                .iter()
                .filter(|pixel| **pixel == 255)
                .count(),
            4
        );
        let empty = ObjectMask::of(9, 7, |_, _| false);
        assert_eq!((empty.count(), empty.bounding_box()), (0, None));
    }
}
