//! Subdivision of polygon meshes.

mod cage;
mod edges;
mod refine;
mod seams;
mod sharp;
mod surface;

/// The subdivision of a mesh, in OpenUSD's terms.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Subdivision {
    /// The scheme; with [`Scheme::None`] the polygons are the surface.
    pub scheme: Scheme,
    /// The sharp edges.
    pub creases: Vec<Crease>,
    /// The sharp points, each with its sharpness in levels; 10 and above is infinite.
    pub corners: Vec<(i32, f32)>,
    /// The rule at the border of the mesh.
    pub boundary: BoundaryRule,
    /// The rule for face-varying values.
    pub face_varying: FaceVaryingRule,
}

/// A subdivision scheme.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scheme {
    /// No subdivision: the polygons are the surface.
    #[default]
    None,
    /// Catmull-Clark, for any polygons.
    CatmullClark,
    /// Loop, for triangles.
    Loop,
    /// Linear interpolation of points.
    Bilinear,
}

/// A chain of sharp edges.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Crease {
    /// The points along it.
    pub points: Vec<i32>,
    /// The sharpness in levels: one value for the whole chain, or one per edge; 10 and above is infinite.
    pub sharpness: Vec<f32>,
}

/// The rule at the border of a mesh, OpenUSD's `interpolateBoundary`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoundaryRule {
    /// Faces at the border are holes.
    None,
    /// The border is a smooth curve.
    EdgeOnly,
    /// The border is a smooth curve, except at points with only one face.
    #[default]
    EdgeAndCorner,
}

/// The rule for face-varying values, OpenUSD's `faceVaryingLinearInterpolation`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FaceVaryingRule {
    /// Smooth everywhere.
    None,
    /// Linear at corners.
    CornersOnly,
    /// Linear at corners and where seams meet.
    #[default]
    CornersPlus1,
    /// Linear at corners and where seams meet or end.
    CornersPlus2,
    /// Linear along borders.
    Boundaries,
    /// Linear everywhere.
    All,
}

#[cfg(test)]
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss
)]
mod tests;
