//! What is sampled at a place of a grid, and what the nodes around predict well enough.

use super::node::{Around, Expected, Node, Shadow};
use crate::ray::Stack;
use crate::shade::lamp::Size;
use crate::shade::occlusion::{Occlusion, ShadingPoint};
use crate::shade::pattern::{self, Pattern, Spots};
use crate::shade::strength::Strongest;

/// The difference between shares of light that is not seen.
const INVISIBLE: f32 = 0.02;

/// A place and the nodes around it.
pub(super) struct Spot<'a> {
    pub(super) place: ShadingPoint,
    pub(super) around: Around<'a>,
    /// Selects the spot of a lamp that is looked at where the nodes around agree.
    pub(super) probe: Option<u32>,
    pub(super) detail: Detail,
}

/// The grid that a place belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Detail {
    /// Finer ones will follow.
    Coarse,
    Finest,
    /// Pixels between the samples.
    Pixel,
}

/// Whether shares around a place differ by more than is invisible, and were not predicted well themselves.
fn is_rough_in(expected: &[Expected; 2], invisible: [f32; 2]) -> bool {
    let mut shares = expected.iter().zip(invisible);
    shares.any(|(share, invisible)| share.varies(invisible))
}

impl Occlusion<'_> {
    /// Returns the light of a place.
    pub(super) fn node(&self, spot: &Spot<'_>, strongest: Strongest, stack: &mut Stack) -> Node {
        let lamps =
            strongest.map(|lamp| lamp.map(|(lamp, strength)| (lamp, strength, spot.around.lamp(lamp))));
        let surroundings = spot.around.around();
        let open = surroundings.map_or([0.0; 2], |shares| shares.map(|share| share.mean));
        let full = self.rig.around(spot.place.normal);
        let mut light = full[0] * open[0] + full[1] * open[1];
        for (_, strength, expected) in lamps.iter().flatten() {
            light += expected.map_or(0.0, |(expected, _)| expected.mean * strength);
        }
        let invisible = INVISIBLE * light;
        let lamps = lamps.map(|lamp| {
            let (lamp, strength, expected) = lamp?;
            let (seen, spots, is_rough) = match expected {
                Some(expected) => self.expected_spots(spot, lamp, expected, invisible / strength, stack)?,
                None => self.new_spots(spot, lamp, stack)?,
            };
            Some(Shadow {
                lamp,
                strength,
                seen,
                spots,
                is_rough,
            })
        });
        let invisible = full.map(|full| invisible / full.max(f32::MIN_POSITIVE));
        Node {
            lamps,
            ..self.surroundings_at(spot, surroundings, invisible, stack)
        }
    }

    /// Returns the visible spots of a lamp that is not known around.
    fn new_spots(&self, spot: &Spot<'_>, lamp: u32, stack: &mut Stack) -> Option<(f32, Spots, bool)> {
        let lamp = self.rig.lamps.get(lamp as usize)?;
        // Only large lamps are likely to be partly visible.
        let point = self.eye + spot.place.from_eye.as_dvec3();
        let bits = match lamp.size_from(point) {
            Size::Large if spot.detail != Detail::Coarse => self.few_spots_seen(&spot.place, lamp, stack),
            Size::Large => self.spots_seen(&spot.place, lamp, Spots::UNKNOWN, stack),
            Size::Point | Size::Small => self.centre_seen(&spot.place, lamp, stack),
        };
        Some((pattern::share_of(bits), Spots::known(bits), true))
    }

    /// Returns the visible share and spots of a lamp, and whether the share differs from what the nodes around predict.
    fn expected_spots(
        &self,
        spot: &Spot<'_>,
        lamp: u32,
        (expected, spots): (Expected, Spots),
        invisible: f32,
        stack: &mut Stack,
    ) -> Option<(f32, Spots, bool)> {
        let lamp = self.rig.lamps.get(lamp as usize)?;
        let (place, is_between) = (&spot.place, spot.around.is_between);
        let is_whole = spots.certain == u64::MAX || spots.possible == 0;
        // What all nodes around see is seen, and what none sees is not; where all agree, one ray may tell otherwise.
        let mut known = spots;
        let is_known = if invisible >= 1.0 {
            true
        } else if is_between && !is_whole {
            !expected.varies(invisible)
        } else {
            known = Spots::UNKNOWN;
            let probe = spot.probe.or_else(|| (!is_between).then_some(0));
            probe.is_none_or(|probe| {
                let index = Pattern::first(probe);
                let is_seen = self.sees(place, lamp, self.pattern.spot(index), stack);
                spots.is_seen(index).is_none_or(|expected| expected == is_seen)
            })
        };
        if is_known {
            return Some((expected.mean, spots, false));
        }
        if !lamp.has_steady_spots_from(self.eye + place.from_eye.as_dvec3()) {
            known = Spots::UNKNOWN;
        }
        let bits = self.spots_seen(place, lamp, known, stack);
        let seen = pattern::share_of(bits);
        Some((
            seen,
            Spots::known(bits),
            !is_between || expected.differs(seen, invisible),
        ))
    }

    /// Returns a node with the light of the surroundings, and without lamps.
    fn surroundings_at(
        &self,
        spot: &Spot<'_>,
        expected: Option<[Expected; 2]>,
        invisible: [f32; 2],
        stack: &mut Stack,
    ) -> Node {
        if let Some(expected) = expected {
            let is_sampled = match spot.detail {
                Detail::Coarse => !spot.around.is_between || is_rough_in(&expected, invisible),
                // Interpolation over two pixels hides small differences.
                Detail::Finest => is_rough_in(&expected, invisible.map(|share| 4.0 * share)),
                Detail::Pixel => false,
            };
            if !is_sampled {
                return Node {
                    around: expected.map(|share| share.mean),
                    ..Node::default()
                };
            }
        }
        let around = match (expected, spot.detail) {
            (None, Detail::Finest | Detail::Pixel) => self.few_surroundings(&spot.place, stack),
            _ => self.surroundings(&spot.place, stack),
        };
        let is_rough = expected.is_none_or(|expected| {
            let differs = |part: usize| expected[part].differs(around[part], invisible[part]);
            differs(0) || differs(1)
        });
        Node {
            around,
            is_rough,
            ..Node::default()
        }
    }
}
