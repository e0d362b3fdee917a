//! The pose of the camera in a frame.

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Camera, PixelPoint, RigidTransform, Usd};
use oaktwin_pipeline::render::{Ray, Renderer, look_at};
use serde::Serialize;

use crate::GenerateError;
use crate::arrange::{Arrangement, Placed, Stage, direction, serialize_pose};
use crate::context::Context;
use crate::random::{Numbers, rotation_around};
use crate::recipe::{CameraRule, Target};

/// Surfaces further away do not count as seen, metres.
const FAR_M: f64 = 20.0;
/// The number of rays across the image that tell how much of it sees something.
const RAYS: [u32; 2] = [16, 10];

/// The drawn pose of a camera.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct DrawnView {
    /// The pose of the camera's body (x forward, y left, z up), metres.
    #[serde(serialize_with = "serialize_pose")]
    pub(crate) world_from_body: RigidTransform,
    /// The number of poses that were rejected.
    rejected: u32,
}

/// The reasons why poses are rejected.
#[derive(Default)]
struct Rejected {
    too_close: u32,
    empty: u32,
    without_objects: u32,
}

/// The search for the pose of one frame.
pub(crate) struct Search<'a> {
    pub(crate) context: &'a Context,
    pub(crate) arrangement: &'a Arrangement,
    pub(crate) stage: &'a Stage,
    /// The camera that must see something, in the body's frame.
    pub(crate) camera: Camera,
    pub(crate) body_from_camera: RigidTransform,
}

impl Search<'_> {
    /// Finds the pose of a frame.
    ///
    /// # Errors
    /// Returns an error if all attempts are rejected.
    pub(crate) fn find(&self, frame: u64) -> Result<DrawnView, GenerateError> {
        let rule = &self.context.file.recipe.camera;
        let mut numbers = self.context.random.numbers("camera", frame);
        let mut rejected = Rejected::default();
        for attempt in 0..rule.attempts {
            let pose = self.draw(rule, &mut numbers, frame)?;
            let Some(world_from_body) = pose else { continue };
            // The poses of a trajectory are the user's.
            if rule.trajectory.is_some() || self.suits(rule, &world_from_body, &mut rejected) {
                return Ok(DrawnView {
                    world_from_body,
                    rejected: attempt,
                });
            }
        }
        Err(GenerateError::NoPlace {
            recipe: self.context.file.path.clone(),
            place: "camera".to_owned(),
            frame,
            problem: format!(
                "no pose in {} attempts: {} closer than clearance_m to a surface or inside an object, {} saw less than \
                 min_coverage, {} saw fewer than min_objects",
                rule.attempts, rejected.too_close, rejected.empty, rejected.without_objects
            ),
            remedy: "widen the place of the camera, or relax these limits".to_owned(),
        })
    }

    /// Draws a pose; `None` if the camera would look along the vertical axis.
    fn draw(
        &self,
        rule: &CameraRule,
        numbers: &mut Numbers,
        frame: u64,
    ) -> Result<Option<RigidTransform>, GenerateError> {
        let base = &self.context.bases[self.arrangement.base];
        let up = base.up();
        let poses = &self.context.trajectory;
        if !poses.is_empty() {
            let at = frame % self.context.file.recipe.frames_per_scene;
            let at = usize::try_from(at).unwrap_or_default() % poses.len();
            return Ok(Some(poses[at].world_from_mount));
        }
        let target = self.target(rule, numbers)?;
        let jitter = [(); 3].map(|()| rule.look_jitter_m * numbers.normal_within(3.0));
        let target = target + DVec3::from(jitter);
        let roll = rule.roll_deg.draw(numbers).to_radians();
        let (eye, target) = match &rule.inside {
            Some(inside) => {
                let at = DVec3::from([numbers.uniform(), numbers.uniform(), numbers.uniform()]);
                let (min, max) = (DVec3::from(inside.min), DVec3::from(inside.max));
                let eye = min + (max - min) * at;
                let tilt = inside.tilt_deg.draw(numbers).to_radians();
                let heading = inside.heading_deg.as_ref();
                let heading = heading.map(|heading| heading.draw(numbers).to_radians());
                (
                    eye,
                    heading.map_or(target, |heading| eye + direction(up, heading, tilt)),
                )
            }
            None => {
                let sphere = rule.sphere.clone().unwrap_or_default();
                let distance = sphere.distance_m.draw(numbers);
                let elevation = sphere.elevation_deg.draw(numbers).to_radians();
                let azimuth = sphere.azimuth_deg.draw(numbers).to_radians();
                (target + direction(up, azimuth, elevation) * distance, target)
            }
        };
        let Ok(pose) = look_at(eye, target, up) else {
            return Ok(None);
        };
        let roll = rotation_around(DVec3::X, roll);
        Ok(Some(RigidTransform::new(pose.rotation * roll, pose.translation)))
    }

    fn target(&self, rule: &CameraRule, numbers: &mut Numbers) -> Result<DVec3, GenerateError> {
        let base = &self.context.bases[self.arrangement.base];
        let name = match &rule.look_at {
            Target::Point(point) => return Ok(DVec3::from(*point)),
            Target::Name(name) => name.as_str(),
        };
        let object = numbers
            .pick(&self.arrangement.objects)
            .map(|object| object.center);
        match name {
            "scene" => Ok(base.bounds.center()),
            "objects" => Ok(object.unwrap_or(base.bounds.center())),
            prim => match base.bounds_of(&[prim.to_owned()]) {
                Some(bounds) => Ok(bounds.center()),
                None => Err(GenerateError::Unfit {
                    recipe: self.context.file.path.clone(),
                    place: "camera.look_at".to_owned(),
                    problem: format!("there is no prim {prim} with triangles in {}", base.name).into(),
                    remedy: "name a prim of the base scene, from the root: /World/Table".into(),
                }),
            },
        }
    }

    /// Whether a pose has a free view of something.
    fn suits(&self, rule: &CameraRule, world_from_body: &RigidTransform, rejected: &mut Rejected) -> bool {
        let world_from_camera = *world_from_body * self.body_from_camera;
        let eye = world_from_camera.translation;
        let base = &self.context.bases[self.arrangement.base];
        let is_near = |object: &Placed| object.is_within(eye, rule.clearance_m);
        if base.distance(eye) < rule.clearance_m
            || base.contains(eye)
            || self.arrangement.objects.iter().any(is_near)
        {
            rejected.too_close += 1;
            return false;
        }
        if self.coverage(&world_from_camera) < rule.min_coverage {
            rejected.empty += 1;
            return false;
        }
        let wanted = (rule.min_objects as usize).min(self.arrangement.objects.len());
        let visible = self.visible_objects(&world_from_camera);
        if visible < wanted {
            rejected.without_objects += 1;
            return false;
        }
        true
    }

    /// Returns the share of the image that sees a surface.
    fn coverage(&self, world_from_camera: &RigidTransform) -> f64 {
        let size = self.camera.intrinsics.size;
        let mut rays = Vec::new();
        for y in 0..RAYS[1] {
            for x in 0..RAYS[0] {
                let at = |place: u32, count: u32, length: u32| {
                    (f64::from(place) + 0.5) / f64::from(count) * f64::from(length)
                };
                let pixel = PixelPoint::<Usd>::new(at(x, RAYS[0], size.width), at(y, RAYS[1], size.height));
                let ray = self.camera.unproject(pixel);
                rays.extend(ray.map(|ray| Ray {
                    origin: world_from_camera.translation,
                    direction: world_from_camera.rotation * ray.normalize(),
                    near: 0.0,
                    far: FAR_M,
                }));
            }
        }
        let hits = self.renderer().cast_rays(&rays).iter().flatten().count();
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let share = hits as f64 / f64::from(RAYS[0] * RAYS[1]);
        share
    }

    /// Returns the number of objects whose centre is in the image and not behind the surface of something else.
    fn visible_objects(&self, world_from_camera: &RigidTransform) -> usize {
        let eye = world_from_camera.translation;
        let camera_from_world = world_from_camera.inverse();
        let size = self.camera.intrinsics.size;
        let objects = self.arrangement.objects.iter().zip(&self.stage.objects);
        let seen = objects.filter(|(object, instances)| {
            let in_camera = camera_from_world.apply(object.center);
            let pixel = self.camera.project(in_camera).map(PixelPoint::to::<Usd>);
            let is_inside = pixel.is_some_and(|pixel| {
                (0.0..f64::from(size.width)).contains(&pixel.x)
                    && (0.0..f64::from(size.height)).contains(&pixel.y)
            });
            if in_camera.z <= 0.0 || !is_inside {
                return false;
            }
            let ray = Ray {
                origin: eye,
                direction: object.center - eye,
                near: 0.0,
                far: 1.0,
            };
            // A ray to the centre of a hollow object may meet nothing.
            self.renderer().cast_rays(&[ray])[0]
                .is_none_or(|(_, hit)| instances.contains(&(hit.instance as usize)))
        });
        seen.count()
    }

    fn renderer(&self) -> &Renderer {
        self.stage.renderer()
    }
}
