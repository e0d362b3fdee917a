//! Keeps the precision of files whose coordinates are far from the origin, such as surveys in a national grid: their numbers
//! are read in double precision, and meshes, which store single precision, are placed at an origin of their own.

use oaktwin_camera::math::DVec3;

/// The distance from which on the coordinates of a file count as far, in metres: single precision resolves 8 µm there.
pub(super) const FAR_M: f64 = 100.0;

/// The same for a part of a file from the rest of it: single precision resolves 1 mm there. Nearer parts share an origin, so that
/// points that they have in common stay together.
pub(super) const FAR_PART_M: f64 = 10_000.0;

/// The origin for a mesh with these points, in the file's unit: zero on each axis on which the file's origin is among the points
/// or nearer than `far`.
pub(super) fn origin(points: impl Iterator<Item = [f64; 3]>, far: f64) -> DVec3 {
    let (mut min, mut max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in points.filter(|point| point.iter().all(|x| x.is_finite())) {
        for axis in 0..3 {
            min[axis] = min[axis].min(point[axis]);
            max[axis] = max[axis].max(point[axis]);
        }
    }
    let of_axis = |axis: usize| {
        let (center, half) = (
            0.5 * min[axis] + 0.5 * max[axis],
            0.5 * max[axis] - 0.5 * min[axis],
        );
        // Without points, the centre is not a number.
        if center.abs() > half && center.abs() > far {
            center.round()
        } else {
            0.0
        }
    };
    DVec3::from([0, 1, 2].map(of_axis))
}

/// The point in a frame at an origin.
#[allow(clippy::cast_possible_truncation, reason = "meshes store single precision")]
pub(super) fn relative(point: [f64; 3], origin: DVec3) -> [f32; 3] {
    (DVec3::from(point) - origin).to_array().map(|x| x as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_axes_far_from_the_file_s_origin_move() {
        let survey = [[499_123.4, -20.0, 90.0], [499_125.4, 300.0, 95.0]];
        assert_eq!(origin(survey.into_iter(), 100.0), DVec3::new(499_124.0, 0.0, 0.0));
        assert_eq!(origin(survey.into_iter(), 50.0), DVec3::new(499_124.0, 0.0, 93.0));
        assert_eq!(origin(survey.into_iter(), 1e6), DVec3::ZERO);
        assert_eq!(origin([].into_iter(), 100.0), DVec3::ZERO);
        let holed = [survey[0], [f64::NAN; 3], survey[1]];
        assert_eq!(origin(holed.into_iter(), 100.0), DVec3::new(499_124.0, 0.0, 0.0));
        assert_eq!(
            relative(survey[0], origin(survey.into_iter(), 100.0)),
            [-0.6, -20.0, 90.0]
        );
    }
}
