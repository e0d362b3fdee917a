use super::Subdivision;
use super::cage::Cage;
use super::edges::{Edges, key};
use super::surface::Surface;

/// The sharp edges and points of a mesh.
pub(super) struct Sharp {
    /// Ordered by [`key`].
    pub(super) edges: Vec<(u64, f32)>,
    /// Ordered by point.
    pub(super) points: Vec<(u32, f32)>,
    /// The number of creases that are not edges, points that do not exist, and lists of the wrong length.
    pub(super) unknown: usize,
}

impl Sharp {
    pub(super) fn of(subdivision: &Subdivision, cage: &Cage) -> Self {
        let mut sharp = Self {
            edges: Vec::new(),
            points: Vec::new(),
            unknown: 0,
        };
        if !subdivision.creases.is_empty() {
            sharp.read_creases(subdivision, &Edges::of(&cage.starts, &cage.corners));
        }
        for &(point, sharpness) in &subdivision.corners {
            match u32::try_from(point) {
                Ok(point) if sharpness > 0.0 => sharp.points.push((point, sharpness)),
                Ok(_) => {}
                Err(_) => sharp.unknown += 1,
            }
        }
        sharpest(&mut sharp.edges);
        sharpest(&mut sharp.points);
        sharp
    }

    fn read_creases(&mut self, subdivision: &Subdivision, edges: &Edges) {
        for crease in &subdivision.creases {
            let each = crease.sharpness.len();
            if each != 1 && each + 1 != crease.points.len() {
                self.unknown += 1;
                continue;
            }
            for (i, ends) in crease.points.windows(2).enumerate() {
                let sharpness = crease.sharpness[if each == 1 { 0 } else { i }];
                let edge = match (u32::try_from(ends[0]), u32::try_from(ends[1])) {
                    (Ok(a), Ok(b)) => Some(key(a, b)).filter(|&edge| edges.find(edge).is_some()),
                    _ => None,
                };
                match edge {
                    Some(edge) if sharpness > 0.0 => self.edges.push((edge, sharpness)),
                    Some(_) => {}
                    None => self.unknown += 1,
                }
            }
        }
    }

    /// A surface over the mesh's own points.
    pub(super) fn surface<const N: usize>(
        &self,
        values: Vec<[f64; N]>,
        starts: Vec<u32>,
        corners: Vec<u32>,
        sharp_corners: bool,
    ) -> Surface<N> {
        Surface {
            values,
            starts,
            corners,
            sharp_edges: self.edges.clone(),
            sharp_points: self.points.clone(),
            sharp_corners,
        }
    }
}

/// Sorts the list, keeping the maximum sharpness of duplicates.
pub(super) fn sharpest<K: Ord + Copy>(list: &mut Vec<(K, f32)>) {
    list.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)));
    list.dedup_by_key(|entry| entry.0);
}
