//! Geoms, and the meshes and materials that they name.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::{Finding, Level, suggest};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::import;

use super::super::document::{Element, Vectors, XmlError};
use super::super::robot::Shape;
use super::super::turn;
use super::classes::Classes;
use super::compiler::{self, Compiler};

/// Half the extent of a plane that the file makes infinite, in metres.
const INFINITE: f64 = 50.0;

/// The meshes and materials of a file.
#[derive(Debug, Default)]
pub(super) struct Assets {
    meshes: HashMap<String, Mesh>,
    colors: HashMap<String, [f32; 4]>,
}

/// A mesh of the file.
#[derive(Debug)]
enum Mesh {
    File(PathBuf, DAffine3),
    /// In a form that is not supported: what it is.
    Other(String),
}

impl Assets {
    pub(super) fn new(root: &Element, compiler: &Compiler, classes: &Classes) -> Result<Self, XmlError> {
        let mut assets = Self::default();
        for asset in root.all("asset").flat_map(|section| &section.children) {
            match asset.tag.as_str() {
                "mesh" => {
                    let asset = classes.complete(asset, None)?;
                    assets.mesh(&asset, compiler)?;
                }
                "material" => {
                    let asset = classes.complete(asset, None)?;
                    let color = color(&asset)?.unwrap_or([1.0; 4]);
                    assets.colors.insert(asset.required("name")?.to_owned(), color);
                }
                _ => {}
            }
        }
        Ok(assets)
    }

    fn mesh(&mut self, mesh: &Element, compiler: &Compiler) -> Result<(), XmlError> {
        let file = mesh.get("file");
        let stem = || file.and_then(|file| Path::new(file).file_stem()?.to_str());
        let name = mesh.get("name").or_else(stem);
        let Some(name) = name else {
            return Err(mesh.wrong("has neither a name nor a file", "add name=\"…\""));
        };
        let made = match file {
            Some(file) if import::is_importable(file.as_ref()) => {
                let path = compiler.mesh(file);
                if !path.is_file() {
                    let what = format!("there is no file {}", path.display());
                    return Err(mesh.wrong(what, "copy it there, or correct the name or <compiler meshdir>"));
                }
                Mesh::File(path, transform(mesh)?)
            }
            Some(file) => Mesh::Other(format!("{file} has a format that is not supported")),
            None => Mesh::Other("meshes within the file are not supported".to_owned()),
        };
        self.meshes.insert(name.to_owned(), made);
        Ok(())
    }

    /// Returns the colour of a geom with its opacity.
    pub(super) fn color(&self, geom: &Element) -> Result<[f32; 4], XmlError> {
        if let Some(own) = color(geom)? {
            return Ok(own);
        }
        let Some(name) = geom.get("material") else {
            return Ok([0.5, 0.5, 0.5, 1.0]);
        };
        let found = self.colors.get(name).copied();
        found.ok_or_else(|| unknown(geom, "material", name, self.colors.keys()))
    }

    /// Returns the shape of a geom and its pose in the frame of the geom's parent; `None` of one that is not supported.
    pub(super) fn shape(
        &self,
        geom: &Element,
        compiler: &Compiler,
        findings: &mut Vec<Finding>,
    ) -> Result<Option<(Shape, RigidTransform)>, XmlError> {
        let kind = geom.get("type").unwrap_or("sphere");
        let mut unsupported = |what: String| {
            let remedy =
                "use boxes, spheres, ellipsoids, cylinders, capsules, planes, or meshes in STL or OBJ";
            findings.push(Finding::new(
                "geom-unsupported",
                Level::Warning,
                geom.place(),
                format!("{what}: it is missing in images"),
                remedy,
            ));
            Ok(None)
        };
        if kind == "mesh" {
            let name = geom.required("mesh")?;
            return match self.meshes.get(name) {
                Some(Mesh::File(file, shape_from_file)) => {
                    let shape = Shape::Mesh {
                        file: file.clone(),
                        shape_from_file: *shape_from_file,
                    };
                    Ok(Some((shape, compiler.pose(geom)?)))
                }
                Some(Mesh::Other(what)) => unsupported(what.clone()),
                None => Err(unknown(geom, "mesh", name, self.meshes.keys())),
            };
        }
        if geom.get("mesh").is_some() {
            return unsupported(format!("a {kind} that is fitted to a mesh is not supported"));
        }
        match kind {
            "hfield" | "sdf" => unsupported(format!("{kind} is not supported")),
            kind => solid(geom, kind, compiler).map(Some),
        }
    }
}

/// Returns a shape without a mesh, and its pose in the frame of the geom's parent.
fn solid(geom: &Element, kind: &str, compiler: &Compiler) -> Result<(Shape, RigidTransform), XmlError> {
    let size = geom.numbers("size")?.unwrap_or_default();
    let at = |index: usize| {
        let found = size.get(index).copied().filter(|size| *size > 0.0);
        found.ok_or_else(|| {
            let what = format!("size {} of a {kind} must be above 0", index + 1);
            geom.wrong(what, "give size=\"…\" in metres")
        })
    };
    let (pose, half) = match segment(geom)? {
        Some((pose, length)) => (pose, Some(0.5 * length)),
        None => (compiler.pose(geom)?, None),
    };
    // The half length is between the ends, if the geom has them.
    let along = |index: usize| half.map_or_else(|| at(index), Ok);
    let shape = match kind {
        "sphere" => Shape::Ellipsoid(DVec3::splat(at(0)?)),
        "ellipsoid" => match half {
            Some(half) => Shape::Ellipsoid(DVec3::new(at(0)?, at(0)?, half)),
            None => Shape::Ellipsoid(DVec3::new(at(0)?, at(1)?, at(2)?)),
        },
        "box" => match half {
            Some(half) => Shape::Box(2.0 * DVec3::new(at(0)?, at(0)?, half)),
            None => Shape::Box(2.0 * DVec3::new(at(0)?, at(1)?, at(2)?)),
        },
        "cylinder" => Shape::Cylinder {
            radius: at(0)?,
            length: 2.0 * along(1)?,
        },
        "capsule" => Shape::Capsule {
            radius: at(0)?,
            length: 2.0 * along(1)?,
        },
        "plane" => {
            let side = |index: usize| {
                size.get(index)
                    .copied()
                    .filter(|size| *size > 0.0)
                    .unwrap_or(INFINITE)
            };
            Shape::Rectangle {
                width: 2.0 * side(0),
                length: 2.0 * side(1),
            }
        }
        other => {
            let known = [
                "plane",
                "sphere",
                "capsule",
                "ellipsoid",
                "cylinder",
                "box",
                "mesh",
            ];
            return Err(geom.wrong(format!("unknown type '{other}'"), suggest(other, known)));
        }
    };
    Ok((shape, pose))
}

/// Returns the pose and the length of a shape between two points, its z axis from the second to the first as in `MuJoCo`.
fn segment(geom: &Element) -> Result<Option<(RigidTransform, f64)>, XmlError> {
    let Some([a, b, c, d, e, f]) = geom.exactly::<6>("fromto")? else {
        return Ok(None);
    };
    let (from, to) = (DVec3::new(a, b, c), DVec3::new(d, e, f));
    let length = from.distance(to);
    if length <= 0.0 {
        return Err(geom.wrong("fromto: both points are the same", "give two points"));
    }
    let pose = RigidTransform::new(turn::z_to(from - to), 0.5 * (from + to));
    Ok(Some((pose, length)))
}

/// Returns the transform of a mesh's vertices: the reference pose is removed, then the scale applied.
fn transform(mesh: &Element) -> Result<DAffine3, XmlError> {
    let scale = mesh.vector("scale")?.unwrap_or(DVec3::ONE);
    if scale.cmpeq(DVec3::ZERO).any() {
        return Err(mesh.wrong("the scale is 0", "give another scale"));
    }
    let position = mesh.vector("refpos")?.unwrap_or(DVec3::ZERO);
    let rotation = match mesh.exactly::<4>("refquat")? {
        Some(quat) => compiler::rotation(quat)
            .ok_or_else(|| mesh.wrong("refquat has no direction", "give other numbers"))?,
        None => DMat3::IDENTITY,
    };
    let back = DAffine3::from_mat3_translation(rotation, position).inverse();
    Ok(DAffine3::from_scale(scale) * back)
}

fn color(element: &Element) -> Result<Option<[f32; 4]>, XmlError> {
    #[expect(clippy::cast_possible_truncation, reason = "a colour")]
    let narrow = |share: f64| share.clamp(0.0, 1.0) as f32;
    Ok(element.exactly::<4>("rgba")?.map(|rgba| rgba.map(narrow)))
}

fn unknown<'a>(
    element: &Element,
    what: &str,
    name: &str,
    known: impl Iterator<Item = &'a String>,
) -> XmlError {
    let mut known: Vec<&str> = known.map(String::as_str).collect();
    known.sort_unstable();
    element.wrong(format!("there is no {what} '{name}'"), suggest(name, known))
}
