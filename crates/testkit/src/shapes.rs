//! Large reproducible meshes.

use oaktwin_scene::Mesh;

/// Creates a grid of `columns × rows` squares of two triangles over `width × depth` metres around the origin; `height`
/// returns z at (x, y).
#[must_use]
#[expect(
    clippy::cast_possible_truncation,
    reason = "positions are float32, indices are u32"
)]
pub fn heightfield(
    [columns, rows]: [u32; 2],
    [width, depth]: [f64; 2],
    height: impl Fn(f64, f64) -> f64,
) -> Mesh {
    let place = |i: u32, count: u32, extent: f64| (f64::from(i) / f64::from(count) - 0.5) * extent;
    let mut positions = Vec::with_capacity((columns as usize + 1) * (rows as usize + 1));
    for j in 0..=rows {
        for i in 0..=columns {
            let (x, y) = (place(i, columns, width), place(j, rows, depth));
            positions.push([x as f32, y as f32, height(x, y) as f32]);
        }
    }
    let mut triangles = Vec::with_capacity(columns as usize * rows as usize * 2);
    let stride = columns + 1;
    for j in 0..rows {
        for i in 0..columns {
            let a = j * stride + i;
            let (b, c, d) = (a + 1, a + stride + 1, a + stride);
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    Mesh {
        positions,
        triangles,
        ..Mesh::default()
    }
}

/// Creates an icosahedron of radius 1 whose triangles are split into four `levels` times; each vertex is moved to the
/// radius that `radius` returns for its direction.
#[must_use]
#[expect(
    clippy::cast_possible_truncation,
    reason = "positions are float32, indices are u32"
)]
pub fn icosphere(levels: u32, radius: impl Fn([f64; 3]) -> f64) -> Mesh {
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let mut directions: Vec<[f64; 3]> = Vec::new();
    for (a, b) in [(1.0, golden), (1.0, -golden), (-1.0, golden), (-1.0, -golden)] {
        directions.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]].map(normalized));
    }
    // The faces are the triples of vertices that are pairwise one edge (length 2 before scaling) apart.
    let edge = 2.0 / (1.0 + golden * golden).sqrt();
    let near = |i: usize, j: usize| {
        let squared: f64 = (0..3)
            .map(|k| (directions[i][k] - directions[j][k]).powi(2))
            .sum();
        (squared.sqrt() - edge).abs() < 1e-6
    };
    let mut triangles = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if near(i, j) && near(j, k) && near(i, k) {
                    triangles.push(outward([i as u32, j as u32, k as u32], &directions));
                }
            }
        }
    }
    for _ in 0..levels {
        triangles = split(&triangles, &mut directions);
    }
    let positions = directions
        .iter()
        .map(|&d| d.map(|x| (x * radius(d)) as f32))
        .collect();
    Mesh {
        positions,
        triangles,
        ..Mesh::default()
    }
}

/// Splits each triangle into four with shared vertices.
#[expect(clippy::cast_possible_truncation, reason = "indices are u32")]
fn split(triangles: &[[u32; 3]], directions: &mut Vec<[f64; 3]>) -> Vec<[u32; 3]> {
    let mut middles = std::collections::BTreeMap::new();
    let mut middle = |a: u32, b: u32| {
        *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
            let (p, q) = (directions[a as usize], directions[b as usize]);
            directions.push(normalized([p[0] + q[0], p[1] + q[1], p[2] + q[2]]));
            directions.len() as u32 - 1
        })
    };
    let mut smaller = Vec::with_capacity(triangles.len() * 4);
    for &[a, b, c] in triangles {
        let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
        smaller.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    smaller
}

fn outward([a, b, c]: [u32; 3], directions: &[[f64; 3]]) -> [u32; 3] {
    let [p, q, r] = [a, b, c].map(|i| directions[i as usize]);
    let determinant = p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
        + p[2] * (q[0] * r[1] - q[1] * r[0]);
    if determinant > 0.0 { [a, b, c] } else { [a, c, b] }
}

fn normalized(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

/// Returns a hilly height within ±1, with detail down to about a thirtieth of a unit.
#[must_use]
pub fn hills(x: f64, y: f64) -> f64 {
    let mut sum = 0.0;
    let (mut frequency, mut amplitude) = (1.0, 0.5);
    for octave in 0..6 {
        let turn = f64::from(octave) * 1.3;
        let (u, v) = (x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos());
        sum += amplitude * (frequency * u + turn).sin() * (frequency * v * 0.9 - turn).sin();
        frequency *= 2.0;
        amplitude *= 0.5;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_icosphere_is_closed_and_faces_outward() {
        let sphere = icosphere(3, |_| 1.0);
        assert_eq!(sphere.triangles.len(), 20 * 64);
        assert_eq!(sphere.positions.len(), 10 * 64 + 2);
        // The enclosed volume is slightly less than a sphere's.
        let volume: f64 = (0..sphere.triangles.len())
            .map(|t| {
                let [a, b, c] = sphere.corners(t).unwrap().map(|p| p.map(f64::from));
                (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                    + a[2] * (b[0] * c[1] - b[1] * c[0]))
                    / 6.0
            })
            .sum();
        let ball = 4.0 / 3.0 * std::f64::consts::PI;
        assert!(volume < ball && volume > 0.97 * ball, "{volume}");
    }

    #[test]
    fn a_heightfield_faces_up() {
        let field = heightfield([3, 2], [6.0, 4.0], |x, _| x);
        assert_eq!(field.triangles.len(), 12);
        assert_eq!(field.positions[0], [-3.0, -2.0, -3.0]);
        assert_eq!(field.positions.last(), Some(&[3.0, 2.0, 3.0]));
        for t in 0..12 {
            let [a, b, c] = field.corners(t).unwrap();
            let up = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            assert!(up > 0.0);
        }
    }

    #[test]
    fn hills_stay_in_their_range() {
        for i in 0..1000 {
            assert!(hills(f64::from(i) * 0.37, f64::from(i) * -0.11).abs() <= 1.0);
        }
    }
}
