//! Lines of sight from a camera to points.

use oaktwin_camera::Usd;
use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_pipeline::render::{Renderer, View};
use oaktwin_render::{Hit, Ray};
use rayon::prelude::*;

use super::SurfacePoint;

/// The relative distance before a point within which a surface counts as the point's own, because faces coincide.
const COINCIDENT: f64 = 1e-6;

/// A view from which points are sighted.
pub(super) struct Sight {
    pub(super) view: View,
    pub(super) camera_from_world: DAffine3,
}

/// The line of sight to a point inside the image.
pub(super) struct SightLine {
    ray: Ray,
    pub(super) point_in_camera: DVec3,
    pub(super) pixel: (u32, u32),
    /// The surface that hides the point.
    pub(super) obstacle: Option<Hit>,
}

impl SightLine {
    /// The unit direction towards the camera.
    pub(super) fn backwards(&self) -> DVec3 {
        -self.ray.direction.normalize_or_zero()
    }
}

impl Sight {
    pub(super) fn new(view: View) -> Self {
        Self {
            view,
            camera_from_world: view.camera_from_world(),
        }
    }

    /// Returns the line of sight to each point; `None` for points outside the view.
    pub(super) fn lines(&self, renderer: &Renderer, points: &[SurfacePoint]) -> Vec<Option<SightLine>> {
        let mut lines: Vec<Option<SightLine>> = points.par_iter().map(|point| self.line(point)).collect();
        let rays: Vec<Ray> = lines.iter().flatten().map(|line| line.ray).collect();
        let mut hits = renderer.cast_rays(&rays).into_iter();
        for (line, point) in lines.iter_mut().zip(points) {
            let Some(line) = line else { continue };
            let own = (point.instance, point.triangle);
            let hit = hits.next().flatten();
            let obstacle =
                hit.filter(|(t, hit)| *t < 1.0 - COINCIDENT && (hit.instance, hit.triangle) != own);
            line.obstacle = obstacle.map(|(_, hit)| hit);
        }
        lines
    }

    /// Returns the line of sight to a point as if nothing hid it.
    fn line(&self, point: &SurfacePoint) -> Option<SightLine> {
        let camera = &self.view.camera;
        let point_in_camera = self.camera_from_world.transform_point3(point.position);
        let at = camera.project(point_in_camera)?.to::<Usd>();
        let size = camera.intrinsics.size;
        let is_inside =
            (0.0..f64::from(size.width)).contains(&at.x) && (0.0..f64::from(size.height)).contains(&at.y);
        let extent = if self.view.clips_along_axis() {
            point_in_camera.z
        } else {
            point_in_camera.length()
        };
        let clip = self.view.clip;
        if !is_inside || !(clip.near_m..=clip.far_m).contains(&extent) {
            return None;
        }
        let origin = self.view.world_from_camera.translation;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "inside the image"
        )]
        let pixel = (at.x as u32, at.y as u32);
        Some(SightLine {
            ray: Ray {
                origin,
                direction: point.position - origin,
                near: clip.near_m / extent,
                far: 1.0,
            },
            point_in_camera,
            pixel,
            obstacle: None,
        })
    }
}
