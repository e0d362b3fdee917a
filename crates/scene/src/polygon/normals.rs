use oaktwin_camera::math::DVec3;

use super::attribute::Triangles;
use crate::MeshAttribute;

/// Normalizes the normals. A zero normal is replaced by the normal of the first triangle that uses it.
pub(super) fn unit(
    mut normals: MeshAttribute<[f32; 3]>,
    positions: &[[f32; 3]],
    triangles: &Triangles<'_>,
) -> Option<MeshAttribute<[f32; 3]>> {
    let normalize = |values: &mut [[f32; 3]]| {
        let mut all = true;
        for value in values {
            *value = unit_or_zero(DVec3::from(value.map(f64::from)));
            all &= *value != [0.0; 3];
        }
        all
    };
    let flat = |triangle: [u32; 3]| unit_or_zero(area(positions, triangle));
    match &mut normals {
        MeshAttribute::Constant(value) => {
            *value = unit_or_zero(DVec3::from(value.map(f64::from)));
            if *value == [0.0; 3] {
                return None;
            }
        }
        MeshAttribute::Triangle(values) => {
            if !normalize(values) {
                for (value, &triangle) in values.iter_mut().zip(triangles.vertices) {
                    if *value == [0.0; 3] {
                        *value = flat(triangle);
                    }
                }
            }
        }
        MeshAttribute::Vertex(values) => {
            if !normalize(values) {
                repair(values, triangles.vertices, &flat, triangles.vertices);
            }
        }
        MeshAttribute::Corner { values, indices } => {
            if !normalize(values) {
                repair(values, indices, &flat, triangles.vertices);
            }
        }
    }
    Some(normals)
}

fn repair(
    values: &mut [[f32; 3]],
    indices: &[[u32; 3]],
    flat: &dyn Fn([u32; 3]) -> [f32; 3],
    triangles: &[[u32; 3]],
) {
    for (picked, &triangle) in indices.iter().zip(triangles) {
        for &index in picked {
            if values[index as usize] == [0.0; 3] {
                values[index as usize] = flat(triangle);
            }
        }
    }
}

/// Computes smooth normals: at each vertex, the normals of its triangles, weighted by their angles.
pub(super) fn smooth(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> MeshAttribute<[f32; 3]> {
    let mut sums = vec![[0.0_f32; 3]; positions.len()];
    for &triangle in triangles {
        let [a, b, c] = triangle.map(|vertex| point(positions, vertex));
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let [ab, bc, ca] = [b - a, c - b, a - c].map(DVec3::normalize_or_zero);
        let weights = [angle(ab, -ca), angle(bc, -ab), angle(ca, -bc)];
        for (vertex, weight) in triangle.into_iter().zip(weights) {
            let sum = &mut sums[vertex as usize];
            for (sum, part) in sum.iter_mut().zip((weight * normal).to_array()) {
                *sum += narrow(part);
            }
        }
    }
    for sum in &mut sums {
        *sum = unit_or_zero(DVec3::from(sum.map(f64::from)));
    }
    // Where normals cancel out (a sheet folded onto itself), the first triangle's is used.
    let flat = |triangle: [u32; 3]| unit_or_zero(area(positions, triangle));
    repair(&mut sums, triangles, &flat, triangles);
    MeshAttribute::Vertex(sums)
}

/// The angle between two unit vectors within 1e-3 rad, computed identically on every machine.
fn angle(a: DVec3, b: DVec3) -> f64 {
    let full = a.dot(b).clamp(-1.0, 1.0);
    let (sine, cosine) = ((1.0 - full).sqrt(), (1.0 + full).sqrt());
    // Half the angle, as the arc tangent of a number from 0 to 1 or of its inverse.
    let arc_tangent = |x: f64| {
        let xx = x * x;
        x * (0.999_866 + xx * (-0.330_299_5 + xx * (0.180_141 + xx * (-0.085_133 + xx * 0.020_835_1))))
    };
    if sine <= cosine {
        2.0 * arc_tangent(sine / cosine.max(f64::MIN_POSITIVE))
    } else {
        std::f64::consts::PI - 2.0 * arc_tangent(cosine / sine)
    }
}

fn point(positions: &[[f32; 3]], vertex: u32) -> DVec3 {
    DVec3::from(positions[vertex as usize].map(f64::from))
}

/// The triangle's normal, with twice its area as length.
fn area(positions: &[[f32; 3]], triangle: [u32; 3]) -> DVec3 {
    let [a, b, c] = triangle.map(|vertex| point(positions, vertex));
    (b - a).cross(c - a)
}

fn unit_or_zero(v: DVec3) -> [f32; 3] {
    v.normalize_or_zero().to_array().map(narrow)
}

#[allow(clippy::cast_possible_truncation, reason = "unit vectors and sums of them")]
fn narrow(x: f64) -> f32 {
    x as f32
}
