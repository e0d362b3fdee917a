//! The light that pixels see in mirrors and through glass.

use std::ops::Range;

use glam::Vec3;

use super::ShadingContext;
use super::optic::OwnLightFactors;
use super::paint::Finishes;
use super::path::{Arrival, Origin, Tracer, Vertex};
use super::reflect::OwnLight;
use super::rig::luminance;
use super::surfaces::{PacketSurfaces, lane_of};
use crate::ray::Stack;
use crate::rays::Rays;

/// What arrives at the pixels of a packet beyond the light of the surfaces that they see.
pub(super) struct Followed {
    /// The factors of the surfaces' own light.
    pub(super) own: OwnLight,
    arrivals: [Range<usize>; 8],
}

impl OwnLight {
    pub(super) fn set(&mut self, lane: usize, own: OwnLightFactors) {
        let lane = lane & 7;
        self.scattered[lane] = own.scattered;
        self.glossy[lane] = own.glossy;
        self.around[lane] = own.around;
        self.emitted[lane] = own.emitted;
    }
}

impl Followed {
    /// Follows the rays of a packet's pixels; `None` if its surfaces send none on. `arrivals` is reused memory.
    pub(super) fn new<'w>(
        context: &'w ShadingContext<'_>,
        rays: &Rays<'_>,
        found: &PacketSurfaces<'_, 'w>,
        finishes: &Finishes,
        stack: &mut Stack,
        arrivals: &mut Vec<Arrival<'w>>,
    ) -> Option<Self> {
        let optic = |lane: usize| {
            let paint = context.paints.get(found.material(lane)? as usize)?;
            paint.optic()
        };
        if !(0..found.count()).any(|lane| optic(lane).is_some()) {
            return None;
        }
        arrivals.clear();
        let mut followed = Self {
            own: OwnLight::ALL,
            arrivals: Default::default(),
        };
        for lane in 0..found.count() {
            let first = arrivals.len();
            let vertex = optic(lane).zip(context.visible(rays, found, lane));
            if let Some((optic, vertex)) = vertex {
                let color = lane_of(&finishes.color, lane);
                let own = Tracer::new(context, stack, arrivals).follow(&vertex, optic, color);
                followed.own.set(lane, own);
            }
            followed.arrivals[lane & 7] = first..arrivals.len();
        }
        Some(followed)
    }

    /// Returns the sum of a surface's own light and of what arrives in its lane, and the distance of the brightest part; `matt` is the own
    /// light without the highlights of lamps, which are not where the surface is. `lights` is the light of each of the packet's arrivals.
    pub(super) fn gathered(
        &self,
        lane: usize,
        [own, matt]: [Vec3; 2],
        range: f64,
        arrivals: &[Arrival<'_>],
        lights: &[Vec3],
    ) -> (Vec3, f64) {
        let mut sum = own;
        let mut brightest = (luminance(matt), range);
        let mut part = (0, 0.0, 0.0);
        let arrived = arrivals.iter().zip(lights).take(self.arrivals[lane & 7].end);
        for (arrival, light) in arrived.skip(self.arrivals[lane & 7].start) {
            let distance = match &arrival.from {
                Origin::Background(_, distance) => *distance,
                Origin::Surface(vertex, _) => vertex.transfer.apparent_m(),
            };
            let light = *light * arrival.factor;
            sum += light;
            // The rays of a blurred reflection are one part, at the distance of the first.
            part = match part {
                (route, sum, first) if route == arrival.route => (route, sum + luminance(light), first),
                _ => (arrival.route, luminance(light), distance),
            };
            if part.1 > brightest.0 {
                brightest = (part.1, part.2);
            }
        }
        (sum, brightest.1)
    }
}

impl ShadingContext<'_> {
    /// Returns the vertex that a pixel of a packet sees.
    fn visible<'w>(
        &'w self,
        rays: &Rays<'_>,
        found: &PacketSurfaces<'_, 'w>,
        lane: usize,
    ) -> Option<Vertex<'w>> {
        let pose = &self.view.world_from_camera;
        let [x, y] = found.place(lane);
        let ray = rays.centre(x, y)?;
        let length = ray.length();
        let in_world = |ray: glam::DVec3| pose.rotation * ray / length;
        let next = rays.next(x, y, ray).map(|next| next.map(in_world));
        let range = f64::from(found.surfaces.range[lane & 7]);
        Vertex::new(
            self.scene,
            pose.translation,
            in_world(ray),
            next,
            found.hit(lane),
            range,
        )
    }
}
