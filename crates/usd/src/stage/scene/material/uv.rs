use super::super::super::reader::Reader;
use super::super::super::value::{number, text, vec2};
use super::identifier;
use super::network::{Input, Node, input};

/// The texture coordinates of an image.
pub(super) struct Placement {
    /// The primvar with the texture coordinates, without its prefix; `None` if the network does not specify it.
    pub(super) primvar: Option<String>,
    /// The rows of the matrix from texture coordinates to image coordinates.
    pub(super) image_from_uv: [[f32; 3]; 2],
}

/// The maximum number of chained transforms.
const MAX_DEPTH: usize = 8;

impl Placement {
    /// Returns the placement with the image repeated `tiling` times.
    pub(super) fn tiled(mut self, tiling: [f32; 2]) -> Self {
        for (row, factor) in self.image_from_uv.iter_mut().zip(tiling) {
            *row = row.map(|v| v * factor);
        }
        self
    }
}

/// Follows an image's texture coordinates to their primvar.
pub(super) fn placement(reader: &Reader, image: &Node, name: &str) -> Placement {
    let mut placement = Placement {
        primvar: None,
        image_from_uv: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    };
    let (mut node, mut name) = (image.clone(), name);
    for _ in 0..MAX_DEPTH {
        let Some(Input::Node(source)) = input(reader, &node.shader, name) else {
            return placement;
        };
        let id = identifier(reader, &source);
        if id.starts_with("UsdPrimvarReader_") {
            placement.primvar = value(reader, &source, "inputs:varname").and_then(text);
            return placement;
        }
        if id.starts_with("ND_geompropvalue_") {
            placement.primvar = value(reader, &source, "inputs:geomprop").and_then(text);
            return placement;
        }
        let inner = match id.as_str() {
            "UsdTransform2d" => {
                name = "inputs:in";
                transform_2d(reader, &source)
            }
            "ND_place2d_vector2" => {
                name = "inputs:texcoord";
                place_2d(reader, &source)
            }
            _ => return placement,
        };
        placement.image_from_uv = product(placement.image_from_uv, inner);
        node = source;
    }
    placement
}

fn value(reader: &Reader, node: &Node, name: &str) -> Option<openusd::sdf::Value> {
    match input(reader, &node.shader, name)? {
        Input::Value(value, _) => Some(value),
        Input::Node(_) => None,
    }
}

/// Returns the matrix of `UsdTransform2d`: scale, then counter-clockwise rotation, then translation.
fn transform_2d(reader: &Reader, node: &Node) -> [[f32; 3]; 2] {
    let pair = |name, fallback| {
        value(reader, node, name)
            .and_then(|v| vec2(&v))
            .unwrap_or(fallback)
    };
    let [sx, sy] = pair("inputs:scale", [1.0; 2]);
    let [tx, ty] = pair("inputs:translation", [0.0; 2]);
    let (sin, cos) = angle(reader, node, "inputs:rotation").sin_cos();
    [[cos * sx, -sin * sy, tx], [sin * sx, cos * sy, ty]]
}

/// Returns the matrix of `MaterialX`'s `place2d` in its default order: about the pivot, division by the scale, then
/// clockwise rotation, then subtraction of the offset.
fn place_2d(reader: &Reader, node: &Node) -> [[f32; 3]; 2] {
    let pair = |name, fallback| {
        value(reader, node, name)
            .and_then(|v| vec2(&v))
            .unwrap_or(fallback)
    };
    let [px, py] = pair("inputs:pivot", [0.0; 2]);
    let [sx, sy] = pair("inputs:scale", [1.0; 2]);
    let [ox, oy] = pair("inputs:offset", [0.0; 2]);
    let (sin, cos) = angle(reader, node, "inputs:rotate").sin_cos();
    let back = [[1.0, 0.0, px - ox], [0.0, 1.0, py - oy]];
    let turn = [[cos, sin, 0.0], [-sin, cos, 0.0]];
    let scale = [[1.0 / sx, 0.0, -px / sx], [0.0, 1.0 / sy, -py / sy]];
    product(back, product(turn, scale))
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "image coordinates have single precision"
)]
fn angle(reader: &Reader, node: &Node, name: &str) -> f32 {
    let degrees = value(reader, node, name).and_then(|v| number(&v)).unwrap_or(0.0);
    degrees.to_radians() as f32
}

/// Returns the transform that applies `b`, then `a`.
fn product(a: [[f32; 3]; 2], b: [[f32; 3]; 2]) -> [[f32; 3]; 2] {
    a.map(|[ax, ay, at]| {
        [
            ax * b[0][0] + ay * b[1][0],
            ax * b[0][1] + ay * b[1][1],
            ax * b[0][2] + ay * b[1][2] + at,
        ]
    })
}
