/// Values that a mesh carries, as OpenUSD's primvars: how they are spread over it, and what they are.
#[derive(Clone, Debug, PartialEq)]
pub struct Primvar<T> {
    /// What has a value of its own.
    pub interpolation: Interpolation,
    /// The values; without `indices` one for each element of the interpolation.
    pub values: Vec<T>,
    /// For each element which of the values it has, so that equal ones are stored once.
    pub indices: Option<Vec<i32>>,
}

impl<T> Primvar<T> {
    /// A value for each element.
    #[must_use]
    pub const fn new(interpolation: Interpolation, values: Vec<T>) -> Self {
        Self {
            interpolation,
            values,
            indices: None,
        }
    }
}

/// What has a value of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// The whole mesh has one.
    Constant,
    /// Each face has one.
    Uniform,
    /// Each point has one; OpenUSD's `varying` too, which differs only on a subdivided surface.
    Vertex,
    /// Each corner of each face has one.
    FaceVarying,
}

/// How many elements of each kind a mesh has.
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
    /// Says what is wrong with it on a mesh of so many elements.
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
                Err(format!("{} values where {wanted} are needed", self.values.len()))
            };
        };
        if indices.len() != wanted {
            return Err(format!("{} indices where {wanted} are needed", indices.len()));
        }
        let in_range = |&index: &i32| usize::try_from(index).is_ok_and(|index| index < self.values.len());
        match indices.iter().find(|index| !in_range(index)) {
            Some(index) => Err(format!("index {index} among {} values", self.values.len())),
            None => Ok(()),
        }
    }

    /// The value of an element; only for one that was checked.
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
