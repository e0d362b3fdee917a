/// A cluster or a triangle to be drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Visible {
    pub(super) instance: u32,
    /// The index of the cluster in the mesh.
    pub(super) cluster: u32,
    /// The index of a single triangle in the clustered mesh; `None` for the whole cluster.
    pub(super) triangle: Option<u32>,
    /// An upper bound of 1/z.
    pub(super) inverse_z: f32,
    /// The first and the last column, and row, that it can touch.
    pub(super) x: [u32; 2],
    pub(super) y: [u32; 2],
}
