/// Whose prim names a layer of overrides addresses. Only the time-of-flight model differs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PrimNames {
    /// Those of the parameter sheet: `Camera_tof_33d`, `Camera_pseudo_depth_stereo`.
    #[default]
    Document,
    /// Those of the asset that Isaac Sim ships: `Camera_33d`, `Camera_pseudo_depth`.
    Isaac,
}

/// The sheet's name, and the shipped asset's where it differs.
const ALIASES: [(&str, &str); 2] = [
    ("Camera_tof_33d", "Camera_33d"),
    ("Camera_pseudo_depth_stereo", "Camera_pseudo_depth"),
];

impl PrimNames {
    /// What the camera of this name in the sheet is called.
    #[must_use]
    pub fn of(self, document: &str) -> &str {
        let alias = ALIASES.iter().find(|(name, _)| *name == document);
        match (self, alias) {
            (Self::Isaac, Some((_, isaac))) => isaac,
            _ => document,
        }
    }
}

/// The render product of a camera, as the sheet and Isaac Sim's helpers name it.
#[must_use]
pub fn render_product_name(camera: &str) -> String {
    format!("{camera}_render_product")
}
