//! Surfaces of revolution.

use super::{AROUND, Axis, are_sizes, narrow};
use crate::{Mesh, MeshAttribute, turn};

/// A point of an outline: its distances from the axis and along it.
struct Knot {
    out: f64,
    along: f64,
    /// The unit normal of the surface.
    normal: [f64; 2],
    v: f64,
}

/// An outline, from the bottom to the top, with the surface on its right.
#[derive(Default)]
pub(super) struct Outline {
    knots: Vec<Knot>,
}

impl Outline {
    /// Adds an arc between quarters of a circle: −1 is the bottom pole, 0 the equator, 1 the top pole.
    pub(super) fn arc(&mut self, from: i8, to: i8, radius: f64, center: f64, [v0, v1]: [f64; 2]) {
        let steps = u32::from(to.abs_diff(from)) * AROUND / 4;
        for step in 0..=steps {
            // Adds a full turn to avoid negative angles.
            let part = if from < 0 { 3 * AROUND / 4 + step } else { step };
            let (cosine, sine) = turn::cos_sin(part, AROUND);
            self.push(Knot {
                out: radius * cosine,
                along: center + radius * sine,
                normal: [cosine, sine],
                v: v0 + (v1 - v0) * f64::from(step) / f64::from(steps),
            });
        }
    }

    /// Adds a knot, with no surface between it and an equal previous knot.
    fn push(&mut self, knot: Knot) {
        let is_last = |last: &Knot| (last.out, last.along) == (knot.out, knot.along);
        if !self.knots.last().is_some_and(is_last) {
            self.knots.push(knot);
        }
    }

    pub(super) fn line(&mut self, from: [f64; 2], to: [f64; 2], [v0, v1]: [f64; 2]) {
        let [out, along] = [to[0] - from[0], to[1] - from[1]];
        let length = (out * out + along * along).sqrt();
        let normal = [along / length, -out / length];
        for ([out, along], v) in [(from, v0), (to, v1)] {
            self.push(Knot {
                out,
                along,
                normal,
                v,
            });
        }
    }
}

/// A mesh assembled from surfaces of revolution.
pub(super) struct Lathe {
    axis: Axis,
    exists: bool,
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl Lathe {
    pub(super) fn new(axis: Axis, sizes: &[f64]) -> Self {
        Self {
            axis,
            exists: are_sizes(sizes),
            positions: Vec::new(),
            normals: Vec::new(),
            uvs: Vec::new(),
            triangles: Vec::new(),
        }
    }

    /// Adds the surface of an outline; u runs around the axis.
    pub(super) fn surface(mut self, outline: &Outline) -> Self {
        let mut below: Option<(&Knot, u32)> = None;
        for knot in &outline.knots {
            let first = self.ring(knot);
            if let Some((lower, lower_first)) = below {
                for k in 0..AROUND {
                    let (a, b) = (lower_first + k, lower_first + k + 1);
                    let (d, c) = (first + k, first + k + 1);
                    if lower.out > 0.0 {
                        self.triangles.push([a, b, if knot.out > 0.0 { c } else { d }]);
                    }
                    if knot.out > 0.0 {
                        self.triangles.push([a, c, d]);
                    }
                }
            }
            below = Some((knot, first));
        }
        self
    }

    /// Adds the vertices of a circle, with the first repeated at the end; a pole has one vertex per triangle, half-way
    /// between that triangle's other vertices.
    fn ring(&mut self, knot: &Knot) -> u32 {
        let first = u32::try_from(self.positions.len()).unwrap_or(u32::MAX);
        let half = u32::from(knot.out <= 0.0);
        for k in 0..=AROUND {
            let (cosine, sine) = turn::cos_sin(2 * k + half, 2 * AROUND);
            let [out, up] = knot.normal;
            self.push(
                [knot.out * cosine, knot.out * sine, knot.along],
                [out * cosine, out * sine, up],
                [f64::from(2 * k + half) / f64::from(2 * AROUND), knot.v],
            );
        }
        first
    }

    /// Adds a flat disk at `along`, facing away from the centre.
    pub(super) fn disk(mut self, radius: f64, along: f64) -> Self {
        let up = along.signum();
        let first = u32::try_from(self.positions.len()).unwrap_or(u32::MAX);
        for k in 0..AROUND {
            let (cosine, sine) = turn::cos_sin(k, AROUND);
            self.push(
                [radius * cosine, radius * sine, along],
                [0.0, 0.0, up],
                [0.5 + 0.5 * up * cosine, 0.5 + 0.5 * sine],
            );
        }
        for k in 1..AROUND - 1 {
            let (b, c) = (first + k, first + k + 1);
            self.triangles
                .push(if up > 0.0 { [first, b, c] } else { [first, c, b] });
        }
        self
    }

    fn push(&mut self, position: [f64; 3], normal: [f64; 3], uv: [f64; 2]) {
        self.positions.push(narrow(self.axis.turn(position)));
        self.normals.push(narrow(self.axis.turn(normal)));
        self.uvs.push(narrow(uv));
    }

    pub(super) fn mesh(self) -> Mesh {
        if !self.exists {
            return Mesh::default();
        }
        Mesh {
            positions: self.positions,
            triangles: self.triangles,
            normals: Some(MeshAttribute::Vertex(self.normals)),
            uvs: Some(MeshAttribute::Vertex(self.uvs)),
            ..Mesh::default()
        }
    }
}
