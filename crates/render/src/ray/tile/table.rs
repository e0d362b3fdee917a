use std::borrow::Cow;
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Camera, LensModel, PixelPoint, Usd};
use rayon::prelude::*;

use super::rays::{PerRay, SIDE, TileRays, place};

/// The number of cameras whose rays are cached.
const KEPT: usize = 4;

/// The rays of a camera in the camera frame.
#[derive(Debug)]
pub(crate) struct RayTable {
    camera: Camera,
    /// Whether all directions have z = 1 rather than unit length.
    is_flat: bool,
    rays: Rays,
}

#[derive(Debug)]
enum Rays {
    /// An ideal pinhole: x of the directions for each column and y for each row.
    Grid { x: Vec<f64>, y: Vec<f64> },
    /// Other lenses: the rays of each tile.
    Tiles(Vec<(TileRays, PerRay<DVec3>)>),
    /// Other lenses: each tile is computed when it is needed.
    Lens,
}

impl RayTable {
    /// Creates rays of which few tiles are needed, once.
    pub(crate) fn sparse(camera: Camera, is_flat: bool) -> Self {
        if camera.lens == LensModel::Pinhole {
            return Self::new(camera, is_flat);
        }
        Self {
            camera,
            is_flat,
            rays: Rays::Lens,
        }
    }

    fn new(camera: Camera, is_flat: bool) -> Self {
        let size = camera.intrinsics.size;
        let normalized = |x: u32, y: u32| {
            let pixel = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            camera.intrinsics.normalized_from_pixel(pixel)
        };
        let rays = if camera.lens == LensModel::Pinhole {
            Rays::Grid {
                x: (0..size.width).map(|x| normalized(x, 0).x).collect(),
                y: (0..size.height).map(|y| normalized(0, y).y).collect(),
            }
        } else {
            let (columns, rows) = (size.width.div_ceil(SIDE), size.height.div_ceil(SIDE));
            Rays::Tiles(over(columns, rows, |column, row| {
                through_lens(&camera, is_flat, column, row)
            }))
        };
        Self {
            camera,
            is_flat,
            rays,
        }
    }

    /// Returns the rays of the tile in a column and a row of tiles, and their directions in the camera frame, NaN where there is
    /// no ray.
    pub(crate) fn tile(&self, column: u32, row: u32) -> (Cow<'_, TileRays>, Cow<'_, PerRay<DVec3>>) {
        let size = self.camera.intrinsics.size;
        match &self.rays {
            Rays::Grid { x: xs, y: ys } => {
                let directions = in_tile(column, row, (size.width, size.height), |x, y| {
                    DVec3::new(xs[x as usize], ys[y as usize], 1.0)
                });
                (
                    Cow::Owned(TileRays::new(&directions, self.is_flat)),
                    Cow::Owned(directions),
                )
            }
            Rays::Tiles(tiles) => {
                let columns = size.width.div_ceil(SIDE) as usize;
                let (rays, directions) = &tiles[row as usize * columns + column as usize];
                (Cow::Borrowed(rays), Cow::Borrowed(directions))
            }
            Rays::Lens => {
                let (rays, directions) = through_lens(&self.camera, self.is_flat, column, row);
                (Cow::Owned(rays), Cow::Owned(directions))
            }
        }
    }

    /// Returns the direction of the ray through the centre of a pixel, in the camera frame. Its components are NaN where the lens
    /// has no ray. Returns `None` for a pixel outside the image, and for tables that do not store directions.
    #[inline]
    pub(crate) fn direction(&self, x: u32, y: u32) -> Option<DVec3> {
        let size = self.camera.intrinsics.size;
        match &self.rays {
            Rays::Tiles(tiles) if x < size.width && y < size.height => {
                let columns = size.width.div_ceil(SIDE) as usize;
                let (_, directions) = tiles.get((y / SIDE) as usize * columns + (x / SIDE) as usize)?;
                let (packet, lane) = place((x % SIDE) as usize, (y % SIDE) as usize);
                Some(directions[packet][lane])
            }
            _ => None,
        }
    }
}

/// Computes the rays of a tile, whose directions are NaN where the lens has none.
fn through_lens(camera: &Camera, is_flat: bool, column: u32, row: u32) -> (TileRays, PerRay<DVec3>) {
    let size = camera.intrinsics.size;
    let directions = in_tile(column, row, (size.width, size.height), |x, y| {
        let centre = [f64::from(x) + 0.5, f64::from(y) + 0.5];
        ray_through(camera, is_flat, centre).unwrap_or(DVec3::NAN)
    });
    (TileRays::new(&directions, is_flat), directions)
}

/// Returns the ray through a point of the image in pixels, where the centre of the first pixel is at 0.5; `None` where the lens
/// has no ray. It has z = 1 if `is_flat`, else unit length.
pub(crate) fn ray_through(camera: &Camera, is_flat: bool, [x, y]: [f64; 2]) -> Option<DVec3> {
    let ray = camera.unproject(PixelPoint::<Usd>::new(x, y))?;
    Some(if is_flat { ray / ray.z } else { ray })
}

/// Returns the directions of a tile's pixels; NaN outside the image.
fn in_tile(
    column: u32,
    row: u32,
    (width, height): (u32, u32),
    direction: impl Fn(u32, u32) -> DVec3,
) -> PerRay<DVec3> {
    let mut directions = PerRay::default();
    for y in 0..SIDE {
        for x in 0..SIDE {
            let (packet, lane) = place(x as usize, y as usize);
            let (x, y) = (column * SIDE + x, row * SIDE + y);
            directions[packet][lane] = if x < width && y < height {
                direction(x, y)
            } else {
                DVec3::NAN
            };
        }
    }
    directions
}

/// Computes a value for each position, by rows.
#[allow(clippy::cast_possible_truncation, reason = "indices of u32 sizes")]
fn over<T: Send>(width: u32, height: u32, value: impl Fn(u32, u32) -> T + Sync) -> Vec<T> {
    let mut values = Vec::new();
    (0..width as usize * height as usize)
        .into_par_iter()
        .map(|index| {
            let (x, y) = (index % width as usize, index / width as usize);
            value(x as u32, y as u32)
        })
        .collect_into_vec(&mut values);
    values
}

/// The rays of the cameras used last: undistortion is slow, and rays do not depend on the camera pose.
#[derive(Debug, Default)]
pub(crate) struct RayTables(Mutex<Vec<Arc<RayTable>>>);

impl RayTables {
    /// Returns the rays of a camera; `is_flat` if they have z = 1.
    pub(crate) fn get(&self, camera: &Camera, is_flat: bool) -> Arc<RayTable> {
        if camera.lens == LensModel::Pinhole {
            return Arc::new(RayTable::new(*camera, is_flat));
        }
        let known = |tables: &[Arc<RayTable>]| tables.iter().position(|table| table.camera == *camera);
        let mut tables = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(index) = known(&tables) {
            tables[index..].rotate_left(1);
            return Arc::clone(&tables[tables.len() - 1]);
        }
        // Computed outside the lock, at worst twice.
        drop(tables);
        let made = Arc::new(RayTable::new(*camera, is_flat));
        let mut tables = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if known(&tables).is_none() {
            if tables.len() == KEPT {
                tables.remove(0);
            }
            tables.push(Arc::clone(&made));
        }
        made
    }
}
