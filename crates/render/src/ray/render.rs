//! Rendering of a view, tile by tile.

use oaktwin_base::interrupt;
use std::sync::Arc;

use oaktwin_camera::math::DVec3;
use oaktwin_image::Image;
use oaktwin_scene::Scene;
use oaktwin_simd::run_lanes_at;
use rayon::prelude::*;

use super::single::power_of_two_near;
use super::tile::{Origin, PACKETS, PerRay, RayTable, SIDE, Solve, TileRays, TileState, Trace, place};
use super::{Prepared, Ray, RayCaster, Stack};
use crate::blocks::Blocks;
use crate::{Hit, View};

/// A row of tiles of an image.
struct Band<'a> {
    row: u32,
    z: &'a mut [f32],
    hits: Option<&'a mut [Hit]>,
}

impl RayCaster {
    /// Renders some blocks, or all, into images of misses.
    pub(super) fn render(
        &self,
        scene: &Scene,
        view: &View,
        rendered: Option<&Blocks>,
        z: &mut Image<f32>,
        hits: Option<&mut Image<Hit>>,
    ) {
        let size = view.camera.intrinsics.size;
        let length = (size.width as usize * SIDE as usize).max(1);
        let rays = match rendered {
            Some(_) => Arc::new(RayTable::sparse(view.camera, view.clips_along_axis())),
            None => self.table(view),
        };
        let frame = FrameOfView {
            caster: self,
            scene: self.prepared(scene),
            view,
            rendered,
            rays: &rays,
            origin: self.origin(view),
        };
        let bands = z
            .pixels_mut()
            .par_chunks_mut(length)
            .zip(0..size.height.div_ceil(SIDE));
        match hits {
            Some(hits) => bands.zip(hits.pixels_mut().par_chunks_mut(length)).for_each_init(
                Workspace::new,
                |workspace, ((z, row), hits)| {
                    if interrupt::is_unwanted() {
                        return;
                    }
                    frame.render_band(
                        Band {
                            row,
                            z,
                            hits: Some(hits),
                        },
                        workspace,
                    );
                },
            ),
            None => bands.for_each_init(Workspace::new, |workspace, (z, row)| {
                if interrupt::is_unwanted() {
                    return;
                }
                frame.render_band(Band { row, z, hits: None }, workspace);
            }),
        }
    }

    fn origin(&self, view: &View) -> Origin {
        let point = view.world_from_camera.translation;
        let (min, max) = (self.instances.bounds.min(), self.instances.bounds.max());
        let reach = (0..3).map(|axis| {
            (f64::from(min[axis]) - point[axis])
                .abs()
                .max((f64::from(max[axis]) - point[axis]).abs())
        });
        let extent = reach.fold(0.0, f64::max);
        Origin {
            point,
            camera_from_world: view.world_from_camera.rotation.transpose(),
            scale: power_of_two_near(1.0 / extent.clamp(1e-100, 1e100)),
        }
    }
}

/// The data that all tiles of a view share.
struct FrameOfView<'a> {
    caster: &'a RayCaster,
    scene: Prepared<'a>,
    view: &'a View,
    rendered: Option<&'a Blocks>,
    rays: &'a RayTable,
    origin: Origin,
}

/// The reused memory of a thread.
struct Workspace {
    stack: Stack,
    state: TileState,
    distances: PerRay<f64>,
}

impl Workspace {
    fn new() -> Self {
        Self {
            stack: Stack::default(),
            state: TileState::NONE,
            distances: [[0.0; 8]; PACKETS],
        }
    }
}

impl FrameOfView<'_> {
    fn render_band(&self, mut band: Band, workspace: &mut Workspace) {
        let width = self.view.camera.intrinsics.size.width;
        for column in 0..width.div_ceil(SIDE) {
            if self
                .rendered
                .is_some_and(|blocks| !blocks.contains(column, band.row))
            {
                continue;
            }
            let (rays, directions) = self.rays.tile(column, band.row);
            let trace = Trace {
                scene: &self.scene,
                origin: &self.origin,
                rays: &rays,
                clip: self.view.clip,
                state: &mut workspace.state,
                stack: &mut workspace.stack.entries,
            };
            run_lanes_at(self.caster.level, trace);
            let solve = Solve {
                scene: &self.scene,
                origin: self.origin.point,
                world_from_camera: self.view.world_from_camera.rotation,
                seen: &workspace.state.seen,
                directions: &directions,
                distances: &mut workspace.distances,
            };
            run_lanes_at(self.caster.level, solve);
            self.finish(&rays, &directions, column, &mut band, workspace);
        }
    }

    /// Writes the results of a tile.
    #[allow(clippy::cast_possible_truncation, reason = "depth is float32")]
    fn finish(
        &self,
        rays: &TileRays,
        directions: &PerRay<DVec3>,
        column: u32,
        band: &mut Band,
        workspace: &mut Workspace,
    ) {
        let width = self.view.camera.intrinsics.size.width;
        let clip = self.view.clip;
        for (y, line) in band.z.chunks_exact_mut(width as usize).enumerate() {
            let from = (column * SIDE) as usize;
            for (x, z) in line[from..].iter_mut().take(SIDE as usize).enumerate() {
                let (packet, lane) = place(x, y);
                let direction = directions[packet][lane];
                let z_per_length = f64::from(rays.z_per_length[packet][lane]);
                let instance = workspace.state.seen.instance[packet][lane];
                // A miss in single precision is final, and so is a pixel without a ray; sideways rays are cast below.
                if instance == u32::MAX && (z_per_length > 0.0 || direction.is_nan()) {
                    continue;
                }
                let mut t = workspace.distances[packet][lane];
                let inverse = f64::from(workspace.state.seen.inverse_z[packet][lane])
                    * self.origin.scale
                    * z_per_length;
                // Where the plane is seen almost edge-on the result of single precision is used: it stays on the triangle.
                let error = (t * inverse - 1.0).abs();
                if error.is_nan() || error > 1e-3 {
                    t = 1.0 / inverse;
                }
                let is_within = instance != u32::MAX && t >= clip.near_m && t <= clip.far_m;
                let (t, hit) = if is_within {
                    let slot = workspace.state.seen.triangle[packet][lane];
                    (t, self.scene.hit(instance, slot))
                } else if let Some(found) = self.cast(direction, &mut workspace.stack) {
                    found
                } else {
                    continue;
                };
                *z = (t * direction.z) as f32;
                if let Some(hits) = &mut band.hits {
                    hits[y * width as usize + from + x] = hit;
                }
            }
        }
    }

    /// Casts a single ray.
    #[cold]
    fn cast(&self, direction: DVec3, stack: &mut Stack) -> Option<(f64, Hit)> {
        let ray = Ray {
            origin: self.origin.point,
            direction: self.view.world_from_camera.rotation * direction,
            near: self.view.clip.near_m,
            far: self.view.clip.far_m,
        };
        self.caster.cast(self.scene.scene, ray, stack)
    }
}
