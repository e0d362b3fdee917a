//! A whole view, tile by tile.

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_image::{Image, ZDepth};
use oaktwin_scene::Scene;
use rayon::prelude::*;

use super::exact::Plane;
use super::single::power_of_two_near;
use super::tile::{Origin, RayTable, SIDE, Seen, TileRays, Trace, place};
use super::{Prepared, Ray, RayCaster, Stack};
use crate::{Hit, View};

/// A row of tiles of an image, by columns and lines.
struct Band<'a> {
    row: u32,
    z: &'a mut [f32],
    hits: Option<&'a mut [Hit]>,
}

impl RayCaster {
    pub(super) fn render(&self, scene: &Scene, view: &View, hits: Option<&mut Image<Hit>>) -> ZDepth {
        let size = view.camera.intrinsics.size;
        let mut z = Image::filled(size.width, size.height, f32::INFINITY);
        let length = (size.width as usize * SIDE as usize).max(1);
        let rays = self.tables.get(&view.camera, view.clips_along_axis());
        let frame = FrameOfView {
            caster: self,
            scene: self.prepared(scene),
            view,
            rays: &rays,
            origin: self.origin(view),
        };
        let bands = z
            .pixels_mut()
            .par_chunks_mut(length)
            .zip(0..size.height.div_ceil(SIDE));
        match hits {
            Some(hits) => bands.zip(hits.pixels_mut().par_chunks_mut(length)).for_each_init(
                Stack::new,
                |stack, ((z, row), hits)| {
                    frame.render_band(
                        Band {
                            row,
                            z,
                            hits: Some(hits),
                        },
                        stack,
                    );
                },
            ),
            None => bands.for_each_init(Stack::new, |stack, (z, row)| {
                frame.render_band(Band { row, z, hits: None }, stack);
            }),
        }
        ZDepth(z)
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

/// All that the tiles of a view have in common.
struct FrameOfView<'a> {
    caster: &'a RayCaster,
    scene: Prepared<'a>,
    view: &'a View,
    rays: &'a RayTable,
    origin: Origin,
}

impl FrameOfView<'_> {
    fn render_band(&self, mut band: Band, stack: &mut Stack) {
        let width = self.view.camera.intrinsics.size.width;
        for column in 0..width.div_ceil(SIDE) {
            let rays = self.rays.tile(column, band.row);
            let seen = self.caster.instructions.run(Trace {
                scene: &self.scene,
                origin: &self.origin,
                rays: &rays,
                clip: self.view.clip,
                stack,
            });
            self.finish(&rays, &seen, column, &mut band, stack);
        }
    }

    /// Finds out exactly how far it is to what the rays see.
    #[allow(clippy::cast_possible_truncation, reason = "depth is float32")]
    fn finish(&self, rays: &TileRays, seen: &Seen, column: u32, band: &mut Band, stack: &mut Stack) {
        let width = self.view.camera.intrinsics.size.width;
        let axis = rays.tile_from_camera.row(2);
        let mut solver = Solver::new(self);
        for (y, line) in band.z.chunks_exact_mut(width as usize).enumerate() {
            for x in 0..SIDE.min(width - column * SIDE) {
                let pixel = column * SIDE + x;
                let (x, at) = (x as usize, pixel as usize);
                let Some(direction) = self.rays.direction(pixel, band.row * SIDE + y as u32) else {
                    continue;
                };
                let (packet, lane) = place(x, y);
                let found = if rays.has(x, y) {
                    let instance = seen.instance[packet][lane];
                    if instance == u32::MAX {
                        continue;
                    }
                    let z_in_tile = 1.0 / (f64::from(seen.inverse_z[packet][lane]) * self.origin.scale);
                    let about = z_in_tile / axis.dot(direction);
                    solver.solve(instance, seen.triangle[packet][lane], direction, about)
                } else {
                    None
                };
                let found = found.or_else(|| self.cast(direction, stack));
                if let Some((t, hit)) = found {
                    line[at] = (t * direction.z) as f32;
                    if let Some(hits) = &mut band.hits {
                        hits[y * width as usize + at] = hit;
                    }
                }
            }
        }
    }

    /// One ray by itself.
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

/// Double precision for triangles that were found; neighbouring pixels often have the same.
struct Solver<'a> {
    frame: &'a FrameOfView<'a>,
    instance: u32,
    slot: u32,
    /// The plane, its normal in the camera's frame.
    plane: Plane,
    triangle: u32,
    origin: DVec3,
    camera_from_normal: DMat3,
}

impl<'a> Solver<'a> {
    fn new(frame: &'a FrameOfView<'a>) -> Self {
        Self {
            frame,
            instance: u32::MAX,
            slot: u32::MAX,
            plane: Plane {
                normal: DVec3::ZERO,
                distance: 0.0,
            },
            triangle: u32::MAX,
            origin: DVec3::ZERO,
            camera_from_normal: DMat3::IDENTITY,
        }
    }

    /// Where a ray meets a triangle, which is about there; `None` where it does not within the clip.
    fn solve(&mut self, instance: u32, slot: u32, direction: DVec3, about: f64) -> Option<(f64, Hit)> {
        if (instance, slot) != (self.instance, self.slot) {
            self.turn_to(instance, slot)?;
        }
        let t = self.plane.meet(direction);
        // Seen all but from the side, single precision decides; it keeps to the triangle.
        let t = if (t - about).abs() <= 1e-3 * about {
            t
        } else {
            about
        };
        let clip = self.frame.view.clip;
        let hit = Hit {
            instance,
            triangle: self.triangle,
        };
        (t >= clip.near_m && t <= clip.far_m).then_some((t, hit))
    }

    fn turn_to(&mut self, instance: u32, slot: u32) -> Option<()> {
        let (mesh, tree, mesh_from_world) = self.frame.scene.instance(instance)?;
        if instance != self.instance {
            self.origin = mesh_from_world.transform_point3(self.frame.origin.point);
            let mesh_from_camera = mesh_from_world.matrix3 * self.frame.view.world_from_camera.rotation;
            self.camera_from_normal = mesh_from_camera.transpose();
        }
        let [a, b, c, triangle] = *tree.triangles.get(slot as usize)?;
        let corners = [a, b, c].map(|index| mesh.positions[index as usize]);
        let plane = Plane::new(corners, self.origin);
        self.plane = Plane {
            normal: self.camera_from_normal * plane.normal,
            distance: plane.distance,
        };
        (self.instance, self.slot, self.triangle) = (instance, slot, triangle);
        Some(())
    }
}
