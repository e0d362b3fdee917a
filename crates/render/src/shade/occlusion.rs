//! What hides the lights from a place.

use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;

use super::lamp::{Emitter, Lamp};
use super::pattern::{LOOKS, Pattern, Turn};
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

    /// All of `smooth` but the sharp shadows.
    pub(super) fn with_smooth(self, smooth: Self) -> Self {
        Self {
            small: self.small,
            ..smooth
        }
    }

    /// Only what is all around of `smooth`.
    pub(super) fn with_smooth_surroundings(self, smooth: Self) -> Self {
        Self {
            ambient: smooth.ambient,
            sky: smooth.sky,
            ..self
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

impl Place {
    /// As far off the surface as the point may be wrong by.
    fn above(&self) -> DVec3 {
        self.point + self.flat_normal * (2e-5 + self.range * 1e-4)
    }
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
    /// What one of 16 neighbours finds. What arrives of `small_lamps` and from all around may be left for later: NaN.
    pub(super) fn look(
        &self,
        place: &Place,
        turn: Turn,
        [small_lamps, around]: [bool; 2],
        stack: &mut Stack,
    ) -> Light {
        let (ambient, sky) = if around {
            self.look_around(place, turn, stack)
        } else {
            (f32::NAN, f32::NAN)
        };
        let mut light = Light {
            ambient,
            sky,
            ..Light::default()
        };
        self.each_lamp(place, |lamp, strength| {
            if lamp.looks_small_from(place.point) {
                let some = if small_lamps {
                    self.arriving(place, lamp, [0.0; 2], strength, stack)
                } else {
                    f32::NAN
                };
                light.small = light.small.plus(Arrived { some, all: strength }, 1.0);
            } else {
                let some = self.arriving(place, lamp, Pattern::place(turn.of_place), strength, stack);
                light.large = light.large.plus(Arrived { some, all: strength }, 1.0);
            }
        });
        light
    }

    /// What arrives of the small lamps.
    pub(super) fn light_of_small_lamps(&self, place: &Place, stack: &mut Stack) -> f32 {
        let mut sum = 0.0;
        self.each_lamp(place, |lamp, strength| {
            if lamp.looks_small_from(place.point) {
                sum += self.arriving(place, lamp, [0.0; 2], strength, stack);
            }
        });
        sum
    }

    /// What a few of the neighbours find at one and the same place.
    pub(super) fn look_alone(&self, place: &Place, stack: &mut Stack) -> Light {
        // One of each quarter of a lamp, and each about as far from straight up.
        [0usize, 6, 9, 15]
            .into_iter()
            .map(|turn| {
                let turn = Turn {
                    of_place: turn,
                    of_tile: turn,
                };
                self.look(place, turn, [true; 2], stack)
            })
            .fold(Light::default(), |sum, light| sum.plus(light, 0.25))
    }

    /// How open the surroundings and the sky are.
    pub(super) fn look_around(&self, place: &Place, turn: Turn, stack: &mut Stack) -> (f32, f32) {
        // Without a sky all tiles do the same, and none stands out.
        let (far, of_tile) = if self.rig.has_sky {
            (f64::INFINITY, turn.of_tile)
        } else {
            (self.rig.reach, 7)
        };
        let turn = Turn { of_tile, ..turn };
        let (mut ambient, mut sky) = (0.0, 0.0);
        for direction in self.pattern.looks(turn, place.normal) {
            let ray = Ray {
                origin: place.above(),
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
            let distance = found.map_or(1.0, |t| (t / self.rig.reach).min(1.0) as f32);
            ambient += distance * distance;
            sky += if found.is_none() { 1.0 } else { 0.0 };
        }
        #[expect(clippy::cast_precision_loss, reason = "a few")]
        let share = 1.0 / LOOKS as f32;
        (ambient * share, sky * share)
    }

    fn arriving(&self, place: &Place, lamp: &Lamp, spot: [f64; 2], strength: f32, stack: &mut Stack) -> f32 {
        let origin = place.above();
        let (direction, ends) = lamp.shape.towards(origin, spot);
        let ray = Ray {
            origin,
            direction,
            near: 0.0,
            // Just before the lamp, which may have a mesh to look at.
            far: if ends { 0.999 } else { f64::INFINITY },
        };
        let hidden =
            direction.dot(place.flat_normal) <= 0.0 || self.caster.is_occluded(self.scene, ray, stack);
        if hidden { 0.0 } else { strength }
    }

    /// The lamps that light a place most, and how much.
    fn each_lamp(&self, place: &Place, mut with: impl FnMut(&Lamp, f32)) {
        let normal = place.normal.as_vec3();
        let mut strongest: [Option<(&Lamp, f32)>; MOST_SHADOWS] = [None; MOST_SHADOWS];
        for (lamp, emitter) in self.rig.lamps.iter().zip(self.emitters) {
            let mut strength = 0.0;
            emitter.each(place.from_eye, |towards, irradiance, _| {
                strength += luminance(irradiance) * normal.dot(towards).max(0.0);
            });
            let mut entry = (strength > 0.0).then_some((lamp, strength));
            for slot in &mut strongest {
                if entry.is_some()
                    && slot.is_none_or(|(_, other)| other < entry.map_or(0.0, |(_, mine)| mine))
                {
                    std::mem::swap(slot, &mut entry);
                }
            }
        }
        for (lamp, strength) in strongest.into_iter().flatten() {
            with(lamp, strength);
        }
    }
}
