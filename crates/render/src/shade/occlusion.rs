//! Shadows and ambient occlusion.

use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;
use oaktwin_simd::Level;

use super::lamp::{Emitter, Lamp, Size};
use super::pattern::{self, Hemisphere, Pattern, Spot, Spots};
use super::rig::LightRig;
use super::strength::{Strengths, Strongest};
use super::surfaces::{PacketSurfaces, Surfaces, lane_of};
use crate::ray::{RAYS, Ray, RayCaster, Rays, Stack, ray_bits};

/// The light that reaches a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Light {
    /// The luminance that arrives from the strongest lamps.
    pub(super) some: f32,
    /// The luminance that would arrive without shadows.
    pub(super) all: f32,
    /// The unoccluded shares of the surroundings and the sky.
    pub(super) ambient: f32,
    pub(super) sky: f32,
}

impl Light {
    /// Returns the share of the lamps' light that arrives.
    #[inline]
    pub(super) fn direct(&self) -> f32 {
        if self.all > 0.0 { self.some / self.all } else { 1.0 }
    }

    /// Returns the shares that arrive: of the light from lamps, surroundings and sky.
    #[inline]
    pub(super) fn shares(&self) -> [f32; 3] {
        [self.direct(), self.ambient, self.sky]
    }
}

/// The light of a sample in rows, which vector code gathers.
pub(super) type LightRows = [[f32; 3]; 2];

/// The shares of the light from lamps, surroundings and sky that reach eight points.
#[derive(Clone, Debug, Default)]
pub(super) struct Shares {
    pub(super) direct: [f32; 8],
    pub(super) ambient: [f32; 8],
    pub(super) sky: [f32; 8],
}

impl Shares {
    /// Sets one of eight lanes.
    #[inline]
    pub(super) fn set(&mut self, lane: usize, [direct, ambient, sky]: [f32; 3]) {
        self.direct[lane & 7] = direct;
        self.ambient[lane & 7] = ambient;
        self.sky[lane & 7] = sky;
    }
}

/// A point on a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShadingPoint {
    /// The point relative to the eye, metres.
    pub(super) from_eye: Vec3,
    /// The distance from the eye, metres.
    pub(super) range: f32,
    /// The interpolated unit normal, on the visible side.
    pub(super) normal: Vec3,
    /// The triangle's unit normal, on the visible side.
    pub(super) flat_normal: Vec3,
}

impl ShadingPoint {
    #[inline]
    pub(super) fn new(found: &PacketSurfaces<'_, '_>, lane: usize) -> Self {
        Self::of_lane(found.surfaces, lane)
    }

    /// Returns the point in one of eight lanes.
    #[inline]
    pub(super) fn of_lane(surfaces: &Surfaces, lane: usize) -> Self {
        Self {
            from_eye: lane_of(&surfaces.point, lane),
            range: surfaces.range[lane & 7],
            normal: lane_of(&surfaces.normal, lane),
            flat_normal: lane_of(&surfaces.flat_normal, lane),
        }
    }

    /// Returns the point relative to the eye, offset from the surface by its rounding error.
    fn above(&self) -> DVec3 {
        let offset = 2e-5 + self.range * 1e-4;
        (self.from_eye + self.flat_normal * offset).as_dvec3()
    }
}

/// The number of lamps with a last blocker of their own. The last blockers of sky directions follow in the table.
const LAMPS: usize = 64;

/// The number of rays from which on they are traced together.
const MIN_BUNDLE: u32 = 3;

/// The end of rays to a lamp, just before it because it may have its own mesh.
const BEFORE_LAMP: f64 = 0.999;

/// Casts shadow rays.
pub(super) struct Occlusion<'a> {
    pub(super) scene: &'a Scene,
    pub(super) caster: &'a RayCaster,
    pub(super) rig: &'a LightRig,
    pub(super) emitters: &'a [Emitter],
    pub(super) pattern: &'a Pattern,
    pub(super) level: Level,
    /// The eye in the world, metres.
    pub(super) eye: DVec3,
}

impl Occlusion<'_> {
    /// Returns the bits of the spots of a lamp that are visible; `known` are those that need no ray.
    pub(super) fn spots_seen(
        &self,
        place: &ShadingPoint,
        lamp: &Lamp,
        known: Spots,
        stack: &mut Stack,
    ) -> u64 {
        let size = lamp.size_from(self.eye + place.from_eye.as_dvec3());
        if size == Size::Point {
            return self.centre_seen(place, lamp, stack);
        }
        let mut test = |spots: u64| self.sees_of(spots, place, lamp, stack);
        // The penumbrae of small lamps are narrow: few points see a part of them.
        if size == Size::Small {
            let few = Pattern::FEW_BITS;
            let seen = (known.certain & few) | test(known.possible & !known.certain & few);
            match seen {
                Pattern::FEW_BITS => return u64::MAX,
                0 => return 0,
                _ => {}
            }
        }
        pattern::mask(known, test)
    }

    /// Returns the bits of all spots of a lamp if its centre is visible.
    pub(super) fn centre_seen(&self, place: &ShadingPoint, lamp: &Lamp, stack: &mut Stack) -> u64 {
        match self.sees(place, lamp, Spot::default(), stack) {
            true => u64::MAX,
            false => 0,
        }
    }

    /// Returns [`spots_seen`](Self::spots_seen) from four rays.
    pub(super) fn few_spots_seen(&self, place: &ShadingPoint, lamp: &Lamp, stack: &mut Stack) -> u64 {
        let seen = self.sees_of(Pattern::FEW_BITS, place, lamp, stack);
        let mut bits = 0;
        for (quarter, index) in Pattern::FEW.into_iter().enumerate() {
            if (seen >> index) & 1 == 1 {
                bits |= 0xFFFF << (16 * quarter);
            }
        }
        bits
    }

    /// Returns the light at a point that has no similar samples around it, from few rays.
    pub(super) fn sample_alone(
        &self,
        place: &ShadingPoint,
        strengths: &mut Strengths,
        stack: &mut Stack,
    ) -> Light {
        strengths.set(0, place.from_eye, place.normal);
        strengths.measure(self.emitters, self.level);
        self.sample(place, strengths.strongest(0), &Pattern::FEW, stack)
    }

    /// Returns the light at a point, from rays to some spots of large lamps and in some directions, by their numbers in the pattern.
    pub(super) fn sample(
        &self,
        place: &ShadingPoint,
        strongest: Strongest,
        rays: &[usize],
        stack: &mut Stack,
    ) -> Light {
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let share = 1.0 / rays.len() as f32;
        let [ambient, sky] = self.some_surroundings(place, rays, stack);
        let mut light = Light {
            ambient,
            sky,
            ..Light::default()
        };
        for (index, strength) in strongest.into_iter().flatten() {
            let Some(lamp) = self.rig.lamps.get(index as usize) else {
                continue;
            };
            let seen = match lamp.size_from(self.eye + place.from_eye.as_dvec3()) {
                Size::Large => (rays.iter())
                    .filter(|index| self.sees(place, lamp, self.pattern.spot(**index), stack))
                    .fold(0.0, |seen, _| seen + share),
                Size::Point | Size::Small => pattern::share_of(self.centre_seen(place, lamp, stack)),
            };
            light.all += strength;
            light.some += strength * seen;
        }
        light
    }

    /// Returns [`surroundings`](Self::surroundings) from four rays.
    pub(super) fn few_surroundings(&self, place: &ShadingPoint, stack: &mut Stack) -> [f32; 2] {
        self.some_surroundings(place, &Pattern::FEW, stack)
    }

    fn some_surroundings(&self, place: &ShadingPoint, rays: &[usize], stack: &mut Stack) -> [f32; 2] {
        let around = Hemisphere::new(place.normal.as_dvec3());
        let mut sum = [0.0; 2];
        for index in rays {
            let [ambient, sky] = self.open(place, *index, &around, stack);
            sum = [sum[0] + ambient, sum[1] + sky];
        }
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let count = rays.len() as f32;
        sum.map(|sum| sum / count)
    }

    /// Returns the unoccluded shares of the surroundings and the sky.
    pub(super) fn surroundings(&self, place: &ShadingPoint, stack: &mut Stack) -> [f32; 2] {
        let around = Hemisphere::new(place.normal.as_dvec3());
        let part = usize::from(self.rig.has_sky);
        pattern::mean(part, |index| self.open(place, index, &around, stack))
    }

    /// Returns how open a direction of the pattern is to the surroundings and to the sky.
    fn open(&self, place: &ShadingPoint, index: usize, around: &Hemisphere, stack: &mut Stack) -> [f32; 2] {
        let direction = self.pattern.direction(index, around);
        if direction.dot(place.flat_normal.as_dvec3()) <= 0.0 {
            return [0.0; 2];
        }
        let reach = self.rig.reach;
        let ray = Ray {
            origin: self.eye + place.above(),
            direction,
            near: 0.0,
            // Anything hides the sky, however far it is.
            far: if self.rig.has_sky { f64::INFINITY } else { reach },
        };
        match (self.caster).distance_within(self.scene, ray, reach, LAMPS + index, stack) {
            None => [1.0, 1.0],
            Some(t) => {
                #[expect(clippy::cast_possible_truncation, reason = "a share")]
                let distance = (t / reach) as f32;
                [distance * distance, 0.0]
            }
        }
    }

    /// Returns the bits of the spots on a lamp, among those with the bits `spots`, that are visible from a point.
    fn sees_of(&self, spots: u64, place: &ShadingPoint, lamp: &Lamp, stack: &mut Stack) -> u64 {
        if spots.count_ones() < MIN_BUNDLE {
            let seen =
                ray_bits(spots).filter(|index| self.sees(place, lamp, self.pattern.spot(*index), stack));
            return seen.fold(0, |bits, index| bits | 1 << index);
        }
        let origin = self.eye + place.above();
        let normal = place.flat_normal.as_dvec3();
        let mut rays = Rays {
            origin,
            directions: [DVec3::ZERO; RAYS],
            used: 0,
            far: f64::INFINITY,
        };
        for index in ray_bits(spots) {
            let (direction, ends) = lamp.shape.towards(origin, self.pattern.spot(index));
            if direction.dot(normal) > 0.0 {
                rays.directions[index] = direction;
                rays.used |= 1 << index;
            }
            if ends {
                rays.far = BEFORE_LAMP;
            }
        }
        rays.used & !(self.caster).shadowed(self.scene, &rays, lamp.number % LAMPS, stack)
    }

    /// Tests whether a spot on a lamp is visible from a point.
    pub(super) fn sees(&self, place: &ShadingPoint, lamp: &Lamp, spot: Spot, stack: &mut Stack) -> bool {
        let origin = self.eye + place.above();
        let (direction, ends) = lamp.shape.towards(origin, spot);
        let ray = Ray {
            origin,
            direction,
            near: 0.0,
            far: if ends { BEFORE_LAMP } else { f64::INFINITY },
        };
        direction.dot(place.flat_normal.as_dvec3()) > 0.0
            && !(self.caster).is_shadowed(self.scene, ray, lamp.number % LAMPS, stack)
    }
}
