use oaktwin_camera::math::{DVec2, DVec3};

use super::mesh::BodyMesh;
use super::outline::Outline;

/// A right-handed frame: outlines lie in (u, v) and are swept along w.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoftFrame {
    origin: DVec3,
    u: DVec3,
    v: DVec3,
    w: DVec3,
}

impl LoftFrame {
    /// The frame that points forward: (u, v, w) is (y, z, x).
    pub(super) const FORWARD: Self = Self {
        origin: DVec3::ZERO,
        u: DVec3::Y,
        v: DVec3::Z,
        w: DVec3::X,
    };

    /// Returns the frame at `origin` that points backward: (u, v, w) is (-y, z, -x).
    pub(super) const fn backward(origin: DVec3) -> Self {
        Self {
            origin,
            u: DVec3::NEG_Y,
            v: DVec3::Z,
            w: DVec3::NEG_X,
        }
    }

    /// Returns the frame at `origin` that points left: (u, v, w) is (z, x, y).
    pub(super) const fn left(origin: DVec3) -> Self {
        Self {
            origin,
            u: DVec3::Z,
            v: DVec3::X,
            w: DVec3::Y,
        }
    }

    pub(super) fn point(&self, uv: DVec2, w: f64) -> DVec3 {
        self.origin + self.u * uv.x + self.v * uv.y + self.w * w
    }
}

/// The shape of an end of a loft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum End {
    /// The filled outline.
    Flat,
    /// A point on the axis at this w.
    Pole(f64),
    /// No end: the loft is a ring that closes on itself.
    Closed,
}

/// Joins outlines of equal length, in order. Along +w the surface faces outward, along -w inward (the wall of a
/// pocket).
pub(super) fn loft(frame: LoftFrame, stations: &[(f64, Outline)], start: End, end: End) -> BodyMesh {
    let mut mesh = BodyMesh::default();
    let Some(count) = stations.first().map(|(_, outline)| outline.len()) else {
        return mesh;
    };
    for (w, outline) in stations {
        mesh.points.extend(outline.iter().map(|&uv| frame.point(uv, *w)));
    }
    let last = stations.len() - 1;
    let closed = end == End::Closed;
    for station in 0..if closed { stations.len() } else { last } {
        let (near, far) = (
            station * count,
            if station == last { 0 } else { (station + 1) * count },
        );
        for i in 0..count {
            let j = (i + 1) % count;
            mesh.quad(near + i, near + j, far + j, far + i);
        }
    }
    if !closed {
        cap(&mut mesh, frame, &stations[0].1, 0, start, true);
        cap(&mut mesh, frame, &stations[last].1, last * count, end, false);
    }
    mesh
}

fn cap(mesh: &mut BodyMesh, frame: LoftFrame, outline: &[DVec2], first: usize, end: End, reversed: bool) {
    let count = outline.len();
    match end {
        End::Flat => {
            // Strips between mirrored points avoid fans with slivers at a centre.
            for i in 0..count / 2 - 1 {
                let [a, b, c, d] = [i, i + 1, count - 2 - i, count - 1 - i].map(|k| first + k);
                if reversed {
                    mesh.quad(d, c, b, a);
                } else {
                    mesh.quad(a, b, c, d);
                }
            }
        }
        End::Pole(w) => {
            let centre = outline.iter().sum::<DVec2>() / super::outline::fraction(count, 1);
            let pole = mesh.points.len();
            mesh.points.push(frame.point(centre, w));
            for i in 0..count {
                let (a, b) = (first + i, first + (i + 1) % count);
                if reversed {
                    mesh.triangle(pole, b, a);
                } else {
                    mesh.triangle(pole, a, b);
                }
            }
        }
        End::Closed => {}
    }
}
