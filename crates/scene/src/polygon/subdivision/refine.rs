//! Subdivides a polygon mesh with all its primvars.

use oaktwin_base::diagnostic::{Finding, Level, Message};
use oaktwin_files::memory::Shortage;

use super::cage::{Cage, MAX_FACES};
use super::edges::Edges;
use super::seams::{Seams, border};
use super::sharp::Sharp;
use super::{BoundaryRule, FaceVaryingRule, Scheme, Subdivision};
use crate::polygon::primvar::Elements;
use crate::polygon::{Interpolation, PolygonMesh, Primvar};

impl PolygonMesh {
    /// Subdivides the mesh by its own scheme, `levels` times; each level has four times as many faces as the one before.
    /// With [`Scheme::None`] the mesh is unchanged. `place` names it in findings, such as the path of a prim.
    ///
    /// Positions and per-point values follow the scheme with its creases, corners and border; face-varying values
    /// follow [`FaceVaryingRule`]. Authored normals are dropped: OpenUSD ignores them on a subdivided surface. The number
    /// of levels is reduced if the result would have more than 2²⁵ faces.
    #[must_use]
    pub fn subdivided(mut self, levels: u32, place: &str) -> (Self, Vec<Finding>) {
        let scheme = self.subdivision.scheme;
        if levels == 0 || scheme == Scheme::None {
            return (self, Vec::new());
        }
        let (cage, lost) = Cage::of(&self);
        let sharp = Sharp::of(&self.subdivision, &cage);
        let fits = scheme != Scheme::Loop || cage.all_triangles();
        let affordable = cage.affordable(scheme, levels, self.points.len());
        let (affordable, shortage) = cage.fitting(scheme, affordable);
        let findings = Problems {
            lost,
            unknown: sharp.unknown,
            fits,
            affordable,
            shortage,
            levels,
        }
        .findings(place);
        if !fits || affordable == 0 {
            return (self, findings);
        }
        if self.subdivision.boundary == BoundaryRule::None {
            self.hide_border_faces(&cage);
        }
        self.refine(&cage, &sharp, affordable);
        (self, findings)
    }

    fn refine(&mut self, cage: &Cage, sharp: &Sharp, levels: u32) {
        let scheme = self.subdivision.scheme;
        let refinement = Refinement {
            cage,
            sharp,
            subdivision: &self.subdivision,
            levels,
            origins: cage.origins(scheme, levels),
            elements: Elements {
                faces: self.face_vertex_counts.len(),
                points: self.points.len(),
                corners: self.face_vertex_indices.len(),
            },
        };
        self.normals = None;
        self.uvs = self.uvs.take().map(|uvs| refinement.primvar(uvs));
        self.colors = self.colors.take().map(|colors| refinement.primvar(colors));
        self.holes = refinement.children(&self.holes);
        for subset in &mut self.face_materials {
            subset.faces = refinement.children(&subset.faces);
        }
        let values = self.points.iter().copied().map(widen).collect();
        let surface = refinement.at_points(values);
        self.points = surface.values.into_iter().map(narrow).collect();
        self.face_vertex_counts = surface
            .starts
            .windows(2)
            .map(|face| signed(face[1] - face[0]))
            .collect();
        self.face_vertex_indices = surface.corners.into_iter().map(signed).collect();
        self.subdivision = Subdivision {
            scheme,
            ..Subdivision::default()
        };
    }

    /// Without interpolation at the border, its faces only influence those inside.
    fn hide_border_faces(&mut self, cage: &Cage) {
        let at_border = border(&Edges::of(&cage.starts, &cage.corners), self.points.len());
        for (face, &number) in cage.starts.windows(2).zip(&cage.faces) {
            let corners = &cage.corners[face[0] as usize..face[1] as usize];
            if corners.iter().any(|&point| at_border[point as usize]) {
                self.holes.push(signed(number));
            }
        }
    }
}

/// The problems found during subdivision.
struct Problems {
    lost: u64,
    unknown: usize,
    fits: bool,
    affordable: u32,
    shortage: Option<Shortage>,
    levels: u32,
}

impl Problems {
    fn findings(&self, place: &str) -> Vec<Finding> {
        let mut findings = Vec::new();
        let mut warn = |message: String, remedy: Message| {
            findings.push(Finding::new(
                "mesh-subdivision",
                Level::Warning,
                place,
                message,
                remedy,
            ));
        };
        if !self.fits {
            warn(
                "not subdivided: the scheme loop requires triangles".into(),
                "triangulate it or use the scheme catmullClark".into(),
            );
            return findings;
        }
        if self.affordable < self.levels {
            let (why, remedy) = match &self.shortage {
                Some(shortage) => (shortage.what(), shortage.remedy()),
                None => (
                    format!("the limit is {MAX_FACES} faces"),
                    "reduce the number of levels".into(),
                ),
            };
            warn(
                format!(
                    "subdivided {} times instead of {}: {why}",
                    self.affordable, self.levels
                ),
                remedy,
            );
        }
        if self.affordable > 0 && self.lost > 0 {
            warn(
                format!(
                    "{} faces with fewer than three corners, or with missing or non-finite points; skipped",
                    self.lost
                ),
                Message::default(),
            );
        }
        if self.unknown > 0 {
            warn(
                format!(
                    "{} creases and corners are not on an edge or point of the mesh; ignored",
                    self.unknown
                ),
                Message::default(),
            );
        }
        findings
    }
}

/// The data shared by the subdivision of all primvars.
struct Refinement<'a> {
    cage: &'a Cage,
    sharp: &'a Sharp,
    subdivision: &'a Subdivision,
    levels: u32,
    /// The mesh's face from which each new face originates.
    origins: Vec<u32>,
    /// The number of elements before subdivision.
    elements: Elements,
}

impl Refinement<'_> {
    fn at_points<const N: usize>(&self, values: Vec<[f64; N]>) -> super::surface::Surface<N> {
        let corners_stay = self.subdivision.boundary != BoundaryRule::EdgeOnly;
        let (starts, corners) = (self.cage.starts.clone(), self.cage.corners.clone());
        self.sharp.surface(values, starts, corners, corners_stay).refined(
            self.subdivision.scheme,
            false,
            self.levels,
        )
    }

    fn primvar<const N: usize>(&self, primvar: Primvar<[f32; N]>) -> Primvar<[f32; N]> {
        if primvar.check(self.elements).is_err() {
            // Triangulation reports the mismatch.
            return primvar;
        }
        let value = |element: usize| widen(primvar.get(element).unwrap_or([0.0; N]));
        match primvar.interpolation {
            Interpolation::Constant => primvar,
            Interpolation::Uniform => Primvar {
                interpolation: Interpolation::Uniform,
                indices: Some(self.uniform_indices(primvar.indices.as_deref())),
                values: primvar.values,
            },
            Interpolation::Vertex => {
                let surface = self.at_points((0..self.elements.points).map(value).collect());
                let values = surface.values.into_iter().map(narrow).collect();
                Primvar::new(Interpolation::Vertex, values)
            }
            Interpolation::FaceVarying => {
                let rule = self.subdivision.face_varying;
                let corners = self.cage.mesh_corners.iter();
                let points = u32::try_from(self.elements.points).unwrap_or(u32::MAX);
                let surface = Seams::of(corners.map(|&corner| value(corner as usize)), self.cage, points)
                    .surface(rule, self.cage, self.sharp)
                    .refined(self.subdivision.scheme, rule == FaceVaryingRule::All, self.levels);
                Primvar {
                    interpolation: Interpolation::FaceVarying,
                    values: surface.values.into_iter().map(narrow).collect(),
                    indices: Some(surface.corners.into_iter().map(signed).collect()),
                }
            }
        }
    }

    fn uniform_indices(&self, indices: Option<&[i32]>) -> Vec<i32> {
        let index = |&face: &u32| indices.map_or(signed(face), |indices| indices[face as usize]);
        self.origins.iter().map(index).collect()
    }

    /// The faces that originate from `faces`. Indices out of range stay out of range.
    fn children(&self, faces: &[i32]) -> Vec<i32> {
        let mut chosen = vec![false; self.elements.faces];
        let mut children = Vec::new();
        for &face in faces {
            match usize::try_from(face).ok().and_then(|face| chosen.get_mut(face)) {
                Some(chosen) => *chosen = true,
                None => children.push(-1),
            }
        }
        let new_faces = (0..).zip(&self.origins);
        children.extend(
            new_faces
                .filter(|&(_, &origin)| chosen[origin as usize])
                .map(|(face, _)| face),
        );
        children
    }
}

fn widen<const N: usize>(value: [f32; N]) -> [f64; N] {
    value.map(f64::from)
}

#[allow(clippy::cast_possible_truncation, reason = "meshes store single precision")]
fn narrow<const N: usize>(value: [f64; N]) -> [f32; N] {
    value.map(|x| x as f32)
}

/// The numbers of points, corners and faces stay below 2³¹.
fn signed(index: u32) -> i32 {
    i32::try_from(index).unwrap_or(i32::MAX)
}
