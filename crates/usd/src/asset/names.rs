/// The prim names that a layer of overrides addresses. They differ for the time-of-flight model only.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PrimNames {
    /// The parameter sheet's names: `Camera_tof_33d`, `Camera_pseudo_depth_stereo`.
    #[default]
    Document,
    /// The names in the asset that Isaac Sim ships: `Camera_33d`, `Camera_pseudo_depth`.
    Isaac,
}

/// The sheet's names that differ in the shipped asset, and the names there.
const ALIASES: [(&str, &str); 2] = [
    ("Camera_tof_33d", "Camera_33d"),
    ("Camera_pseudo_depth_stereo", "Camera_pseudo_depth"),
];

impl PrimNames {
    /// Returns the name of the camera that the sheet calls `document`.
    #[must_use]
    pub fn of(self, document: &str) -> &str {
        let alias = ALIASES.iter().find(|(name, _)| *name == document);
        match (self, alias) {
            (Self::Isaac, Some((_, isaac))) => isaac,
            _ => document,
        }
    }
}

/// Returns the name that the sheet and Isaac Sim's helpers give a camera's render product.
#[must_use]
pub fn render_product_name(camera: &str) -> String {
    format!("{camera}_render_product")
}
