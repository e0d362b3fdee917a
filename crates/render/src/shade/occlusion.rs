//! Shadows and ambient occlusion.

use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;

use super::lamp::{Emitter, Lamp};
use super::pattern::{DIRECTIONS_PER_PLACE, Pattern, PatternCell};
use super::rig::{LightRig, luminance};
use super::surfaces::{Found, lane_of};
use crate::ray::{Ray, RayCaster, Stack};

/// The number of lamps, those that contribute most, for which shadow rays are cast; the others get the same shadow.
const MAX_SHADOWS: usize = 4;

/// The luminance of lamp light.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Arrived {
    /// The part that arrives.
    pub(super) some: f32,
    /// The amount without shadows.
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

/// The light that reaches a point: from lamps of small angular size, which cast sharp shadows, from large lamps, and from the
/// surroundings.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Light {
    pub(super) small: Arrived,
    pub(super) large: Arrived,
    /// The unoccluded shares of the surroundings and the sky.
    pub(super) ambient: f32,
    pub(super) sky: f32,
}

impl Light {
    /// Unoccluded light.
    pub(super) const FULL: Self = Self {
        small: Arrived { some: 0.0, all: 0.0 },
        large: Arrived { some: 0.0, all: 0.0 },
        ambient: 1.0,
        sky: 1.0,
    };

    #[inline]
    pub(super) fn shares(&self) -> Shares {
        let (some, all) = (self.small.some + self.large.some, self.small.all + self.large.all);
        Shares {
            direct: if all > 0.0 { some / all } else { 1.0 },
            ambient: self.ambient,
            sky: self.sky,
        }
    }

    /// Returns the sum, with a weight for `other`.
    #[inline]
    pub(super) fn plus(self, other: Self, weight: f32) -> Self {
        Self {
            small: self.small.plus(other.small, weight),
            large: self.large.plus(other.large, weight),
            ambient: self.ambient + other.ambient * weight,
            sky: self.sky + other.sky * weight,
        }
    }

    /// Returns `smooth` with the sharp shadows of `self`.
    pub(super) fn with_smooth(self, smooth: Self) -> Self {
        Self {
            small: self.small,
            ..smooth
        }
    }

    /// Returns `self` with the surroundings and the sky of `smooth`.
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

/// The shares of the light from lamps, surroundings and sky that reach a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shares {
    pub(super) direct: f32,
    pub(super) ambient: f32,
    pub(super) sky: f32,
}

/// A point on a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// The point relative to the eye, metres.
    pub(super) from_eye: Vec3,
    /// The distance from the eye, metres.
    pub(super) range: f32,
    /// The interpolated unit normal, on the visible side.
    pub(super) normal: Vec3,
    /// The triangle's unit normal, on the visible side.
    pub(super) flat_normal: Vec3,
}

impl Place {
    #[inline]
    pub(super) fn new(found: &Found<'_, '_>, lane: usize) -> Self {
        let surfaces = found.surfaces;
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

/// Casts shadow rays.
pub(super) struct Occlusion<'a> {
    pub(super) scene: &'a Scene,
    pub(super) caster: &'a RayCaster,
    pub(super) rig: &'a LightRig,
    pub(super) emitters: &'a [Emitter],
    pub(super) pattern: &'a Pattern,
    /// The eye in the world, metres.
    pub(super) eye: DVec3,
}

/// The index of a lamp and whether its sampled point is visible.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LampSample {
    pub(super) lamp: u32,
    pub(super) is_seen: bool,
}

/// The samples of the lamps that contribute most.
pub(super) type LampSamples = [Option<LampSample>; MAX_SHADOWS];

impl Occlusion<'_> {
    /// Returns the lamp light at a point relative to the eye. `sees` tests whether a spot on a lamp, −1 to 1, is visible.
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

    /// Returns [`lamplight`](Self::lamplight) with shadow rays.
    pub(super) fn sample_lamps(
        &self,
        place: &Place,
        cell: PatternCell,
        stack: &mut Stack,
    ) -> (Light, LampSamples) {
        self.lamplight(place.from_eye, place.normal, cell, |_, lamp, spot| {
            self.sees(place, lamp, spot, stack)
        })
    }

    /// Averages several pattern cells at one point, for pixels without similar samples.
    pub(super) fn sample_alone(&self, place: &Place, stack: &mut Stack) -> Light {
        // One cell for each quarter of a lamp, at similar angles from the normal.
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

    /// Returns the unoccluded shares of the surroundings and the sky.
    pub(super) fn sample_surroundings(
        &self,
        place: &Place,
        cell: PatternCell,
        stack: &mut Stack,
    ) -> (f32, f32) {
        // Without a sky all tiles use the same directions, so no tile is visible.
        let of_tile = if self.rig.has_sky { cell.of_tile } else { 7 };
        let cell = PatternCell { of_tile, ..cell };
        let (mut ambient, mut sky) = (0.0, 0.0);
        let flat_normal = place.flat_normal.as_dvec3();
        for direction in self.pattern.directions(cell, place.normal.as_dvec3()) {
            if direction.dot(flat_normal) <= 0.0 {
                continue;
            }
            let near = Ray {
                origin: self.eye + place.above(),
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
            // Anything hides the sky, however far it is.
            let far = Ray {
                near: self.rig.reach,
                far: f64::INFINITY,
                ..near
            };
            if self.rig.has_sky && !self.caster.is_occluded(self.scene, far, stack) {
                sky += 1.0;
            }
        }
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let share = 1.0 / DIRECTIONS_PER_PLACE as f32;
        (ambient * share, sky * share)
    }

    /// Tests whether a spot on a lamp, −1 to 1 across it, is visible from a point.
    pub(super) fn sees(&self, place: &Place, lamp: &Lamp, spot: [f64; 2], stack: &mut Stack) -> bool {
        let origin = self.eye + place.above();
        let (direction, ends) = lamp.shape.towards(origin, spot);
        let ray = Ray {
            origin,
            direction,
            near: 0.0,
            // The ray ends just before the lamp, which may have a mesh of its own.
            far: if ends { 0.999 } else { f64::INFINITY },
        };
        direction.dot(place.flat_normal.as_dvec3()) > 0.0 && !self.caster.is_occluded(self.scene, ray, stack)
    }

    /// Returns the lamps that contribute most, with their luminance.
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
