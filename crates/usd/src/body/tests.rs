use std::collections::{BTreeMap, BTreeSet};

use oaktwin_camera::math::{DMat3, DVec2, DVec3};
use oaktwin_camera::{PixelPoint, Usd};
use oaktwin_catalog::{Catalog, Role, Twin, TwinCamera};

use super::{BodyModel, BodyPart, body};

fn twins() -> Vec<Twin> {
    Catalog::builtin().nominals()
}

fn points(part: &BodyPart) -> Vec<DVec3> {
    part.points
        .iter()
        .map(|&[x, y, z]| DVec3::new(x.into(), y.into(), z.into()))
        .collect()
}

fn faces(part: &BodyPart) -> Vec<Vec<usize>> {
    let mut indices = part
        .face_vertex_indices
        .iter()
        .map(|&i| usize::try_from(i).unwrap());
    let faces: Vec<Vec<usize>> = part
        .face_vertex_counts
        .iter()
        .map(|&count| indices.by_ref().take(usize::try_from(count).unwrap()).collect())
        .collect();
    assert_eq!(indices.count(), 0, "{}: indices left over", part.name);
    faces
}

fn triangles(part: &BodyPart) -> Vec<[DVec3; 3]> {
    let points = points(part);
    let fan = |face: Vec<usize>| -> Vec<[DVec3; 3]> {
        face[1..]
            .windows(2)
            .map(|edge| [points[face[0]], points[edge[0]], points[edge[1]]])
            .collect()
    };
    faces(part).into_iter().flat_map(fan).collect()
}

fn bounds<'a>(parts: impl IntoIterator<Item = &'a BodyPart>) -> (DVec3, DVec3) {
    parts
        .into_iter()
        .flat_map(points)
        .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| {
            (low.min(point), high.max(point))
        })
}

fn volume(part: &BodyPart) -> f64 {
    triangles(part)
        .iter()
        .map(|[a, b, c]| a.dot(b.cross(*c)) / 6.0)
        .sum()
}

/// Asserts that a part is closed, consistently wound outward, without degenerate faces and with matching unit normals.
fn check(part: &BodyPart, at: &str) {
    let points = points(part);
    assert!(points.iter().all(|point| point.is_finite()), "{at}");
    let mut edges: BTreeMap<(usize, usize), u32> = BTreeMap::new();
    let mut used = BTreeSet::new();
    let mut corner = 0;
    assert_eq!(part.normals.len(), part.face_vertex_indices.len(), "{at}");
    for face in faces(part) {
        assert!((3..=4).contains(&face.len()), "{at}");
        assert_eq!(
            face.iter().collect::<BTreeSet<_>>().len(),
            face.len(),
            "{at}: a vertex twice"
        );
        let area = face[1..]
            .windows(2)
            .map(|edge| (points[edge[0]] - points[face[0]]).cross(points[edge[1]] - points[face[0]]))
            .sum::<DVec3>();
        assert!(
            area.length() > 1e-11,
            "{at}: a face of {} m²",
            area.length() / 2.0
        );
        for (i, &vertex) in face.iter().enumerate() {
            used.insert(vertex);
            *edges.entry((vertex, face[(i + 1) % face.len()])).or_default() += 1;
            let normal = DVec3::from(part.normals[corner].map(f64::from));
            assert!(
                (normal.length() - 1.0).abs() < 2e-4,
                "{at}: a normal of {}",
                normal.length()
            );
            assert!(normal.dot(area.normalize()) > 0.75, "{at}: a normal off its face");
            corner += 1;
        }
    }
    for (&(a, b), &count) in &edges {
        assert_eq!(
            count, 1,
            "{at}: the edge {a}-{b} is used more than once in one direction"
        );
        assert!(edges.contains_key(&(b, a)), "{at}: the edge {a}-{b} is open");
    }
    assert_eq!(used.len(), points.len(), "{at}: unused vertices");
    assert!(volume(part) > 0.0, "{at}: inside out");
}

#[test]
fn every_part_is_a_closed_solid() {
    for twin in twins() {
        let model = body(&twin);
        for part in model.parts.iter().chain([&model.collider]) {
            check(part, &format!("{} {}", twin.device.id, part.name));
        }
    }
}

/// Calibrated units and user-defined devices differ from the nominal models.
#[test]
fn unusual_twins_have_closed_solids() {
    for nominal in twins() {
        for (scale, shift_mm, turn) in [
            (1.0, 1.3, 0.05),
            (0.5, 0.0, 0.0),
            (1.7, -2.0, -0.2),
            (1.0, 7.0, 3.0),
            (1.0, -9.0, 0.6),
            (1.0, 80.0, 1.4),
        ] {
            let mut twin = nominal.clone();
            for size in &mut twin.device.body.dimensions_mm {
                *size *= scale;
            }
            for (i, camera) in twin.cameras.iter_mut().enumerate() {
                let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
                camera.body_from_camera.translation += DVec3::new(0.4, sign, 0.7) * shift_mm / 1e3;
                let turn = DMat3::from_rotation_z(sign * turn) * DMat3::from_rotation_y(turn / 2.0);
                camera.body_from_camera.rotation = turn * camera.body_from_camera.rotation;
            }
            for part in body(&twin).parts {
                check(
                    &part,
                    &format!("{} {scale} {shift_mm} {turn}: {}", twin.device.id, part.name),
                );
            }
        }
        let blind = Twin {
            cameras: Vec::new(),
            ..nominal
        };
        assert!(body(&blind).parts.iter().any(|part| part.name == "front_glass"));
    }
}

#[test]
fn outer_dimensions_match_the_catalog() {
    for twin in twins() {
        let model = body(&twin);
        let [width, height, depth] = twin.device.body.dimensions_mm;
        let front = DVec3::from_array(twin.device.body.front_mm) / 1e3;
        let size = DVec3::new(depth, width, height) / 1e3;
        let high = front + DVec3::new(0.0, size.y, size.z) / 2.0;
        for (low_found, high_found) in [bounds(&model.parts), bounds([&model.collider])] {
            assert!(
                high_found.abs_diff_eq(high, 1e-6),
                "{}: {high_found} {high}",
                twin.device.id
            );
            assert!(
                low_found.abs_diff_eq(high - size, 1e-6),
                "{}: {low_found}",
                twin.device.id
            );
        }
    }
}

#[test]
fn names_and_materials_are_consistent() {
    for twin in twins() {
        let BodyModel {
            parts,
            materials,
            collider,
        } = body(&twin);
        let names: BTreeSet<&str> = parts.iter().map(|part| part.name.as_str()).collect();
        assert_eq!(names.len(), parts.len());
        assert!(
            names
                .iter()
                .all(|name| name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'))
        );
        let used: BTreeSet<&str> = parts.iter().map(|part| part.material).collect();
        assert_eq!(
            used.into_iter().collect::<Vec<_>>(),
            materials.iter().map(|m| m.name).collect::<Vec<_>>()
        );
        let triangles = parts.iter().map(|part| triangles(part).len()).sum::<usize>();
        println!("{}: {} parts, {triangles} triangles", twin.device.id, parts.len());
        assert!(triangles < 20_000, "{}: {triangles} triangles", twin.device.id);
        assert!(collider.face_vertex_indices.len() <= 64);
        for camera in &twin.cameras {
            let role = format!("{:?}", camera.spec.role).to_lowercase();
            assert!(
                names.contains(format!("lens_{role}").as_str()),
                "{}: no lens_{role}",
                twin.device.id
            );
        }
        assert_eq!(
            names.contains("dot_projector"),
            twin.device.body.projector_mm.is_some()
        );
        assert_eq!(names.contains("tof_emitter"), twin.camera(Role::Tof).is_some());
    }
}

#[test]
fn the_collider_is_convex() {
    for twin in twins() {
        let collider = body(&twin).collider;
        let points = points(&collider);
        for [a, b, c] in triangles(&collider) {
            let normal = (b - a).cross(c - a).normalize();
            assert!(
                points.iter().all(|point| normal.dot(*point - a) < 2e-6),
                "{}",
                twin.device.id
            );
        }
    }
}

/// Returns the distances along a ray to the triangles that it hits.
fn hits<'a>(triangles: &'a [[DVec3; 3]], origin: DVec3, direction: DVec3) -> impl Iterator<Item = f64> + 'a {
    // Möller and Trumbore 1997.
    triangles.iter().filter_map(move |&[a, b, c]| {
        let (ab, ac) = (b - a, c - a);
        let p = direction.cross(ac);
        let determinant = ab.dot(p);
        if determinant.abs() < 1e-18 {
            return None;
        }
        let s = origin - a;
        let q = s.cross(ab);
        let (u, v) = (s.dot(p) / determinant, direction.dot(q) / determinant);
        let t = ac.dot(q) / determinant;
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0).then_some(t)
    })
}

/// Returns the pixels at which a camera's pinhole sees the body, with z of the hit in the camera frame, in metres.
fn seen_body(twin: &Twin, camera: &TwinCamera) -> Vec<(DVec2, f64)> {
    let all: Vec<[DVec3; 3]> = body(twin).parts.iter().flat_map(triangles).collect();
    let size = camera.intrinsics.size;
    let mut seen = Vec::new();
    for row in 0..=10 {
        for column in 0..=16 {
            let share = DVec2::new(f64::from(column) / 16.0, f64::from(row) / 10.0);
            let pixel = share * DVec2::new(size.width.into(), size.height.into());
            let pinhole = camera
                .intrinsics
                .normalized_from_pixel(PixelPoint::<Usd>::new(pixel.x, pixel.y));
            let ray = camera.body_from_camera.rotation * pinhole.extend(1.0);
            // The ray's z is 1 in the camera frame, so its parameter is z.
            let found = hits(&all, camera.body_from_camera.translation, ray);
            seen.extend(found.map(|z| (pixel, z)));
        }
    }
    seen
}

#[test]
fn no_camera_sees_its_own_body() {
    for twin in twins() {
        for camera in &twin.cameras {
            let seen = seen_body(&twin, camera);
            assert!(
                seen.is_empty(),
                "{} {:?}: {:?}",
                twin.device.id,
                camera.spec.role,
                &seen[..1]
            );
        }
    }
}

/// Overlapping triangles would include some with reversed winding.
#[test]
fn glass_triangles_do_not_overlap() {
    for twin in twins() {
        let model = body(&twin);
        let glass = model
            .parts
            .iter()
            .find(|part| part.name == "front_glass")
            .unwrap();
        let (low, high) = bounds([glass]);
        for (x, sign) in [(low.x, -1.0), (high.x, 1.0)] {
            let on_face = |triangle: &&[DVec3; 3]| triangle.iter().all(|p| (p.x - x).abs() < 1e-7);
            let all = triangles(glass);
            let turned: Vec<f64> = all
                .iter()
                .filter(on_face)
                .map(|[a, b, c]| sign * (b - a).cross(c - a).x)
                .collect();
            let openings = model
                .parts
                .iter()
                .filter(|part| part.name.starts_with("bezel_"))
                .count();
            assert!(
                openings > 0 && turned.len() > 30 * openings,
                "{}: {openings}",
                twin.device.id
            );
            assert!(
                turned.iter().all(|area| *area > 0.0),
                "{}: a turned triangle",
                twin.device.id
            );
        }
    }
}

#[test]
fn bodies_are_deterministic() {
    for twin in twins() {
        assert_eq!(body(&twin), body(&twin));
    }
}
