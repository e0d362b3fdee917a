use super::FaceMaterial;
use super::faces::Faces;

/// The material of each face, and the order that groups faces by material.
#[derive(Debug)]
pub(super) struct FaceMaterials {
    /// The material of each face; empty if all have the mesh's own.
    of_face: Vec<Option<u32>>,
    /// The faces in their new order; `None` if it is unchanged.
    pub(super) order: Option<Vec<u32>>,
    default: Option<u32>,
}

impl FaceMaterials {
    /// Also returns the number of faces in the subsets that do not exist.
    pub(super) fn of(subsets: &[FaceMaterial], default: Option<u32>, faces: &Faces) -> (Self, usize) {
        let mut result = Self {
            of_face: Vec::new(),
            order: None,
            default,
        };
        let mut unknown = 0;
        if subsets.is_empty() {
            return (result, unknown);
        }
        let mut of_face = vec![default; faces.len() as usize];
        for subset in subsets {
            for &face in &subset.faces {
                let slot = usize::try_from(face).ok().and_then(|face| of_face.get_mut(face));
                match slot {
                    Some(slot) => *slot = Some(subset.material),
                    None => unknown += 1,
                }
            }
        }
        result.order = order(&of_face);
        result.of_face = of_face;
        (result, unknown)
    }

    /// Whether all faces have the same material.
    pub(super) fn is_one(&self) -> bool {
        self.of_face.is_empty()
    }

    pub(super) fn get(&self, face: u32) -> Option<u32> {
        self.of_face.get(face as usize).copied().unwrap_or(self.default)
    }
}

/// The faces grouped by material, materials by their first face, in stable order; `None` if they are grouped already.
fn order(of_face: &[Option<u32>]) -> Option<Vec<u32>> {
    let mut ranks = std::collections::BTreeMap::new();
    let mut interleaved = false;
    let mut previous = None;
    for material in of_face {
        let next_rank = ranks.len();
        let rank = *ranks.entry(*material).or_insert(next_rank);
        interleaved |= previous.is_some_and(|previous| rank < previous);
        previous = Some(rank);
    }
    if !interleaved {
        return None;
    }
    let mut faces: Vec<u32> = (0..u32::try_from(of_face.len()).ok()?).collect();
    faces.sort_by_key(|&face| ranks.get(&of_face[face as usize]).copied());
    Some(faces)
}
