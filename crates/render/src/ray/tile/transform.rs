use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_simd::Lanes;

use super::rays::Range;
use crate::ray::bvh::{Bounds, Node};
use crate::ray::vector::Vector;

/// The transform from the frame of a mesh, or the world, into a tile frame: `tile_from_frame · (point − coarse − fine)`.
#[derive(Clone, Debug)]
pub(super) struct TileTransform {
    pub(super) tile_from_frame: [[f32; 3]; 3],
    /// The origin of the rays in two parts.
    pub(super) coarse: [f32; 3],
    pub(super) fine: [f32; 3],
    /// The axes and the origin in double precision.
    exact: (DMat3, DVec3),
    /// The four sides of the tile's frustum, positive inside, and the plane of depth.
    sides: [Plane; 4],
    depth: Plane,
}

/// An upper bound of `normal · point − offset`.
#[derive(Clone, Copy, Debug)]
struct Plane {
    normal: [f32; 3],
    offset: f32,
    /// The planes of a node's box at the corner farthest along the normal.
    farthest: [usize; 3],
}

impl TileTransform {
    /// Creates the transform; `None` if the bounds or the origin are not finite.
    #[allow(
        clippy::cast_possible_truncation,
        reason = "the remainder is kept or within the slack"
    )]
    pub(super) fn new(
        tile_from_world: &DMat3,
        origin_in_frame: DVec3,
        world_from_frame: &DAffine3,
        bounds: &Bounds,
        extent: &Range<f32>,
    ) -> Option<Self> {
        let tile_from_frame = *tile_from_world * world_from_frame.matrix3;
        if !(bounds.is_finite() && origin_in_frame.is_finite()) {
            return None;
        }
        let frame_from_normal = tile_from_frame.transpose();
        let plane =
            |normal_in_tile: DVec3| Plane::new(frame_from_normal * normal_in_tile, origin_in_frame, bounds);
        let [[u0, u1], [v0, v1]] = [extent.u, extent.v].map(|range| range.map(f64::from));
        let coarse = origin_in_frame.to_array().map(|x| x as f32);
        let rows = tile_from_frame.transpose().to_cols_array_2d();
        Some(Self {
            tile_from_frame: rows.map(|row| row.map(|x| x as f32)),
            coarse,
            exact: (tile_from_frame, origin_in_frame),
            fine: std::array::from_fn(|i| (origin_in_frame[i] - f64::from(coarse[i])) as f32),
            sides: [
                plane(DVec3::new(1.0, 0.0, -u0)),
                plane(DVec3::new(-1.0, 0.0, u1)),
                plane(DVec3::new(0.0, 1.0, -v0)),
                plane(DVec3::new(0.0, -1.0, v1)),
            ],
            depth: plane(DVec3::NEG_Z),
        })
    }

    /// Returns the mask of a node's children that the tile may see in front of `limit`, and the minimum z of each.
    #[inline(always)]
    pub(super) fn children<L: Lanes>(&self, node: &Node, limit: f32) -> (L::I32, L) {
        let zero = L::splat(0.0);
        let nearest = zero - self.depth.farthest::<L>(node);
        let mut seen = nearest.le(L::splat(limit));
        for side in &self.sides {
            seen = seen & zero.le(side.farthest::<L>(node));
        }
        (seen, nearest)
    }

    /// Transforms a point into the tile frame in double precision.
    pub(super) fn transform_exactly(&self, point: DVec3) -> DVec3 {
        let (tile_from_frame, origin) = &self.exact;
        *tile_from_frame * (point - *origin)
    }

    /// Transforms eight points into the tile frame.
    #[inline(always)]
    pub(super) fn transform<L: Lanes>(&self, point: Vector<L>) -> Vector<L> {
        let from_origin = point - Vector::splat(self.coarse) - Vector::splat(self.fine);
        let [x, y, z] = self.tile_from_frame;
        Vector {
            x: from_origin.dot(Vector::splat(x)),
            y: from_origin.dot(Vector::splat(y)),
            z: from_origin.dot(Vector::splat(z)),
        }
    }
}

impl Plane {
    #[allow(clippy::cast_possible_truncation, reason = "within the slack")]
    fn new(normal: DVec3, origin: DVec3, bounds: &Bounds) -> Self {
        let (min, max) = (bounds.min(), bounds.max());
        let reach = |axis: usize| f64::from(min[axis].abs().max(max[axis].abs())) + origin[axis].abs();
        let largest: f64 = (0..3).map(|axis| normal[axis].abs() * reach(axis)).sum();
        Self {
            normal: normal.to_array().map(|x| x as f32),
            // The slack is eight times the rounding error.
            offset: (normal.dot(origin) - 1e-6 * largest) as f32,
            farthest: std::array::from_fn(|axis| if normal[axis] > 0.0 { axis + 3 } else { axis }),
        }
    }

    /// Returns the maximum in each child.
    #[inline(always)]
    fn farthest<L: Lanes>(&self, node: &Node) -> L {
        let [x, y, z] = self.farthest;
        let corner = Vector {
            x: L::load(&node.bounds[x]),
            y: L::load(&node.bounds[y]),
            z: L::load(&node.bounds[z]),
        };
        corner.dot(Vector::splat(self.normal)) - L::splat(self.offset)
    }
}
