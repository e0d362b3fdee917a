use super::{Axis, are_sizes, narrow};
use crate::{Mesh, MeshAttribute};

/// Creates a cube with edges of length `size`; each side shows the whole image.
#[must_use]
pub fn cube(size: f64) -> Mesh {
    if !are_sizes(&[size]) {
        return Mesh::default();
    }
    let mut mesh = Builder::default();
    let half = size / 2.0;
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        for side in [-1.0, 1.0] {
            mesh.rectangle([half * side, half, half * side], axis, [0.0, 0.0, side]);
        }
    }
    mesh.finish()
}

/// Creates a rectangle perpendicular to `axis`, visible from both sides. As in OpenUSD, `width` is along x, or along z if
/// `axis` is x; `length` is along y, or along z if `axis` is y.
#[must_use]
pub fn plane(width: f64, length: f64, axis: Axis) -> Mesh {
    if !are_sizes(&[width, length]) {
        return Mesh::default();
    }
    // The sizes before `Axis::turn`.
    let (x, y) = match axis {
        Axis::X => (length, width),
        Axis::Y => (length, width),
        Axis::Z => (width, length),
    };
    let mut mesh = Builder::default();
    mesh.rectangle([x / 2.0, y / 2.0, 0.0], axis, [0.0, 0.0, 1.0]);
    Mesh {
        double_sided: true,
        ..mesh.finish()
    }
}

#[derive(Default)]
struct Builder {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl Builder {
    /// Adds the rectangle from `(−x, −y, z)` to `(x, y, z)`, turned to the axis; a negative x reverses its normal.
    fn rectangle(&mut self, [x, y, z]: [f64; 3], axis: Axis, normal: [f64; 3]) {
        let first = u32::try_from(self.positions.len()).unwrap_or(u32::MAX);
        for [u, v] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
            let position = [(2.0 * u - 1.0) * x, (2.0 * v - 1.0) * y, z];
            self.positions.push(narrow(axis.turn(position)));
            self.normals.push(narrow(axis.turn(normal)));
            self.uvs.push(narrow([u, v]));
        }
        let corner = |i| first + i;
        self.triangles.extend([
            [corner(0), corner(1), corner(2)],
            [corner(0), corner(2), corner(3)],
        ]);
    }

    fn finish(self) -> Mesh {
        Mesh {
            positions: self.positions,
            triangles: self.triangles,
            normals: Some(MeshAttribute::Vertex(self.normals)),
            uvs: Some(MeshAttribute::Vertex(self.uvs)),
            ..Mesh::default()
        }
    }
}
