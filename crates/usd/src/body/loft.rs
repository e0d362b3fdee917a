use oaktwin_camera::math::{DVec2, DVec3};

use super::mesh::Mesh;
use super::outline::Outline;

/// Right-handed axes: outlines are drawn in (u, v) and swept along w.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    origin: DVec3,
    u: DVec3,
    v: DVec3,
    w: DVec3,
}

impl Frame {
    /// Towards the front: (u, v, w) is (y, z, x).
    pub(super) const FORWARD: Self = Self {
        origin: DVec3::ZERO,
        u: DVec3::Y,
        v: DVec3::Z,
        w: DVec3::X,
    };

    /// Towards the back from a place: (u, v, w) is (-y, z, -x).
    pub(super) const fn backward(origin: DVec3) -> Self {
        Self {
            origin,
            u: DVec3::NEG_Y,
            v: DVec3::Z,
            w: DVec3::NEG_X,
        }
    }

    /// Towards the left from a place: (u, v, w) is (z, x, y).
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

/// How a loft ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum End {
    /// With its outline, filled.
    Flat,
    /// In a point on the axis at this w.
    Pole(f64),
    /// At its own beginning: a ring.
    Closed,
}

/// Joins outlines of one count, in order. Outside is on the right hand of the path seen with the axis to its left:
/// along +w the surface faces outward, along -w inward (the wall of a pocket).
pub(super) fn loft(frame: Frame, stations: &[(f64, Outline)], start: End, end: End) -> Mesh {
    let mut mesh = Mesh::default();
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

fn cap(mesh: &mut Mesh, frame: Frame, outline: &[DVec2], first: usize, end: End, reversed: bool) {
    let count = outline.len();
    match end {
        End::Flat => {
            // Strips between mirrored points: no fans, no slivers at a centre.
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
