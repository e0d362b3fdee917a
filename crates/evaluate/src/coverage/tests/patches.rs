use super::*;

fn area([a, b, c]: [DVec3; 3]) -> f64 {
    (b - a).cross(c - a).length() / 2.0
}

/// A plate of 0.25 m² whose left half is hidden by a block.
fn half_hidden() -> Stage {
    let block = DVec3::new(1.0, 0.25, 0.0);
    Stage::default()
        .plate("/Plate", DVec3::X * 2.0)
        .block("/Block", block, DVec3::new(0.1, 0.5, 1.0))
}

#[test]
fn patches_cover_the_surface_and_agree_with_the_shares() {
    let rig = rig_of("OAK4-D", &[]);
    let candidate = || Candidate::new(&rig, "ahead", facing(&rig, DVec3::ZERO, DVec3::X));
    let region = objects(&["/Plate"]);
    let renderer = Renderer::new(half_hidden().0);
    let count = 3000;
    let found = Patches::new(&renderer, &region, &candidate(), count).unwrap();
    assert!((3000..=6000).contains(&found.corners.len()));
    assert_eq!(found.corners.len(), found.outcomes.len());
    let total: f64 = found.corners.iter().map(|corners| area(*corners)).sum();
    assert!((total - 0.25).abs() < 1e-9, "{total}");
    let largest = 0.25 / f64::from(count) * (1.0 + 1e-9);
    assert!(found.corners.iter().all(|corners| area(*corners) <= largest));

    let share = |name: &str| {
        let own = found
            .corners
            .iter()
            .zip(&found.outcomes)
            .filter(|(_, outcome)| outcome.name() == name);
        own.map(|(corners, _)| area(*corners)).sum::<f64>() / total
    };
    let sampled = measure(
        &renderer,
        &region,
        &[candidate()],
        &CoverageOptions::default(),
        &go_on,
    )
    .unwrap();
    let sampled = &sampled.candidates[0].shares;
    assert!((share("hidden") - 0.5).abs() < 0.02, "{}", share("hidden"));
    assert!((share("hidden") - sampled.lost["hidden"]).abs() < 0.02);
    assert!((share("measured") - sampled.measured).abs() < 0.02);
    for (corners, outcome) in found.corners.iter().zip(&found.outcomes) {
        let centre = (corners[0] + corners[1] + corners[2]) / 3.0;
        // Left of the centre, apart from the patches at the edge.
        assert!(outcome.name() != "measured" || centre.y < 0.01, "{centre}");
    }
    let errors = found.errors_m.iter().zip(&found.outcomes);
    assert!(
        errors
            .into_iter()
            .all(|(error, outcome)| error.is_nan() == (*outcome != Outcome::MEASURED))
    );
}

#[test]
fn patches_are_cut_by_a_box_and_keep_small_triangles() {
    let rig = rig_of("OAK4-D", &[]);
    let candidate = Candidate::new(&rig, "ahead", facing(&rig, DVec3::ZERO, DVec3::X));
    let renderer = Renderer::new(half_hidden().0);
    let within = Some(oaktwin_scene::Bounds {
        min: DVec3::new(1.9, -0.1, -0.1),
        max: DVec3::new(2.1, 0.1, 0.1),
    });
    let region = Region {
        within,
        ..Region::default()
    };
    let found = Patches::new(&renderer, &region, &candidate, 1).unwrap();
    let total: f64 = found.corners.iter().map(|corners| area(*corners)).sum();
    assert!((total - 0.04).abs() < 1e-9, "{total}");
    assert!(
        found
            .corners
            .iter()
            .flatten()
            .all(|corner| corner.y.abs() <= 0.1 + 1e-9)
    );
}

#[test]
fn surfaces_of_too_many_triangles_are_rejected() {
    let rig = rig_of("OAK4-D", &[]);
    let candidate = Candidate::new(&rig, "ahead", facing(&rig, DVec3::ZERO, DVec3::X));
    let mut plate = shape::plane(0.5, 0.5, shape::Axis::X);
    let triangles = plate.triangles.clone();
    while plate.triangles.len() <= MAX_TRIANGLES {
        plate.triangles.extend(&triangles);
    }
    let stage = Stage::default().with("/Plate", plate, DAffine3::from_translation(DVec3::X));
    let renderer = Renderer::new(stage.0);
    let error = Patches::new(&renderer, &objects(&["/Plate"]), &candidate, 1).unwrap_err();
    assert!(error.to_string().contains("choose a smaller region"), "{error}");
}
