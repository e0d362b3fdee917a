use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Intrinsics, PixelPoint, Usd};
use oaktwin_image::ImageView;

use super::statistics::{mean, median_in_place};
use super::{FittedPlane, ImageRegion, is_valid};

/// The optics of depth images.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Optics {
    /// The intrinsics of the images, without distortion.
    pub intrinsics: Intrinsics,
    /// Focal length times baseline in px·m, in the pixels in which disparity is counted.
    pub disparity_times_depth: f64,
}

/// Quality measures on a flat board, as in librealsense's depth quality tool; the plane is fitted in inverse depth
/// ([`FittedPlane::fitted`]). `None` if too little was measured.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quality {
    /// The share of the region's pixels that are valid, 0 to 1; the mean over the captures.
    pub fill_rate: f64,
    /// Spatial noise: the root mean square distance of a capture's points from the plane fitted to them in metres; the mean
    /// over the captures.
    pub plane_fit_rms_m: Option<f64>,
    /// Spatial noise in disparity: the same of `f b / z − f b / z'`, where z' is the depth of the fitted plane at the pixel, px.
    pub subpixel_rms_px: Option<f64>,
    /// Z accuracy in metres, positive if too far: the median distance of the points from the fitted plane, which is first
    /// turned perpendicular, plus that plane's distance from the true one. The mean over the captures.
    pub z_accuracy_m: Option<f64>,
    /// The median of |z − truth| over all points of all captures in metres. A mean is meaningless where disparity is close
    /// to 0.
    pub pixel_error_m: Option<f64>,
    /// The median over the pixels of the standard deviation over time (of the sample) in metres, for pixels that are valid in
    /// at least two captures.
    pub temporal_noise_m: Option<f64>,
}

/// Measures the quality of images of a flat board in a region.
#[must_use]
pub fn quality(
    captures: &[ImageView<'_, f32>],
    region: &ImageRegion,
    optics: &Optics,
    truth_m: f64,
) -> Quality {
    let mut deviations = Deviations::new(region.pixels());
    let (mut fill, mut spatial) = (Vec::new(), Vec::new());
    let mut errors_m: Vec<f32> = Vec::with_capacity(region.pixels() * captures.len());
    #[expect(clippy::cast_possible_truncation, reason = "images have no more digits")]
    let off = |z: f32| (f64::from(z) - truth_m).abs() as f32;
    let rays = rays(region, &optics.intrinsics);
    let mut points: Vec<DVec3> = Vec::with_capacity(region.pixels());
    for capture in captures {
        points.clear();
        for (row, start) in region.rows_of(*capture).zip((0..).step_by(region.columns.len())) {
            for (&z, at) in row.iter().zip(start..) {
                if is_valid(z) {
                    points.push(rays[at] * f64::from(z));
                    deviations.add(at, f64::from(z));
                    errors_m.push(off(z));
                }
            }
        }
        fill.push(points.len() as f64 / region.pixels() as f64);
        spatial.extend(Spatial::new(&points, optics.disparity_times_depth, truth_m));
    }
    Quality {
        fill_rate: mean(fill).filter(|rate| rate.is_finite()).unwrap_or(0.0),
        plane_fit_rms_m: mean(spatial.iter().map(|one| one.rms_m)),
        subpixel_rms_px: mean(spatial.iter().map(|one| one.rms_px)),
        z_accuracy_m: mean(spatial.iter().map(|one| one.z_accuracy_m)),
        pixel_error_m: median_in_place(&mut errors_m),
        temporal_noise_m: deviations.median(),
    }
}

/// Returns the points at depth 1 on the rays of the region's pixels, row by row.
fn rays(region: &ImageRegion, intrinsics: &Intrinsics) -> Vec<DVec3> {
    let pixel = |x: u32, y: u32| {
        let centre = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        intrinsics.normalized_from_pixel(centre).extend(1.0)
    };
    let (rows, columns) = (region.rows.clone(), &region.columns);
    rows.flat_map(|y| columns.clone().map(move |x| pixel(x, y)))
        .collect()
}

/// The measures of a single capture.
struct Spatial {
    rms_m: f64,
    rms_px: f64,
    z_accuracy_m: f64,
}

impl Spatial {
    fn new(points: &[DVec3], disparity_times_depth: f64, truth_m: f64) -> Option<Self> {
        let plane = FittedPlane::fitted(points)?;
        let mut distances = Vec::with_capacity(points.len());
        let (mut squares_m, mut squares_px) = (0.0, 0.0);
        for point in points {
            let distance = plane.signed_distance(*point);
            squares_m += distance * distance;
            // On the pixel's ray, the depth of the plane is this share of the point's depth.
            let share = plane.distance_m / (plane.distance_m + distance);
            let off_px = disparity_times_depth / point.z * (1.0 - 1.0 / share);
            squares_px += off_px * off_px;
            #[expect(clippy::cast_possible_truncation, reason = "images have no more digits")]
            distances.push(distance as f32);
        }
        let count = points.len() as f64;
        Some(Self {
            rms_m: (squares_m / count).sqrt(),
            rms_px: (squares_px / count).sqrt(),
            z_accuracy_m: median_in_place(&mut distances)? + plane.distance_m - truth_m,
        })
    }
}

/// The deviation of each pixel over time, accumulated capture by capture (Welford 1962).
struct Deviations {
    count: Vec<u32>,
    mean: Vec<f64>,
    squares: Vec<f64>,
}

impl Deviations {
    fn new(pixels: usize) -> Self {
        Self {
            count: vec![0; pixels],
            mean: vec![0.0; pixels],
            squares: vec![0.0; pixels],
        }
    }

    fn add(&mut self, at: usize, value: f64) {
        self.count[at] += 1;
        let from_old = value - self.mean[at];
        self.mean[at] += from_old / f64::from(self.count[at]);
        self.squares[at] += from_old * (value - self.mean[at]);
    }

    fn median(&self) -> Option<f64> {
        let both = self
            .count
            .iter()
            .zip(&self.squares)
            .filter(|(count, _)| **count >= 2);
        #[expect(clippy::cast_possible_truncation, reason = "images have no more digits")]
        let mut deviations: Vec<f32> = both
            .map(|(count, squares)| (squares / f64::from(count - 1)).sqrt() as f32)
            .collect();
        median_in_place(&mut deviations)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::ImageSize;
    use oaktwin_image::Image;

    fn optics() -> Optics {
        let size = ImageSize::new(40, 20);
        Optics {
            intrinsics: Intrinsics::new(size, 50.0, 50.0, PixelPoint::<Usd>::new(20.0, 10.0)),
            disparity_times_depth: 60.0,
        }
    }

    fn board(z: impl Fn(u32, u32) -> f64) -> Image<f32> {
        #[expect(clippy::cast_possible_truncation, reason = "a depth")]
        let pixels = (0..800).map(|i| z(i % 40, i / 40) as f32).collect();
        Image::new(40, 20, pixels).unwrap()
    }

    fn of(images: &[Image<f32>], truth_m: f64) -> Quality {
        let views: Vec<ImageView<'_, f32>> = images.iter().map(ImageView::from).collect();
        quality(&views, &ImageRegion::centred(40, 20, 0.5), &optics(), truth_m)
    }

    #[test]
    fn perfect_board_has_no_error() {
        let quality = of(&[board(|_, _| 4.0), board(|_, _| 4.0)], 3.5);
        assert_eq!((quality.fill_rate, quality.temporal_noise_m), (1.0, Some(0.0)));
        assert!(quality.plane_fit_rms_m.unwrap() < 1e-9 && quality.subpixel_rms_px.unwrap() < 1e-9);
        assert!((quality.z_accuracy_m.unwrap() - 0.5).abs() < 1e-9);
        assert_eq!(quality.pixel_error_m, Some(0.5));
    }

    /// A tilted board is flat, and its distance is its plane's.
    #[test]
    fn tilt_is_not_an_error() {
        let normal = DVec3::new(0.2, -0.1, 1.0).normalize();
        let rays = rays(&ImageRegion::centred(40, 20, 1.0), &optics().intrinsics);
        let image = board(|x, y| 2.0 / normal.dot(rays[(y * 40 + x) as usize]));
        let quality = of(&[image], 2.0);
        assert!(quality.plane_fit_rms_m.unwrap() < 1e-6, "{quality:?}");
        assert!(quality.subpixel_rms_px.unwrap() < 1e-5, "{quality:?}");
        assert!(quality.z_accuracy_m.unwrap().abs() < 1e-6, "{quality:?}");
        assert_eq!(quality.temporal_noise_m, None);
    }

    /// A checkerboard of half a pixel of disparity: the RMS is half a pixel, and z²/(f b) times that in metres.
    #[test]
    fn rms_of_a_disparity_checkerboard() {
        let off = |x: u32, y: u32| if (x + y).is_multiple_of(2) { 0.01 } else { -0.01 };
        let quality = of(&[board(|x, y| 60.0 / (15.0 + off(x, y)))], 4.0);
        assert!(
            (quality.subpixel_rms_px.unwrap() - 0.01).abs() < 1e-5,
            "{quality:?}"
        );
        let metres = 0.01 * 16.0 / 60.0;
        assert!(
            (quality.plane_fit_rms_m.unwrap() / metres - 1.0).abs() < 1e-3,
            "{quality:?}"
        );
    }

    #[test]
    fn measures_fill_rate_and_temporal_noise() {
        // A quarter of the columns is never valid; the rest oscillates by 1 cm.
        let at = |z: f64| board(|x, _| if x.is_multiple_of(4) { f64::NAN } else { z });
        let quality = of(&[at(2.01), at(1.99), at(2.01), at(1.99)], 2.0);
        assert!((quality.fill_rate - 0.75).abs() < 1e-12);
        let deviation = (4.0f64 / 3.0).sqrt() * 0.01;
        assert!(
            (quality.temporal_noise_m.unwrap() - deviation).abs() < 1e-6,
            "{quality:?}"
        );
        assert!(quality.plane_fit_rms_m.unwrap() < 1e-6);
    }

    #[test]
    fn returns_none_without_enough_values() {
        let nothing = of(&[board(|_, _| 0.0)], 2.0);
        assert_eq!(nothing, Quality::default());
        assert_eq!(of(&[], 2.0), Quality::default());
        let one = of(&[board(|x, y| if (x, y) == (20, 10) { 2.0 } else { 0.0 })], 2.0);
        assert!(one.fill_rate > 0.0 && one.plane_fit_rms_m.is_none());
        let row = of(&[board(|_, y| if y == 10 { 2.0 } else { 0.0 })], 2.0);
        assert_eq!(row.plane_fit_rms_m, None);
    }
}
