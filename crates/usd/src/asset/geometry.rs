use super::float;
use crate::body::{BodyMaterial, BodyPart};
use crate::text::{AttributeSpec, PrimSpec, SpecValue};

/// Creates the scopes `visuals` and `Looks`.
pub(super) fn scopes(parts: Vec<BodyPart>, materials: &[BodyMaterial], device_path: &str) -> [PrimSpec; 2] {
    let mut visuals = PrimSpec::def("Scope", "visuals");
    for part in parts {
        let looks = format!("{device_path}/Looks/{}", part.material);
        let mut mesh = mesh(part);
        mesh.api_schemas.push("MaterialBindingAPI".into());
        mesh.relate("material:binding", vec![looks]);
        visuals.children.push(mesh);
    }
    let mut looks = PrimSpec::def("Scope", "Looks");
    looks.children.extend(
        materials
            .iter()
            .map(|m| material(m, &format!("{device_path}/Looks/{}", m.name))),
    );
    [visuals, looks]
}

/// Creates a polygon mesh without subdivision, with normals.
pub(super) fn mesh(part: BodyPart) -> PrimSpec {
    let mut mesh = PrimSpec::def("Mesh", part.name);
    mesh.set("extent", SpecValue::Float3Array(extent(&part.points)));
    mesh.set("faceVertexCounts", SpecValue::IntArray(part.face_vertex_counts));
    mesh.set("faceVertexIndices", SpecValue::IntArray(part.face_vertex_indices));
    let mut normals = AttributeSpec::new("normals", SpecValue::Normal3fArray(part.normals));
    normals.interpolation = Some("faceVarying");
    mesh.add(normals);
    mesh.set("points", SpecValue::Point3fArray(part.points));
    mesh.set_uniform("subdivisionScheme", SpecValue::token("none"));
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

fn material(material: &BodyMaterial, path: &str) -> PrimSpec {
    const SHADER: &str = "Surface";
    let mut shader = PrimSpec::def("Shader", SHADER);
    shader.set_uniform("info:id", SpecValue::token("UsdPreviewSurface"));
    shader.set("inputs:diffuseColor", SpecValue::Color3f(material.diffuse));
    for (name, value) in [
        ("metallic", material.metallic),
        ("roughness", material.roughness),
        ("opacity", material.opacity),
        ("ior", material.ior),
        ("clearcoat", material.clearcoat),
    ] {
        shader.set(format!("inputs:{name}"), float(value.into()));
    }
    shader.add(AttributeSpec::without_value("outputs:surface", "token"));

    let mut prim = PrimSpec::def("Material", material.name);
    let mut surface = AttributeSpec::without_value("outputs:surface", "token");
    surface.connections = vec![format!("{path}/{SHADER}.outputs:surface")];
    prim.add(surface);
    prim.with_child(shader)
}
