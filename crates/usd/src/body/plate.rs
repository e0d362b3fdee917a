use oaktwin_camera::math::DVec2;

use super::loft::LoftFrame;
use super::mesh::BodyMesh;
use super::outline::Outline;

/// A convex opening through a plate, with front and back outlines of equal length.
#[derive(Clone, Debug)]
pub(super) struct Opening {
    pub(super) front: Outline,
    pub(super) back: Outline,
}

/// Creates a plate with openings whose outer outline is `outer[i]` at x = `levels[i]`, from back to front.
///
/// The openings are sorted by descending u. `cuts` holds the u of the lines between them, one fewer.
pub(super) fn plate(outer: &[Outline; 3], levels: [f64; 3], openings: &[Opening], cuts: &[f64]) -> BodyMesh {
    let frame = LoftFrame::FORWARD;
    let mut mesh = BodyMesh::default();
    // Seams cross the outer outline at the same fraction of the same edges on every level.
    let splits = split(&outer[0], cuts);
    let rings: Vec<Vec<usize>> = outer
        .iter()
        .zip(levels)
        .map(|(outline, x)| {
            let first = mesh.points.len();
            mesh.points
                .extend(splits.iter().map(|place| frame.point(place.on(outline), x)));
            (first..mesh.points.len()).collect()
        })
        .collect();
    let flat: Vec<DVec2> = splits.iter().map(|place| place.on(&outer[0])).collect();
    for ring in rings.windows(2) {
        walls(&mut mesh, &ring[0], &ring[1]);
    }
    let mut holes = Vec::with_capacity(openings.len());
    for opening in openings {
        let back = mesh.points.len();
        mesh.points
            .extend(opening.back.iter().map(|&uv| frame.point(uv, levels[0])));
        let front = mesh.points.len();
        mesh.points
            .extend(opening.front.iter().map(|&uv| frame.point(uv, levels[2])));
        let back: Vec<usize> = (back..front).collect();
        let front: Vec<usize> = (front..mesh.points.len()).collect();
        walls(&mut mesh, &front, &back);
        holes.push((front, back));
    }
    let seams: Vec<(usize, usize)> = (0..cuts.len()).map(|cut| seam(&splits, &flat, cut)).collect();
    for (index, (front, back)) in holes.iter().enumerate() {
        let cell = cell(flat.len(), index, &seams);
        bridge(
            &mut mesh,
            front,
            &cell.iter().map(|&i| rings[2][i]).collect::<Vec<_>>(),
            false,
        );
        bridge(
            &mut mesh,
            back,
            &cell.iter().map(|&i| rings[0][i]).collect::<Vec<_>>(),
            true,
        );
    }
    mesh
}

/// A point on an outline: a fraction of the edge that starts at a vertex, and the cut that created it, if any.
#[derive(Clone, Copy, Debug)]
struct OutlinePoint {
    edge: usize,
    share: f64,
    cut: Option<usize>,
}

impl OutlinePoint {
    fn on(&self, outline: &[DVec2]) -> DVec2 {
        outline[self.edge].lerp(outline[(self.edge + 1) % outline.len()], self.share)
    }
}

/// Returns the vertices of an outline and its intersections with vertical lines.
fn split(outline: &[DVec2], cuts: &[f64]) -> Vec<OutlinePoint> {
    let mut places = Vec::with_capacity(outline.len() + 2 * cuts.len());
    for edge in 0..outline.len() {
        places.push(OutlinePoint {
            edge,
            share: 0.0,
            cut: None,
        });
        let (a, b) = (outline[edge].x, outline[(edge + 1) % outline.len()].x);
        let mut crossed: Vec<OutlinePoint> = cuts
            .iter()
            .enumerate()
            .filter(|(_, u)| (a - **u) * (b - **u) < 0.0)
            .map(|(cut, &u)| OutlinePoint {
                edge,
                share: (u - a) / (b - a),
                cut: Some(cut),
            })
            .collect();
        crossed.sort_by(|a, b| a.share.total_cmp(&b.share));
        places.extend(crossed);
    }
    places
}

/// Returns the upper and the lower point of a cut.
fn seam(places: &[OutlinePoint], flat: &[DVec2], cut: usize) -> (usize, usize) {
    let mut on_cut = (0..places.len()).filter(|&i| places[i].cut == Some(cut));
    let (a, b) = (on_cut.next().unwrap_or(0), on_cut.next().unwrap_or(0));
    if flat[a].y > flat[b].y { (a, b) } else { (b, a) }
}

/// Returns the outline of the cell around an opening, counter-clockwise. Seams are sorted by descending u.
fn cell(count: usize, index: usize, seams: &[(usize, usize)]) -> Vec<usize> {
    // The outline runs counter-clockwise from the right seam's lower end to its upper end and on to the left seam.
    let left = seams.get(index);
    let right = index.checked_sub(1).and_then(|i| seams.get(i));
    let run = |from: usize, to: usize| {
        let length = (to + count - from) % count;
        (0..=length).map(move |step| (from + step) % count)
    };
    match (right, left) {
        (None, None) => (0..count).collect(),
        (None, Some(&(upper, lower))) => run(lower, upper).collect(),
        (Some(&(upper, lower)), None) => run(upper, lower).collect(),
        (Some(&(upper, lower)), Some(&(far_upper, far_lower))) => {
            run(upper, far_upper).chain(run(far_lower, lower)).collect()
        }
    }
}

fn walls(mesh: &mut BodyMesh, near: &[usize], far: &[usize]) {
    for i in 0..near.len() {
        let j = (i + 1) % near.len();
        mesh.quad(near[i], near[j], far[j], far[i]);
    }
}

/// Fills the band between a convex opening and the convex cell around it, both counter-clockwise in (y, z).
///
/// Each edge of one ring is joined to the vertex of the other that lies farthest along the edge's normal; by convexity
/// no triangle is flipped. Edges are visited in order of direction, once around both rings.
fn bridge(mesh: &mut BodyMesh, hole: &[usize], cell: &[usize], reversed: bool) {
    let at = |mesh: &BodyMesh, i: usize| DVec2::new(mesh.points[i].y, mesh.points[i].z);
    let edge = |mesh: &BodyMesh, ring: &[usize], i: usize| {
        at(mesh, ring[(i + 1) % ring.len()]) - at(mesh, ring[i % ring.len()])
    };
    let normal = -edge(mesh, hole, 0).perp();
    let along = |mesh: &BodyMesh, i: usize| at(mesh, cell[i]).dot(normal);
    let start = (0..cell.len())
        .max_by(|&a, &b| along(mesh, a).total_cmp(&along(mesh, b)))
        .unwrap_or(0);
    let (mut h, mut c) = (0, 0);
    while h < hole.len() || c < cell.len() {
        let (inner, outer) = (hole[h % hole.len()], cell[(start + c) % cell.len()]);
        let turn = edge(mesh, hole, h).perp_dot(edge(mesh, cell, start + c));
        let advance_inner = c == cell.len() || (h < hole.len() && turn >= 0.0);
        let next = if advance_inner {
            h += 1;
            hole[h % hole.len()]
        } else {
            c += 1;
            cell[(start + c) % cell.len()]
        };
        if reversed {
            mesh.triangle(next, outer, inner);
        } else {
            mesh.triangle(inner, outer, next);
        }
    }
}
