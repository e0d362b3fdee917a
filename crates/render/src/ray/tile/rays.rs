use oaktwin_camera::math::{DMat3, DVec3};

use crate::blocks::BLOCK;

/// The width and height of a tile, px.
pub(crate) const SIDE: u32 = BLOCK;
/// The number of packets in a tile; each has eight rays, four wide and two high.
pub(crate) const PACKETS: usize = 8;

/// One value for each ray of a tile, by packet.
pub(crate) type PerRay<T> = [[T; 8]; PACKETS];

/// The rays of a tile.
#[derive(Clone, Debug)]
pub(crate) struct TileRays {
    /// The tile frame, whose z axis runs through the middle of the tile.
    pub(crate) tile_from_camera: DMat3,
    /// The point where each ray meets the plane z = 1 of the tile frame.
    pub(crate) u: PerRay<f32>,
    pub(crate) v: PerRay<f32>,
    /// The z component of each ray's direction in the tile frame; 0 where there is no ray.
    pub(crate) z_per_length: PerRay<f32>,
    /// The range of u and v of each packet's rays, with a margin for rounding at the edges of triangles; inverted where there
    /// are no rays.
    pub(crate) packets: Range<[f32; 8]>,
    /// The range of all rays.
    pub(crate) all: Range<f32>,
    /// The square of the maximum angle between an edge and the direction to it for which single precision may displace the edge
    /// by more than 0.01 px.
    pub(crate) needle: f32,
}

/// The largest such angle.
pub(crate) const MAX_NEEDLE: f32 = 1.0 / 32.0;

/// The maximum rounding error of the normal of a plane through the origin and an edge, in products of the lengths of the edge and to
/// its ends.
const SIDE_ERROR: f32 = 4e-7;

/// Minimum and maximum.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Range<T> {
    pub(crate) u: [T; 2],
    pub(crate) v: [T; 2],
}

/// Returns the packet and the lane of a pixel of a tile.
#[inline]
pub(crate) const fn place(x: usize, y: usize) -> (usize, usize) {
    (y / 2 * 2 + x / 4, y % 2 * 4 + x % 4)
}

impl TileRays {
    pub(crate) const NONE: Self = Self {
        tile_from_camera: DMat3::IDENTITY,
        u: [[0.0; 8]; PACKETS],
        v: [[0.0; 8]; PACKETS],
        z_per_length: [[0.0; 8]; PACKETS],
        packets: Range {
            u: [[f32::INFINITY; 8], [f32::NEG_INFINITY; 8]],
            v: [[f32::INFINITY; 8], [f32::NEG_INFINITY; 8]],
        },
        all: Range {
            u: [f32::INFINITY, f32::NEG_INFINITY],
            v: [f32::INFINITY, f32::NEG_INFINITY],
        },
        needle: 0.0,
    };

    /// Creates a tile from directions in the camera frame, by packet, NaN where there is no ray. With `is_flat`, for
    /// directions with z = 1, the tile frame is the camera frame.
    #[allow(clippy::cast_possible_truncation, reason = "rounds by less than 1e-4 px")]
    pub(crate) fn new(directions: &PerRay<DVec3>, is_flat: bool) -> Self {
        let mut rays = Self::NONE;
        if !is_flat {
            let sum = directions.iter().flatten().filter(|d| !d.is_nan()).copied().sum();
            rays.tile_from_camera = frame_along(sum);
        }
        for (packet, directions) in directions.iter().enumerate() {
            for (lane, direction) in directions.iter().enumerate() {
                let in_tile = rays.tile_from_camera * *direction;
                // Rays that point sideways are not part of the tile.
                let is_seen = is_flat || in_tile.z > 0.1 * direction.length();
                let [u, v] = [in_tile.x / in_tile.z, in_tile.y / in_tile.z].map(|x| x as f32);
                if !(is_seen && u.is_finite() && v.is_finite()) {
                    continue;
                }
                rays.u[packet][lane] = u;
                rays.v[packet][lane] = v;
                rays.z_per_length[packet][lane] = in_tile.z as f32;
                for (range, at) in [(&mut rays.packets.u, u), (&mut rays.packets.v, v)] {
                    range[0][packet] = range[0][packet].min(at);
                    range[1][packet] = range[1][packet].max(at);
                }
            }
        }
        let mut widest = 0f32;
        for (packets, all) in [
            (&mut rays.packets.u, &mut rays.all.u),
            (&mut rays.packets.v, &mut rays.all.v),
        ] {
            let low = packets[0].into_iter().fold(f32::INFINITY, f32::min);
            let high = packets[1].into_iter().fold(f32::NEG_INFINITY, f32::max);
            if low <= high {
                widest = widest.max(high - low);
                let slack = (high - low) / 256.0 + 2e-6 * (1.0 + low.abs().max(high.abs()));
                *all = [low - slack, high + slack];
                *packets = [packets[0].map(|x| x - slack), packets[1].map(|x| x + slack)];
            }
        }
        let hundredth_px = widest / (100.0 * (SIDE - 1) as f32);
        rays.needle = (SIDE_ERROR / hundredth_px).min(MAX_NEEDLE).powi(2);
        rays
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.all.u[0] > self.all.u[1]
    }
}

/// Returns a frame whose z axis is along a direction and whose x axis is close to the camera's.
fn frame_along(direction: DVec3) -> DMat3 {
    let z = direction.normalize_or(DVec3::Z);
    let x = if z.x.abs() < 0.99 { DVec3::X } else { DVec3::NEG_Z };
    let y = z.cross(x).normalize();
    DMat3::from_cols(y.cross(z), y, z).transpose()
}
