//! One level of refinement: the rules of Catmull and Clark, of Loop, and linear ones, with creases as in
//! `OpenSubdiv`.
//!
//! Sources: E. Catmull and J. Clark, "Recursively generated B-spline surfaces on arbitrary topological meshes" (1978);
//! C. Loop, "Smooth subdivision surfaces based on triangles" (1987); T. `DeRose`, M. Kass and T. Truong, "Subdivision
//! surfaces in character animation" (1998) for creases of finite sharpness.

use super::Scheme;
use super::edges::{Edges, key};
use crate::turn;

/// This sharpness and above is infinite.
pub(super) const INFINITE: f32 = 10.0;

/// Polygons with values at their points, such as positions.
pub(super) struct Surface<const N: usize> {
    pub(super) values: Vec<[f64; N]>,
    /// The first corner of each face, and the end of the last face.
    pub(super) starts: Vec<u32>,
    /// The point of each corner.
    pub(super) corners: Vec<u32>,
    /// Sharp edges, ordered by [`key`].
    pub(super) sharp_edges: Vec<(u64, f32)>,
    /// Sharp points, ordered.
    pub(super) sharp_points: Vec<(u32, f32)>,
    /// Whether points with a single face are fixed.
    pub(super) sharp_corners: bool,
}

/// The sharpness at the next level.
fn worn(sharpness: f32) -> f32 {
    if sharpness >= INFINITE {
        INFINITE
    } else {
        (sharpness - 1.0).max(0.0)
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Rule {
    Smooth,
    Crease,
    Corner,
}

impl Rule {
    fn of(sharpness: f32, sharp_edges: usize) -> Self {
        match sharp_edges {
            _ if sharpness > 0.0 => Self::Corner,
            0 | 1 => Self::Smooth,
            2 => Self::Crease,
            _ => Self::Corner,
        }
    }
}

/// A sharp edge seen from one of its end points.
struct Spoke {
    point: u32,
    end: u32,
    sharpness: f32,
}

/// The neighbourhood of each point.
struct Ring<const N: usize> {
    ends: Vec<[f64; N]>,
    faces: Vec<[f64; N]>,
    edge_count: Vec<u32>,
    face_count: Vec<u32>,
}

impl<const N: usize> Surface<N> {
    /// Refines by the given number of levels.
    pub(super) fn refined(self, scheme: Scheme, linear: bool, levels: u32) -> Self {
        let rules = if linear { Scheme::Bilinear } else { scheme };
        (0..levels).fold(self, |surface, _| surface.split(scheme == Scheme::Loop, rules))
    }

    /// Returns the next level: existing points first, then points of edges, then points of faces. The children of a face are
    /// consecutive, one for each corner in order; a triangle split into triangles has a fourth in the middle.
    fn split(self, into_triangles: bool, scheme: Scheme) -> Self {
        let edges = Edges::of(&self.starts, &self.corners);
        let sharpness = self.edge_sharpness(&edges);
        let faces = self.face_points();
        let edge_points = self.edge_points(scheme, &edges, &sharpness, &faces);
        let points = match scheme {
            Scheme::CatmullClark | Scheme::Loop => self.moved_points(scheme, &edges, &sharpness, &faces),
            Scheme::Bilinear | Scheme::None => self.values.clone(),
        };
        let offset = index(self.values.len());
        let mut sharp_edges = Vec::with_capacity(2 * self.sharp_edges.len());
        for &(edge, sharpness) in &self.sharp_edges {
            let sharpness = worn(sharpness);
            if let Some(found) = edges.find(edge).filter(|_| sharpness > 0.0) {
                let middle = offset + index(found);
                sharp_edges.extend(edges.ends[found].map(|end| (key(end, middle), sharpness)));
            }
        }
        sharp_edges.sort_unstable_by_key(|&(edge, _)| edge);
        let (starts, corners) = if into_triangles {
            self.quartered(&edges, offset)
        } else {
            self.quads(&edges, offset)
        };
        let mut values = points;
        values.extend(edge_points);
        if !into_triangles {
            values.extend(faces);
        }
        Self {
            values,
            starts,
            corners,
            sharp_edges,
            sharp_points: self
                .sharp_points
                .iter()
                .map(|&(point, sharpness)| (point, worn(sharpness)))
                .filter(|&(_, sharpness)| sharpness > 0.0)
                .collect(),
            sharp_corners: self.sharp_corners,
        }
    }

    fn quads(&self, edges: &Edges, offset: u32) -> (Vec<u32>, Vec<u32>) {
        let mut corners = Vec::with_capacity(4 * self.corners.len());
        for (center, face) in (offset + index(edges.len())..).zip(self.starts.windows(2)) {
            for corner in face[0]..face[1] {
                let before = if corner > face[0] { corner - 1 } else { face[1] - 1 };
                corners.extend([
                    self.corners[corner as usize],
                    offset + edges.of_corner[corner as usize],
                    center,
                    offset + edges.of_corner[before as usize],
                ]);
            }
        }
        (
            (0..=index(self.corners.len())).map(|quad| 4 * quad).collect(),
            corners,
        )
    }

    fn quartered(&self, edges: &Edges, offset: u32) -> (Vec<u32>, Vec<u32>) {
        let mut corners = Vec::with_capacity(4 * self.corners.len());
        for (face, points) in edges.of_corner.chunks_exact(3).zip(self.corners.chunks_exact(3)) {
            let middle = [face[0], face[1], face[2]].map(|edge| offset + edge);
            corners.extend([points[0], middle[0], middle[2]]);
            corners.extend([points[1], middle[1], middle[0]]);
            corners.extend([points[2], middle[2], middle[1]]);
            corners.extend(middle);
        }
        let triangles = index(corners.len() / 3);
        ((0..=triangles).map(|triangle| 3 * triangle).collect(), corners)
    }

    fn face_points(&self) -> Vec<[f64; N]> {
        let center = |face: &[u32]| {
            let mut sum = [0.0; N];
            for &point in &self.corners[face[0] as usize..face[1] as usize] {
                add(&mut sum, self.values[point as usize], 1.0);
            }
            sum.map(|x| x / f64::from((face[1] - face[0]).max(1)))
        };
        self.starts.windows(2).map(center).collect()
    }

    /// The sharpness of all edges, infinite at borders and where more than two faces meet.
    fn edge_sharpness(&self, edges: &Edges) -> Vec<f32> {
        let mut sharpness: Vec<f32> = edges
            .faces
            .iter()
            .map(|&faces| if faces == 2 { 0.0 } else { INFINITE })
            .collect();
        for &(edge, sharp) in &self.sharp_edges {
            if let Some(found) = edges.find(edge) {
                sharpness[found] = sharpness[found].max(sharp);
            }
        }
        sharpness
    }

    fn edge_points(
        &self,
        scheme: Scheme,
        edges: &Edges,
        sharpness: &[f32],
        faces: &[[f64; N]],
    ) -> Vec<[f64; N]> {
        // The sum that smooth edges also depend on: the faces' centres, or the opposite points.
        let mut across = vec![[0.0; N]; edges.len()];
        for (face, center) in self.starts.windows(2).zip(faces) {
            for corner in face[0]..face[1] {
                let other = match scheme {
                    Scheme::Loop => {
                        self.values[self.corners[(face[0] + (corner - face[0] + 2) % 3) as usize] as usize]
                    }
                    _ => *center,
                };
                add(&mut across[edges.of_corner[corner as usize] as usize], other, 1.0);
            }
        }
        let (near, far) = match scheme {
            Scheme::CatmullClark => (0.25, 0.25),
            Scheme::Loop => (0.375, 0.125),
            Scheme::Bilinear | Scheme::None => (0.5, 0.0),
        };
        let point = |(edge, across): (usize, [f64; N])| {
            let [a, b] = edges.ends[edge].map(|end| self.values[end as usize]);
            let sharp = f64::from(sharpness[edge].min(1.0));
            let near = near + (0.5 - near) * sharp;
            let mut sum = [0.0; N];
            add(&mut sum, a, near);
            add(&mut sum, b, near);
            add(&mut sum, across, far * (1.0 - sharp));
            sum
        };
        across.into_iter().enumerate().map(point).collect()
    }

    fn moved_points(
        &self,
        scheme: Scheme,
        edges: &Edges,
        sharpness: &[f32],
        faces: &[[f64; N]],
    ) -> Vec<[f64; N]> {
        let ring = self.ring(edges, faces);
        let spokes = spokes(edges, sharpness);
        let mut spokes = spokes.chunk_by(|a, b| a.point == b.point).peekable();
        let mut sharp_points = self.sharp_points.iter().peekable();
        let mut moved = Vec::with_capacity(self.values.len());
        for point in 0..index(self.values.len()) {
            let spokes = spokes.next_if(|spokes| spokes[0].point == point).unwrap_or(&[]);
            let authored = sharp_points
                .next_if(|sharp| sharp.0 == point)
                .map_or(0.0, |sharp| sharp.1);
            let sharpness = if self.is_pinned(point, &ring, spokes, edges) {
                INFINITE
            } else {
                authored
            };
            moved.push(self.moved_point(scheme, point, &ring, spokes, sharpness));
        }
        moved
    }

    /// Whether a point is a corner of the border, or not on a manifold surface.
    fn is_pinned(&self, point: u32, ring: &Ring<N>, spokes: &[Spoke], edges: &Edges) -> bool {
        let (edge_count, face_count) = (ring.edge_count[point as usize], ring.face_count[point as usize]);
        let many_faces = |spoke: &Spoke| {
            edges
                .find(key(spoke.point, spoke.end))
                .is_some_and(|edge| edges.faces[edge] > 2)
        };
        face_count == 0
            || (face_count == 1 && self.sharp_corners)
            || edge_count > face_count + 1
            || spokes.iter().any(many_faces)
    }

    fn moved_point(
        &self,
        scheme: Scheme,
        point: u32,
        ring: &Ring<N>,
        spokes: &[Spoke],
        sharpness: f32,
    ) -> [f64; N] {
        let here = self.values[point as usize];
        let sharp_after = spokes.iter().filter(|spoke| worn(spoke.sharpness) > 0.0);
        let before = Rule::of(sharpness, spokes.len());
        let after = Rule::of(worn(sharpness), sharp_after.clone().count());
        let at = |rule: Rule, spokes: &mut dyn Iterator<Item = &Spoke>| match rule {
            Rule::Corner => here,
            Rule::Crease => {
                let mut sum = here.map(|x| 0.75 * x);
                for spoke in spokes {
                    add(&mut sum, self.values[spoke.end as usize], 0.125);
                }
                sum
            }
            Rule::Smooth => smooth(scheme, point as usize, here, ring),
        };
        let sharp = at(before, &mut spokes.iter());
        if before == after {
            return sharp;
        }
        // Interpolates by the mean sharpness of the edges that end within this level.
        let ending = spokes
            .iter()
            .map(|spoke| spoke.sharpness)
            .chain((sharpness > 0.0).then_some(sharpness))
            .filter(|&sharpness| worn(sharpness) == 0.0);
        let (sum, count) = ending.fold((0.0, 0.0), |(sum, count), sharpness| {
            (sum + f64::from(sharpness), count + 1.0)
        });
        let weight = if count > 0.0 { (sum / count).min(1.0) } else { 0.0 };
        let dull = at(after, &mut sharp_after.clone());
        let mut mixed = sharp.map(|x| weight * x);
        add(&mut mixed, dull, 1.0 - weight);
        mixed
    }

    fn ring(&self, edges: &Edges, faces: &[[f64; N]]) -> Ring<N> {
        let count = self.values.len();
        let mut ring = Ring {
            ends: vec![[0.0; N]; count],
            faces: vec![[0.0; N]; count],
            edge_count: vec![0; count],
            face_count: vec![0; count],
        };
        for &[a, b] in &edges.ends {
            for (here, there) in [(a, b), (b, a)] {
                add(&mut ring.ends[here as usize], self.values[there as usize], 1.0);
                ring.edge_count[here as usize] += 1;
            }
        }
        for (face, center) in self.starts.windows(2).zip(faces) {
            for &point in &self.corners[face[0] as usize..face[1] as usize] {
                add(&mut ring.faces[point as usize], *center, 1.0);
                ring.face_count[point as usize] += 1;
            }
        }
        ring
    }
}

/// The new position of a point inside a smooth surface.
fn smooth<const N: usize>(scheme: Scheme, point: usize, here: [f64; N], ring: &Ring<N>) -> [f64; N] {
    let valence = ring.edge_count[point];
    let n = f64::from(valence);
    if scheme == Scheme::Loop {
        let cosine = turn::cos_sin(1, valence).0;
        let inner = 0.375 + 0.25 * cosine;
        let weight = (0.625 - inner * inner) / n;
        let mut sum = here.map(|x| (1.0 - n * weight) * x);
        add(&mut sum, ring.ends[point], weight);
        return sum;
    }
    let mut sum = here.map(|x| (n - 2.0) / n * x);
    add(&mut sum, ring.ends[point], 1.0 / (n * n));
    add(&mut sum, ring.faces[point], 1.0 / (n * n));
    sum
}

/// Sharp edges from both end points, ordered by point.
fn spokes(edges: &Edges, sharpness: &[f32]) -> Vec<Spoke> {
    let mut spokes = Vec::new();
    for (&[a, b], &sharpness) in edges.ends.iter().zip(sharpness) {
        if sharpness > 0.0 {
            for (point, end) in [(a, b), (b, a)] {
                spokes.push(Spoke {
                    point,
                    end,
                    sharpness,
                });
            }
        }
    }
    spokes.sort_by_key(|spoke| (spoke.point, spoke.end));
    spokes
}

fn add<const N: usize>(sum: &mut [f64; N], value: [f64; N], weight: f64) {
    for (sum, x) in sum.iter_mut().zip(value) {
        *sum += weight * x;
    }
}

/// The number of points is limited before a level is computed.
fn index(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
