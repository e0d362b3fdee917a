//! Imports STL, binary and text. Triangles share points with equal coordinates; facet normals repeat the winding and
//! are ignored.

use oaktwin_camera::math::{DAffine3, DVec3};

use super::builder::{Builder, step};
use super::error::Fault;
use super::origin::{FAR_M, relative};
use super::text;
use super::weld::Welder;
use crate::polygon::PolygonMesh;

/// Bytes before the first facet: a comment and the number of facets.
const HEADER: usize = 84;
/// Bytes of a facet: a normal and three points of three numbers each, and an attribute of two bytes.
const FACET: usize = 50;

pub(super) fn read(bytes: &[u8], builder: &mut Builder) -> Result<(), Fault> {
    let binary = binary_length(bytes);
    let starts_as_text = bytes.trim_ascii_start().starts_with(b"solid");
    match binary {
        // Binary files may start with `solid` as well; the length decides.
        Some(length) if length == bytes.len() || (!starts_as_text && length <= bytes.len()) => {
            if length < bytes.len() {
                let spare = bytes.len() - length;
                builder.warn(
                    "stl-trailing",
                    "end",
                    format!("{spare} extra bytes after the last facet"),
                );
            }
            read_binary(&bytes[HEADER..length], builder);
            Ok(())
        }
        _ if starts_as_text => read_text(bytes, builder),
        Some(length) => Err(Fault::damaged(
            "header",
            format!("{length} bytes required, {} available", bytes.len()),
        )),
        None => Err(Fault::damaged(
            "header",
            "is neither a binary nor a text STL file",
        )),
    }
}

fn binary_length(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(HEADER - 4..HEADER)?.first_chunk()?;
    usize::try_from(u32::from_le_bytes(*count))
        .ok()?
        .checked_mul(FACET)?
        .checked_add(HEADER)
}

fn read_binary(facets: &[u8], builder: &mut Builder) {
    let count = facets.len() / FACET;
    // A closed mesh has half as many points as triangles.
    let mut welder = Welder::with_capacity(count / 2 + 3);
    let mut indices = Vec::with_capacity(3 * count);
    for facet in facets.as_chunks::<FACET>().0 {
        for point in facet[12..48].as_chunks::<12>().0 {
            let float =
                |at: usize| f32::from_le_bytes([point[at], point[at + 1], point[at + 2], point[at + 3]]);
            indices.push(welder.index([float(0), float(4), float(8)]));
        }
    }
    let name = builder.stem.clone();
    add(&name, welder.points, indices, DVec3::ZERO, builder);
}

fn read_text(bytes: &[u8], builder: &mut Builder) -> Result<(), Fault> {
    let mut name = String::new();
    let mut welder = Welder::with_capacity(0);
    let mut indices = Vec::new();
    let mut corners = 0;
    let mut ended = true;
    for (number, line) in text::lines(bytes) {
        let place = || format!("line {number}");
        let mut words = text::words(line);
        match words.next().map(<[u8]>::to_ascii_lowercase).as_deref() {
            Some(b"vertex") => {
                let Some(point) = text::numbers(&mut words) else {
                    return Err(Fault::damaged(place(), "expected three coordinates of a vertex"));
                };
                indices.push(welder.index(point));
                corners += 1;
            }
            Some(b"endfacet") => {
                if corners != 3 {
                    return Err(Fault::damaged(place(), format!("a facet has {corners} vertices")));
                }
                corners = 0;
            }
            Some(b"solid") => {
                name = String::from_utf8_lossy(line.trim_ascii().get(5..).unwrap_or_default()).into_owned();
                ended = false;
            }
            Some(b"endsolid") => {
                let points = std::mem::replace(&mut welder, Welder::with_capacity(0)).points;
                let origin = builder.origin(points.iter().copied(), FAR_M);
                let points = points.into_iter().map(|point| relative(point, origin)).collect();
                add(&name, points, std::mem::take(&mut indices), origin, builder);
                ended = true;
            }
            Some(b"facet" | b"outer" | b"endloop" | b"color") | None => {}
            Some(_) => {
                return Err(Fault::damaged(
                    place(),
                    format!("unknown keyword: {}", text::shown(line)),
                ));
            }
        }
    }
    if !ended || corners != 0 {
        return Err(Fault::damaged("end", "endsolid is missing"));
    }
    Ok(())
}

fn add(name: &str, points: Vec<[f32; 3]>, indices: Vec<i32>, origin: DVec3, builder: &mut Builder) {
    let name = step(name);
    let path = format!(
        "/{}",
        if name.is_empty() {
            step(&builder.stem)
        } else {
            name
        }
    );
    let (mesh, findings) = PolygonMesh {
        points,
        face_vertex_counts: vec![3; indices.len() / 3],
        face_vertex_indices: indices,
        ..PolygonMesh::default()
    }
    .into_mesh(&path);
    builder.findings.extend(findings);
    if let Some(mesh) = builder.add_mesh(mesh) {
        builder.place(mesh, &path, DAffine3::from_translation(origin));
    }
}
