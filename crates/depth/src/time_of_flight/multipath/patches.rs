//! The image's surfaces: one patch per cell, and the points where light is gathered.

use oaktwin_simd as simd;

use super::spread::{Normals, Surfaces};
use super::{Grid, MultipathInput, ReceiverPosition};
use crate::time_of_flight::light::{Albedos, InverseDepth};

/// The surface of a cell, in metres in the camera's frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Patch {
    pub(super) point: [f32; 3],
    /// The unit normal towards the camera.
    pub(super) normal: [f32; 3],
    /// The reflected share of the lamp's light per steradian.
    pub(super) flux: f32,
    /// The area, m².
    pub(super) area: f32,
    /// The distance from the lamp, m.
    pub(super) range: f32,
}

/// The memory of one thread for a band of cells.
pub(super) struct Surveyor<'a> {
    view: &'a MultipathInput<'a>,
    grid: Grid,
    columns: &'a [usize],
    rows: &'a [usize],
    inverse: [Vec<f32>; 3],
    albedo: Vec<f32>,
    surfaces: Surfaces,
    sums: Vec<Sum>,
}

/// The sums over a cell's pixels.
#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    point: [f32; 3],
    normal: [f32; 3],
    flux: f32,
    area: f32,
}

impl<'a> Surveyor<'a> {
    pub(super) fn new(
        view: &'a MultipathInput<'a>,
        grid: Grid,
        columns: &'a [usize],
        rows: &'a [usize],
    ) -> Self {
        let width = grid.size[0];
        let mut surfaces = Surfaces::default();
        surfaces.reset(width);
        Self {
            view,
            grid,
            columns,
            rows,
            inverse: [(); 3].map(|()| vec![0.0; width + 2]),
            albedo: vec![view.albedo; width],
            surfaces,
            sums: vec![Sum::default(); width.div_ceil(grid.cell)],
        }
    }

    /// Computes the cells from row `band`·cell.
    pub(super) fn band(mut self, band: usize) -> (Vec<Patch>, Vec<ReceiverPosition>) {
        let first = band * self.grid.cell;
        let last = (first + self.grid.cell).min(self.grid.size[1]);
        let mut found = Vec::new();
        self.inverse(first.checked_sub(1), 0);
        self.inverse(Some(first), 1);
        for y in first..last {
            self.inverse(Some(y + 1), (y + 2 - first) % 3);
            self.survey(y, first);
            if self.rows.binary_search(&y).is_ok() {
                let of = |rows: &[Vec<f32>; 3], x: usize| rows.each_ref().map(|row| row[x]);
                found.extend(self.columns.iter().map(|&x| ReceiverPosition {
                    point: of(&self.surfaces.point, x),
                    normal: of(&self.surfaces.normal, x),
                }));
            }
        }
        (self.sums.iter().filter_map(Sum::patch).collect(), found)
    }

    /// There is no surface beyond the border.
    fn inverse(&mut self, y: Option<usize>, slot: usize) {
        let out = &mut self.inverse[slot];
        let row = y.and_then(|y| self.view.depth.pixels().chunks_exact(self.grid.size[0]).nth(y));
        match row {
            None => out.fill(0.0),
            Some(depth) => simd::run_at(self.view.level, InverseDepth { depth, out }),
        }
    }

    fn survey(&mut self, y: usize, first: usize) {
        let Self { view, grid, .. } = self;
        let start = y * grid.size[0];
        let row = start..start + grid.size[0];
        if let Some(picture) = view.picture {
            simd::run_at(
                view.level,
                Albedos {
                    picture: &picture.pixels()[row.clone()],
                    out: &mut self.albedo,
                },
            );
        }
        let v = view.optics.row(y.cast_signed());
        simd::run_at(
            view.level,
            Normals {
                inverse: [0, 1, 2].map(|k| self.inverse[(y - first + k) % 3].as_slice()),
                depth: &view.depth.pixels()[row],
                focal_length_px: view.optics.focal_length_px,
                u: &view.optics.columns,
                v,
                out: &mut self.surfaces,
            },
        );
        let pixel = 1.0 / (view.optics.focal_length_px * view.optics.focal_length_px);
        let Surfaces {
            point, normal, range, ..
        } = &self.surfaces;
        for (cell, sum) in self.sums.iter_mut().enumerate() {
            let end = ((cell + 1) * grid.cell).min(grid.size[0]);
            for x in cell * grid.cell..end {
                let (p, n) = (
                    point.each_ref().map(|row| row[x]),
                    normal.each_ref().map(|row| row[x]),
                );
                let facing = -(p[0] * n[0] + p[1] * n[1] + p[2] * n[2]);
                if facing > 0.0 {
                    // The ray's length at a depth of 1; the pixel's solid angle is its area there divided by the cube of it.
                    let ray = range[x] / p[2];
                    let flux = self.albedo[x] * pixel / (ray * ray * ray);
                    for k in 0..3 {
                        sum.point[k] += flux * p[k];
                        sum.normal[k] += flux * n[k];
                    }
                    sum.flux += flux;
                    // Ω·r²/cos θ with cos θ = `facing` / r.
                    sum.area += pixel * p[2] * p[2] * p[2] / facing;
                }
            }
        }
    }
}

impl Sum {
    fn patch(&self) -> Option<Patch> {
        let length = |v: [f32; 3]| (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
        let size = length(self.normal);
        (self.flux > 0.0 && size > 0.0).then(|| {
            let point = self.point.map(|sum| sum / self.flux);
            Patch {
                point,
                normal: self.normal.map(|sum| sum / size),
                flux: self.flux,
                area: self.area,
                range: length(point),
            }
        })
    }
}
