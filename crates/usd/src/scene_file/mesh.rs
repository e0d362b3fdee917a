use oaktwin_scene::{Attribute as Data, Instance, MaterialSpan, Mesh};

use super::material::Materials;
use crate::text::{Attribute, Prim, Value};

/// Creates the mesh of an instance, without its name and transform.
pub(super) fn prim(mesh: &Mesh, instance: &Instance, materials: &Materials<'_>) -> Prim {
    let mut prim = Prim::def("Mesh", "");
    prim.set("extent", Value::Float3Array(extent(&mesh.positions)));
    prim.set("faceVertexCounts", Value::IntArray(vec![3; mesh.triangles.len()]));
    prim.set(
        "faceVertexIndices",
        Value::IntArray(integers(mesh.triangles.as_flattened())),
    );
    prim.set("points", Value::Point3fArray(mesh.positions.clone()));
    prim.set_uniform("subdivisionScheme", Value::token("none"));
    if mesh.double_sided {
        prim.set_uniform("doubleSided", Value::Bool(true));
    }
    if let Some(normals) = &mesh.normals {
        primvar(&mut prim, "normals", normals, Value::Normal3fArray);
    }
    if let Some(uvs) = &mesh.uvs {
        primvar(&mut prim, "st", uvs, Value::TexCoord2fArray);
    }
    if let Some(colors) = &mesh.colors {
        primvar(&mut prim, "displayColor", colors, Value::Color3fArray);
    }
    label(&mut prim, instance);
    match mesh.materials.as_slice() {
        [] => {}
        [MaterialSpan { material, .. }] => materials.relate(&mut prim, instance.material(*material)),
        spans => subsets(&mut prim, instance, spans, materials),
    }
    prim
}

/// Adds data at the corners of triangles as a primitive variable.
fn primvar<T: Copy>(prim: &mut Prim, name: &str, data: &Data<T>, value: impl Fn(Vec<T>) -> Value) {
    let (values, interpolation) = match data {
        Data::Constant(value) => (vec![*value], "constant"),
        Data::Triangle(values) => (values.clone(), "uniform"),
        Data::Vertex(values) => (values.clone(), "vertex"),
        Data::Corner { values, .. } => (values.clone(), "faceVarying"),
    };
    let mut attribute = Attribute::new(format!("primvars:{name}"), value(values));
    attribute.interpolation = Some(interpolation);
    prim.add(attribute);
    if let Data::Corner { indices, .. } = data {
        prim.set(
            format!("primvars:{name}:indices"),
            Value::IntArray(integers(indices.as_flattened())),
        );
    }
}

/// Adds the labels of an instance and of its ancestors, by taxonomy.
fn label(prim: &mut Prim, instance: &Instance) {
    let mut taxonomies: Vec<(&str, Vec<String>)> = Vec::new();
    for label in &instance.labels {
        match taxonomies
            .iter_mut()
            .find(|(taxonomy, _)| *taxonomy == label.taxonomy)
        {
            Some((_, names)) => names.push(label.name.clone()),
            None => taxonomies.push((&label.taxonomy, vec![label.name.clone()])),
        }
    }
    for (taxonomy, names) in taxonomies {
        let taxonomy = super::tree::identifier(taxonomy);
        prim.api_schemas.push(format!("SemanticsLabelsAPI:{taxonomy}"));
        prim.set(format!("semantics:labels:{taxonomy}"), Value::TokenArray(names));
    }
}

/// Adds a subset of the faces for each material.
fn subsets(prim: &mut Prim, instance: &Instance, spans: &[MaterialSpan], materials: &Materials<'_>) {
    prim.set_uniform(
        "subsetFamily:materialBind:familyType",
        Value::token("nonOverlapping"),
    );
    let mut start = 0;
    for (i, span) in spans.iter().enumerate() {
        let mut subset = Prim::def("GeomSubset", format!("subset_{i}"));
        subset.set_uniform("elementType", Value::token("face"));
        subset.set_uniform("familyName", Value::token("materialBind"));
        subset.set(
            "indices",
            Value::IntArray((start..span.end).map(integer).collect()),
        );
        materials.relate(&mut subset, instance.material(span.material));
        prim.children.push(subset);
        start = span.end;
    }
}

fn integers(indices: &[u32]) -> Vec<i32> {
    indices.iter().copied().map(integer).collect()
}

fn integer(index: u32) -> i32 {
    i32::try_from(index).unwrap_or(i32::MAX)
}

fn extent(points: &[[f32; 3]]) -> Vec<[f32; 3]> {
    let Some(&first) = points.first() else {
        return Vec::new();
    };
    let bound = |pick: fn(f32, f32) -> f32| {
        let wider =
            |bound: [f32; 3], point: &[f32; 3]| std::array::from_fn(|axis| pick(bound[axis], point[axis]));
        points.iter().fold(first, wider)
    };
    vec![bound(f32::min), bound(f32::max)]
}
