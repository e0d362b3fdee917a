//! Face-varying values as a surface that is cut open where neighbouring faces disagree.

use super::FaceVaryingRule;
use super::cage::Cage;
use super::edges::{Edges, key};
use super::sharp::{Sharp, sharpest};
use super::surface::{INFINITE, Surface};
use crate::polygon::weld::Welder;

pub(super) struct Seams<const N: usize> {
    values: Vec<[f64; N]>,
    /// The mesh's point of each value.
    points: Vec<u32>,
    /// The value of each corner.
    corners: Vec<u32>,
}

impl<const N: usize> Seams<N> {
    /// Creates seams from a value for each corner of the cage.
    pub(super) fn of(values: impl Iterator<Item = [f64; N]>, cage: &Cage, points: u32) -> Self {
        let mut welder = Welder::new(points as usize);
        let mut points: Vec<u32> = (0..points).collect();
        let mut corners = Vec::with_capacity(cage.corners.len());
        for (value, &point) in values.zip(&cage.corners) {
            corners.push(welder.index(point, value));
            if welder.values.len() > points.len() {
                points.push(point);
            }
        }
        Self {
            values: welder.values,
            points,
            corners,
        }
    }

    pub(super) fn surface(self, rule: FaceVaryingRule, cage: &Cage, sharp: &Sharp) -> Surface<N> {
        let edges = self.sharp_edges(cage, sharp);
        let mut points: Vec<(u32, f32)> = Vec::new();
        let pinned = self.pinned(rule, cage);
        for (value, point) in (0..).zip(&self.points) {
            if pinned[value as usize] {
                points.push((value, INFINITE));
            } else if let Ok(found) = sharp.points.binary_search_by_key(point, |entry| entry.0) {
                points.push((value, sharp.points[found].1));
            }
        }
        Surface {
            values: self.values,
            starts: cage.starts.clone(),
            corners: self.corners,
            sharp_edges: edges,
            sharp_points: points,
            sharp_corners: rule != FaceVaryingRule::None,
        }
    }

    /// The mesh's sharp edges as edges between values.
    fn sharp_edges(&self, cage: &Cage, sharp: &Sharp) -> Vec<(u64, f32)> {
        let mut list = Vec::new();
        if sharp.edges.is_empty() {
            return list;
        }
        let ring = cage.next_corners();
        for (corner, next) in ring.enumerate() {
            let edge = key(cage.corners[corner], cage.corners[next]);
            if let Ok(found) = sharp.edges.binary_search_by_key(&edge, |entry| entry.0) {
                list.push((
                    key(self.corners[corner], self.corners[next]),
                    sharp.edges[found].1,
                ));
            }
        }
        sharpest(&mut list);
        list
    }

    /// The values that the rule keeps fixed, besides a single face's.
    fn pinned(&self, rule: FaceVaryingRule, cage: &Cage) -> Vec<bool> {
        let none = vec![false; self.values.len()];
        match rule {
            FaceVaryingRule::None | FaceVaryingRule::CornersOnly | FaceVaryingRule::All => none,
            FaceVaryingRule::CornersPlus1 => {
                let meeting = self.values_at_points();
                let many = |point: &u32| meeting[*point as usize] > 2;
                self.points.iter().map(many).collect()
            }
            FaceVaryingRule::CornersPlus2 => {
                let meeting = self.values_at_points();
                let mut uses = vec![0_u32; self.values.len()];
                for &value in &self.corners {
                    uses[value as usize] += 1;
                }
                let mut at_corner = vec![false; meeting.len()];
                for (&point, &uses) in self.points.iter().zip(&uses) {
                    at_corner[point as usize] |= uses == 1;
                }
                let at_border = self.at_border(cage);
                let mesh_border = border(&Edges::of(&cage.starts, &cage.corners), meeting.len());
                let keeps = |(&point, &at_border): (&u32, &bool)| {
                    let point = point as usize;
                    let seam_ends = meeting[point] == 1 && at_border && !mesh_border[point];
                    meeting[point] > 2 || seam_ends || (meeting[point] == 2 && at_corner[point])
                };
                self.points.iter().zip(&at_border).map(keeps).collect()
            }
            FaceVaryingRule::Boundaries => self.at_border(cage),
        }
    }

    /// The number of values at each point of the mesh.
    fn values_at_points(&self) -> Vec<u32> {
        let mut used = vec![false; self.values.len()];
        for &value in &self.corners {
            used[value as usize] = true;
        }
        let points = self.points.iter().max().map_or(0, |&last| last as usize + 1);
        let mut counts = vec![0; points];
        for (&point, used) in self.points.iter().zip(used) {
            counts[point as usize] += u32::from(used);
        }
        counts
    }

    fn at_border(&self, cage: &Cage) -> Vec<bool> {
        border(&Edges::of(&cage.starts, &self.corners), self.values.len())
    }
}

/// The points on an edge with only one face.
pub(super) fn border(edges: &Edges, points: usize) -> Vec<bool> {
    let mut at_border = vec![false; points];
    for (ends, &faces) in edges.ends.iter().zip(&edges.faces) {
        if faces == 1 {
            for &end in ends {
                at_border[end as usize] = true;
            }
        }
    }
    at_border
}
