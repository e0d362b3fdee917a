//! Rays that mirrors and transparent surfaces send on.
//!
//! A ray is followed to each surface that sends light along it, with the factor of this light. What a mirror shows is seen from a virtual
//! eye behind it, so that surfaces beyond mirrors have the same footprints of pixels as those seen directly.

use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;

use super::ShadingContext;
use super::curvature::{self, Transfer};
use super::grain;
use super::lobe::{Lobe, normals};
use super::optic::{Balance, Meeting, Optic, OwnLightFactors, Wall};
use super::paint::Paint;
use super::rig::luminance;
use super::surfaces::{Spot, lengths};
use crate::Hit;
use crate::annotate::{Surface, SurfaceFinder};
use crate::ray::{Ray, Stack};

/// The maximum number of reflections on a path.
const MAX_REFLECTIONS: u32 = 4;
/// The maximum number of surfaces that a path passes.
const MAX_PASSES: u32 = 16;
/// Rays that carry a smaller share of the light of a pixel are not followed.
const MIN_SHARE: f32 = 1.0 / 128.0;

/// A place on a surface, as a ray sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex<'a> {
    pub(super) hit: Hit,
    /// The surface as seen from the eye.
    pub(super) surface: Surface<'a>,
    /// The eye, which is a virtual one behind mirrors.
    pub(super) eye: DVec3,
    /// The direction of the ray, a unit vector.
    pub(super) ray: DVec3,
    /// The rays of the pixels to the right and below.
    pub(super) next: [Option<DVec3>; 2],
    /// What the path to the place does to rays beside it.
    pub(super) transfer: Transfer,
    /// The length of the path, metres, in which light travels as far in a vacuum: longer in glass.
    pub(super) length: f64,
}

/// Light that arrives along a path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arrival<'a> {
    /// Its factor, by channel.
    pub(super) factor: Vec3,
    pub(super) from: Origin<'a>,
    /// The reflections and passages on its way, as bits, after a leading 1: equal for all rays of a blurred reflection.
    pub(super) route: u64,
    /// The number of the ray in a blurred reflection; `None` if all reflections are sharp.
    pub(super) ray: Option<u8>,
}

/// Where light comes from.
#[expect(clippy::large_enum_variant, reason = "most light comes from surfaces")]
#[derive(Clone, Copy, Debug)]
pub(super) enum Origin<'a> {
    /// A surface, with the factors of its own light.
    Surface(Vertex<'a>, OwnLightFactors),
    /// The background in a direction, and the distance, metres, at which it appears to be: infinite but for curved mirrors.
    Background(DVec3, f64),
}

/// The state of a path.
#[derive(Clone, Copy, Debug)]
struct Progress {
    factor: Vec3,
    reflections: u32,
    passes: u32,
    route: u64,
    ray: Option<u8>,
}

impl Progress {
    /// Whether nothing has happened to the ray that could blur it.
    fn is_first(&self) -> bool {
        self.reflections == 0 && self.ray.is_none()
    }

    /// Returns the progress of one ray of a lobe.
    fn in_lobe(self, lobe: &Lobe, number: u8) -> Self {
        Self {
            ray: if lobe.is_sharp() { self.ray } else { Some(number) },
            ..self
        }
    }
}

/// How a ray goes on from a vertex.
#[derive(Clone, Copy, Debug)]
struct PathStep {
    /// The ratio of the angle between the rays of pixels to the one at the vertex.
    widening: f64,
    /// Includes what the vertex does.
    transfer: Transfer,
    /// The index of refraction of what is ahead.
    index: f64,
}

/// Follows the rays of an image.
pub(super) struct Tracer<'c, 'a> {
    context: &'c ShadingContext<'a>,
    stack: &'c mut Stack,
    arrivals: &'c mut Vec<Arrival<'a>>,
}

impl<'a> Vertex<'a> {
    /// Finds where the ray of an eye meets a triangle at a distance in metres.
    pub(super) fn new(
        scene: &'a Scene,
        eye: DVec3,
        ray: DVec3,
        next: [Option<DVec3>; 2],
        hit: Hit,
        distance: f64,
    ) -> Option<Self> {
        let surface = SurfaceFinder::at(scene, eye).find_at(hit, ray, distance)?;
        Some(Self {
            hit,
            surface,
            eye,
            ray,
            next,
            transfer: Transfer::over(surface.range),
            length: surface.range,
        })
    }

    /// Returns the place on the triangle.
    pub(super) fn spot(&self) -> Spot {
        Spot::seen_on(&self.surface, self.next)
    }
}

impl<'c, 'a> Tracer<'c, 'a> {
    /// Creates a tracer that puts what arrives into a list.
    pub(super) fn new(
        context: &'c ShadingContext<'a>,
        stack: &'c mut Stack,
        arrivals: &'c mut Vec<Arrival<'a>>,
    ) -> Self {
        Self {
            context,
            stack,
            arrivals,
        }
    }

    /// Follows the rays that a visible surface sends on. Returns the factors of the surface's own light.
    pub(super) fn follow(&mut self, vertex: &Vertex<'a>, optic: &Optic, color: Vec3) -> OwnLightFactors {
        let progress = Progress {
            factor: Vec3::ONE,
            reflections: 0,
            passes: 0,
            route: 1,
            ray: None,
        };
        self.send_on(vertex, optic, color, progress)
    }

    fn send_on(
        &mut self,
        vertex: &Vertex<'a>,
        optic: &Optic,
        color: Vec3,
        progress: Progress,
    ) -> OwnLightFactors {
        let meeting = self.meeting(vertex, optic, color);
        let Balance {
            reflected,
            transmitted,
            mut own,
        } = optic.balance(&meeting);
        let is_followed = |share: Vec3| luminance(progress.factor * share) >= MIN_SHARE;
        if progress.reflections < MAX_REFLECTIONS && is_followed(reflected) {
            let index = if meeting.wall == Wall::Exit {
                optic.index()
            } else {
                1.0
            };
            self.reflect(vertex, optic, reflected, index, progress);
        } else if reflected != Vec3::ZERO {
            own.around = 1.0;
        }
        if progress.passes < MAX_PASSES && is_followed(transmitted) {
            self.pass(vertex, optic, meeting, transmitted, progress);
        }
        own
    }

    fn meeting(&self, vertex: &Vertex<'a>, optic: &Optic, color: Vec3) -> Meeting {
        let scene = self.context.scene;
        let surface = &vertex.surface;
        let cutouts = self.context.occlusion.caster.cutouts();
        let [opacity, clarity] = cutouts.map_or([1.0; 2], |cutouts| {
            cutouts.opacity(scene, vertex.hit, vertex.eye, vertex.ray)
        });
        let is_clear = optic.transmits() && clarity > 0.0 || opacity < 1.0;
        let instance = scene.instances.get(vertex.hit.instance as usize);
        let is_closed = || instance.is_some_and(|instance| self.context.closed.is(scene, instance.mesh));
        let wall = match is_clear {
            true if !is_closed() => Wall::Sheet,
            true if optic.refracts() && surface.is_back => Wall::Exit,
            true if optic.refracts() => Wall::Entry,
            _ => Wall::Side,
        };
        Meeting {
            cosine: -vertex.ray.dot(surface.normal),
            color,
            opacity,
            clarity,
            wall,
        }
    }

    /// Follows what a surface reflects; `index` is the index of refraction on the side of the ray.
    fn reflect(&mut self, vertex: &Vertex<'a>, optic: &Optic, share: Vec3, index: f64, progress: Progress) {
        let lobe = normals(vertex.surface.normal, optic.roughness(), 2.0, progress.is_first());
        let progress = Progress {
            reflections: progress.reflections + 1,
            factor: progress.factor * share * lobe.share(),
            route: progress.route << 1,
            ..progress
        };
        let widening = lobe.widening(vertex.ray, vertex.next);
        let transfer = vertex.transfer.reflected(self.curvature(vertex));
        let way = PathStep {
            widening,
            transfer,
            index,
        };
        for (number, normal) in (0..).zip(lobe.iter()) {
            let progress = progress.in_lobe(&lobe, number);
            let normal = match mirrored(vertex.ray, normal).dot(vertex.surface.flat_normal) > 0.0 {
                true => normal,
                false => vertex.surface.flat_normal,
            };
            let turned = |ray: DVec3| lobe.widened(mirrored(vertex.ray, normal), mirrored(ray, normal));
            let next = vertex.next.map(|ray| ray.map(turned));
            self.cast(vertex, mirrored(vertex.ray, normal), next, way, progress);
        }
    }

    fn pass(
        &mut self,
        vertex: &Vertex<'a>,
        optic: &Optic,
        meeting: Meeting,
        share: Vec3,
        progress: Progress,
    ) {
        let is_first = progress.is_first();
        let progress = Progress {
            passes: progress.passes + 1,
            factor: progress.factor * share,
            route: progress.route << 1 | 1,
            ..progress
        };
        // The index of refraction on the side of the ray divided by the one behind; 1 where light passes straight on.
        let (ratio, index) = match meeting.wall {
            Wall::Entry => (1.0 / optic.index(), optic.index()),
            Wall::Exit => (optic.index(), 1.0),
            Wall::Sheet | Wall::Side => (1.0, 1.0),
        };
        // Light is scattered by rough glass, and not by what is partly invisible.
        let roughness = if optic.transmits() { optic.roughness() } else { 0.0 };
        let normal = vertex.surface.normal;
        let is_straight = meeting.wall == Wall::Sheet || meeting.wall == Wall::Side;
        let turn = if is_straight { 2.0 } else { (1.0 - ratio).abs() };
        let lobe = normals(normal, roughness, turn, is_first);
        let transfer = match is_straight {
            true => vertex.transfer,
            false => vertex.transfer.refracted(ratio, self.curvature(vertex)),
        };
        let way = PathStep {
            widening: lobe.widening(vertex.ray, vertex.next),
            transfer,
            index,
        };
        for (number, facet) in (0..).zip(lobe.iter()) {
            let bent = |ray: DVec3| match is_straight {
                true if lobe.is_sharp() => Some(ray),
                // A thin wall turns rays as a mirror does, to its other side.
                true => Some(mirrored(mirrored(ray, facet), normal)),
                false => refracted(ray.normalize(), facet, ratio),
            };
            let Some(ray) = bent(vertex.ray) else { continue };
            // Facets that would reflect it are as seldom as those that would reflect light into the surface.
            if !lobe.is_sharp() && ray.dot(vertex.surface.flat_normal) > 0.0 {
                continue;
            }
            let next = (vertex.next).map(|next| next.and_then(bent).map(|next| lobe.widened(ray, next)));
            let progress = Progress {
                factor: progress.factor * lobe.share(),
                ..progress.in_lobe(&lobe, number)
            };
            self.cast(vertex, ray, next, way, progress);
        }
    }

    /// Returns the curvature of a vertex along the baseline: the cameras of a pair are side by side.
    fn curvature(&self, vertex: &Vertex<'a>) -> f64 {
        let across = self.context.view.world_from_camera.rotation.x_axis;
        curvature::along(
            self.context.scene,
            &vertex.surface,
            vertex.hit,
            vertex.eye,
            across,
        )
    }

    /// Casts a ray from a vertex in a direction, a unit vector.
    fn cast(
        &mut self,
        from: &Vertex<'a>,
        ray: DVec3,
        next: [Option<DVec3>; 2],
        way: PathStep,
        progress: Progress,
    ) {
        let PathStep {
            widening, transfer, ..
        } = way;
        let scene = self.context.scene;
        let (point, range) = (from.surface.point, from.surface.range);
        let ahead = Ray {
            origin: point,
            direction: ray,
            near: 1e-6 + 1e-6 * range,
            far: f64::INFINITY,
        };
        let Some((t, hit)) = self.context.occlusion.caster.cast(scene, ahead, self.stack) else {
            self.arrivals.push(Arrival {
                factor: progress.factor,
                from: Origin::Background(ray, transfer.apparent_sky_m()),
                route: progress.route,
                ray: progress.ray,
            });
            return;
        };
        // From the virtual eye, the footprint of the pixel at the vertex is unchanged.
        let behind = range / widening;
        let Some(vertex) = Vertex::new(scene, point - ray * behind, ray, next, hit, behind + t) else {
            return;
        };
        let vertex = Vertex {
            transfer: transfer.ahead(t),
            length: from.length + t * way.index,
            ..vertex
        };
        let paint = self.context.paint(hit);
        let own = match paint.optic() {
            Some(optic) => {
                let color = self.context.color_at(paint, &vertex);
                self.send_on(&vertex, optic, color, progress)
            }
            None => OwnLightFactors::ALL,
        };
        self.arrivals.push(Arrival {
            factor: progress.factor,
            from: Origin::Surface(vertex, own),
            route: progress.route,
            ray: progress.ray,
        });
    }
}

impl ShadingContext<'_> {
    /// Returns the base colour of a place.
    pub(super) fn color_at(&self, paint: &Paint<'_>, vertex: &Vertex<'_>) -> Vec3 {
        let (mesh, triangle, spot) = (vertex.surface.mesh, vertex.hit.triangle, vertex.spot());
        let color = paint.color(mesh, triangle, &spot, self.level);
        let grain = self.scene.micro_texture.as_ref().filter(|_| !paint.is_textured());
        let instance = self.scene.instances.get(vertex.hit.instance as usize);
        let place = instance.and_then(|instance| {
            let scale = lengths(&instance.world_from_mesh.matrix3);
            spot.grained(mesh, triangle, scale)
        });
        match (grain, place) {
            (Some(grain), Some((point, footprint))) => {
                color * grain::factor(grain, vertex.hit.instance, point, footprint)
            }
            _ => color,
        }
    }
}

fn mirrored(ray: DVec3, normal: DVec3) -> DVec3 {
    ray - normal * (2.0 * ray.dot(normal))
}

/// Returns the direction of a ray, a unit vector, behind a surface with a normal towards it; `ratio` is the index of refraction on its side
/// divided by the one behind. `None` if all light is reflected.
fn refracted(ray: DVec3, normal: DVec3, ratio: f64) -> Option<DVec3> {
    let cosine = -ray.dot(normal);
    let behind = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (behind > 0.0).then(|| ray * ratio + normal * (ratio * cosine - behind.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refraction_follows_snells_law() {
        let normal = DVec3::new(0.0, 0.0, -1.0);
        for degrees in [0.0, 20.0, 60.0, 85.0_f64] {
            let sine = degrees.to_radians().sin();
            let ray = DVec3::new(sine, 0.0, (1.0 - sine * sine).sqrt());
            let inside = refracted(ray, normal, 1.0 / 1.5).unwrap();
            assert!((inside.x - sine / 1.5).abs() < 1e-12 && (inside.length() - 1.0).abs() < 1e-12);
            let outside = refracted(inside, normal, 1.5).unwrap();
            assert!((outside - ray).length() < 1e-9);
        }
        let steep = DVec3::new(0.8, 0.0, 0.6);
        assert_eq!(refracted(steep, normal, 1.5), None);
    }
}
