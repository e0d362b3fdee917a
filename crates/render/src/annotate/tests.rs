#![allow(clippy::cast_possible_truncation, reason = "coordinates are float32")]

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_camera::{PixelPoint, Usd};
use oaktwin_image::annotation::{Annotator, Box2d, Frame};
use oaktwin_scene::{Mesh, MeshAttribute, MetersPerUnit, Scene};
use proptest::prelude::*;

use super::AnnotateOptions;
use crate::fixture::{cube, fisheye, look_at, placed, placed_at, rectangle, view};
use crate::{Backend, Renderer, View};

fn annotate(scene: &Scene, view: &View) -> Frame {
    let all: Vec<_> = Annotator::all()
        .filter(|annotator| *annotator != Annotator::Rgb)
        .collect();
    let renderer = Renderer::new(scene.clone());
    let (frame, findings) = renderer.annotate(view, &all, Backend::Auto, &AnnotateOptions::default());
    assert_eq!(findings, []);
    frame
}

fn ray(view: &View, x: u32, y: u32) -> DVec3 {
    let centre = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
    view.camera.unproject(centre).unwrap()
}

fn normal_at(frame: &Frame, x: u32, y: u32) -> DVec3 {
    let normal = *frame.normals.as_ref().unwrap().get(x, y).unwrap();
    DVec3::from(normal.map(f64::from))
}

#[test]
fn only_requested_annotators_are_rendered() {
    let mut scene = Scene::default();
    placed(&mut scene, "/Wall", rectangle([-9.0, 9.0], [-9.0, 9.0], 2.0));
    let renderer = Renderer::new(scene);
    let ask = |annotators: &[Annotator]| {
        let options = AnnotateOptions::default();
        renderer.annotate(&view(), annotators, Backend::Auto, &options).0
    };
    assert_eq!(ask(&[]), Frame::default());
    assert_eq!(ask(&[Annotator::CameraParams]), Frame::default());
    let z = ask(&[Annotator::DistanceToImagePlane]);
    assert!(z.distance_to_image_plane.is_some() && z.distance_to_camera.is_none());
    let range = ask(&[Annotator::DistanceToCamera]);
    assert!(range.distance_to_image_plane.is_none() && range.distance_to_camera.is_some());
    // The result does not depend on the other annotators.
    let both = ask(&[
        Annotator::DistanceToCamera,
        Annotator::DistanceToImagePlane,
        Annotator::Normals,
    ]);
    assert_eq!(both.distance_to_image_plane, z.distance_to_image_plane);
    assert_eq!(both.distance_to_camera, range.distance_to_camera);
    assert!(both.normals.is_some() && both.pointcloud.is_none());
}

#[test]
fn range_is_depth_times_the_length_of_the_ray() {
    let mut scene = Scene::default();
    placed(&mut scene, "/Wall", rectangle([-1.0, 9.0], [-9.0, 9.0], 2.0));
    let frame = annotate(&scene, &view());
    let z = frame.distance_to_image_plane.unwrap().0;
    let range = frame.distance_to_camera.unwrap().0;
    for (x, y) in [(60, 0), (100, 80), (199, 159), (130, 7)] {
        assert_eq!(z.get(x, y), Some(&2.0));
        let expected = 2.0 / ray(&view(), x, y).z;
        assert_eq!(f64::from(*range.get(x, y).unwrap()), f64::from(expected as f32));
    }
    assert_eq!(z.get(10, 80), Some(&f32::INFINITY));
    assert_eq!(range.get(10, 80), Some(&f32::INFINITY));
}

#[test]
fn a_fisheye_measures_surfaces_beside_and_behind_it() {
    // A wall parallel to the optical axis, visible sideways and backwards.
    let mut scene = Scene::default();
    let wall = rectangle([-3.0, 3.0], [-3.0, 3.0], 0.0);
    let turned = DAffine3::from_rotation_y(-std::f64::consts::FRAC_PI_2);
    let aside = DAffine3::from_translation(DVec3::new(0.8, 0.0, 0.0)) * turned;
    placed_at(&mut scene, "/Wall", wall, aside, &[]);
    let mut view = fisheye();
    // Half the width of the image is 2 rad.
    view.camera.intrinsics.fx = 50.0;
    view.camera.intrinsics.fy = 50.0;
    let frame = annotate(&scene, &view);
    let range = frame.distance_to_camera.unwrap().0;
    let mut behind = 0;
    for x in 120..195 {
        let ray = ray(&view, x, 80);
        let point = ray * (0.8 / ray.x);
        if point.z.abs() < 2.9 {
            let expected = point.length();
            let got = f64::from(*range.get(x, 80).unwrap());
            assert!((got - expected).abs() < 1e-6 * expected, "{x}: {got} {expected}");
            let normal = normal_at_row(&frame.normals, x, 80);
            assert!((normal - DVec3::NEG_X).length() < 1e-6);
            behind += u32::from(point.z < 0.0);
        }
    }
    assert!(behind > 10);
}

fn normal_at_row(normals: &Option<oaktwin_image::Image<[f32; 3]>>, x: u32, y: u32) -> DVec3 {
    DVec3::from(normals.as_ref().unwrap().get(x, y).unwrap().map(f64::from))
}

/// A ball of radius 1, with or without normals.
fn ball(smooth: bool) -> Mesh {
    let (rings, sectors) = (24u32, 48u32);
    let mut mesh = Mesh::default();
    for i in 0..=rings {
        for j in 0..=sectors {
            let polar = std::f64::consts::PI * f64::from(i) / f64::from(rings);
            let azimuth = std::f64::consts::TAU * f64::from(j) / f64::from(sectors);
            let point = DVec3::new(
                polar.sin() * azimuth.cos(),
                polar.sin() * azimuth.sin(),
                polar.cos(),
            );
            mesh.positions.push(point.to_array().map(|p| p as f32));
        }
    }
    for i in 0..rings {
        for j in 0..sectors {
            let at = |i, j| i * (sectors + 1) + j;
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh.normals = smooth.then(|| MeshAttribute::Vertex(mesh.positions.clone()));
    mesh
}

#[test]
fn normals_of_a_transformed_ball() {
    // Non-uniform scaling transforms normals unlike points; mirroring reverses the winding.
    for mirror in [1.0, -1.0] {
        for (smooth, tolerance) in [(true, 0.02), (false, 0.25)] {
            let mut scene = Scene::default();
            let half_axes = DVec3::new(1.5 * mirror, 1.0, 0.5);
            let centre = DVec3::new(0.2, -0.1, 4.0);
            let turn = DAffine3::from_rotation_x(0.4) * DAffine3::from_rotation_y(0.3);
            let world_from_mesh = DAffine3::from_translation(centre) * turn * DAffine3::from_scale(half_axes);
            placed_at(&mut scene, "/Ball", ball(smooth), world_from_mesh, &[]);
            let frame = annotate(&scene, &view());
            let mut checked = 0;
            for x in (0..200).step_by(7) {
                for y in (0..160).step_by(7) {
                    let z = *frame
                        .distance_to_image_plane
                        .as_ref()
                        .unwrap()
                        .0
                        .get(x, y)
                        .unwrap();
                    if z.is_infinite() {
                        assert_eq!(normal_at(&frame, x, y), DVec3::ZERO);
                        continue;
                    }
                    let ray = ray(&view(), x, y);
                    let point = turn
                        .inverse()
                        .transform_vector3(ray * (f64::from(z) / ray.z) - centre);
                    let expected = turn
                        .transform_vector3(point / (half_axes * half_axes))
                        .normalize();
                    let got = normal_at(&frame, x, y);
                    assert!((got.length() - 1.0).abs() < 1e-6);
                    // Near the outline the true normal varies strongly within a triangle.
                    if expected.dot(ray) < -0.2 {
                        assert!((got - expected).length() < tolerance, "{got} {expected}");
                        checked += 1;
                    }
                }
            }
            assert!(checked > 50);
        }
    }
}

#[test]
fn normals_inside_a_box_face_the_camera() {
    let mut scene = Scene::default();
    placed(&mut scene, "/Room", cube());
    let frame = annotate(&scene, &view());
    assert!((normal_at(&frame, 100, 80) - DVec3::NEG_Z).length() < 1e-6);
    assert!((normal_at(&frame, 0, 80) - DVec3::NEG_Z).length() < 1e-6);
    let turned = look_at(view(), DVec3::ZERO, DVec3::X);
    assert!((normal_at(&annotate(&scene, &turned), 100, 80) - DVec3::NEG_X).length() < 1e-6);
}

fn pixels(found: &Box2d) -> [i32; 4] {
    [found.x_min, found.x_max, found.y_min, found.y_max]
}

#[test]
fn tight_boxes_bound_visible_pixels_and_loose_boxes_all_pixels() {
    let mut scene = Scene::default();
    let label = |prim, name| [[prim, "class", name]];
    let here = DAffine3::IDENTITY;
    // 100 px · 0.5 m / 2 m = 25 px each side of the centre.
    let square = rectangle([-0.5, 0.5], [-0.5, 0.5], 2.0);
    placed_at(&mut scene, "/Square", square, here, &label("/Square", "square"));
    // A cover in front of the left half of the square.
    let cover = rectangle([-0.5, 0.0], [-0.5, 0.5], 1.0);
    placed(&mut scene, "/Cover", cover);
    // A square completely behind the cover.
    let hidden = rectangle([-0.8, -0.4], [-0.4, 0.4], 2.5);
    placed_at(&mut scene, "/Hidden", hidden, here, &label("/Hidden", "hidden"));
    // A floor that extends beyond the image and behind the camera.
    let floor = Mesh {
        positions: vec![
            [-50.0, 0.7, -9.0],
            [50.0, 0.7, -9.0],
            [50.0, 0.7, 100.0],
            [-50.0, 0.7, 100.0],
        ],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    };
    placed_at(&mut scene, "/Floor", floor, here, &label("/Floor", "floor"));
    let outside = rectangle([5.0, 6.0], [0.0, 1.0], 2.0);
    placed_at(
        &mut scene,
        "/Outside",
        outside,
        here,
        &label("/Outside", "square"),
    );

    let frame = annotate(&scene, &view());
    let tight = frame.bounding_box_2d_tight.unwrap();
    let loose = frame.bounding_box_2d_loose.unwrap();
    assert_eq!(tight.prim_paths, ["/Square", "/Floor"]);
    assert_eq!(loose.prim_paths, ["/Square", "/Hidden", "/Floor"]);
    assert_eq!(pixels(&loose.boxes[0]), [75, 124, 55, 104]);
    assert_eq!(pixels(&tight.boxes[0]), [100, 124, 55, 104]);
    assert_eq!(tight.boxes[0].occlusion_ratio, 0.5);
    assert_eq!(loose.boxes[0].occlusion_ratio, 0.5);
    assert_eq!(loose.boxes[1].occlusion_ratio, 1.0);
    // -0.8 m · 100 px / 2.5 m = -32 px, -0.4 m is -16 px.
    assert_eq!(pixels(&loose.boxes[1]), [68, 83, 64, 95]);
    // The horizon is at 0.7 px below the centre, row 80.
    assert_eq!(pixels(&loose.boxes[2]), [0, 199, 81, 159]);
    // Ids are in the order of the labels: floor, hidden, square.
    let ids: Vec<u32> = loose.boxes.iter().map(|found| found.semantic_id).collect();
    assert_eq!(ids, [4, 3, 2]);
    assert_eq!(loose.labels[&3]["class"], "hidden");
    assert_eq!(tight.labels.keys().copied().collect::<Vec<_>>(), [2, 4]);
}

#[test]
fn labels_are_inherited_and_labelled_prims_have_boxes() {
    let mut scene = Scene::default();
    let table = ["/Table", "class", "table"];
    let old = ["/Table", "age", "old"];
    let oak = ["/Table/Leg", "class", "oak"];
    let leg = ["/Table/Leg", "class", "leg"];
    let at = DAffine3::from_translation;
    let square = || rectangle([-0.1, 0.1], [-0.1, 0.1], 1.0);
    let here = DAffine3::IDENTITY;
    placed_at(&mut scene, "/Table/Top", square(), here, &[table, old]);
    let right = at(DVec3::new(0.5, 0.0, 0.0));
    placed_at(&mut scene, "/Table/Leg", square(), right, &[oak, leg, table, old]);
    let below = at(DVec3::new(0.0, 0.5, 0.0));
    placed_at(&mut scene, "/Stone", square(), below, &[]);
    let frame = annotate(&scene, &view());
    let semantic = frame.semantic_segmentation.unwrap();
    let ids = [(100, 80), (150, 80), (100, 130), (0, 0)].map(|(x, y)| *semantic.ids.get(x, y).unwrap());
    assert_eq!(ids, [3, 2, 1, 0]);
    let text = |id: u32| format!("{:?}", semantic.labels[&id]);
    assert_eq!(text(0), r#"{"class": "BACKGROUND"}"#);
    assert_eq!(text(1), r#"{"class": "UNLABELLED"}"#);
    assert_eq!(text(2), r#"{"age": "old", "class": "leg,oak,table"}"#);
    assert_eq!(text(3), r#"{"age": "old", "class": "table"}"#);
    let tight = frame.bounding_box_2d_tight.unwrap();
    assert_eq!(tight.prim_paths, ["/Table", "/Table/Leg"]);
    assert_eq!(pixels(&tight.boxes[0]), [90, 159, 70, 89]);
    assert_eq!(pixels(&tight.boxes[1]), [140, 159, 70, 89]);
    assert_eq!(
        tight.boxes.iter().map(|b| b.semantic_id).collect::<Vec<_>>(),
        [3, 2]
    );
    let instances = frame.instance_id_segmentation.unwrap();
    let ids = [(100, 80), (150, 80), (100, 130), (0, 0)].map(|(x, y)| *instances.ids.get(x, y).unwrap());
    assert_eq!(ids, [1, 2, 3, 0]);
    assert_eq!(instances.prim_paths[&3], "/Stone");
    assert_eq!(instances.prim_paths.len(), 3);
}

#[test]
fn ids_are_the_same_in_every_view() {
    let mut scene = Scene::default();
    for (x, name) in [(-3.0, "pear"), (0.0, "apple"), (3.0, "fig")] {
        let path = format!("/{name}");
        let place = DAffine3::from_translation(DVec3::new(x, 0.0, 5.0));
        placed_at(&mut scene, &path, cube(), place, &[[&path, "class", name]]);
    }
    let all = annotate(&scene, &view());
    let one = annotate(
        &scene,
        &look_at(view(), DVec3::new(4.0, 0.5, 2.5), DVec3::new(4.0, 0.0, 5.0)),
    );
    let (all_ids, one_ids) = (
        all.instance_id_segmentation.unwrap(),
        one.instance_id_segmentation.unwrap(),
    );
    assert_eq!(all_ids.prim_paths.len(), 3);
    assert_eq!(
        one_ids.prim_paths.into_iter().collect::<Vec<_>>(),
        [(3, "/fig".to_owned())]
    );
    assert_eq!(all_ids.prim_paths[&3], "/fig");
    let (all, one) = (
        all.semantic_segmentation.unwrap(),
        one.semantic_segmentation.unwrap(),
    );
    for (id, labels) in &one.labels {
        assert_eq!(all.labels.get(id), Some(labels));
    }
    assert_eq!(all.labels[&3]["class"], "fig");
}

#[test]
fn points_are_in_scene_units_without_misses() {
    let mut scene = Scene {
        meters_per_unit: MetersPerUnit(0.01),
        ..Scene::default()
    };
    let label = [["/Wall", "class", "wall"]];
    let here = DAffine3::IDENTITY;
    placed_at(
        &mut scene,
        "/Wall",
        rectangle([0.0, 9.0], [-9.0, 9.0], 2.0),
        here,
        &label,
    );
    placed(&mut scene, "/Rest", rectangle([-1.0, 0.0], [-9.0, 9.0], 2.0));
    for view in [view(), fisheye()] {
        let view = look_at(view, DVec3::new(0.1, 0.2, 0.3), DVec3::new(0.0, 0.0, 2.0));
        let frame = annotate(&scene, &view);
        let z = frame.distance_to_image_plane.unwrap().0;
        let cloud = frame.pointcloud.unwrap();
        let seen = z.pixels().iter().filter(|z| z.is_finite()).count();
        assert!(seen > 10_000 && seen < z.pixels().len());
        assert_eq!(
            [cloud.points.len(), cloud.semantic.len(), cloud.rgb.len()],
            [seen, seen, 0]
        );
        for (point, normal) in cloud.points.iter().zip(&cloud.normals) {
            assert!((point[2] - 200.0).abs() < 1e-4);
            assert!((DVec3::from(normal.map(f64::from)) + DVec3::Z).length() < 1e-6);
        }
        for ((point, semantic), instance) in cloud.points.iter().zip(&cloud.semantic).zip(&cloud.instance) {
            let expected = if point[0] > 0.0 { (2, 1) } else { (1, 2) };
            assert!((*semantic, *instance) == expected || point[0].abs() < 1e-3);
        }
        let labelled = AnnotateOptions {
            unlabelled_points: false,
            ..AnnotateOptions::default()
        };
        let renderer = Renderer::new(scene.clone());
        let (frame, _) = renderer.annotate(&view, &[Annotator::Pointcloud], Backend::Auto, &labelled);
        let cloud = frame.pointcloud.unwrap();
        assert!(cloud.points.len() < seen && cloud.semantic.iter().all(|id| *id == 2));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn a_single_entity_has_equal_tight_and_loose_boxes(
        corners in prop::collection::vec(prop::array::uniform3(-3.0..3.0f32), 9),
        wide in any::<bool>(),
    ) {
        let mesh = Mesh {
            positions: corners,
            triangles: vec![[0, 1, 2], [3, 4, 5], [6, 7, 8]],
            ..Mesh::default()
        };
        let mut scene = Scene::default();
        placed_at(&mut scene, "/It", mesh, DAffine3::IDENTITY, &[["/It", "class", "it"]]);
        let mut view = if wide { fisheye() } else { view() };
        view.clip.near_m = 0.4;
        view.clip.far_m = 3.0;
        if wide {
            view.camera.intrinsics.fx = 50.0;
            view.camera.intrinsics.fy = 50.0;
        }
        let frame = annotate(&scene, &view);
        let tight = frame.bounding_box_2d_tight.unwrap().boxes;
        let loose = frame.bounding_box_2d_loose.unwrap().boxes;
        // Rounding decides whether a pixel is visible whose centre lies on an edge.
        for (tight, loose) in tight.iter().zip(&loose) {
            prop_assert!(loose.x_min <= tight.x_min && loose.x_min + 1 >= tight.x_min);
            prop_assert!(loose.y_min <= tight.y_min && loose.y_min + 1 >= tight.y_min);
            prop_assert!(loose.x_max >= tight.x_max && loose.x_max - 1 <= tight.x_max);
            prop_assert!(loose.y_max >= tight.y_max && loose.y_max - 1 <= tight.y_max);
        }
        let seen = frame.distance_to_image_plane.unwrap().0.pixels().iter().filter(|z| z.is_finite()).count();
        prop_assert_eq!(tight.len(), usize::from(seen > 0));
        prop_assert!(seen < 100 || tight.iter().all(|found| found.occlusion_ratio < 0.01));
    }
}
