use oaktwin_camera::math::{DMat3, DVec3};

/// A tile's width and height, px.
pub(crate) const SIDE: u32 = 8;
/// Packets in a tile: each of eight rays, four wide and two high.
pub(crate) const PACKETS: usize = 8;

/// A value for each ray of a tile, packet by packet.
pub(crate) type PerRay<T> = [[T; 8]; PACKETS];

/// The rays of a tile.
#[derive(Clone, Debug)]
pub(crate) struct TileRays {
    /// The tile's frame: its z axis runs through the middle of the tile.
    pub(crate) tile_from_camera: DMat3,
    /// Where each ray meets the plane z = 1 of the tile's frame.
    pub(crate) u: PerRay<f32>,
    pub(crate) v: PerRay<f32>,
    /// How far in z each ray comes with one length of its direction.
    pub(crate) z_per_length: PerRay<f32>,
    /// Which rays there are, a bit each.
    pub(crate) present: [u8; PACKETS],
}

/// The directions of a tile's rays, by rows.
pub(crate) type Directions = [[Option<DVec3>; SIDE as usize]; SIDE as usize];

/// The packet and the lane of a pixel of a tile.
pub(crate) fn place(x: usize, y: usize) -> (usize, usize) {
    (y / 2 * 2 + x / 4, y % 2 * 4 + x % 4)
}

impl TileRays {
    /// Of the directions in the camera's frame; `None` where there is no ray. In the camera's own frame if
    /// `is_flat`, which is right where all directions have z = 1.
    #[allow(clippy::cast_possible_truncation, reason = "of 1e-8 of a pixel")]
    pub(crate) fn new(directions: &Directions, is_flat: bool) -> Self {
        let tile_from_camera = if is_flat {
            DMat3::IDENTITY
        } else {
            frame_along(directions.iter().flatten().flatten().copied().sum())
        };
        let mut rays = Self {
            tile_from_camera,
            u: [[0.0; 8]; PACKETS],
            v: [[0.0; 8]; PACKETS],
            z_per_length: [[1.0; 8]; PACKETS],
            present: [0; PACKETS],
        };
        for (y, row) in directions.iter().enumerate() {
            for (x, direction) in row.iter().enumerate() {
                let Some(direction) = direction else { continue };
                let (packet, lane) = place(x, y);
                let in_tile = if is_flat {
                    *direction
                } else {
                    tile_from_camera * *direction
                };
                // What looks sideways is no part of the tile.
                if in_tile.z <= 0.1 * direction.length() && !is_flat {
                    continue;
                }
                rays.u[packet][lane] = (in_tile.x / in_tile.z) as f32;
                rays.v[packet][lane] = (in_tile.y / in_tile.z) as f32;
                rays.z_per_length[packet][lane] = in_tile.z as f32;
                rays.present[packet] |= 1 << lane;
            }
        }
        rays
    }

    /// Whether the ray of a pixel is among them.
    pub(crate) fn has(&self, x: usize, y: usize) -> bool {
        let (packet, lane) = place(x, y);
        self.present[packet] >> lane & 1 == 1
    }
}

/// A frame whose z axis is along a direction and whose x axis is near the camera's.
fn frame_along(direction: DVec3) -> DMat3 {
    let z = direction.normalize_or(DVec3::Z);
    let x = if z.x.abs() < 0.99 { DVec3::X } else { DVec3::NEG_Z };
    let y = z.cross(x).normalize();
    DMat3::from_cols(y.cross(z), y, z).transpose()
}
