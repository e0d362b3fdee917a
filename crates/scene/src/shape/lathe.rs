//! Outlines turned round an axis.

use super::{AROUND, Axis, are_sizes, narrow};
use crate::{Attribute, Mesh, turn};

/// A corner of an outline: distances from the axis and along it.
struct Stop {
    out: f64,
    along: f64,
    /// The surface's direction there, of unit length.
    normal: [f64; 2],
    v: f64,
}

/// What is turned, from the bottom to the top, the surface on its right.
#[derive(Default)]
pub(super) struct Outline {
    stops: Vec<Stop>,
}

impl Outline {
    /// From one quarter of a circle to another: −1 is the pole at the bottom, 0 the equator, 1 the pole at the top.
    pub(super) fn arc(&mut self, from: i8, to: i8, radius: f64, center: f64, [v0, v1]: [f64; 2]) {
        let steps = u32::from(to.abs_diff(from)) * AROUND / 4;
        for step in 0..=steps {
            // A turn ahead: there are no negative parts.
            let part = if from < 0 { 3 * AROUND / 4 + step } else { step };
            let (cosine, sine) = turn::cos_sin(part, AROUND);
            self.push(Stop {
                out: radius * cosine,
                along: center + radius * sine,
                normal: [cosine, sine],
                v: v0 + (v1 - v0) * f64::from(step) / f64::from(steps),
            });
        }
    }

    /// Where one piece goes on smoothly from another there is no band between them.
    fn push(&mut self, stop: Stop) {
        let is_last = |last: &Stop| (last.out, last.along) == (stop.out, stop.along);
        if !self.stops.last().is_some_and(is_last) {
            self.stops.push(stop);
        }
    }

    pub(super) fn line(&mut self, from: [f64; 2], to: [f64; 2], [v0, v1]: [f64; 2]) {
        let [out, along] = [to[0] - from[0], to[1] - from[1]];
        let length = (out * out + along * along).sqrt();
        let normal = [along / length, -out / length];
        for ([out, along], v) in [(from, v0), (to, v1)] {
            self.push(Stop {
                out,
                along,
                normal,
                v,
            });
        }
    }
}

/// A body that is turned piece by piece.
pub(super) struct Turned {
    axis: Axis,
    exists: bool,
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl Turned {
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

    /// The outline's surface; u goes round.
    pub(super) fn surface(mut self, outline: &Outline) -> Self {
        let mut below: Option<(&Stop, u32)> = None;
        for stop in &outline.stops {
            let first = self.ring(stop);
            if let Some((lower, lower_first)) = below {
                for k in 0..AROUND {
                    let (a, b) = (lower_first + k, lower_first + k + 1);
                    let (d, c) = (first + k, first + k + 1);
                    if lower.out > 0.0 {
                        self.triangles.push([a, b, if stop.out > 0.0 { c } else { d }]);
                    }
                    if stop.out > 0.0 {
                        self.triangles.push([a, c, d]);
                    }
                }
            }
            below = Some((stop, first));
        }
        self
    }

    /// A circle's corners, the first once more at the end; a pole is there once for each triangle at it, half-way
    /// between that triangle's other corners.
    fn ring(&mut self, stop: &Stop) -> u32 {
        let first = u32::try_from(self.positions.len()).unwrap_or(u32::MAX);
        let half = u32::from(stop.out <= 0.0);
        for k in 0..=AROUND {
            let (cosine, sine) = turn::cos_sin(2 * k + half, 2 * AROUND);
            let [out, up] = stop.normal;
            self.push(
                [stop.out * cosine, stop.out * sine, stop.along],
                [out * cosine, out * sine, up],
                [f64::from(2 * k + half) / f64::from(2 * AROUND), stop.v],
            );
        }
        first
    }

    /// A flat lid or floor at `along`, which looks away from the middle.
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
            normals: Some(Attribute::Vertex(self.normals)),
            uvs: Some(Attribute::Vertex(self.uvs)),
            ..Mesh::default()
        }
    }
}
