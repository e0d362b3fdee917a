//! What hides the lights from a place.

use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;

use super::lamp::{Emitter, Lamp};
use super::pattern::{DIRECTIONS_PER_PLACE, Pattern, PatternCell};
use super::rig::{LightRig, luminance};
use crate::ray::{Ray, RayCaster, Stack};

/// How many lamps, those that light a place most, are looked for; the rest is taken to be hidden as they are.
const MAX_SHADOWS: usize = 4;

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

    /// As shares.
    #[inline]
    pub(super) fn shares(&self) -> Shares {
        let (some, all) = (self.small.some + self.large.some, self.small.all + self.large.all);
        Shares {
            direct: if all > 0.0 { some / all } else { 1.0 },
            ambient: self.ambient,
            sky: self.sky,
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

/// The shares of the lamps' light, of the surroundings' and of the sky's that reach a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shares {
    pub(super) direct: f32,
    pub(super) ambient: f32,
    pub(super) sky: f32,
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
    pub(super) rig: &'a LightRig,
    pub(super) emitters: &'a [Emitter],
    pub(super) pattern: &'a Pattern,
    /// In the world, metres.
    pub(super) eye: DVec3,
}

/// A lamp of the scene, by its number there, and whether a place sees what it looks at of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LampSample {
    pub(super) lamp: u32,
    pub(super) is_seen: bool,
}

/// Of the lamps that light a place most.
pub(super) type LampSamples = [Option<LampSample>; MAX_SHADOWS];

impl Occlusion<'_> {
    /// What the lamps send to a place that is `from_eye` away from the eye. `sees` says whether it sees its place on a lamp,
    /// −1 to 1.
    pub(super) fn lamplight(
        &self,
        from_eye: Vec3,
        normal: Vec3,
        cell: PatternCell,
        mut sees: impl FnMut(u32, &Lamp, [f64; 2]) -> bool,
    ) -> (Light, LampSamples) {
        let mut light = Light::default();
        let mut lamp_samples = LampSamples::default();
        let strongest = self.strongest(from_eye, normal);
        for (lamp_sample, (index, strength)) in lamp_samples.iter_mut().zip(strongest.into_iter().flatten()) {
            let Some(lamp) = self.rig.lamps.get(index as usize) else {
                continue;
            };
            let is_small = lamp.looks_small_from(self.eye + from_eye.as_dvec3());
            let spot = if is_small {
                [0.0; 2]
            } else {
                Pattern::place(cell.of_place)
            };
            let is_seen = sees(index, lamp, spot);
            *lamp_sample = Some(LampSample { lamp: index, is_seen });
            let arrived = Arrived {
                some: if is_seen { strength } else { 0.0 },
                all: strength,
            };
            if is_small {
                light.small = light.small.plus(arrived, 1.0);
            } else {
                light.large = light.large.plus(arrived, 1.0);
            }
        }
        (light, lamp_samples)
    }

    /// [`lamplight`](Self::lamplight), by looking.
    pub(super) fn sample_lamps(
        &self,
        place: &Place,
        cell: PatternCell,
        stack: &mut Stack,
    ) -> (Light, LampSamples) {
        self.lamplight(place.from_eye, place.normal.as_vec3(), cell, |_, lamp, spot| {
            self.sees(place, lamp, spot, stack)
        })
    }

    /// What a few of the neighbours find at one and the same place.
    pub(super) fn sample_alone(&self, place: &Place, stack: &mut Stack) -> Light {
        // One of each quarter of a lamp, and each about as far from straight up.
        [0usize, 6, 9, 15]
            .into_iter()
            .map(|cell| {
                let cell = PatternCell {
                    of_place: cell,
                    of_tile: cell,
                };
                let (light, _) = self.sample_lamps(place, cell, stack);
                let (ambient, sky) = self.sample_surroundings(place, cell, stack);
                Light {
                    ambient,
                    sky,
                    ..light
                }
            })
            .fold(Light::default(), |sum, light| sum.plus(light, 0.25))
    }

    /// How open the surroundings and the sky are.
    pub(super) fn sample_surroundings(
        &self,
        place: &Place,
        cell: PatternCell,
        stack: &mut Stack,
    ) -> (f32, f32) {
        // Without a sky all tiles do the same, and none stands out.
        let of_tile = if self.rig.has_sky { cell.of_tile } else { 7 };
        let cell = PatternCell { of_tile, ..cell };
        let (mut ambient, mut sky) = (0.0, 0.0);
        for direction in self.pattern.directions(cell, place.normal) {
            if direction.dot(place.flat_normal) <= 0.0 {
                continue;
            }
            let near = Ray {
                origin: place.above(),
                direction,
                near: 0.0,
                far: self.rig.reach,
            };
            if let Some((t, _)) = self.caster.cast(self.scene, near, stack) {
                #[expect(clippy::cast_possible_truncation, reason = "a share")]
                let distance = (t / self.rig.reach) as f32;
                ambient += distance * distance;
                continue;
            }
            ambient += 1.0;
            // How far what hides the sky is does not matter.
            let far = Ray {
                near: self.rig.reach,
                far: f64::INFINITY,
                ..near
            };
            if self.rig.has_sky && !self.caster.is_occluded(self.scene, far, stack) {
                sky += 1.0;
            }
        }
        #[expect(clippy::cast_precision_loss, reason = "a few")]
        let share = 1.0 / DIRECTIONS_PER_PLACE as f32;
        (ambient * share, sky * share)
    }

    /// Whether a place sees one on a lamp, −1 to 1 across it.
    pub(super) fn sees(&self, place: &Place, lamp: &Lamp, spot: [f64; 2], stack: &mut Stack) -> bool {
        let origin = place.above();
        let (direction, ends) = lamp.shape.towards(origin, spot);
        let ray = Ray {
            origin,
            direction,
            near: 0.0,
            // Just before the lamp, which may have a mesh to look at.
            far: if ends { 0.999 } else { f64::INFINITY },
        };
        direction.dot(place.flat_normal) > 0.0 && !self.caster.is_occluded(self.scene, ray, stack)
    }

    /// The lamps that light a place most, and how much, as luminance.
    fn strongest(&self, from_eye: Vec3, normal: Vec3) -> [Option<(u32, f32)>; MAX_SHADOWS] {
        let mut strongest = [None; MAX_SHADOWS];
        for (index, emitter) in (0u32..).zip(self.emitters) {
            let mut strength = 0.0;
            emitter.each(from_eye, |towards, irradiance| {
                strength += luminance(irradiance) * normal.dot(towards).max(0.0);
            });
            let mut entry = (strength > 0.0).then_some((index, strength));
            for slot in &mut strongest {
                if entry.is_some()
                    && slot.is_none_or(|(_, other): (u32, f32)| other < entry.map_or(0.0, |(_, mine)| mine))
                {
                    std::mem::swap(slot, &mut entry);
                }
            }
        }
        strongest
    }
}
