use oaktwin_catalog::Twin;

use super::{AssetError, float};
use crate::text::{Attribute, Prim, Value};

/// A mesh of the body, in the device's frame, metres.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPart {
    /// A prim name.
    pub name: String,
    /// Positions.
    pub points: Vec<[f32; 3]>,
    /// Corners of each face.
    pub face_vertex_counts: Vec<i32>,
    /// The points of the corners, counter-clockwise seen from outside.
    pub face_vertex_indices: Vec<i32>,
    /// Unit normals: one for each corner, or one for each point.
    pub normals: Vec<[f32; 3]>,
    /// What it is made of. Parts with materials of one name share the first.
    pub material: BodyMaterial,
}

/// The inputs of a `UsdPreviewSurface`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BodyMaterial {
    /// A prim name.
    pub name: String,
    /// `diffuseColor`, linear Rec. 709.
    pub diffuse: [f32; 3],
    /// `metallic`, 0 to 1.
    pub metallic: f32,
    /// `roughness`, 0 to 1.
    pub roughness: f32,
    /// `opacity`, 0 to 1.
    pub opacity: f32,
    /// `ior`.
    pub ior: f32,
}

/// The visible body of a twin.
pub(super) fn body_parts(_twin: &Twin) -> Vec<BodyPart> {
    Vec::new()
}

/// The scopes `visuals` and `Looks`.
pub(super) fn prims(parts: &[BodyPart], device_path: &str) -> Result<[Prim; 2], AssetError> {
    let mut visuals = Prim::def("Scope", "visuals");
    let mut looks = Prim::def("Scope", "Looks");
    for part in parts {
        let corners = part.face_vertex_indices.len();
        let interpolation = if part.normals.len() == corners {
            "faceVarying"
        } else if part.normals.len() == part.points.len() {
            "vertex"
        } else {
            return Err(AssetError::Normals {
                part: part.name.clone(),
                normals: part.normals.len(),
                points: part.points.len(),
                corners,
            });
        };
        let mut mesh = mesh(part, interpolation);
        mesh.api_schemas.push("MaterialBindingAPI".into());
        let material_path = format!("{device_path}/Looks/{}", part.material.name);
        mesh.relate("material:binding", vec![material_path.clone()]);
        visuals.children.push(mesh);
        if looks.child(&part.material.name).is_none() {
            looks.children.push(material(&part.material, &material_path));
        }
    }
    Ok([visuals, looks])
}

/// A polygon mesh: not subdivided, so it carries its normals.
pub(super) fn mesh(part: &BodyPart, interpolation: &'static str) -> Prim {
    let mut mesh = Prim::def("Mesh", &part.name);
    mesh.set("extent", Value::Float3Array(extent(&part.points)));
    mesh.set(
        "faceVertexCounts",
        Value::IntArray(part.face_vertex_counts.clone()),
    );
    mesh.set(
        "faceVertexIndices",
        Value::IntArray(part.face_vertex_indices.clone()),
    );
    let mut normals = Attribute::new("normals", Value::Normal3fArray(part.normals.clone()));
    normals.interpolation = Some(interpolation);
    mesh.add(normals);
    mesh.set("points", Value::Point3fArray(part.points.clone()));
    mesh.set_uniform("subdivisionScheme", Value::token("none"));
    mesh
}

fn extent(points: &[[f32; 3]]) -> Vec<[f32; 3]> {
    let Some(&first) = points.first() else {
        return Vec::new();
    };
    let bound = |pick: fn(f32, f32) -> f32| {
        points.iter().fold(first, |bound, point| {
            std::array::from_fn(|axis| pick(bound[axis], point[axis]))
        })
    };
    vec![bound(f32::min), bound(f32::max)]
}

fn material(material: &BodyMaterial, path: &str) -> Prim {
    const SHADER: &str = "Surface";
    let mut shader = Prim::def("Shader", SHADER);
    shader.set_uniform("info:id", Value::token("UsdPreviewSurface"));
    shader.set("inputs:diffuseColor", Value::Color3f(material.diffuse));
    for (name, value) in [
        ("metallic", material.metallic),
        ("roughness", material.roughness),
        ("opacity", material.opacity),
        ("ior", material.ior),
    ] {
        shader.set(format!("inputs:{name}"), float(value.into()));
    }
    shader.add(Attribute::without_value("outputs:surface", "token"));

    let mut prim = Prim::def("Material", &material.name);
    let mut surface = Attribute::without_value("outputs:surface", "token");
    surface.connections = vec![format!("{path}/{SHADER}.outputs:surface")];
    prim.add(surface);
    prim.with_child(shader)
}
