//! Scenes and cameras in motion, and how far they move in an image.

use oaktwin_camera::math::{DAffine3, DMat3, DQuat, DVec3};
use oaktwin_camera::{OpenCv, PixelPoint, RigidTransform, Usd};
use oaktwin_render::{Backend, Renderer, View};

use super::plan::Timing;
use crate::render::RigError;

/// Every so many pixels in rows and columns are followed.
const STRIDE: u32 = 4;

/// The parts in which a path is measured, of which none is straight enough to be missed by its ends.
const PARTS: u32 = 4;

/// A scene and a rig around the time of a frame.
pub trait Moments {
    /// Goes to a time, s after the frame's own, and returns the scene and the pose of the mount of a camera, by its index in the rig.
    ///
    /// # Errors
    /// Returns an error if the scene cannot be read at this time.
    fn at(&mut self, offset_s: f64, camera: usize) -> Result<(&Renderer, RigidTransform), RigError>;
}

/// The moments of a camera that takes its frames later than others.
pub(in crate::render) struct Later<'a> {
    pub(in crate::render) moments: &'a mut dyn Moments,
    pub(in crate::render) offset_s: f64,
}

impl Moments for Later<'_> {
    fn at(&mut self, offset_s: f64, camera: usize) -> Result<(&Renderer, RigidTransform), RigError> {
        self.moments.at(offset_s + self.offset_s, camera)
    }
}

/// A constant velocity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist {
    /// The velocity in the world, m/s.
    pub velocity: DVec3,
    /// The angular velocity about the axes of the moving body, rad/s.
    pub angular_velocity: DVec3,
}

impl Twist {
    /// Returns where a body is at a time after it was at a pose, s.
    #[must_use]
    pub fn after(&self, pose: &RigidTransform, time_s: f64) -> RigidTransform {
        let turned = DMat3::from_quat(DQuat::from_scaled_axis(self.angular_velocity * time_s));
        RigidTransform::new(pose.rotation * turned, pose.translation + self.velocity * time_s)
    }
}

/// A rig that passes a scene in which nothing moves.
#[derive(Clone, Copy, Debug)]
pub struct Passing<'a> {
    /// The scene.
    pub renderer: &'a Renderer,
    /// The pose of the body at the time of the frame, metres.
    pub world_from_body: RigidTransform,
    /// Its velocity.
    pub twist: Twist,
}

impl Moments for Passing<'_> {
    fn at(&mut self, offset_s: f64, _: usize) -> Result<(&Renderer, RigidTransform), RigError> {
        Ok((self.renderer, self.twist.after(&self.world_from_body, offset_s)))
    }
}

/// A point that moves with an instance, or with the world.
struct Followed {
    instance: usize,
    point: DVec3,
}

/// Returns the longest way that a visible point moves in the image of a camera while it takes a frame, px. The points are those of every
/// fourth pixel in rows and columns at the time of the frame.
pub(super) fn motion_px(
    moments: &mut dyn Moments,
    camera: usize,
    timing: Timing,
    view: &dyn Fn(&RigidTransform) -> View,
) -> Result<f64, RigError> {
    let points = {
        let (renderer, mount) = moments.at(0.0, camera)?;
        points(renderer, &view(&mount))
    };
    let mut before: Vec<Option<PixelPoint<OpenCv>>> = Vec::new();
    let mut ways = vec![0.0f64; points.len()];
    for part in 0..=PARTS {
        let offset_s = timing.span_s() * (f64::from(part) / f64::from(PARTS) - 0.5);
        let (renderer, mount) = moments.at(offset_s, camera)?;
        let view = view(&mount);
        let camera_from_world = view.camera_from_world();
        let instances = &renderer.scene().instances;
        let now: Vec<_> = points
            .iter()
            .map(|followed| {
                let instance = instances.get(followed.instance)?;
                let point = instance.world_from_mesh.transform_point3(followed.point);
                view.camera.project(camera_from_world.transform_point3(point))
            })
            .collect();
        for ((way, before), now) in ways.iter_mut().zip(&before).zip(&now) {
            if let (Some(before), Some(now)) = (before, now) {
                *way += (now.x - before.x).hypot(now.y - before.y);
            }
        }
        before = now;
    }
    // Points beside the camera move without limit.
    let size = moments
        .at(0.0, camera)
        .map(|(_, mount)| view(&mount).camera.intrinsics.size)?;
    let most = f64::from(size.width.max(size.height));
    Ok(ways.into_iter().fold(0.0, f64::max).min(most))
}

/// The points that a view sees, in the frames of their meshes.
fn points(renderer: &Renderer, view: &View) -> Vec<Followed> {
    let seen = renderer.visibility(view, Backend::Auto);
    let (width, height) = (seen.hits.width(), seen.hits.height());
    let world_from_camera = &view.world_from_camera;
    let instances = &renderer.scene().instances;
    let mut points = Vec::new();
    for y in (STRIDE / 2..height).step_by(STRIDE as usize) {
        for x in (STRIDE / 2..width).step_by(STRIDE as usize) {
            let (Some(hit), Some(z)) = (seen.hits.get(x, y), seen.z.0.get(x, y)) else {
                continue;
            };
            let pixel = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let (Some(instance), Some(ray)) = (
                instances.get(hit.instance as usize),
                view.camera.unproject(pixel).filter(|ray| ray.z.abs() > 1e-6),
            ) else {
                continue;
            };
            let point = world_from_camera.apply(ray * (f64::from(*z) / ray.z));
            let mesh_from_world: DAffine3 = instance.world_from_mesh.inverse();
            let point = mesh_from_world.transform_point3(point);
            if point.is_finite() {
                points.push(Followed {
                    instance: hit.instance as usize,
                    point,
                });
            }
        }
    }
    points
}
