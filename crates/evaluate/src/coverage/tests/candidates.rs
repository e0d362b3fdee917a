//! Several candidates.

use std::sync::atomic::{AtomicU64, Ordering};

use oaktwin_camera::math::DVec3;
use oaktwin_pipeline::sensor::{SINGLE_VIEW, STEREO_MATCHING};

use super::*;

/// A thin box, 2 m in front of and behind which two cameras face it.
fn sandwich() -> (Renderer, MeasuringRig, [RigidTransform; 2]) {
    let thin = DVec3::new(0.01, 0.5, 0.5);
    let rig = rig_of("OAK4-D", &[]);
    let poses = [-2.0, 2.0].map(|x| facing(&rig, DVec3::new(x, 0.0, 0.0), DVec3::ZERO));
    let stage = Stage::default().block("/Thin", DVec3::ZERO, thin);
    (Renderer::new(stage.0), rig, poses)
}

#[test]
fn two_cameras_cover_both_sides() {
    let (renderer, rig, [front, back]) = sandwich();
    let aside = facing(&rig, DVec3::new(-2.0, 0.0, 0.0), DVec3::new(-2.0, 1.0, 0.0));
    let candidates = [
        Candidate::new(&rig, "aside", aside),
        Candidate::new(&rig, "front", front),
        Candidate::new(&rig, "front again", front),
        Candidate::new(&rig, "back", back),
    ];
    let options = CoverageOptions {
        keeps_points: true,
        ..CoverageOptions::default()
    };
    let coverage = measure(&renderer, &Region::default(), &candidates, &options, &go_on).unwrap();
    let side = 0.25 / 0.52;
    for (index, expected) in [(0, 0.0), (1, side), (2, side), (3, side)] {
        let shares = &coverage.candidates[index].shares;
        assert_share(shares.seen, expected);
        assert!((shares.measured - resolved(shares)).abs() < 1e-12);
    }
    assert_share(coverage.together.seen, 2.0 * side);
    assert!((coverage.together.measured - resolved(&coverage.together)).abs() < 1e-12);
    assert_eq!(coverage.ranking.last(), Some(&0));
    // Neither the candidate that sees nothing nor the one that adds nothing is selected.
    let mut selected: Vec<usize> = coverage.selection.iter().map(|one| one.candidate).collect();
    assert_eq!(coverage.selection[1].measured, coverage.together.measured);
    selected.sort_unstable();
    assert_eq!(selected, [1, 3]);
    // What was kept agrees with the shares.
    let kept = coverage.points.unwrap();
    for (candidate, outcomes) in coverage.candidates.iter().zip(&kept.outcomes) {
        let measured = outcomes.iter().filter(|one| **one == Outcome::MEASURED).count();
        assert_eq!(measured as f64 / f64::from(SAMPLES), candidate.shares.measured);
    }
    for (point, outcome) in kept.samples.points.iter().zip(&kept.outcomes[1]) {
        assert_eq!(outcome.is_seen(), point.normal.x < -0.5, "{point:?}");
    }
}

#[test]
fn a_tolerance_loses_points_with_larger_errors() {
    let (renderer, rig, [front, _]) = sandwich();
    let run = |tolerance_mm: Option<f64>| {
        let options = CoverageOptions {
            keeps_points: true,
            tolerance_mm,
            ..CoverageOptions::default()
        };
        let candidates = [Candidate::new(&rig, "front", front)];
        measure(&renderer, &Region::default(), &candidates, &options, &go_on).unwrap()
    };
    let any = run(None);
    let shares = |coverage: &Coverage| coverage.candidates[0].shares.clone();
    let errors: Vec<f64> = any.points.as_ref().unwrap().errors_m[0]
        .iter()
        .filter(|error| !error.is_nan())
        .map(|error| f64::from(error.abs()))
        .collect();
    let tolerance_mm = 1e3 * errors[errors.len() / 2];
    let strict = run(Some(tolerance_mm));
    let within = errors
        .iter()
        .filter(|&&error| error <= tolerance_mm * 1e-3)
        .count();
    assert!(within > 0 && within < errors.len());
    assert_eq!(shares(&strict).measured, within as f64 / f64::from(SAMPLES));
    assert_share(
        shares(&strict).lost["inaccurate"],
        shares(&any).measured - shares(&strict).measured,
    );
    assert_eq!(shares(&strict).seen, shares(&any).seen);
    assert_eq!(strict.together.measured, shares(&strict).measured);
}

#[test]
fn results_do_not_depend_on_threads_or_other_candidates() {
    let (renderer, rig, [front, back]) = sandwich();
    let options = CoverageOptions {
        samples: 3000,
        keeps_points: true,
        ..CoverageOptions::default()
    };
    let both = [
        Candidate::new(&rig, "front", front),
        Candidate::new(&rig, "back", back),
    ];
    let all = Region::default();
    let run = |candidates: &[Candidate<'_>]| measure(&renderer, &all, candidates, &options, &go_on).unwrap();
    let expected = format!("{:?}", run(&both));
    for threads in [1, 2, 5] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        assert!(
            pool.install(|| format!("{:?}", run(&both))) == expected,
            "{threads} threads"
        );
    }
    let alone = run(&both[1..]);
    assert_eq!(alone.candidates[0], run(&both).candidates[1]);
}

#[test]
fn an_interrupted_measurement_has_the_complete_candidates() {
    let (renderer, rig, [front, back]) = sandwich();
    let candidates = [front, back, front].map(|pose| Candidate::new(&rig, "", pose));
    let seen = AtomicU64::new(0);
    let watch = |Progress { done, total }| {
        assert_eq!(total, 3);
        seen.store(done, Ordering::Relaxed);
        if done < 2 {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    };
    let options = CoverageOptions {
        samples: 100,
        ..CoverageOptions::default()
    };
    let coverage = measure(&renderer, &Region::default(), &candidates, &options, &watch).unwrap();
    assert!(coverage.is_interrupted);
    assert_eq!(coverage.candidates.len(), 2);
    assert_eq!(coverage.ranking.len(), 2);
    let whole = measure(&renderer, &Region::default(), &candidates, &options, &go_on).unwrap();
    assert!(!whole.is_interrupted);
    assert_eq!(whole.candidates[..2], coverage.candidates);
}

#[test]
fn every_engine_measures() {
    let plate = Stage::default().plate("/Plate", DVec3::new(1.5, 0.0, 0.0));
    let renderer = Renderer::new(plate.0);
    let catalog = Catalog::builtin();
    let mut small = RigSpec {
        size: Some(ImageSize::new(320, 200)),
        ..RigSpec::default()
    };
    let untextured = ("confidenceThreshold".to_owned(), 0.into());
    small.sensor.parameters.push(untextured);
    let mut decimated = small.clone();
    decimated.sensor.filters.push("decimation".to_owned());
    let mut matching = small.clone();
    matching.sensor.engine = Some((&STEREO_MATCHING).into());
    let mut single = small.clone();
    single.sensor.engine = Some((&SINGLE_VIEW).into());
    single.sensor.parameters = vec![("confidenceThreshold".to_owned(), "1".into())];
    for (model, options) in [
        ("OAK-D ToF", &RigSpec::default()),
        ("OAK-D Pro PoE", &decimated),
        ("OAK-D Pro PoE", &single),
        ("OAK4-D", &matching),
    ] {
        let twin = catalog.nominal(catalog.device(model).unwrap());
        let (rig, _) = MeasuringRig::new(&twin, None, None, options).unwrap();
        let candidate = Candidate::new(&rig, model, facing(&rig, DVec3::ZERO, DVec3::X));
        let all = Region::default();
        let coverage = measure(&renderer, &all, &[candidate], &CoverageOptions::default(), &go_on).unwrap();
        let found = &coverage.candidates[0];
        assert_eq!(found.shares.seen, 1.0, "{found:?}");
        // A plate without texture cannot be matched.
        if found.engine != "stereo-matching" {
            assert!(found.shares.measured > 0.9, "{found:?}");
            assert!(found.shares.median_absolute_error_mm.unwrap() < 60.0, "{found:?}");
        }
    }
}

#[test]
fn every_outcome_has_a_name_of_its_own() {
    let mut names: Vec<&str> = reasons().iter().map(|reason| reason.name.as_str()).collect();
    assert_eq!(names[0], "measured");
    assert!(reasons().is_sorted_by(|a, b| a.code < b.code));
    for reason in reasons() {
        assert_eq!(Outcome(reason.code).name(), reason.name);
    }
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), count);
}

#[test]
fn numbers_out_of_range_are_rejected() {
    let (renderer, rig, [front, _]) = sandwich();
    let error = |count: usize, options: CoverageOptions| {
        let candidates = vec![Candidate::new(&rig, "", front); count];
        let result = measure(&renderer, &Region::default(), &candidates, &options, &go_on);
        result.unwrap_err().to_string()
    };
    let options = CoverageOptions::default();
    assert!(error(0, options).contains("there are no candidates"));
    assert!(error(MAX_CANDIDATES + 1, options).contains("10001 candidates are too many"));
    for samples in [0, MAX_SAMPLES + 1] {
        assert!(error(1, CoverageOptions { samples, ..options }).contains("give 1 to 1000000"));
    }
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let tolerance_mm = Some(tolerance);
        assert!(
            error(
                1,
                CoverageOptions {
                    tolerance_mm,
                    ..options
                }
            )
            .contains("give more than 0")
        );
    }
    let kept = CoverageOptions {
        samples: MAX_SAMPLES,
        keeps_points: true,
        ..CoverageOptions::default()
    };
    assert!(error(101, kept).contains("too many to keep"));
}
