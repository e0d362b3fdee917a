use oaktwin_scene::{Instance, MaterialSpan, Mesh, MeshAttribute};

use super::material::Materials;
use crate::text::{AttributeSpec, PrimSpec, SpecValue};

/// Creates the mesh of an instance, without its name and transform.
pub(super) fn prim(mesh: &Mesh, instance: &Instance, materials: &Materials<'_>) -> PrimSpec {
    let mut prim = PrimSpec::def("Mesh", "");
    prim.set("extent", SpecValue::Float3Array(extent(&mesh.positions)));
    prim.set(
        "faceVertexCounts",
        SpecValue::IntArray(vec![3; mesh.triangles.len()]),
    );
    prim.set(
        "faceVertexIndices",
        SpecValue::IntArray(integers(mesh.triangles.as_flattened())),
    );
    prim.set("points", SpecValue::Point3fArray(mesh.positions.clone()));
    prim.set_uniform("subdivisionScheme", SpecValue::token("none"));
    if mesh.double_sided {
        prim.set_uniform("doubleSided", SpecValue::Bool(true));
    }
    if let Some(normals) = &mesh.normals {
        primvar(&mut prim, "normals", normals, SpecValue::Normal3fArray);
    }
    if let Some(uvs) = &mesh.uvs {
        primvar(&mut prim, "st", uvs, SpecValue::TexCoord2fArray);
    }
    if let Some(colors) = &mesh.colors {
        primvar(&mut prim, "displayColor", colors, SpecValue::Color3fArray);
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
fn primvar<T: Copy>(
    prim: &mut PrimSpec,
    name: &str,
    data: &MeshAttribute<T>,
    value: impl Fn(Vec<T>) -> SpecValue,
) {
    let (values, interpolation) = match data {
        MeshAttribute::Constant(value) => (vec![*value], "constant"),
        MeshAttribute::Triangle(values) => (values.clone(), "uniform"),
        MeshAttribute::Vertex(values) => (values.clone(), "vertex"),
        MeshAttribute::Corner { values, .. } => (values.clone(), "faceVarying"),
    };
    let mut attribute = AttributeSpec::new(format!("primvars:{name}"), value(values));
    attribute.interpolation = Some(interpolation);
    prim.add(attribute);
    if let MeshAttribute::Corner { indices, .. } = data {
        prim.set(
            format!("primvars:{name}:indices"),
            SpecValue::IntArray(integers(indices.as_flattened())),
        );
    }
}

/// Adds the labels of an instance and of its ancestors, by taxonomy.
fn label(prim: &mut PrimSpec, instance: &Instance) {
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
        prim.set(
            format!("semantics:labels:{taxonomy}"),
            SpecValue::TokenArray(names),
        );
    }
}

/// Adds a subset of the faces for each material.
fn subsets(prim: &mut PrimSpec, instance: &Instance, spans: &[MaterialSpan], materials: &Materials<'_>) {
    prim.set_uniform(
        "subsetFamily:materialBind:familyType",
        SpecValue::token("nonOverlapping"),
    );
    let mut start = 0;
    for (i, span) in spans.iter().enumerate() {
        let mut subset = PrimSpec::def("GeomSubset", format!("subset_{i}"));
        subset.set_uniform("elementType", SpecValue::token("face"));
        subset.set_uniform("familyName", SpecValue::token("materialBind"));
        subset.set(
            "indices",
            SpecValue::IntArray((start..span.end).map(integer).collect()),
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
