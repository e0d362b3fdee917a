//! Reflection towards the eye, eight points at a time.

use glam::Vec3;
use oaktwin_simd::{I32Lanes, LaneKernel, Lanes};

use super::film::Film;
use super::harmonics::Harmonics;
use super::lamp::{Emitter, Receiver};
use super::occlusion::Shares;
use super::paint::Finishes;
use super::rig::LightRig;
use super::surfaces::{Columns, Surfaces};
use super::tone::tone_lanes;
use crate::ray::Vector;

/// The reflectance of dielectrics at normal incidence.
const DIELECTRIC: f32 = 0.04;

/// The roughness from which on dielectrics have no specular highlights.
const DULL: f32 = 0.75;

/// The exposed radiance towards the eye on film, by channel: a diffuse part, and a glossy part with the distribution of Trowbridge and
/// Reitz ("GGX") and Schlick's Fresnel term. Emission is not exposed: 1 is white.
pub(super) struct Radiance<'a> {
    /// The points, and their materials and light.
    pub(super) surfaces: &'a Surfaces,
    pub(super) finishes: &'a Finishes,
    pub(super) shares: &'a Shares,
    pub(super) emitters: &'a [Emitter],
    pub(super) rig: &'a LightRig,
    /// The unit vectors towards the viewer; `None` if that is the eye of the view.
    pub(super) viewer: Option<&'a Columns>,
    /// The parts of the surfaces' own light; `None` for all of it.
    pub(super) own: Option<&'a OwnLight>,
    pub(super) film: Film,
}

/// The factors of the light that surfaces send themselves, where rays are followed to the rest.
#[derive(Clone, Debug)]
pub(super) struct OwnLight {
    /// Of diffuse reflection.
    pub(super) scattered: [f32; 8],
    /// Of the highlights of lamps.
    pub(super) glossy: [f32; 8],
    /// Of the reflection of the surroundings, which is approximate.
    pub(super) around: [f32; 8],
    /// Of emission.
    pub(super) emitted: [f32; 8],
}

impl Default for OwnLight {
    fn default() -> Self {
        Self::ALL
    }
}

impl OwnLight {
    /// All of the light.
    pub(super) const ALL: Self = Self {
        scattered: [1.0; 8],
        glossy: [1.0; 8],
        around: [1.0; 8],
        emitted: [1.0; 8],
    };

    /// Returns the light without highlights of lamps.
    pub(super) fn matt(&self) -> Self {
        Self {
            glossy: [0.0; 8],
            around: [0.0; 8],
            ..self.clone()
        }
    }
}

impl LaneKernel for Radiance<'_> {
    type Output = [[f32; 8]; 3];

    #[inline(always)]
    fn run<L: Lanes>(self) -> Self::Output {
        let Self {
            surfaces,
            finishes,
            shares,
            emitters,
            rig,
            viewer,
            own,
            film,
        } = self;
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let point = Vector::<L>::load(&surfaces.point);
        let normal = Vector::<L>::load(&surfaces.normal);
        let color = Vector::<L>::load(&finishes.color);
        let (metallic, roughness) = (L::load(&finishes.metallic), L::load(&finishes.roughness));
        let ambient = L::load(&shares.ambient);
        let length = point.dot(point).sqrt().max(L::splat(f32::MIN_POSITIVE));
        let eye = match viewer {
            None => point * (L::splat(-1.0) / length),
            Some(viewer) => Vector::load(viewer),
        };
        let dielectric = Vector::splat([DIELECTRIC; 3]);
        let straight = dielectric + (color - dielectric) * metallic;
        let to_eye = normal.dot(eye).max(L::splat(1e-3));
        let is_smooth = roughness.lt(L::splat(DULL));
        let mut shine = Shine {
            normal,
            eye,
            to_eye,
            straight,
            alpha: (roughness * roughness).max(L::splat(0.02)),
            is_glossy: is_smooth | zero.lt(metallic),
            diffuse: Vector::splat([0.0; 3]),
            glossy: Vector::splat([0.0; 3]),
        };
        for emitter in emitters {
            emitter.shine(point, &mut shine);
        }
        let direct = L::load(&shares.direct);
        let mirrored = normal * (L::splat(2.0) * normal.dot(eye)) - eye;
        let mut around = mean_by_cosine(&rig.ambient, normal) * ambient;
        let mut reflected = mean_by_cosine(&rig.ambient, mirrored) * ambient;
        if rig.has_sky {
            let sky = L::load(&shares.sky);
            around = around + mean_by_cosine(&rig.sky, normal) * sky;
            reflected = reflected + mean_by_cosine(&rig.sky, mirrored) * sky;
        }
        let lambert = shine.diffuse * (direct * L::splat(std::f32::consts::FRAC_1_PI)) + around;
        let even = one - roughness;
        let smooth = Vector {
            x: even.max(straight.x),
            y: even.max(straight.y),
            z: even.max(straight.z),
        };
        let all_around = straight + (smooth - straight) * fifth_power(one - to_eye);
        let mut scattered = times(color * (one - metallic), lambert);
        let mut glossy = shine.glossy * direct;
        let mut mirrored = times(all_around, reflected);
        let mut emitted = Vector::load(&finishes.emissive);
        if let Some(own) = own {
            scattered = scattered * L::load(&own.scattered);
            glossy = glossy * L::load(&own.glossy);
            mirrored = mirrored * L::load(&own.around);
            emitted = emitted * L::load(&own.emitted);
        }
        let sent = (scattered + glossy + mirrored) * L::splat(rig.exposure) + emitted;
        let mut out = [[0.0; 8]; 3];
        exposed(film, sent).store(&mut out);
        out
    }
}

/// [`Film::exposed`].
#[inline(always)]
fn exposed<L: Lanes>(film: Film, radiance: Vector<L>) -> Vector<L> {
    let zero = L::splat(0.0);
    // NaN becomes 0.
    let (x, y, z) = (radiance.x.max(zero), radiance.y.max(zero), radiance.z.max(zero));
    match film {
        Film::Tones => Vector {
            x: tone_lanes(x),
            y: tone_lanes(y),
            z: tone_lanes(z),
        },
        Film::Linear => Vector { x, y, z },
    }
}

/// Reflected lamp light without shadows.
struct Shine<L: Lanes> {
    normal: Vector<L>,
    eye: Vector<L>,
    to_eye: L,
    straight: Vector<L>,
    alpha: L,
    /// The mask of lanes that reflect lamps.
    is_glossy: L::I32,
    diffuse: Vector<L>,
    glossy: Vector<L>,
}

impl<L: Lanes> Receiver<L> for Shine<L> {
    #[inline(always)]
    fn receive(&mut self, towards: Vector<L>, share: L, radiance: Vec3, width: L) {
        let zero = L::splat(0.0);
        let to_light = self.normal.dot(towards).max(zero);
        let share = share * to_light;
        let is_lit = zero.lt(share);
        if is_lit.signs() == 0 {
            return;
        }
        let received = Vector::splat(radiance.to_array()) * share;
        self.diffuse = self.diffuse + received;
        let is_lit = is_lit & self.is_glossy;
        if is_lit.signs() == 0 {
            return;
        }
        // A large lamp has a large highlight.
        let one = L::splat(1.0);
        let alpha = (self.alpha + width * L::splat(0.5)).min(one);
        let (factor, fresnel) = self.lobe(towards, to_light, alpha);
        let factor = L::select(is_lit, factor, zero);
        self.glossy = self.glossy + times(received, fresnel) * factor;
    }
}

impl<L: Lanes> Shine<L> {
    /// Returns the glossy reflectance without the cosine: a factor and the Fresnel term.
    #[inline(always)]
    fn lobe(&self, towards: Vector<L>, to_light: L, alpha: L) -> (L, Vector<L>) {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let half = self.eye + towards;
        let length = half.dot(half).sqrt();
        let shortest = L::splat(1e-18);
        let half = half * L::select(shortest.lt(length), one / length.max(shortest), zero);
        let to_half = self.normal.dot(half).max(zero);
        let eye_to_half = self.eye.dot(half).max(zero);
        let a2 = alpha * alpha;
        let spread = to_half * to_half * (a2 - one) + one;
        // Schlick's masking for both directions, divided by the 4 cos cos of the specular term.
        let k = alpha * L::splat(0.5);
        let rest = one - k;
        let masking = (self.to_eye * rest + k) * (to_light * rest + k);
        let below = L::splat(4.0 * std::f32::consts::PI) * (spread * spread) * masking;
        let grazing = fifth_power(one - eye_to_half);
        let white = Vector::splat([1.0; 3]);
        let fresnel = self.straight + (white - self.straight) * grazing;
        (a2 / below, fresnel)
    }
}

/// Multiplies by channel.
#[inline(always)]
fn times<L: Lanes>(a: Vector<L>, b: Vector<L>) -> Vector<L> {
    Vector {
        x: a.x * b.x,
        y: a.y * b.y,
        z: a.z * b.z,
    }
}

/// [`Harmonics::mean_by_cosine`].
#[inline(always)]
fn mean_by_cosine<L: Lanes>(of: &Harmonics, d: Vector<L>) -> Vector<L> {
    let zero = L::splat(0.0);
    let [uniform, y, z, x, xy, yz, zz, xz, xx_yy] = of.by_cosine();
    let one = L::splat(1.0);
    let mut sum = Vector::splat(uniform.to_array());
    if !of.is_uniform() {
        sum = sum
            + Vector::splat(y.to_array()) * d.y
            + Vector::splat(z.to_array()) * d.z
            + Vector::splat(x.to_array()) * d.x
            + Vector::splat(xy.to_array()) * (d.x * d.y)
            + Vector::splat(yz.to_array()) * (d.y * d.z)
            + Vector::splat(zz.to_array()) * (L::splat(3.0) * (d.z * d.z) - one)
            + Vector::splat(xz.to_array()) * (d.x * d.z)
            + Vector::splat(xx_yy.to_array()) * (d.x * d.x - d.y * d.y);
    }
    Vector {
        x: sum.x.max(zero),
        y: sum.y.max(zero),
        z: sum.z.max(zero),
    }
}

#[inline(always)]
fn fifth_power<L: Lanes>(x: L) -> L {
    let x2 = x * x;
    x2 * x2 * x
}
