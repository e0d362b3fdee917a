/// Data at the corners of a mesh's triangles: texture coordinates, normals, colours.
#[derive(Clone, Debug, PartialEq)]
pub enum MeshAttribute<T> {
    /// One value for the whole mesh.
    Constant(T),
    /// One value for each triangle.
    Triangle(Vec<T>),
    /// One value for each vertex.
    Vertex(Vec<T>),
    /// Shared values, selected by three indices per triangle.
    Corner {
        /// The values.
        values: Vec<T>,
        /// For each triangle, the index of the value at each corner.
        indices: Vec<[u32; 3]>,
    },
}

impl<T: Copy> MeshAttribute<T> {
    /// The values at the three corners of the triangle with index `triangle` and the vertices `vertices`; `None` if the
    /// attribute has too few values.
    #[must_use]
    #[inline]
    pub fn corners(&self, triangle: usize, vertices: [u32; 3]) -> Option<[T; 3]> {
        let pick = |values: &[T], [a, b, c]: [u32; 3]| {
            Some([
                *values.get(a as usize)?,
                *values.get(b as usize)?,
                *values.get(c as usize)?,
            ])
        };
        match self {
            Self::Constant(value) => Some([*value; 3]),
            Self::Triangle(values) => Some([*values.get(triangle)?; 3]),
            Self::Vertex(values) => pick(values, vertices),
            Self::Corner { values, indices } => pick(values, *indices.get(triangle)?),
        }
    }
}
