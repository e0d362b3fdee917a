//! What hides the lights from a place.

use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;

use super::lamp::{Emitter, Lamp};
use super::pattern::{LOOKS, Pattern};
use super::rig::{Rig, luminance};
use crate::ray::{Ray, RayCaster, Stack};

/// How many lamps, those that light a place most, are looked for; the rest is taken to be hidden as they are.
const MOST_SHADOWS: usize = 4;

/// Of lamps' light, as luminance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Arrived {
    /// What arrives.
    pub(super) some: f32,
    /// What would arrive without shadows.
    pub(super) all: f32,
}

impl Arrived {
    #[inline]
    fn plus(self, other: Self, weight: f32) -> Self {
        Self {
            some: self.some + other.some * weight,
            all: self.all + other.all * weight,
        }
    }
}

/// How much of its light reaches a place: of lamps that look small, whose shadows are sharp, of large ones, and of what
/// is all around.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Light {
    pub(super) small: Arrived,
    pub(super) large: Arrived,
    /// The shares of the surroundings and of the sky that are open.
    pub(super) ambient: f32,
    pub(super) sky: f32,
}

impl Light {
    /// All of it.
    pub(super) const FULL: Self = Self {
        small: Arrived { some: 0.0, all: 0.0 },
        large: Arrived { some: 0.0, all: 0.0 },
        ambient: 1.0,
        sky: 1.0,
    };

    /// The share of the lamps' light that arrives.
    #[inline]
    pub(super) fn direct(&self) -> f32 {
        let all = self.small.all + self.large.all;
        if all > 0.0 {
            (self.small.some + self.large.some) / all
        } else {
            1.0
        }
    }

    /// Both, one of them weighted.
    #[inline]
    pub(super) fn plus(self, other: Self, weight: f32) -> Self {
        Self {
            small: self.small.plus(other.small, weight),
            large: self.large.plus(other.large, weight),
            ambient: self.ambient + other.ambient * weight,
            sky: self.sky + other.sky * weight,
        }
    }

    #[inline]
    pub(super) fn times(self, factor: f32) -> Self {
        Self::default().plus(self, factor)
    }
}

/// A place on a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// In the world, metres.
    pub(super) point: DVec3,
    /// The same, from the eye.
    pub(super) from_eye: Vec3,
    pub(super) normal: DVec3,
    pub(super) flat_normal: DVec3,
    /// From the eye, metres.
    pub(super) range: f64,
}

/// Looks for what hides the lights.
pub(super) struct Occlusion<'a> {
    pub(super) scene: &'a Scene,
    pub(super) caster: &'a RayCaster,
    pub(super) rig: &'a Rig,
    pub(super) emitters: &'a [Emitter],
    pub(super) pattern: &'a Pattern,
}

impl Occlusion<'_> {
    /// What one of 16 neighbours finds.
    pub(super) fn look(&self, place: &Place, turn: usize, stack: &mut Stack) -> Light {
        // As far off the surface as the point may be wrong by.
        let origin = place.point + place.flat_normal * (2e-5 + place.range * 1e-4);
        let mut light = Light::default();
        let strongest = self.strongest(place);
        for (lamp, strength) in strongest.into_iter().flatten() {
            let Some(lamp) = self.rig.lamps.get(lamp) else {
                continue;
            };
            let is_small = lamp.looks_small_from(origin);
            let spot = if is_small { [0.0; 2] } else { Pattern::place(turn) };
            let some = if self.is_hidden(origin, lamp, spot, stack) {
                0.0
            } else {
                strength
            };
            let arrived = if is_small {
                &mut light.small
            } else {
                &mut light.large
            };
            *arrived = arrived.plus(Arrived { some, all: strength }, 1.0);
        }
        let far = if self.rig.has_sky {
            f64::INFINITY
        } else {
            self.rig.reach
        };
        for direction in self.pattern.looks(turn, place.normal) {
            let ray = Ray {
                origin,
                direction,
                near: 0.0,
                far,
            };
            let into_surface = direction.dot(place.flat_normal) <= 0.0;
            let found = if into_surface {
                Some(0.0)
            } else {
                self.caster.cast(self.scene, ray, stack).map(|(t, _)| t)
            };
            #[expect(clippy::cast_possible_truncation, reason = "a share")]
            let near = found.map_or(1.0, |t| (t / self.rig.reach).min(1.0) as f32);
            light.ambient += near;
            light.sky += if found.is_none() { 1.0 } else { 0.0 };
        }
        #[expect(clippy::cast_precision_loss, reason = "a few")]
        let share = 1.0 / LOOKS as f32;
        light.ambient *= share;
        light.sky *= share;
        light
    }

    /// What a few of the neighbours find at one and the same place.
    pub(super) fn look_alone(&self, place: &Place, stack: &mut Stack) -> Light {
        // One of each quarter of a lamp, and each about as far from straight up.
        [0usize, 6, 9, 15]
            .into_iter()
            .map(|turn| self.look(place, turn, stack))
            .fold(Light::default(), |sum, light| sum.plus(light, 0.25))
    }

    fn is_hidden(&self, origin: DVec3, lamp: &Lamp, spot: [f64; 2], stack: &mut Stack) -> bool {
        let (direction, ends) = lamp.shape.towards(origin, spot);
        let ray = Ray {
            origin,
            direction,
            near: 0.0,
            // Just before the lamp, which may have a mesh to look at.
            far: if ends { 0.999 } else { f64::INFINITY },
        };
        self.caster.is_occluded(self.scene, ray, stack)
    }

    /// The lamps that light a place most, and how much.
    fn strongest(&self, place: &Place) -> [Option<(usize, f32)>; MOST_SHADOWS] {
        let normal = place.normal.as_vec3();
        let mut strongest = [None; MOST_SHADOWS];
        for (lamp, emitter) in self.emitters.iter().enumerate() {
            let mut strength = 0.0;
            emitter.each(place.from_eye, |towards, irradiance, _| {
                strength += luminance(irradiance) * normal.dot(towards).max(0.0);
            });
            if !(strength > 0.0) {
                continue;
            }
            let mut entry = Some((lamp, strength));
            for slot in &mut strongest {
                if slot.is_none_or(|(_, other)| other < entry.map_or(0.0, |(_, mine)| mine)) {
                    std::mem::swap(slot, &mut entry);
                }
                if entry.is_none() {
                    break;
                }
            }
        }
        strongest
    }
}
