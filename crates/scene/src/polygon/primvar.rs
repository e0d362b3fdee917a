/// Values attached to a mesh, like OpenUSD's primvars.
#[derive(Clone, Debug, PartialEq)]
pub struct Primvar<T> {
    /// The elements that have values.
    pub interpolation: Interpolation,
    /// The values; without `indices`, one per element.
    pub values: Vec<T>,
    /// For each element, the index of its value.
    pub indices: Option<Vec<i32>>,
}

impl<T> Primvar<T> {
    /// Creates a primvar with one value per element.
    #[must_use]
    pub const fn new(interpolation: Interpolation, values: Vec<T>) -> Self {
        Self {
            interpolation,
            values,
            indices: None,
        }
    }
}

/// The elements of a mesh that have values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// One value for the whole mesh.
    Constant,
    /// One value per face.
    Uniform,
    /// One value per point; includes OpenUSD's `varying`, which differs only on a subdivided surface.
    Vertex,
    /// One value per corner of each face.
    FaceVarying,
}

/// The number of elements of each kind.
#[derive(Clone, Copy, Debug)]
pub(super) struct Elements {
    pub(super) faces: usize,
    pub(super) points: usize,
    pub(super) corners: usize,
}

impl Elements {
    pub(super) const fn of(self, interpolation: Interpolation) -> usize {
        match interpolation {
            Interpolation::Constant => 1,
            Interpolation::Uniform => self.faces,
            Interpolation::Vertex => self.points,
            Interpolation::FaceVarying => self.corners,
        }
    }
}

impl<T: Copy> Primvar<T> {
    /// Checks that the primvar fits a mesh with these elements; the error is the reason.
    pub(super) fn check(&self, elements: Elements) -> Result<(), String> {
        let wanted = elements.of(self.interpolation);
        let Some(indices) = &self.indices else {
            let enough = if self.interpolation == Interpolation::Constant {
                !self.values.is_empty()
            } else {
                self.values.len() == wanted
            };
            return if enough {
                Ok(())
            } else {
                Err(format!("{} values instead of {wanted}", self.values.len()))
            };
        };
        if indices.len() != wanted {
            return Err(format!("{} indices instead of {wanted}", indices.len()));
        }
        let in_range = |&index: &i32| usize::try_from(index).is_ok_and(|index| index < self.values.len());
        match indices.iter().find(|index| !in_range(index)) {
            Some(index) => Err(format!(
                "index {index} is out of range: there are {} values",
                self.values.len()
            )),
            None => Ok(()),
        }
    }

    /// The value of an element of a checked primvar.
    pub(super) fn get(&self, element: usize) -> Option<T> {
        match &self.indices {
            None => self.values.get(element).copied(),
            Some(indices) => self
                .values
                .get(usize::try_from(*indices.get(element)?).ok()?)
                .copied(),
        }
    }
}
