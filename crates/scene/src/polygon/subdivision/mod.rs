//! Refinement of meshes: what a file says about it, and the rules.

mod cage;
mod edges;
mod refine;
mod seams;
mod sharp;
mod surface;

/// How a mesh is refined, in OpenUSD's terms.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Subdivision {
    /// The rule for new points; with [`Scheme::None`] the polygons are the surface.
    pub scheme: Scheme,
    /// Edges that stay sharp.
    pub creases: Vec<Crease>,
    /// Points that stay sharp, each with how many levels; 10 and more is for ever.
    pub corners: Vec<(i32, f32)>,
    /// What happens at the border of the mesh.
    pub boundary: BoundaryRule,
    /// How face-varying values are refined.
    pub face_varying: FaceVaryingRule,
}

/// The rule for new points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scheme {
    /// No refinement: polygons.
    #[default]
    None,
    /// Catmull and Clark's, for any polygons.
    CatmullClark,
    /// Loop's, for triangles.
    Loop,
    /// Points are only interpolated.
    Bilinear,
}

/// A chain of edges that stay sharp.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Crease {
    /// The points along it.
    pub points: Vec<i32>,
    /// For how many levels: one for the whole chain, or one for each of its edges; 10 and more is for ever.
    pub sharpness: Vec<f32>,
}

/// What happens at the border of a mesh, OpenUSD's `interpolateBoundary`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoundaryRule {
    /// Faces at the border are holes.
    None,
    /// The border is a smooth curve.
    EdgeOnly,
    /// The border is a smooth curve through points that only one face has.
    #[default]
    EdgeAndCorner,
}

/// How face-varying values are refined, OpenUSD's `faceVaryingLinearInterpolation`.
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
