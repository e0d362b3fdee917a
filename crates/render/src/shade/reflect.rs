//! How much of the light a surface sends to the eye.

use glam::Vec3;

use super::lamp::Emitter;
use super::occlusion::Light;
use super::paint::Finish;
use super::rig::Rig;

/// What dielectrics reflect of light that comes from straight above.
const DIELECTRIC: f32 = 0.04;

/// From this roughness on a dielectric shows no lamps.
const DULL: f32 = 0.75;

/// A place on a surface, in single precision, relative to the eye, in the world's axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    pub(super) point: Vec3,
    pub(super) normal: Vec3,
    /// Unit vector to the eye.
    pub(super) eye: Vec3,
}

/// The exposed radiance that leaves a place towards the eye: diffuse, and a glossy part with the distribution of
/// Trowbridge and Reitz ("GGX") and Schlick's Fresnel term. What a surface gives off by itself is not exposed: 1 is white.
#[inline]
pub(super) fn radiance(
    facet: &Facet,
    finish: &Finish,
    light: &Light,
    emitters: &[Emitter],
    rig: &Rig,
) -> Vec3 {
    let albedo = finish.color * (1.0 - finish.metallic);
    let straight = Vec3::splat(DIELECTRIC).lerp(finish.color, finish.metallic);
    let alpha = (finish.roughness * finish.roughness).max(0.02);
    let is_glossy = finish.roughness < DULL || finish.metallic > 0.0;
    let (normal, eye) = (facet.normal, facet.eye);
    let to_eye = normal.dot(eye).max(1e-3);
    let mut diffuse = Vec3::ZERO;
    let mut glossy = Vec3::ZERO;
    for emitter in emitters {
        emitter.each(facet.point, |towards, irradiance, width| {
            let to_light = normal.dot(towards);
            if to_light <= 0.0 {
                return;
            }
            let received = irradiance * to_light;
            diffuse += received;
            if is_glossy {
                // A wide lamp has a wide reflection.
                let alpha = (alpha + width * 0.5).min(1.0);
                glossy += received * lobe(normal, eye, towards, to_eye, to_light, alpha, straight);
            }
        });
    }
    let direct = light.direct();
    let surroundings = rig.ambient.mean_by_cosine(normal) * light.ambient;
    let mirrored = normal * (2.0 * normal.dot(eye)) - eye;
    let mut reflected = rig.ambient.mean_by_cosine(mirrored) * light.ambient;
    let mut above = Vec3::ZERO;
    if rig.has_sky {
        above = rig.sky.mean_by_cosine(normal) * light.sky;
        reflected += rig.sky.mean_by_cosine(mirrored) * light.sky;
    }
    let lambert = diffuse * (direct * std::f32::consts::FRAC_1_PI) + surroundings + above;
    let smooth = Vec3::splat(1.0 - finish.roughness).max(straight);
    let all_around = straight + (smooth - straight) * fifth_power(1.0 - to_eye);
    (albedo * lambert + glossy * direct + all_around * reflected) * rig.exposure + finish.emissive
}

/// The glossy part of the reflectance, without the cosine.
#[inline]
fn lobe(
    normal: Vec3,
    eye: Vec3,
    towards: Vec3,
    to_eye: f32,
    to_light: f32,
    alpha: f32,
    straight: Vec3,
) -> Vec3 {
    let half = (eye + towards).normalize_or_zero();
    let (to_half, eye_to_half) = (normal.dot(half).max(0.0), eye.dot(half).max(0.0));
    let a2 = alpha * alpha;
    let spread = to_half * to_half * (a2 - 1.0) + 1.0;
    let distribution = a2 / (std::f32::consts::PI * spread * spread);
    // Schlick's masking, both ways, over the usual 4 cos cos.
    let k = alpha * 0.5;
    let masking = 0.25 / ((to_eye * (1.0 - k) + k) * (to_light * (1.0 - k) + k));
    let fresnel = straight + (Vec3::ONE - straight) * fifth_power(1.0 - eye_to_half);
    fresnel * (distribution * masking)
}

#[inline]
fn fifth_power(x: f32) -> f32 {
    let x2 = x * x;
    x2 * x2 * x
}
