//! Models of BOP: their sizes, and their files in millimetres.

use std::collections::HashMap;
use std::path::PathBuf;

use oaktwin_image::{CodecError, png};
use serde_json::{Value, json};

use crate::{Model, Paint};

/// Describes a model: its size in millimetres, its name and its class.
pub(super) fn info(model: &Model) -> Value {
    let points: Vec<[f64; 3]> = model
        .positions
        .iter()
        .map(|p| p.map(|x| 1000.0 * f64::from(x)))
        .collect();
    let reduce =
        |axis: usize, f: fn(f64, f64) -> f64| points.iter().map(|p| p[axis]).reduce(f).unwrap_or_default();
    let low = [0, 1, 2].map(|axis| reduce(axis, f64::min));
    let high = [0, 1, 2].map(|axis| reduce(axis, f64::max));
    json!({
        "name": model.name,
        "label": model.label,
        "is_textured": matches!(model.paint, Paint::Texture { .. }),
        "info": {
            "diameter": diameter(&points),
            "min_x": low[0], "min_y": low[1], "min_z": low[2],
            "size_x": high[0] - low[0], "size_y": high[1] - low[1], "size_z": high[2] - low[2],
        },
    })
}

/// Returns the largest distance between two points.
///
/// Points are compared from the outermost inwards, so that most pairs cannot be further apart than one that is known.
fn diameter(points: &[[f64; 3]]) -> f64 {
    let distance = |a: &[f64; 3], b: &[f64; 3]| {
        let [x, y, z] = [0, 1, 2].map(|axis| a[axis] - b[axis]);
        (x * x + y * y + z * z).sqrt()
    };
    #[expect(clippy::cast_precision_loss, reason = "a number of points")]
    let mean = [0, 1, 2].map(|axis| points.iter().map(|p| p[axis]).sum::<f64>() / points.len().max(1) as f64);
    let mut outermost: Vec<(f64, &[f64; 3])> = points.iter().map(|p| (distance(p, &mean), p)).collect();
    outermost.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut largest: f64 = 0.0;
    for (at, (radius, point)) in outermost.iter().enumerate() {
        for (other_radius, other) in &outermost[..at] {
            if radius + other_radius <= largest {
                break;
            }
            largest = largest.max(distance(point, other));
        }
    }
    largest
}

/// The paths of the files of a model with this description.
pub(super) fn paths(id: u64, info: &Value) -> Vec<PathBuf> {
    paths_of(id, info["is_textured"] == true)
}

fn paths_of(id: u64, is_textured: bool) -> Vec<PathBuf> {
    let path = |extension: &str| PathBuf::from(format!("models/obj_{id:06}.{extension}"));
    let extensions = ["ply"].into_iter().chain(is_textured.then_some("png"));
    extensions.map(path).collect()
}

/// The files of a model: a binary PLY, and a PNG of its texture if it has one.
pub(super) fn files(model: &Model) -> Result<Vec<(PathBuf, Vec<u8>)>, CodecError> {
    let image = format!("obj_{:06}.png", model.id);
    let is_textured = matches!(model.paint, Paint::Texture { .. });
    let mut contents = vec![ply(model, is_textured.then_some(image.as_str()))];
    if let Paint::Texture { image, .. } = &model.paint {
        contents.push(png::encode(&image.map(|[r, g, b, _]| [*r, *g, *b]))?);
    }
    Ok(paths_of(model.id.into(), is_textured)
        .into_iter()
        .zip(contents)
        .collect())
}

/// A vertex of a file: the index of its position, and its colour or texture coordinates.
type Vertex = (u32, [u8; 3], [u32; 2]);

/// Vertices with the same position, but other colours or texture coordinates, are different vertices of the file.
fn ply(model: &Model, image: Option<&str>) -> Vec<u8> {
    let mut vertices: Vec<Vertex> = Vec::new();
    let mut known: HashMap<Vertex, u32> = HashMap::new();
    let mut index = |vertex: Vertex| {
        *known.entry(vertex).or_insert_with(|| {
            vertices.push(vertex);
            u32::try_from(vertices.len() - 1).unwrap_or(u32::MAX)
        })
    };
    let corner = |triangle: usize, corner: usize| match &model.paint {
        Paint::Corners(colors) => (
            colors.get(triangle).map_or([0; 3], |colors| colors[corner]),
            [0; 2],
        ),
        Paint::Texture { uvs, .. } => {
            let uv = uvs.get(triangle).map_or([0.0; 2], |uvs| uvs[corner]);
            ([0; 3], uv.map(f32::to_bits))
        }
    };
    let triangles = model.triangles.iter().enumerate();
    let triangles: Vec<[u32; 3]> = triangles
        .map(|(at, positions)| {
            [0, 1, 2].map(|i| {
                let (color, uv) = corner(at, i);
                index((positions[i], color, uv))
            })
        })
        .collect();
    let is_colored = matches!(&model.paint, Paint::Corners(colors) if !colors.is_empty());
    let mut header = "ply\nformat binary_little_endian 1.0\n".to_owned();
    if let Some(image) = image {
        header += &format!("comment TextureFile {image}\n");
    }
    header += &format!("element vertex {}\n", vertices.len());
    header += "property float x\nproperty float y\nproperty float z\n";
    if is_colored {
        header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    } else if image.is_some() {
        header += "property float texture_u\nproperty float texture_v\n";
    }
    header += &format!(
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        triangles.len()
    );
    let mut bytes = header.into_bytes();
    for (position, color, uv) in vertices {
        let position = model
            .positions
            .get(position as usize)
            .copied()
            .unwrap_or_default();
        bytes.extend(position.iter().flat_map(|x| (x * 1000.0).to_le_bytes()));
        if is_colored {
            bytes.extend(color);
        } else if image.is_some() {
            bytes.extend(uv.iter().flat_map(|bits| bits.to_le_bytes()));
        }
    }
    for triangle in &triangles {
        bytes.push(3);
        bytes.extend(triangle.iter().flat_map(|index| index.to_le_bytes()));
    }
    bytes
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use oaktwin_image::Image;

    use super::*;

    fn quad(paint: Paint) -> Model {
        Model {
            id: 7,
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            paint,
            ..Model::default()
        }
    }

    fn header(file: &[u8]) -> String {
        let text = String::from_utf8_lossy(file);
        text.split("end_header").next().unwrap_or_default().to_owned()
    }

    #[test]
    fn corners_that_differ_become_vertices() {
        let plain = &files(&quad(Paint::default())).unwrap()[0].1;
        assert!(header(plain).contains("element vertex 4\n") && !header(plain).contains("red"));
        let colored = files(&quad(Paint::Corners(vec![[[9, 8, 7]; 3], [[1, 2, 3]; 3]]))).unwrap();
        assert_eq!(colored.len(), 1);
        assert!(header(&colored[0].1).contains("element vertex 6\n"));
        let textured = files(&quad(Paint::Texture {
            uvs: vec![
                [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]],
                [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            ],
            image: Arc::new(Image::filled(2, 2, [1, 2, 3, 255])),
        }))
        .unwrap();
        assert_eq!(textured[1].0.as_os_str(), "models/obj_000007.png");
        let header = header(&textured[0].1);
        assert!(
            header.contains("comment TextureFile obj_000007.png\nelement vertex 4\n"),
            "{header}"
        );
    }
}
