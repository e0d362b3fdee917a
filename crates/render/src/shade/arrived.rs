//! The light that arrives along the paths of rays, of eight surfaces at a time.

use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_simd::run_lanes_at;

use super::ShadingContext;
use super::film::Film;
use super::occlusion::{ShadingPoint, Shares};
use super::paint::Finishes;
use super::path::{Arrival, Origin, Vertex};
use super::pattern::Pattern;
use super::reflect::{OwnLight, Radiance};
use super::strength::Strengths;
use super::surfaces::{Columns, Surfaces, lane_of, set_lane};
use crate::ray::Stack;

/// Up to eight places that send light along paths.
#[derive(Default)]
struct Senders {
    count: usize,
    /// The indices of the arrivals, and their rays in blurred reflections.
    arrivals: [usize; 8],
    rays: [Option<u8>; 8],
    surfaces: Surfaces,
    viewers: Columns,
    finishes: Finishes,
    own: OwnLight,
}

impl Senders {
    /// Adds a place that sends light to an arrival. Returns its lane.
    #[expect(clippy::cast_possible_truncation, reason = "shading is float32")]
    fn push(&mut self, arrival: usize, vertex: &Vertex<'_>, eye: DVec3) -> usize {
        let lane = self.count & 7;
        self.count = lane + 1;
        self.arrivals[lane] = arrival;
        let surface = &vertex.surface;
        let from_eye = surface.point - eye;
        set_lane(&mut self.surfaces.point, lane, from_eye.as_vec3());
        self.surfaces.range[lane] = from_eye.length() as f32;
        set_lane(&mut self.surfaces.normal, lane, surface.normal.as_vec3());
        set_lane(
            &mut self.surfaces.flat_normal,
            lane,
            surface.flat_normal.as_vec3(),
        );
        set_lane(&mut self.viewers, lane, -vertex.ray.as_vec3());
        lane
    }
}

impl ShadingContext<'_> {
    /// Computes the exposed radiance that arrives along each path, without the path's factor.
    pub(super) fn lights(
        &self,
        arrivals: &[Arrival<'_>],
        lights: &mut Vec<Vec3>,
        strengths: &mut Strengths,
        stack: &mut Stack,
    ) {
        lights.clear();
        let mut senders = Senders::default();
        for arrival in arrivals {
            match &arrival.from {
                Origin::Background(direction, _) => lights.push(self.rig.background(*direction)),
                Origin::Surface(vertex, own) => {
                    let paint = self.paint(vertex.hit);
                    let lane = senders.push(lights.len(), vertex, self.view.world_from_camera.translation);
                    senders.finishes.set(lane, paint, self.color_at(paint, vertex));
                    senders.own.set(lane, *own);
                    senders.rays[lane] = arrival.ray;
                    lights.push(Vec3::ZERO);
                }
            }
            if senders.count == 8 {
                self.light_up(&mut senders, lights, strengths, stack);
            }
        }
        self.light_up(&mut senders, lights, strengths, stack);
    }

    /// Computes the lights of places and removes them.
    fn light_up(
        &self,
        senders: &mut Senders,
        lights: &mut [Vec3],
        strengths: &mut Strengths,
        stack: &mut Stack,
    ) {
        for lane in 0..senders.count {
            let place = ShadingPoint::of_lane(&senders.surfaces, lane);
            strengths.set(lane, place.from_eye, place.normal);
        }
        strengths.measure(self.occlusion.emitters, self.level);
        let mut shares = Shares::default();
        for lane in 0..senders.count {
            let place = ShadingPoint::of_lane(&senders.surfaces, lane);
            // All rays of a blurred reflection together resolve its light.
            let one = senders.rays[lane & 7].map(|ray| [Pattern::first(ray.into())]);
            let rays = one.as_ref().map_or(&Pattern::FEW[..], |one| &one[..]);
            let light = (self.occlusion).sample(&place, strengths.strongest(lane), rays, stack);
            shares.set(lane, light.shares());
        }
        let kernel = Radiance {
            surfaces: &senders.surfaces,
            finishes: &senders.finishes,
            shares: &shares,
            emitters: self.occlusion.emitters,
            rig: self.rig,
            viewer: Some(&senders.viewers),
            own: Some(&senders.own),
            film: Film::Linear,
        };
        let radiance = run_lanes_at(self.level, kernel);
        for lane in 0..senders.count {
            if let Some(light) = lights.get_mut(senders.arrivals[lane & 7]) {
                *light = lane_of(&radiance, lane);
            }
        }
        senders.count = 0;
    }
}
