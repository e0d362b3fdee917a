//! Imports PLY, text and binary of both byte orders: a mesh with normals, colours and texture coordinates at its points.
//!
//! Integer colours are sRGB, as scanners and viewers write them; floating-point colours are linear.

mod body;
mod header;

use oaktwin_camera::math::DAffine3;

use self::body::Body;
use self::header::{Element, Encoding, Header, NumberKind, Property};
use super::builder::{Builder, step};
use super::error::Fault;
use super::origin::{FAR_M, relative};
use crate::polygon::{Interpolation, PolygonMesh, Primvar};
use oaktwin_image::srgb;

pub(super) fn read(bytes: &[u8], builder: &mut Builder) -> Result<(), Fault> {
    let header = Header::read(bytes)?;
    if let Some((line, text)) = &header.unknown {
        let message = format!("unknown header line; ignored: {text}");
        builder.warn("ply-header", format!("line {line}"), message);
    }
    let mut body = Body::new(&bytes[header.length..], &header);
    let mut mesh = PolygonMesh::default();
    let mut points = Vec::new();
    for element in &header.elements {
        check_size(element, header.encoding, &body)?;
        match element.name.as_str() {
            "vertex" => points = read_vertices(element, &mut body, &mut mesh)?,
            "face" => read_faces(element, &mut body, &mut mesh)?,
            name => {
                if name == "tristrips" && element.count > 0 {
                    builder.warn(
                        "ply-strips",
                        "tristrips",
                        "triangle strips are not supported; skipped",
                    );
                }
                skip(element, &mut body)?;
            }
        }
    }
    if points.is_empty() {
        return Err(Fault::new("vertex", "contains no points", "export it again"));
    }
    if mesh.face_vertex_counts.is_empty() {
        return Err(Fault::new(
            "face",
            format!("is a point cloud of {} points without faces", points.len()),
            "convert it to a mesh first, for example by Poisson reconstruction",
        ));
    }
    let used = mesh.face_vertex_indices.iter();
    let used = used.filter_map(|&at| points.get(usize::try_from(at).ok()?).copied());
    let origin = builder.origin(used, FAR_M);
    mesh.points = points.into_iter().map(|point| relative(point, origin)).collect();
    let path = format!("/{}", step(&builder.stem));
    let (mesh, findings) = mesh.into_mesh(&path);
    builder.findings.extend(findings);
    if let Some(mesh) = builder.add_mesh(mesh) {
        builder.place(mesh, &path, DAffine3::from_translation(origin));
    }
    Ok(())
}

/// Rejects an element count that the rest of the file cannot hold, before memory is allocated for it.
fn check_size(element: &Element, encoding: Encoding, body: &Body<'_>) -> Result<(), Fault> {
    let min_size = element.min_size(encoding);
    let needed = element.count.checked_mul(min_size);
    // In text the last number needs no separator.
    if min_size > 0 && needed.is_none_or(|needed| needed > body.left() + 1) {
        return Err(Fault::damaged(
            &element.name,
            format!("{} elements do not fit into the file", element.count),
        ));
    }
    Ok(())
}

fn skip(element: &Element, body: &mut Body<'_>) -> Result<(), Fault> {
    if element.properties.is_empty() {
        return Ok(());
    }
    for _ in 0..element.count {
        for property in &element.properties {
            skip_property(property, body)?;
        }
        body.end_row();
    }
    Ok(())
}

fn skip_property(property: &Property, body: &mut Body<'_>) -> Result<(), Fault> {
    let count = match property.list {
        Some(kind) => body.length(kind)?,
        None => 1,
    };
    body.skip(property.kind, count)
}

/// The meaning of a column of the vertex element.
#[derive(Clone, Copy)]
enum Column {
    Position(usize),
    Normal(usize),
    Uv(usize),
    /// A colour channel, with the value that means 1 if it is an integer.
    Color(usize, Option<f64>),
    Other,
}

fn columns(element: &Element) -> Vec<Column> {
    let column = |property: &Property| {
        let whole = match property.kind {
            NumberKind::U8 => Some(255.0),
            NumberKind::U16 => Some(65535.0),
            _ => None,
        };
        match property.name.as_str() {
            _ if property.list.is_some() => Column::Other,
            "x" => Column::Position(0),
            "y" => Column::Position(1),
            "z" => Column::Position(2),
            "nx" => Column::Normal(0),
            "ny" => Column::Normal(1),
            "nz" => Column::Normal(2),
            "u" | "s" | "texture_u" => Column::Uv(0),
            "v" | "t" | "texture_v" => Column::Uv(1),
            "red" | "r" | "diffuse_red" => Column::Color(0, whole),
            "green" | "g" | "diffuse_green" => Column::Color(1, whole),
            "blue" | "b" | "diffuse_blue" => Column::Color(2, whole),
            _ => Column::Other,
        }
    };
    element.properties.iter().map(column).collect()
}

/// Reads the points, and sets what else a mesh has at its points.
#[allow(clippy::cast_possible_truncation, reason = "meshes store single precision")]
fn read_vertices(
    element: &Element,
    body: &mut Body<'_>,
    mesh: &mut PolygonMesh,
) -> Result<Vec<[f64; 3]>, Fault> {
    let columns = columns(element);
    if ["x", "y", "z"].iter().any(|name| element.find(&[name]).is_none()) {
        return Err(Fault::new(
            "vertex",
            "x, y and z are missing",
            "export it with positions",
        ));
    }
    let count = element.count;
    let has = |wanted: fn(&Column) -> bool| columns.iter().any(wanted);
    let room = |wanted: bool| if wanted { count } else { 0 };
    let has_normals = has(|column| matches!(column, Column::Normal(_)));
    let has_uvs = has(|column| matches!(column, Column::Uv(_)));
    let has_colors = has(|column| matches!(column, Column::Color(..)));
    let mut points = Vec::with_capacity(count);
    let mut normals = Vec::with_capacity(room(has_normals));
    let mut uvs = Vec::with_capacity(room(has_uvs));
    let mut colors = Vec::with_capacity(room(has_colors));
    for _ in 0..count {
        let (mut point, mut normal, mut uv, mut color) = ([0.0; 3], [0.0; 3], [0.0; 2], [0.0; 3]);
        for (property, column) in element.properties.iter().zip(&columns) {
            if let Column::Other = column {
                skip_property(property, body)?;
                continue;
            }
            let number = body.number(property.kind)?;
            match *column {
                Column::Position(i) => point[i] = number,
                Column::Normal(i) => normal[i] = number as f32,
                Column::Uv(i) => uv[i] = number as f32,
                Column::Color(i, None) => color[i] = number as f32,
                Column::Color(i, Some(one)) => color[i] = srgb::linear((number / one) as f32),
                Column::Other => {}
            }
        }
        body.end_row();
        points.push(point);
        if has_normals {
            normals.push(normal);
        }
        if has_uvs {
            uvs.push(uv);
        }
        if has_colors {
            colors.push(color);
        }
    }
    mesh.normals = has_normals.then(|| Primvar::new(Interpolation::Vertex, normals));
    mesh.uvs = has_uvs.then(|| Primvar::new(Interpolation::Vertex, uvs));
    mesh.colors = has_colors.then(|| Primvar::new(Interpolation::Vertex, colors));
    Ok(points)
}

fn read_faces(element: &Element, body: &mut Body<'_>, mesh: &mut PolygonMesh) -> Result<(), Fault> {
    let corners = element.find(&["vertex_indices", "vertex_index"]);
    if corners.is_none_or(|at| element.properties[at].list.is_none()) && element.count > 0 {
        return Err(Fault::new(
            "face",
            "the list vertex_indices is missing",
            "export it as a mesh",
        ));
    }
    mesh.face_vertex_counts.reserve_exact(element.count);
    for _ in 0..element.count {
        for (at, property) in element.properties.iter().enumerate() {
            let Some(length) = property.list.filter(|_| Some(at) == corners) else {
                skip_property(property, body)?;
                continue;
            };
            let count = body.length(length)?;
            for _ in 0..count {
                let index = body.number(property.kind)?;
                mesh.face_vertex_indices.push(whole(index));
            }
            mesh.face_vertex_counts
                .push(i32::try_from(count).unwrap_or(i32::MAX));
        }
        body.end_row();
    }
    Ok(())
}

/// Converts a vertex index; −1 for an invalid one.
#[allow(clippy::cast_possible_truncation, reason = "checked")]
fn whole(number: f64) -> i32 {
    let index = number as i32;
    if f64::from(index) == number { index } else { -1 }
}
