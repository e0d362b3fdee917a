use oaktwin_simd::Level;

use super::*;
use crate::raster::cluster::{ClusteredMesh, MAX_TRIANGLES, MAX_VERTICES};

/// Triangles of all sizes in front of the camera, behind it and around it, in meshes with several instances.
fn random_scene(seed: u64) -> Scene {
    let mut random = Random(seed);
    let mut scene = Scene::default();
    for _ in 0..4 {
        let mut positions = Vec::new();
        let mut triangles = Vec::new();
        for triangle in 0..300u32 {
            let size = 10f64.powf(random.within(-3.0, 0.7));
            let centre = random.point(5.0);
            positions.extend((0..3).map(|_| centre + random.point(size)));
            triangles.push([3 * triangle, 3 * triangle + 1, 3 * triangle + 2]);
        }
        // Random shared corners: slivers and triangles without area.
        for _ in 0..40 {
            let mut corner = || u32::try_from(random.bits() % 900).unwrap();
            triangles.push([corner(), corner(), corner()]);
        }
        triangles.push([7, 7, 9]);
        scene.meshes.push(mesh(&positions, &triangles));
    }
    for at in 0..6 {
        let scale = DVec3::new(if at % 2 == 0 { -1.0 } else { 1.0 }, random.within(0.5, 2.0), 0.8);
        scene.instances.push(instance(
            at % 4,
            DAffine3::from_scale_rotation_translation(
                scale,
                DQuat::from_scaled_axis(random.point(2.0)),
                random.point(3.0),
            ),
        ));
    }
    scene
}

#[test]
fn random_scenes_match_brute_force() {
    for (seed, view) in [
        (1, view(128, 80, 77.0)),
        (2, view(131, 83, 100.0)),
        (3, odd_view(140, 87)),
        (4, odd_view(9, 13)),
        (5, view(150, 90, 60.0)),
    ] {
        let found = difference(&random_scene(seed), &view);
        assert!(found.hits * 4 > found.depth + 1, "{found:?}");
        assert!(found.depth * 2000 <= found.hits, "{found:?}");
        assert!(found.triangle * 2000 <= found.hits, "{found:?}");
    }
}

#[test]
fn clipping_is_exact() {
    let mut view = odd_view(120, 70);
    view.clip = Clip {
        near_m: 3.0,
        far_m: 3.4,
    };
    let scene = random_scene(11);
    let found = difference(&scene, &view);
    assert!(found.hits > 1000 && found.depth * 2000 <= found.hits, "{found:?}");
    let z = render(&scene, &view).z.0;
    assert!(
        z.pixels()
            .iter()
            .all(|z| (3.0..=3.4).contains(z) || *z == f32::INFINITY)
    );
    assert!(z.pixels().contains(&f32::INFINITY));
}

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let scene = random_scene(6);
    let view = odd_view(500, 333);
    let renders: Vec<_> = [1, 2, 3, 7]
        .into_iter()
        .map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| render(&scene, &view))
        })
        .collect();
    assert!(renders.windows(2).all(|pair| pair[0] == pair[1]));
}

#[test]
fn any_level_gives_the_same_bytes() {
    for view in [view(640, 400, 77.0), odd_view(333, 222)] {
        let scene = random_scene(7);
        let renders: Vec<_> = Level::available()
            .into_iter()
            .map(|level| Rasterizer::with_level(&scene, level).visibility(&scene, &view))
            .collect();
        assert!(
            renders.iter().all(|r| r == &renders[0]),
            "{:?}",
            Level::available()
        );
    }
}

#[test]
fn images_of_any_size() {
    let scene = random_scene(8);
    for (width, height) in [(1, 1), (1, 300), (300, 1), (129, 81), (127, 79), (8, 8)] {
        let found = difference(&scene, &odd_view(width, height));
        assert!(found.depth <= 1, "{width}x{height}: {found:?}");
    }
    let mut empty = odd_view(10, 10);
    for size in [ImageSize::new(0, 0), ImageSize::new(0, 5), ImageSize::new(5, 0)] {
        empty.camera.intrinsics.size = size;
        assert!(
            Rasterizer::new(&scene)
                .visibility(&scene, &empty)
                .z
                .0
                .pixels()
                .is_empty()
        );
    }
    let large = Rasterizer::new(&scene).depth(&scene, &odd_view(4056, 3040));
    assert!(large.0.pixels().iter().any(|z| z.is_finite()));
}

#[test]
fn clusters_of_unconnected_and_degenerate_triangles() {
    // Triangles without shared vertices, all in one place except one far away; and a mesh that is a single point.
    let mut random = Random(9);
    let mut positions: Vec<_> = (0..3000).map(|_| random.point(0.001)).collect();
    positions.extend([DVec3::X * 1e6, DVec3::Y * 1e6, DVec3::Z * 1e6]);
    let triangles: Vec<_> = (0..1001u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    let soup = mesh(&positions, &triangles);
    let point = mesh(&[DVec3::ONE], &[[0, 0, 0]; 600]);
    for mesh in [soup, point] {
        let clustered = ClusteredMesh::new(&mesh);
        let mut found = clustered.triangles.clone();
        found.sort_unstable();
        let all: Vec<_> = (0..u32::try_from(mesh.triangles.len()).unwrap()).collect();
        assert_eq!(found, all, "every triangle once");
        for cluster in &clustered.clusters {
            assert!(usize::from(cluster.vertices) <= MAX_VERTICES);
            assert!(usize::from(cluster.triangles) <= MAX_TRIANGLES);
            let first = cluster.first_triangle as usize;
            for at in first..first + usize::from(cluster.triangles) {
                let number = clustered.triangles[at] as usize;
                assert_eq!(clustered.positions(cluster, at), mesh.corners(number));
            }
        }
    }
}
