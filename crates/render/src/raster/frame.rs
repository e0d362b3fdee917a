//! The projection of points to pixels and to a grid of fractions of a pixel.

use oaktwin_camera::OpenCv;
use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::Scene;

use crate::View;

/// The constants of a frame.
#[derive(Debug)]
pub(super) struct FrameConstants<'a> {
    pub(super) scene: &'a Scene,
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) near: f64,
    pub(super) far: f64,
    pub(super) grid: Grid,
    camera_from_world: DAffine3,
    pixels_from_camera: DMat3,
}

/// A grid finer than pixels to which vertices are snapped, so that the side of an edge on which a pixel lies is computed
/// exactly in integers, and consistently for the triangles on both sides.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    /// A pixel is 2^bits steps.
    pub(super) bits: u32,
    /// Whether depth may be interpolated between snapped vertices rather than between the original ones.
    pub(super) is_fine: bool,
    /// The maximum distance from a tile's corner of points on the grid, in steps.
    pub(super) limit: f64,
}

impl Grid {
    /// Creates a grid with steps of 2^-25 rad, or coarser if the image is too large for that.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
    fn new(focal: f64, largest_side: u32) -> Self {
        let wanted = (25.0 - focal.log2()).ceil().clamp(8.0, 40.0) as u32;
        let fitting = (29 - largest_side.max(1).ilog2().min(28)).saturating_sub(1);
        // Small triangles are set up with sums of products of (bits + 3)-bit numbers, exact in 53 bits.
        let bits = wanted.min(fitting).min(22);
        Self {
            bits,
            is_fine: bits == wanted,
            // Products of two differences of coordinates fit into 64 bits. In extremely large images no point is on the grid.
            limit: if bits < 8 { -1.0 } else { f64::from(1u32 << 30) },
        }
    }

    /// Returns the number of steps in a pixel.
    pub(super) fn steps(self) -> f64 {
        f64::from(1u32 << self.bits)
    }
}

impl<'a> FrameConstants<'a> {
    pub(super) fn new(scene: &'a Scene, view: &View) -> Self {
        let k = &view.camera.intrinsics;
        let centre = k.principal_point::<OpenCv>();
        Self {
            scene,
            width: k.size.width,
            height: k.size.height,
            near: view.clip.near_m,
            far: view.clip.far_m,
            grid: Grid::new(k.fx.min(k.fy), k.size.width.max(k.size.height)),
            camera_from_world: view.camera_from_world(),
            // In OpenCV's convention pixel centres are integers, as on the grid.
            pixels_from_camera: DMat3::from_cols(
                DVec3::new(k.fx, 0.0, 0.0),
                DVec3::new(0.0, k.fy, 0.0),
                DVec3::new(centre.x, centre.y, 1.0),
            ),
        }
    }

    /// Returns the projection of an instance onto the image.
    pub(super) fn projection(&self, instance: u32) -> Option<Projection> {
        let placed = self.scene.instances.get(instance as usize)?;
        let camera_from_mesh = self.camera_from_world * placed.world_from_mesh;
        let linear = self.pixels_from_camera * camera_from_mesh.matrix3;
        let offset = self.pixels_from_camera * camera_from_mesh.translation;
        let row = |axis: usize| {
            let m = linear.row(axis);
            [m.x, m.y, m.z, offset[axis]]
        };
        Some(Projection {
            u: row(0),
            v: row(1),
            z: row(2),
        })
    }
}

/// A projection from the mesh frame to `(u, v, z)`: z-depth in metres, and z times the image coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    pub(super) u: [f64; 4],
    pub(super) v: [f64; 4],
    pub(super) z: [f64; 4],
}

impl Projection {
    /// Returns the projection onto the grid of a tile whose first pixel is `(x, y)`.
    pub(super) fn on_tile(&self, grid: Grid, x: u32, y: u32) -> Self {
        let onto = |row: [f64; 4], first: u32| {
            std::array::from_fn(|i| (row[i] - f64::from(first) * self.z[i]) * grid.steps())
        };
        Self {
            u: onto(self.u, x),
            v: onto(self.v, y),
            z: self.z,
        }
    }

    #[inline(always)]
    pub(super) fn apply(&self, [x, y, z]: [f32; 3]) -> [f64; 3] {
        let (x, y, z) = (f64::from(x), f64::from(y), f64::from(z));
        [self.u, self.v, self.z].map(|row| row[0] * x + row[1] * y + row[2] * z + row[3])
    }
}
