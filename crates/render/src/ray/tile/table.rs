use std::sync::{Arc, Mutex, PoisonError};

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Camera, LensModel, PixelPoint, Usd};
use rayon::prelude::*;

use super::rays::{Directions, SIDE, TileRays};

/// So many cameras' rays are kept.
const KEPT: usize = 4;

/// All rays of a camera, in its own frame. Those of an ideal pinhole are made when they are asked for.
#[derive(Debug)]
pub(crate) struct RayTable {
    camera: Camera,
    /// Whether all directions have z = 1; else they are of unit length.
    is_flat: bool,
    tiles: Vec<TileRays>,
    directions: Vec<DVec3>,
}

impl RayTable {
    fn new(camera: Camera, is_flat: bool) -> Self {
        let mut table = Self {
            camera,
            is_flat,
            tiles: Vec::new(),
            directions: Vec::new(),
        };
        if camera.lens != LensModel::Pinhole {
            let size = camera.intrinsics.size;
            table.directions = over(size.width, size.height, |x, y| {
                table.unproject(x, y).unwrap_or(DVec3::NAN)
            });
            let (columns, rows) = (size.width.div_ceil(SIDE), size.height.div_ceil(SIDE));
            table.tiles = over(columns, rows, |column, row| table.make_tile(column, row));
        }
        table
    }

    fn unproject(&self, x: u32, y: u32) -> Option<DVec3> {
        let pixel = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let ray = self.camera.unproject(pixel)?;
        Some(if self.is_flat { ray / ray.z } else { ray })
    }

    /// The direction of a pixel's ray; `None` where it has none.
    pub(crate) fn direction(&self, x: u32, y: u32) -> Option<DVec3> {
        let intrinsics = &self.camera.intrinsics;
        if self.camera.lens == LensModel::Pinhole {
            let pixel = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let direction = intrinsics.normalized_from_pixel(pixel).extend(1.0);
            return direction.is_finite().then_some(direction);
        }
        let index = y as usize * intrinsics.size.width as usize + x as usize;
        self.directions.get(index).copied().filter(|d| !d.is_nan())
    }

    /// The rays of the tile in a column and a row of tiles.
    pub(crate) fn tile(&self, column: u32, row: u32) -> TileRays {
        let columns = self.camera.intrinsics.size.width.div_ceil(SIDE);
        match self.tiles.get(row as usize * columns as usize + column as usize) {
            Some(tile) => tile.clone(),
            None => self.make_tile(column, row),
        }
    }

    fn make_tile(&self, column: u32, row: u32) -> TileRays {
        let size = self.camera.intrinsics.size;
        let mut directions = Directions::default();
        for (y, line) in (row * SIDE..size.height).zip(&mut directions) {
            for (x, direction) in (column * SIDE..size.width).zip(line) {
                *direction = self.direction(x, y);
            }
        }
        TileRays::new(&directions, self.is_flat)
    }
}

/// A value for each place, by rows.
#[allow(clippy::cast_possible_truncation, reason = "of what were u32")]
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

/// The rays of the cameras that were used last: bending them is slow, and where the camera stands does not matter.
#[derive(Debug, Default)]
pub(crate) struct RayTables(Mutex<Vec<Arc<RayTable>>>);

impl RayTables {
    /// Of a camera; `is_flat` if its rays are measured along the optical axis.
    pub(crate) fn get(&self, camera: &Camera, is_flat: bool) -> Arc<RayTable> {
        if camera.lens == LensModel::Pinhole {
            return Arc::new(RayTable::new(*camera, is_flat));
        }
        // Made outside of the lock: at worst twice.
        let known = |tables: &[Arc<RayTable>]| tables.iter().position(|table| table.camera == *camera);
        let mut tables = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(index) = known(&tables) {
            tables[index..].rotate_left(1);
            return Arc::clone(&tables[tables.len() - 1]);
        }
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
