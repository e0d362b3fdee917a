//! Shadows and ambient occlusion.

use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;
use oaktwin_simd::Level;

use super::lamp::{Emitter, Lamp};
use super::pattern::{DIRECTIONS_PER_PLACE, Pattern, PatternCell};
use super::rig::LightRig;
use super::strength::{MAX_SHADOWS, Strengths, Strongest};
use super::surfaces::{Found, Surfaces, lane_of};
use crate::ray::{Ray, RayCaster, Stack};

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

/// The cells that resolve the light of one point: one for each quarter of a lamp, at similar angles from the normal.
pub(super) const ALONE: [usize; 4] = [0, 6, 9, 15];

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

    /// Returns the light of all lamps.
    #[inline]
    pub(super) fn arrived(&self) -> Arrived {
        self.small.plus(self.large, 1.0)
    }

    /// Returns the shares that arrive: of the light from lamps, surroundings and sky.
    #[inline]
    pub(super) fn shares(&self) -> [f32; 3] {
        let Arrived { some, all } = self.arrived();
        let direct = if all > 0.0 { some / all } else { 1.0 };
        [direct, self.ambient, self.sky]
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

    #[inline]
    pub(super) fn rows(&self) -> LightRows {
        let Self {
            small,
            large,
            ambient,
            sky,
        } = *self;
        [[small.some, small.all, large.some], [large.all, ambient, sky]]
    }

    #[inline]
    pub(super) fn of_rows([first, second]: LightRows) -> Self {
        Self {
            small: Arrived {
                some: first[0],
                all: first[1],
            },
            large: Arrived {
                some: first[2],
                all: second[0],
            },
            ambient: second[1],
            sky: second[2],
        }
    }
}

/// [`Light`] in rows, which vector code gathers.
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

/// The index of a lamp and whether its sampled point is visible.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LampSample {
    pub(super) lamp: u32,
    pub(super) is_seen: bool,
}

/// The samples of the lamps that contribute most.
pub(super) type LampSamples = [Option<LampSample>; MAX_SHADOWS];

impl Occlusion<'_> {
    /// Returns the light of lamps at a point relative to the eye. `sees` tests whether a spot on a lamp, −1 to 1, is visible.
    pub(super) fn lamplight(
        &self,
        from_eye: Vec3,
        strongest: Strongest,
        cell: PatternCell,
        mut sees: impl FnMut(u32, &Lamp, [f64; 2]) -> bool,
    ) -> (Light, LampSamples) {
        let mut light = Light::default();
        let mut lamp_samples = LampSamples::default();
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
        strongest: Strongest,
        cell: PatternCell,
        stack: &mut Stack,
    ) -> (Light, LampSamples) {
        self.lamplight(place.from_eye, strongest, cell, |_, lamp, spot| {
            self.sees(place, lamp, spot, stack)
        })
    }

    /// Averages several pattern cells at one point, for pixels without similar samples.
    pub(super) fn sample_alone(&self, place: &Place, strengths: &mut Strengths, stack: &mut Stack) -> Light {
        strengths.set(0, place.from_eye, place.normal);
        strengths.measure(self.emitters, self.level);
        self.sample(place, strengths.strongest(0), &ALONE, stack)
    }

    /// Averages pattern cells at one point.
    pub(super) fn sample(
        &self,
        place: &Place,
        strongest: Strongest,
        cells: &[usize],
        stack: &mut Stack,
    ) -> Light {
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let share = 1.0 / cells.len() as f32;
        cells
            .iter()
            .map(|&cell| {
                let cell = PatternCell {
                    of_place: cell,
                    of_tile: cell,
                };
                let (light, _) = self.sample_lamps(place, strongest, cell, stack);
                let (ambient, sky) = self.sample_surroundings(place, cell, stack);
                Light {
                    ambient,
                    sky,
                    ..light
                }
            })
            .fold(Light::default(), |sum, light| sum.plus(light, share))
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
            if let Some((t, _)) = self.caster.cast_through(self.scene, near, stack) {
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
            if self.rig.has_sky && !self.caster.is_shadowed(self.scene, far, stack) {
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
            // The ray ends just before the lamp, which may have its own mesh.
            far: if ends { 0.999 } else { f64::INFINITY },
        };
        direction.dot(place.flat_normal.as_dvec3()) > 0.0 && !self.caster.is_shadowed(self.scene, ray, stack)
    }
}
