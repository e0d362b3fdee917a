//! A mesh of polygons with all it carries, some levels finer.

use oaktwin_diagnostic::{Finding, Level};

use super::cage::{Cage, MOST_FACES};
use super::edges::Edges;
use super::seams::{Seams, border};
use super::sharp::Sharp;
use super::{BoundaryRule, FaceVaryingRule, Scheme, Subdivision};
use crate::polygon::primvar::Elements;
use crate::polygon::{Interpolation, PolygonMesh, Primvar};

impl PolygonMesh {
    /// The mesh refined by its own scheme, `levels` times: each level has four times the faces of the one before. With
    /// [`Scheme::None`] it stays as it is. `place` is what findings say it is: a prim's path.
    ///
    /// Positions and per-point values follow the scheme with its creases, corners and border; face-varying ones
    /// follow [`FaceVaryingRule`]. Authored normals are dropped: OpenUSD wants none on a surface that is refined. Fewer
    /// levels are made where the result would have more than 2²⁵ faces.
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
        let findings = Doubts {
            lost,
            unknown: sharp.unknown,
            fits,
            affordable,
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
            said: &self.subdivision,
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

    /// Without interpolation of the border, the faces at it only shape those inside.
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

/// What to tell about a refinement.
struct Doubts {
    lost: u64,
    unknown: usize,
    fits: bool,
    affordable: u32,
    levels: u32,
}

impl Doubts {
    fn findings(&self, place: &str) -> Vec<Finding> {
        let mut findings = Vec::new();
        let mut warn = |message: String, remedy: &str| {
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
                "not refined: Loop's scheme is for triangles, and it has other faces".into(),
                "triangulate it or use the scheme catmullClark",
            );
            return findings;
        }
        if self.affordable < self.levels {
            warn(
                format!(
                    "refined {} times instead of {}: it would have more than {MOST_FACES} faces",
                    self.affordable, self.levels
                ),
                "ask for fewer levels",
            );
        }
        if self.affordable > 0 && self.lost > 0 {
            warn(
                format!(
                    "faces with less than three corners, or with points that do not exist or are not finite, are left out: {}",
                    self.lost
                ),
                "",
            );
        }
        if self.unknown > 0 {
            warn(
                format!(
                    "creases and corners that are not on its edges and points: {}",
                    self.unknown
                ),
                "",
            );
        }
        findings
    }
}

/// What is the same for all that a mesh carries.
struct Refinement<'a> {
    cage: &'a Cage,
    sharp: &'a Sharp,
    said: &'a Subdivision,
    levels: u32,
    /// The mesh's face that each new face came from.
    origins: Vec<u32>,
    /// The mesh's, before.
    elements: Elements,
}

impl Refinement<'_> {
    fn at_points<const N: usize>(&self, values: Vec<[f64; N]>) -> super::surface::Surface<N> {
        let corners_stay = self.said.boundary != BoundaryRule::EdgeOnly;
        let (starts, corners) = (self.cage.starts.clone(), self.cage.corners.clone());
        self.sharp.surface(values, starts, corners, corners_stay).refined(
            self.said.scheme,
            false,
            self.levels,
        )
    }

    fn primvar<const N: usize>(&self, primvar: Primvar<[f32; N]>) -> Primvar<[f32; N]> {
        if primvar.check(self.elements).is_err() {
            // Who makes the triangles says so: it fits them no better.
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
                let rule = self.said.face_varying;
                let corners = self.cage.mesh_corners.iter();
                let points = u32::try_from(self.elements.points).unwrap_or(u32::MAX);
                let surface = Seams::of(corners.map(|&corner| value(corner as usize)), self.cage, points)
                    .surface(rule, self.cage, self.sharp)
                    .refined(self.said.scheme, rule == FaceVaryingRule::All, self.levels);
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

    /// The faces that came from some. Those that did not exist stay so.
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

#[allow(
    clippy::cast_possible_truncation,
    reason = "single precision is what meshes have"
)]
fn narrow<const N: usize>(value: [f64; N]) -> [f32; N] {
    value.map(|x| x as f32)
}

/// Numbers of points, corners and faces stay below 2³¹.
fn signed(index: u32) -> i32 {
    i32::try_from(index).unwrap_or(i32::MAX)
}
