//! The lights of a scene and the exposure.

use glam::Vec3;
use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_scene::{Light, LightKind, Mesh, Scene};
use rayon::prelude::*;

use super::dome::DomeImage;
use super::harmonics::Harmonics;
use super::lamp::{Lamp, LampShape};
use super::pattern::{Hemisphere, Pattern, Spot};
use crate::ray::{Ray, RayCaster, Stack};

/// Indirect light, as a share of the typical irradiance; it is uniform over directions.
const BOUNCE: f32 = 0.22;

/// The light of a white surface in typical light, in the exposure of the scene and before the tone curve.
pub const WHITE: f32 = 0.8;

/// The maximum number of exposure probes.
const MAX_PROBES: usize = 1024;

/// The lights of a scene, and an exposure that depends on them but not on the view, so that both images of a stereo pair and
/// all images of a trajectory are exposed equally.
///
/// # Exposure
/// Probes at the centroids of at most 1024 triangles, spread evenly over the instances, measure the irradiance from lamps and
/// sky, including shadows, of a surface that faces the lamps, on the brighter side. A white diffuse surface with the median
/// irradiance of the lit probes has the value 0.8 before the tone curve.
///
/// # Lights
/// The radiance of a distant light is used as its irradiance, regardless of its angle and normalization: Isaac Sim's own
/// templates light a stage with a dome of 1000 and a distant light of 3000, which is balanced only in that interpretation.
///
/// A scene without lights gets a pale sky, brighter above, that only nearby surfaces occlude, and a key light from above at one
/// side.
#[derive(Debug)]
pub(super) struct LightRig {
    /// All lights except domes.
    pub(super) lamps: Vec<Lamp>,
    /// Light from infinity, which any surface occludes.
    pub(super) sky: Harmonics,
    pub(super) has_sky: bool,
    /// Ambient light, which only nearby surfaces occlude.
    pub(super) ambient: Harmonics,
    /// The maximum distance of surfaces that occlude ambient light, metres.
    pub(super) reach: f64,
    /// The factor of radiance.
    pub(super) exposure: f32,
    backdrop: Backdrop,
    pub(super) findings: Vec<Finding>,
}

/// The background.
#[derive(Debug)]
struct Backdrop {
    plain: Vec3,
    slope: Vec3,
    up: Vec3,
    domes: Vec<DomeImage>,
}

impl LightRig {
    pub(super) fn new(scene: &Scene, caster: &RayCaster, pattern: &Pattern) -> Self {
        let up = scene.up.direction().as_vec3();
        let mut rig = Self {
            lamps: Vec::new(),
            sky: Harmonics::default(),
            has_sky: false,
            ambient: Harmonics::default(),
            reach: reach(scene),
            exposure: 1.0,
            backdrop: Backdrop {
                plain: Vec3::ZERO,
                slope: Vec3::ZERO,
                up,
                domes: Vec::new(),
            },
            findings: Vec::new(),
        };
        for light in &scene.lights {
            rig.add(scene, light);
        }
        let irradiance = rig.typical_irradiance(scene, caster, pattern);
        if irradiance > 0.0 && irradiance.is_finite() {
            rig.ambient = Harmonics::uniform(Vec3::splat(BOUNCE * irradiance / std::f32::consts::PI));
            rig.exposure = WHITE * std::f32::consts::PI / irradiance;
            return rig;
        }
        rig.light_a_dark_scene(up);
        rig
    }

    /// Returns the exposed radiance of the background.
    pub(super) fn background(&self, direction: DVec3) -> Vec3 {
        let backdrop = &self.backdrop;
        let slope = backdrop.slope * backdrop.up.dot(direction.as_vec3());
        let domes = backdrop.domes.iter().map(|dome| dome.radiance(direction));
        (backdrop.plain + slope + domes.fold(Vec3::ZERO, |sum, radiance| sum + radiance)) * self.exposure
    }

    /// Returns the luminance that a surface with a normal receives from its unoccluded surroundings, and from an open sky.
    pub(super) fn around(&self, normal: Vec3) -> [f32; 2] {
        [&self.ambient, &self.sky].map(|light| luminance(light.mean_by_cosine(normal)) * std::f32::consts::PI)
    }

    fn add(&mut self, scene: &Scene, light: &Light) {
        let radiance = Vec3::from(light.radiance);
        if !(radiance.is_finite() && radiance.max_element() > 0.0) {
            return;
        }
        if let LightKind::Dome { texture } = light.kind {
            self.has_sky = true;
            let texture = texture.and_then(|index| scene.textures.get(index as usize));
            match texture.map(|texture| DomeImage::new(texture, radiance, light.world_from_light)) {
                Some(Ok(dome)) => {
                    self.sky = self.sky.plus(&dome.harmonics());
                    self.backdrop.domes.push(dome);
                    return;
                }
                Some(Err(finding)) => self.findings.push(finding),
                None => {}
            }
            self.sky = self.sky.plus(&Harmonics::uniform(radiance));
            self.backdrop.plain += radiance;
            return;
        }
        let lamp = lamp(light, radiance, scene.meters_per_unit.0, scene.up.direction());
        let number = self.lamps.len();
        self.lamps.extend(lamp.map(|lamp| Lamp { number, ..lamp }));
    }

    /// Returns the median irradiance of the lit probes; see [`LightRig`].
    fn typical_irradiance(&self, scene: &Scene, caster: &RayCaster, pattern: &Pattern) -> f32 {
        let mut found: Vec<f32> = exposure_probes(scene)
            .into_par_iter()
            .map_init(Stack::default, |stack, sides| {
                stack.forget();
                sides
                    .map(|side| self.irradiance_at(scene, caster, pattern, &side, stack))
                    .into_iter()
                    .fold(0.0, f32::max)
            })
            .filter(|irradiance| *irradiance > 0.0 && irradiance.is_finite())
            .collect();
        let at = found.len() / 2;
        found.sort_by(f32::total_cmp);
        found.get(at).copied().unwrap_or(0.0)
    }

    fn irradiance_at(
        &self,
        scene: &Scene,
        caster: &RayCaster,
        pattern: &Pattern,
        probe: &ExposureProbe,
        stack: &mut Stack,
    ) -> f32 {
        let mut sum = 0.0;
        for lamp in &self.lamps {
            let irradiance = luminance(lamp.irradiance_at(probe.point));
            let (direction, ends) = lamp.shape.towards(probe.point, Spot::default());
            let ray = Ray {
                origin: probe.point,
                direction,
                near: 0.0,
                far: if ends { 0.999 } else { f64::INFINITY },
            };
            let faces = direction.dot(probe.normal) > 0.0;
            if irradiance > 0.0 && faces && !caster.is_shadowed(scene, ray, 0, stack) {
                sum += irradiance;
            }
        }
        if self.has_sky {
            let around = Hemisphere::new(probe.normal);
            let open = Pattern::FEW.iter().filter(|index| {
                let ray = Ray {
                    origin: probe.point,
                    direction: pattern.direction(**index, &around),
                    near: 0.0,
                    far: f64::INFINITY,
                };
                !caster.is_shadowed(scene, ray, 0, stack)
            });
            #[expect(clippy::cast_precision_loss, reason = "a small count")]
            let share = open.count() as f32 / Pattern::FEW.len() as f32;
            let radiance = luminance(self.sky.mean_by_cosine(probe.normal.as_vec3()));
            sum += share * radiance * std::f32::consts::PI;
        }
        sum
    }

    fn light_a_dark_scene(&mut self, up: Vec3) {
        let side = if up.z > 0.5 {
            Vec3::new(-0.7, -0.35, 0.0)
        } else {
            Vec3::new(-0.7, 0.0, 0.35)
        };
        let towards = (up + side).normalize();
        self.lamps = vec![Lamp {
            shape: LampShape::distant(towards.as_dvec3(), 0.03),
            number: 0,
            radiance: Vec3::new(1.0, 0.97, 0.92) * 2.7,
        }];
        let (plain, slope) = (Vec3::new(0.36, 0.38, 0.4), Vec3::new(0.14, 0.15, 0.17));
        self.ambient = Harmonics::uniform(plain).with_slope(slope, up);
        self.backdrop.plain = plain;
        self.backdrop.slope = slope;
        self.exposure = 1.0;
    }
}

/// Returns the Rec. 709 luminance.
#[inline]
pub(super) fn luminance(rgb: Vec3) -> f32 {
    rgb.dot(Vec3::new(0.2126, 0.7152, 0.0722))
}

fn lamp(light: &Light, radiance: Vec3, metres_per_unit: f64, up: DVec3) -> Option<Lamp> {
    let frame: DAffine3 = light.world_from_light;
    let forward = frame.transform_vector3(DVec3::NEG_Z).try_normalize()?;
    let area = |u: DVec3, v: DVec3, round: bool| {
        let across = u.cross(v).try_normalize()?;
        let normal = if across.dot(forward) < 0.0 {
            -across
        } else {
            across
        };
        Some(LampShape::Area {
            centre: frame.translation,
            u,
            v,
            normal,
            round,
        })
    };
    let along = |axis: DVec3, half: f32| frame.transform_vector3(axis * f64::from(half));
    let shape = match light.kind {
        LightKind::Distant { angle } => LampShape::distant(-forward, f64::from(angle)),
        LightKind::Dome { .. } => return None,
        LightKind::Sphere { radius } => LampShape::Sphere {
            centre: frame.translation,
            radius: along(DVec3::X, radius).length(),
            up,
        },
        LightKind::Rect { width, height } => {
            area(along(DVec3::X, width * 0.5), along(DVec3::Y, height * 0.5), false)?
        }
        LightKind::Disk { radius } => area(along(DVec3::X, radius), along(DVec3::Y, radius), true)?,
    };
    let mut radiance = radiance;
    if light.normalize
        && let Some(square_metres) = shape.surface()
    {
        #[expect(clippy::cast_possible_truncation, reason = "light is float32")]
        let square_units = (square_metres / (metres_per_unit * metres_per_unit)) as f32;
        radiance /= square_units;
    }
    (radiance.is_finite()).then_some(Lamp {
        shape,
        number: 0,
        radiance,
    })
}

/// A point where irradiance is measured.
struct ExposureProbe {
    point: DVec3,
    normal: DVec3,
}

/// Returns probes at the centroids of some triangles, slightly offset to both sides.
fn exposure_probes(scene: &Scene) -> Vec<[ExposureProbe; 2]> {
    let step = scene.instances.len().div_ceil(MAX_PROBES).max(1);
    let each = (MAX_PROBES / scene.instances.len().max(1)).clamp(1, 8);
    let mut found = Vec::new();
    for instance in scene.instances.iter().step_by(step) {
        let Some(mesh) = scene.meshes.get(instance.mesh as usize) else {
            continue;
        };
        let world_from_mesh = instance.world_from_mesh;
        let picked = each.min(mesh.triangles.len());
        for i in 0..picked {
            let Some(corners) = mesh.corners((2 * i + 1) * mesh.triangles.len() / (2 * picked)) else {
                continue;
            };
            let [a, b, c] = corners.map(|p| world_from_mesh.transform_point3(DVec3::from(p.map(f64::from))));
            let across = (b - a).cross(c - a);
            if let Some(normal) = across.try_normalize() {
                let off = 1e-3 * across.length().sqrt();
                found.push([normal, -normal].map(|normal| ExposureProbe {
                    point: (a + b + c) / 3.0 + normal * off,
                    normal,
                }));
            }
        }
    }
    found
}

/// Returns the diagonal of a mesh's bounding box in its own frame; `None` if it has no vertices.
fn diagonal(mesh: &Mesh) -> Option<DVec3> {
    // A sample of the vertices suffices for large meshes.
    let step = mesh.positions.len().div_ceil(4096).max(1);
    (mesh.positions.iter().step_by(step))
        .map(|p| DVec3::from(p.map(f64::from)))
        .map(|p| [p, p])
        .reduce(|[low, high], [p, _]| [low.min(p), high.max(p)])
        .map(|[low, high]| high - low)
}

/// Returns the range of ambient occlusion: half a metre, or half the 90th percentile of the instances' sizes if that is less.
fn reach(scene: &Scene) -> f64 {
    let step = scene.instances.len().div_ceil(MAX_PROBES).max(1);
    let mut sizes: Vec<f64> = (scene.instances.iter().step_by(step))
        .filter_map(|instance| {
            let diagonal = diagonal(scene.meshes.get(instance.mesh as usize)?)?;
            Some(instance.world_from_mesh.transform_vector3(diagonal).length())
        })
        .filter(|size| size.is_finite())
        .collect();
    sizes.sort_by(f64::total_cmp);
    let large = sizes.get(sizes.len() * 9 / 10).copied().unwrap_or(4.0);
    (large / 2.0).min(0.5)
}
