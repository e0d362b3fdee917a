//! Points distributed evenly over a surface.

use std::ops::Range;

use oaktwin_base::diagnostic::{message, opt};
use oaktwin_camera::math::DVec3;
use oaktwin_scene::{Bounds, Scene};
use rayon::prelude::*;

use super::clip::{area, fan, inside};
use super::{CoverageError, Region};

/// The number of triangles that are handled at once.
const CHUNK: usize = 4096;

/// Points on a surface that represent equal areas.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    /// The area of the surface, one side of each face, in m².
    pub area_m2: f64,
    /// The points, in the order of the scene's instances and their triangles.
    pub points: Vec<SurfacePoint>,
}

/// A point on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The position in the world, in metres.
    pub position: DVec3,
    /// The unit normal of the face in the world, towards the outside.
    pub normal: DVec3,
    /// Whether the mesh is visible from both sides, so that the outside may be either.
    pub is_double_sided: bool,
    /// The index of the instance in the scene.
    pub instance: u32,
    /// The index of the triangle in the instance's mesh.
    pub triangle: u32,
}

/// Consecutive triangles of an instance.
#[derive(Clone, Copy)]
struct Chunk {
    instance: usize,
    first: usize,
    count: usize,
}

impl Samples {
    /// Distributes `count` points over the surface of a region. The surface, in the order of its triangles, is divided into as
    /// many parts of equal area, and one point is placed in each. The points depend on nothing but the scene, the region and their
    /// number.
    ///
    /// # Errors
    /// Returns an error if the region is invalid or has no surface.
    pub fn new(scene: &Scene, region: &Region, count: u32) -> Result<Self, CoverageError> {
        let instances = region.instances(scene)?;
        let chunks: Vec<Chunk> = instances
            .iter()
            .flat_map(|&instance| chunks(scene, instance))
            .collect();
        let areas: Vec<f64> = chunks
            .par_iter()
            .map(|chunk| {
                polygons(scene, *chunk, region.within)
                    .map(|(_, part)| area(&part))
                    .sum()
            })
            .collect();
        let mut ends = Vec::with_capacity(areas.len());
        let mut area_m2 = 0.0;
        for area in areas {
            area_m2 += area;
            ends.push(area_m2);
        }
        if !(area_m2 > 0.0 && area_m2.is_finite()) {
            return Err(no_surface(scene, region));
        }
        let strata = Strata { area_m2, count };
        let points: Vec<Vec<SurfacePoint>> = chunks
            .par_iter()
            .enumerate()
            .map(|(i, chunk)| {
                let start = if i == 0 { 0.0 } else { ends[i - 1] };
                place(scene, *chunk, region.within, start..ends[i], strata)
            })
            .collect();
        Ok(Self {
            area_m2,
            points: points.concat(),
        })
    }
}

fn chunks(scene: &Scene, instance: usize) -> impl Iterator<Item = Chunk> {
    let mesh = scene.meshes.get(scene.instances[instance].mesh as usize);
    let count = mesh.map_or(0, |mesh| mesh.triangles.len());
    (0..count).step_by(CHUNK).map(move |first| Chunk {
        instance,
        first,
        count: CHUNK.min(count - first),
    })
}

/// The parts of a chunk's triangles inside the region's box, with the indices of the triangles, in the world.
fn polygons(
    scene: &Scene,
    chunk: Chunk,
    within: Option<Bounds>,
) -> impl Iterator<Item = (usize, Vec<DVec3>)> {
    let instance = &scene.instances[chunk.instance];
    let mesh = &scene.meshes[instance.mesh as usize];
    (chunk.first..chunk.first + chunk.count).filter_map(move |triangle| {
        let corners = mesh.corners(triangle)?;
        let corners = corners.map(|p| {
            instance
                .world_from_mesh
                .transform_point3(DVec3::from(p.map(f64::from)))
        });
        let polygon = inside(corners, within);
        (polygon.len() >= 3).then_some((triangle, polygon))
    })
}

/// A surface divided into parts of equal area.
#[derive(Clone, Copy)]
struct Strata {
    area_m2: f64,
    count: u32,
}

impl Strata {
    /// The position of a point along the accumulated area; it increases with the index.
    fn position(self, i: u32) -> f64 {
        let part = (f64::from(i) + sequence(i)[0]) / f64::from(self.count);
        (part * self.area_m2).min(self.area_m2.next_down())
    }

    /// The first index whose position is not below `start`.
    fn first_from(self, start: f64) -> u32 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the cast saturates"
        )]
        let estimate = (start / self.area_m2 * f64::from(self.count)) as u32;
        let near = estimate.saturating_sub(2)..self.count;
        let mut near = near.skip_while(|&i| self.position(i) < start);
        near.next().unwrap_or(self.count)
    }
}

/// Places those points in a chunk whose position along the accumulated area is in `range`.
fn place(
    scene: &Scene,
    chunk: Chunk,
    within: Option<Bounds>,
    range: Range<f64>,
    strata: Strata,
) -> Vec<SurfacePoint> {
    let mut indices = strata.first_from(range.start)..strata.first_from(range.end);
    let mut points = Vec::with_capacity(indices.len());
    let mut start = range.start;
    let mut last = None;
    for (triangle, polygon) in polygons(scene, chunk, within) {
        if indices.is_empty() {
            break;
        }
        for (corners, area) in fan(&polygon) {
            let end = start + area;
            while !indices.is_empty() && strata.position(indices.start) < end {
                points.push(point(scene, chunk.instance, triangle, corners, indices.start));
                indices.start += 1;
            }
            if area > 0.0 {
                last = Some((triangle, corners));
            }
            start = end;
        }
    }
    // Rounding may leave points behind the end of the last triangle.
    if let Some((triangle, corners)) = last {
        points.extend(indices.map(|i| point(scene, chunk.instance, triangle, corners, i)));
    }
    points
}

/// The point of this index in a triangle.
fn point(scene: &Scene, instance: usize, triangle: usize, [a, b, c]: [DVec3; 3], index: u32) -> SurfacePoint {
    let [_, u, v] = sequence(index);
    // The other half of the parallelogram is folded onto the triangle.
    let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
    SurfacePoint::new(
        scene,
        (instance, triangle),
        [a, b, c],
        a + u * (b - a) + v * (c - a),
    )
}

impl SurfacePoint {
    /// Creates the point at a position in a part of an instance's triangle.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "indices of a scene are 32 bits wide"
    )]
    pub(super) fn new(
        scene: &Scene,
        (instance, triangle): (usize, usize),
        [a, b, c]: [DVec3; 3],
        position: DVec3,
    ) -> Self {
        let normal = (b - a).cross(c - a).normalize_or_zero();
        // A mirrored mesh has its outside on the other side of its winding.
        let placed = &scene.instances[instance];
        let is_mirrored = placed.world_from_mesh.matrix3.determinant() < 0.0;
        Self {
            position,
            normal: if is_mirrored { -normal } else { normal },
            is_double_sided: scene.meshes[placed.mesh as usize].double_sided,
            instance: instance as u32,
            triangle: triangle as u32,
        }
    }
}

/// A part of a triangle of an instance, in the world.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) instance: usize,
    pub(super) triangle: usize,
    pub(super) corners: [DVec3; 3],
    pub(super) area_m2: f64,
}

/// Returns the surface of a region as triangles; `None` if there are more than `limit`.
///
/// # Errors
/// Returns an error if the region is invalid or has no surface.
pub(super) fn parts(
    scene: &Scene,
    region: &Region,
    limit: usize,
) -> Result<Option<Vec<Part>>, CoverageError> {
    let instances = region.instances(scene)?;
    let chunks = instances.iter().flat_map(|&instance| chunks(scene, instance));
    let all = chunks.flat_map(|chunk| {
        polygons(scene, chunk, region.within).flat_map(move |(triangle, polygon)| {
            let parts: Vec<Part> = fan(&polygon)
                .map(|(corners, area_m2)| Part {
                    instance: chunk.instance,
                    triangle,
                    corners,
                    area_m2,
                })
                .collect();
            parts
        })
    });
    let found: Vec<Part> = all
        .filter(|part| part.area_m2 > 0.0 && part.area_m2.is_finite())
        .take(limit.saturating_add(1))
        .collect();
    match found.len() {
        0 => Err(no_surface(scene, region)),
        count if count > limit => Ok(None),
        _ => Ok(Some(found)),
    }
}

/// The element of a sequence that covers the unit cube evenly, and so does any run of its elements: the additive recurrence of
/// Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018), whose steps are powers of the root of x⁴ = x + 1.
fn sequence(i: u32) -> [f64; 3] {
    const ROOT: f64 = 1.220_744_084_605_759_5;
    [ROOT, ROOT * ROOT, ROOT * ROOT * ROOT].map(|step| (0.5 + f64::from(i) / step).fract())
}

fn no_surface(scene: &Scene, region: &Region) -> CoverageError {
    let objects = region.objects.join(", ");
    if region.within.is_none() {
        let place = if objects.is_empty() { "the scene" } else { &objects };
        return message![
            opt("region"),
            format!(": {place} has no surface; choose objects with faces")
        ]
        .into();
    }
    let reach = scene.bounds().map(|bounds| {
        let [min, max] = [bounds.min, bounds.max].map(|p| p.to_array().map(|x| format!("{x:.3}")).join(" "));
        format!("; the scene extends from {min} to {max} m")
    });
    let place = if objects.is_empty() {
        String::new()
    } else {
        format!(" of {objects}")
    };
    message![
        opt("region-box"),
        format!(
            ": it contains no surface{place}; choose a larger box or another place{}",
            reach.unwrap_or_default()
        )
    ]
    .into()
}
