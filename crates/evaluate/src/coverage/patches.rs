//! The outcome of a candidate on the whole surface of a region, patch by patch.

use oaktwin_base::diagnostic::{message, opt};
use oaktwin_camera::math::DVec3;
use oaktwin_pipeline::render::Renderer;

use super::assessment::assess_points;
use super::surface::{Part, parts};
use super::{Candidate, CoverageError, Outcome, Region, SurfacePoint};

/// The default number of patches: on a wall of 4 m × 2.5 m, they are 3 cm wide.
pub const PATCHES: u32 = 20_000;

/// The maximum number of triangles of a surface that is divided.
pub const MAX_TRIANGLES: usize = 100_000;

/// The surface of a region in patches, with the outcome of a candidate at the centre of each.
#[derive(Clone, Debug, PartialEq)]
pub struct Patches {
    /// The corners of the triangular patches in the world, in metres.
    pub corners: Vec<[DVec3; 3]>,
    /// The outcomes.
    pub outcomes: Vec<Outcome>,
    /// Measured minus true z, in metres; NaN where nothing is measured.
    pub errors_m: Vec<f32>,
}

impl Patches {
    /// Divides the surface of a region into about `count` patches, none larger than its share of the area, and assesses each by a
    /// candidate. A triangle of the scene that is smaller is a patch.
    ///
    /// # Errors
    /// Returns an error if the region is invalid, has no surface, or has more than [`MAX_TRIANGLES`] triangles.
    pub fn new(
        renderer: &Renderer,
        region: &Region,
        candidate: &Candidate<'_>,
        count: u32,
    ) -> Result<Self, CoverageError> {
        let scene = renderer.scene();
        let parts = parts(scene, region, MAX_TRIANGLES)?.ok_or_else(too_many)?;
        let area: f64 = parts.iter().map(|part| part.area_m2).sum();
        let largest = area / f64::from(count.max(1));
        let mut corners = Vec::new();
        let mut points = Vec::new();
        for part in &parts {
            let first = corners.len();
            divide(part, largest, &mut corners);
            let place = (part.instance, part.triangle);
            points.extend(
                corners[first..]
                    .iter()
                    .map(|&[a, b, c]| SurfacePoint::new(scene, place, part.corners, (a + b + c) / 3.0)),
            );
        }
        let assessed = assess_points(renderer, candidate, &points)?;
        Ok(Self {
            corners,
            outcomes: assessed.outcomes,
            errors_m: assessed.errors_m,
        })
    }
}

/// Halves a triangle across its longest edge until no part is larger than an area.
fn divide(part: &Part, largest_m2: f64, patches: &mut Vec<[DVec3; 3]>) {
    let mut pending = vec![(part.corners, part.area_m2)];
    while let Some(([a, b, c], area)) = pending.pop() {
        if area <= largest_m2 {
            patches.push([a, b, c]);
            continue;
        }
        let lengths = [a.distance(b), b.distance(c), c.distance(a)];
        let longest = if lengths[0] >= lengths[1] && lengths[0] >= lengths[2] {
            [a, b, c]
        } else if lengths[1] >= lengths[2] {
            [b, c, a]
        } else {
            [c, a, b]
        };
        let [a, b, c] = longest;
        let middle = a.midpoint(b);
        pending.extend([([middle, b, c], area / 2.0), ([a, middle, c], area / 2.0)]);
    }
}

fn too_many() -> CoverageError {
    let what =
        format!(": it has more than {MAX_TRIANGLES} triangles, too many to paint; choose a smaller region");
    message![opt("region"), what].into()
}
