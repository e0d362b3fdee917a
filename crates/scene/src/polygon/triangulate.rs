//! Triangulates polygons: a fan from the first corner if it covers the polygon, otherwise ear clipping.

use oaktwin_camera::math::{DVec2, DVec3};

/// The time of ear clipping grows with the square of the corners; polygons with more corners are split into fans.
const MAX_CORNERS_TO_CLIP: usize = 8192;

/// Buffers that are reused for each face.
#[derive(Debug, Default)]
pub(super) struct Triangulator {
    flat: Vec<DVec2>,
    /// The ring of corners that are not yet clipped.
    next: Vec<u32>,
    previous: Vec<u32>,
    /// Corners that are known not to be ears until a neighbour is clipped.
    blocked: Vec<bool>,
}

impl Triangulator {
    /// Calls `emit` with the corners (0 is the polygon's first) of each of its `corners − 2` triangles, in the
    /// polygon's winding. Returns false if ear clipping is required but the polygon has too many corners.
    pub(super) fn triangulate(&mut self, polygon: &[DVec3], mut emit: impl FnMut([u32; 3])) -> bool {
        let count = u32::try_from(polygon.len()).unwrap_or(u32::MAX);
        let clip = !fan_covers(polygon);
        if clip && polygon.len() <= MAX_CORNERS_TO_CLIP {
            self.clip_ears(polygon, &mut emit);
            return true;
        }
        for corner in 1..count.saturating_sub(1) {
            emit([0, corner, corner + 1]);
        }
        !clip
    }

    fn clip_ears(&mut self, polygon: &[DVec3], emit: &mut impl FnMut([u32; 3])) {
        self.flatten(polygon);
        let count = u32::try_from(polygon.len()).unwrap_or(u32::MAX);
        self.next.clear();
        self.next.extend((1..count).chain([0]));
        self.previous.clear();
        self.previous.extend([count - 1].into_iter().chain(0..count - 1));
        self.blocked.clear();
        self.blocked.resize(polygon.len(), false);
        let mut at = 0;
        for left in (3..=count).rev() {
            let tip = self.choose_ear(at, left);
            let (before, after) = (self.previous[tip as usize], self.next[tip as usize]);
            emit([before, tip, after]);
            self.next[before as usize] = after;
            self.previous[after as usize] = before;
            self.blocked[before as usize] = false;
            self.blocked[after as usize] = false;
            // Skips a corner, so that not all triangles share one.
            at = self.next[after as usize];
        }
    }

    /// Drops the axis along which the polygon's normal is longest, which keeps the coordinates exact.
    fn flatten(&mut self, polygon: &[DVec3]) {
        let normal = newell(polygon);
        let size = normal.abs();
        let project = |p: &DVec3| {
            if size.x >= size.y && size.x >= size.z {
                DVec2::new(p.y, p.z * normal.x.signum())
            } else if size.y >= size.z {
                DVec2::new(p.z, p.x * normal.y.signum())
            } else {
                DVec2::new(p.x, p.y * normal.z.signum())
            }
        };
        self.flat.clear();
        self.flat.extend(polygon.iter().map(project));
    }

    /// The next ear from `at`; if there is none because the polygon intersects itself, the least bad corner.
    fn choose_ear(&mut self, at: u32, left: u32) -> u32 {
        let mut tip = at;
        let mut fallback = (f64::NEG_INFINITY, at);
        for _ in 0..left {
            let turn = self.turn(tip);
            if turn > 0.0 && !self.blocked[tip as usize] {
                if !self.is_blocked(tip) {
                    return tip;
                }
                self.blocked[tip as usize] = true;
            }
            // A corner without area is better than an inverted one or one that covers others.
            let badness = if turn > 0.0 { f64::MIN } else { turn };
            if badness > fallback.0 {
                fallback = (badness, tip);
            }
            tip = self.next[tip as usize];
        }
        fallback.1
    }

    /// Twice the signed area of a corner's triangle.
    fn turn(&self, tip: u32) -> f64 {
        orient(
            self.flat[self.previous[tip as usize] as usize],
            self.flat[tip as usize],
            self.flat[self.next[tip as usize] as usize],
        )
    }

    /// Whether another part of the polygon is inside a corner's triangle.
    fn is_blocked(&self, tip: u32) -> bool {
        let (before, after) = (self.previous[tip as usize], self.next[tip as usize]);
        let [a, b, c] = [before, tip, after].map(|corner| self.flat[corner as usize]);
        let mut other = self.next[after as usize];
        while other != before {
            let p = self.flat[other as usize];
            if p == b {
                // The outline touches itself here, as where a hole is joined to it: its direction from here decides.
                let inside = |corner: u32| {
                    let q = self.flat[corner as usize];
                    orient(a, b, q) > 0.0 && orient(b, c, q) > 0.0
                };
                if inside(self.next[other as usize]) || inside(self.previous[other as usize]) {
                    return true;
                }
            } else if p != a
                && p != c
                && orient(a, b, p) >= 0.0
                && orient(b, c, p) >= 0.0
                && orient(c, a, p) >= 0.0
            {
                return true;
            }
            other = self.next[other as usize];
        }
        false
    }
}

/// Positive if `a`, `b`, `c` turn left. The sign is practically exact for single-precision coordinates.
fn orient(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// The normal of the polygon's best plane, with twice the polygon's area as length.
fn newell(polygon: &[DVec3]) -> DVec3 {
    let Some(&origin) = polygon.first() else {
        return DVec3::ZERO;
    };
    polygon
        .windows(2)
        .map(|edge| (edge[0] - origin).cross(edge[1] - origin))
        .fold(DVec3::ZERO, |sum, area| sum + area)
}

/// Whether no triangle of the fan is inverted: then the fan covers a simple polygon without overlap. This holds
/// for every convex polygon, and for concave ones whose first corner sees all others.
fn fan_covers(polygon: &[DVec3]) -> bool {
    if polygon.len() < 4 {
        return true;
    }
    if let &[a, b, c, d] = polygon {
        // Sufficient for nearly all quads.
        let diagonal = c - a;
        let (first, second) = ((b - a).cross(diagonal), diagonal.cross(d - a));
        let normal = first + second;
        if first.dot(normal) >= 0.0 && second.dot(normal) >= 0.0 {
            return true;
        }
    }
    let normal = newell(polygon);
    let origin = polygon[0];
    let turned = |edge: &[DVec3]| {
        let (from, to) = (edge[0] - origin, edge[1] - origin);
        let area = from.cross(to).dot(normal);
        // A corner on the line between its neighbours, within single-precision rounding, is not inverted.
        area < 0.0 && area < -1e-6 * from.length() * to.length() * normal.length()
    };
    !polygon.windows(2).any(turned)
}

#[cfg(test)]
#[allow(clippy::cast_possible_truncation)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cut(polygon: &[DVec3]) -> Vec<[u32; 3]> {
        let mut triangles = Vec::new();
        assert!(Triangulator::default().triangulate(polygon, |triangle| triangles.push(triangle)));
        triangles
    }

    fn flat(polygon: &[(f64, f64)]) -> Vec<DVec3> {
        polygon.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect()
    }

    /// Checks that every triangle has the polygon's winding and the areas add up: then the triangles cover the polygon.
    fn assert_covers(polygon: &[DVec3], triangles: &[[u32; 3]]) {
        assert_eq!(triangles.len(), polygon.len() - 2);
        let whole = newell(polygon);
        let normal = whole.normalize();
        let mut sum = 0.0;
        for triangle in triangles {
            let [a, b, c] = triangle.map(|corner| polygon[corner as usize]);
            let area = (b - a).cross(c - a).dot(normal);
            assert!(area > -1e-5 * whole.length(), "{triangle:?} is inverted: {area}");
            sum += area.abs();
        }
        assert!(
            (sum / whole.length() - 1.0).abs() < 1e-5,
            "{sum} of {}",
            whole.length()
        );
    }

    #[test]
    fn convex_polygons_are_fanned() {
        let pentagon = flat(&[(0., 0.), (2., 0.), (3., 1.), (1., 3.), (-1., 1.)]);
        assert_eq!(cut(&pentagon), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    }

    #[test]
    fn a_concave_polygon_whose_first_corner_sees_all_is_fanned() {
        let arrow = flat(&[(0., 0.), (2., 1.), (0.5, 0.), (2., -1.)]);
        let from_tail = [&arrow[2..], &arrow[..2]].concat();
        assert_eq!(cut(&from_tail), [[0, 1, 2], [0, 2, 3]]);
        // A fan from a wing would cover the outside.
        let from_wing = [&arrow[1..], &arrow[..1]].concat();
        assert_covers(&from_wing, &cut(&from_wing));
    }

    #[test]
    fn a_hole_joined_by_a_bridge_stays_open() {
        let square = [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (0., 0.)];
        let hole = [(1., 1.), (1., 3.), (3., 3.), (3., 1.), (1., 1.)];
        let polygon = flat(&[square, hole].concat());
        assert_covers(&polygon, &cut(&polygon));
        assert_eq!(newell(&polygon).z, 2.0 * 12.0);
    }

    #[test]
    fn degenerate_polygons_give_the_same_number_of_triangles() {
        for polygon in [
            flat(&[(0., 0.), (1., 0.), (2., 0.), (3., 0.)]),
            flat(&[(1., 1.); 6]),
            flat(&[(0., 0.), (1., 1.), (1., 0.), (0., 1.)]),
            flat(&[(0., 0.), (2., 2.), (2., 0.), (0., 2.), (0., 1.), (2., 1.)]),
        ] {
            assert_eq!(cut(&polygon).len(), polygon.len() - 2);
        }
    }

    #[test]
    fn a_comb_of_many_teeth_is_covered() {
        let teeth = 500;
        let mut comb = vec![(0., -1.)];
        for tooth in 0..teeth {
            let x = f64::from(2 * tooth);
            comb.extend([(x + 1.0, 0.0), (x + 2.0, 10.0)]);
        }
        comb[0] = (0., 10.);
        comb.insert(0, (0., -1.));
        comb.push((f64::from(2 * teeth), -1.));
        comb.reverse();
        let polygon = flat(&comb);
        assert_covers(&polygon, &cut(&polygon));
    }

    proptest! {
        /// A star with any radii, orientation and first corner.
        #[test]
        fn stars_are_covered(
            radii in prop::collection::vec(0.05..10.0_f64, 4..40),
            first in 0..40_usize,
            axis in prop::array::uniform3(-1.0..1.0_f64),
            angle in -3.0..3.0_f64,
            twice in any::<bool>(),
        ) {
            prop_assume!(DVec3::from(axis).length() > 0.1);
            let turn = oaktwin_camera::math::DMat3::from_axis_angle(DVec3::from(axis).normalize(), angle);
            let count = radii.len() as f64;
            let mut polygon: Vec<DVec3> = radii
                .iter()
                .enumerate()
                .map(|(i, r)| {
                    let (sin, cos) = (std::f64::consts::TAU * i as f64 / count).sin_cos();
                    let p = turn * DVec3::new(r * cos, r * sin, 3.0);
                    DVec3::from(p.to_array().map(|x| f64::from(x as f32)))
                })
                .collect();
            let first = first % polygon.len();
            polygon.rotate_left(first);
            if twice {
                // Repeated points count as corners.
                polygon = polygon.into_iter().flat_map(|p| [p, p]).collect();
            }
            let triangles = cut(&polygon);
            assert_covers(&polygon, &triangles);
        }

        /// For any polygon, each corner is used and triangulation terminates.
        #[test]
        fn any_corners_give_triangles(points in prop::collection::vec(prop::array::uniform3(-3..3_i8), 3..30)) {
            let polygon: Vec<DVec3> = points.iter().map(|p| DVec3::from(p.map(f64::from))).collect();
            let triangles = cut(&polygon);
            prop_assert_eq!(triangles.len(), polygon.len() - 2);
            for corner in 0..polygon.len() as u32 {
                prop_assert!(triangles.iter().flatten().any(|&used| used == corner));
            }
        }
    }
}
