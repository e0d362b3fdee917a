//! Polygons inside an axis-aligned box.

use oaktwin_camera::math::DVec3;
use oaktwin_scene::Bounds;

/// Returns the part of a triangle inside a box, its faces included: a convex polygon, empty if there is none.
pub(super) fn inside(triangle: [DVec3; 3], bounds: Option<Bounds>) -> Vec<DVec3> {
    let Some(bounds) = bounds else {
        return triangle.to_vec();
    };
    let [a, b, c] = triangle;
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    if high.cmplt(bounds.min).any() || low.cmpgt(bounds.max).any() {
        return Vec::new();
    }
    let mut polygon = triangle.to_vec();
    if low.cmpge(bounds.min).all() && high.cmple(bounds.max).all() {
        return polygon;
    }
    for axis in 0..3 {
        for (limit, sign) in [(bounds.min[axis], 1.0), (bounds.max[axis], -1.0)] {
            polygon = half_space(&polygon, axis, limit, sign);
        }
    }
    polygon
}

/// Clips a polygon after Sutherland and Hodgman: keeps what lies on the side `sign` of a plane across an axis.
fn half_space(polygon: &[DVec3], axis: usize, limit: f64, sign: f64) -> Vec<DVec3> {
    let is_inside = |point: DVec3| sign * (point[axis] - limit) >= 0.0;
    let mut clipped = Vec::with_capacity(polygon.len() + 1);
    for (i, &point) in polygon.iter().enumerate() {
        let before = polygon[(i + polygon.len() - 1) % polygon.len()];
        if is_inside(before) != is_inside(point) {
            let t = (limit - before[axis]) / (point[axis] - before[axis]);
            let mut crossing = before + t * (point - before);
            crossing[axis] = limit;
            clipped.push(crossing);
        }
        if is_inside(point) {
            clipped.push(point);
        }
    }
    clipped
}

/// Returns the area vectors of a convex polygon's fan of triangles: half the cross products.
pub(super) fn fan(polygon: &[DVec3]) -> impl Iterator<Item = ([DVec3; 3], f64)> {
    let first = polygon.first().copied().unwrap_or_default();
    polygon.windows(2).skip(1).map(move |edge| {
        let area = 0.5 * (edge[0] - first).cross(edge[1] - first).length();
        ([first, edge[0], edge[1]], area)
    })
}

/// Returns the area of a convex polygon.
pub(super) fn area(polygon: &[DVec3]) -> f64 {
    fan(polygon).map(|(_, area)| area).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn bounds(min: [f64; 3], max: [f64; 3]) -> Bounds {
        Bounds {
            min: DVec3::from(min),
            max: DVec3::from(max),
        }
    }

    #[test]
    fn keeps_the_part_inside() {
        let triangle = [[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 4.0, 1.0]].map(DVec3::from);
        let part = |min, max| area(&inside(triangle, Some(bounds(min, max))));
        assert_eq!(area(&inside(triangle, None)), 8.0);
        assert_eq!(part([-1.0; 3], [9.0; 3]), 8.0);
        assert_eq!(part([0.0, 0.0, 1.0], [1.0, 1.0, 1.0]), 1.0);
        assert_eq!(part([2.0, 0.0, 0.0], [9.0, 9.0, 9.0]), 2.0);
        assert_eq!(part([0.0, 0.0, 1.1], [9.0; 3]), 0.0);
        // The corner of the box is outside, but within the bounding box of the triangle.
        assert_eq!(part([3.0, 3.0, 0.0], [9.0; 3]), 0.0);
    }

    proptest! {
        #[test]
        fn two_halves_are_the_whole(
            corners in prop::array::uniform3(prop::array::uniform3(-1.0..1.0f64)),
            at in -1.0..1.0f64,
            axis in 0..3usize,
        ) {
            let triangle = corners.map(DVec3::from);
            let (mut below, mut above) = (bounds([-2.0; 3], [2.0; 3]), bounds([-2.0; 3], [2.0; 3]));
            below.max[axis] = at;
            above.min[axis] = at;
            let halves = [below, above].map(|half| area(&inside(triangle, Some(half))));
            prop_assert!((halves[0] + halves[1] - area(&triangle)).abs() < 1e-12);
        }
    }
}
