use std::ops::ControlFlow;

use super::*;
use oaktwin_camera::math::DMat3;
use oaktwin_imu::allan_deviation;

fn twin(model: &str) -> Twin {
    let catalog = Catalog::builtin();
    catalog.nominal(catalog.device(model).unwrap())
}

fn pose(time_s: Option<f64>, x: f64) -> TimedPose {
    TimedPose {
        time_s,
        world_from_mount: RigidTransform::new(DMat3::IDENTITY, DVec3::new(x, 0.0, 0.0)),
    }
}

fn rest(seconds: f64) -> Motion {
    motion(&[pose(Some(2.0), 0.0), pose(Some(2.0 + seconds), 0.0)]).unwrap()
}

fn simulation(motion: Motion, options: ImuOptions) -> ImuSimulation {
    let twin = twin("OAK-D Pro PoE");
    let part = inertial_part(Catalog::builtin(), &twin.device, None).unwrap();
    ImuSimulation::new(&twin, part, motion, Up::Z, options).unwrap().0
}

#[test]
fn samples_have_the_rate_and_the_mean_of_the_truth() {
    let all: Vec<ImuSample> = simulation(rest(10.0), ImuOptions::default()).collect();
    assert_eq!(all.len(), 4001, "400 Hz, with both ends");
    assert_eq!(all[0].time.nanoseconds(), 2_000_000_000);
    assert_eq!(all[1].time.nanoseconds(), 2_002_500_000);
    assert_eq!(all[4000].time.nanoseconds(), 12_000_000_000);
    let mean = all.iter().map(|s| s.linear_acceleration).sum::<DVec3>() / 4001.0;
    // The driver's axes: z of the body is x of the sensor.
    assert!(
        (mean - DVec3::new(STANDARD_GRAVITY, 0.0, 0.0)).length() < 0.01,
        "{mean}"
    );
    let step = 1.0 / 256.0;
    for sample in &all {
        let codes = sample.linear_acceleration / step;
        assert!((codes - codes.round()).length() < 1e-3, "multiples of 2⁻⁸ m/s²");
    }
}

/// White noise and random walk of the records agree with the part and its quantization.
#[test]
fn records_have_the_densities_of_the_part() {
    let part = Catalog::builtin().inertial_part("BNO086").unwrap();
    let seconds = 4000.0;
    let options = ImuOptions {
        rate_hz: Some(100.0),
        seed: 5,
    };
    let (mut rate, mut force) = (Vec::new(), Vec::new());
    for sample in simulation(rest(seconds), options) {
        rate.push(sample.angular_velocity.x);
        force.push(sample.linear_acceleration.x);
    }
    let check = |record: &[f64], noise: &ChannelNoise| {
        // The noise of a sample is below a step or two, so that rounding adds white noise of variance step²/12.
        let rounding = noise.step.powi(2) / 12.0 / 100.0;
        let point = allan_deviation(record, 100.0, &[100])[0];
        let expected = noise.density.x.powi(2) + rounding + noise.random_walk.x.powi(2) / 3.0;
        let expected = expected.sqrt();
        let ratio = point.deviation / expected;
        assert!((0.95..1.05).contains(&ratio), "{ratio}");
    };
    check(&rate, &part.gyroscope_noise().unwrap());
    check(&force, &part.accelerometer_noise().unwrap());
}

#[test]
fn equal_seeds_give_equal_samples() {
    let samples = |seed, motion: Motion| -> Vec<ImuSample> {
        simulation(motion, ImuOptions { rate_hz: None, seed }).collect()
    };
    assert_eq!(samples(1, rest(2.0)), samples(1, rest(2.0)));
    assert_ne!(samples(1, rest(2.0)), samples(2, rest(2.0)));
    // The first samples do not depend on what follows, nor on the number of poses of the same motion.
    let moving = |count: u32| {
        let poses = (0..=count)
            .map(|i| f64::from(i) / f64::from(count))
            .map(|t| pose(Some(t), t));
        motion(&poses.collect::<Vec<_>>()).unwrap()
    };
    assert_eq!(samples(1, rest(2.0))[..400], samples(1, rest(1.0))[..400]);
    assert_eq!(samples(1, moving(1)), samples(1, moving(30)));
}

#[test]
fn up_is_that_of_the_world() {
    let twin = twin("OAK4-D");
    let part = inertial_part(Catalog::builtin(), &twin.device, None).unwrap();
    let (mut y_up, findings) =
        ImuSimulation::new(&twin, part, rest(1.0), Up::Y, ImuOptions::default()).unwrap();
    assert!(findings.is_empty(), "{findings:?}");
    // y of the body is -x of the sensor.
    let force = y_up.next().unwrap().linear_acceleration;
    assert!((force + DVec3::X * STANDARD_GRAVITY).length() < 0.2, "{force}");
}

#[test]
fn invalid_input_is_rejected() {
    let error = |poses: &[TimedPose]| motion(poses).unwrap_err().to_string();
    assert!(error(&[pose(Some(0.0), 0.0)]).starts_with("has 1 of the at least 2 poses"));
    assert!(error(&[pose(Some(0.0), 0.0), pose(None, 1.0)]).starts_with("pose 1: has no time"));
    assert!(error(&[pose(Some(1.0), 0.0), pose(Some(1.0), 1.0)]).starts_with("pose 1: the time 1 s"));

    let (catalog, oak) = (Catalog::builtin(), twin("OAK-D Pro PoE"));
    let part = inertial_part(catalog, &oak.device, None).unwrap();
    let new = |motion: Motion, rate_hz: f64| {
        let options = ImuOptions {
            rate_hz: Some(rate_hz),
            seed: 0,
        };
        ImuSimulation::new(&oak, part, motion, Up::Z, options).map(|(_, findings)| findings)
    };
    for rate_hz in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e6] {
        let found = new(rest(1.0), rate_hz).unwrap_err().to_string();
        assert!(found.contains("is out of range; give Hz above 0"), "{found}");
    }
    let found = new(rest(1.6e9), 400.0).unwrap_err().to_string();
    assert!(found.contains("samples, more than 2e8"), "{found}");
    let before = motion(&[pose(Some(-1.0), 0.0), pose(Some(1.0), 0.0)]).unwrap();
    assert!(
        new(before, 100.0)
            .unwrap_err()
            .to_string()
            .contains("out of range")
    );
    let codes: Vec<&str> = new(rest(1.0), 8000.0)
        .unwrap()
        .iter()
        .map(|one| one.code)
        .collect();
    assert_eq!(codes, ["imu-rate"]);

    let named = |name| inertial_part(catalog, &oak.device, Some(name)).map(|part| part.id.as_str());
    assert_eq!(named("bmi 270"), Ok("BMI270"));
    let found = named("BMI27").unwrap_err().to_string();
    assert_eq!(found, "unknown inertial part 'BMI27'; did you mean 'BMI270'?");
    assert!(named("AK09919").is_err(), "only a magnetometer");
    let mut without = oak.clone();
    without.body_from_imu = None;
    let made = ImuSimulation::new(&without, part, rest(1.0), Up::Z, ImuOptions::default());
    assert!(made.unwrap_err().to_string().contains("has no inertial sensor"));
}

#[test]
fn files_are_written_as_a_whole_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("imu.csv");
    let samples = simulation(rest(0.01), ImuOptions::default());
    let interrupted = write_euroc(samples.clone(), &path, &|_| ControlFlow::Break(())).unwrap();
    assert!(interrupted.is_none() && std::fs::read_dir(folder.path()).unwrap().count() == 0);
    let written = write_euroc(samples.clone(), &path, &|_| ControlFlow::Continue(())).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    assert_eq!(written.unwrap().bytes, text.len() as u64);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 6);
    assert!(lines[0].starts_with("#timestamp [ns],w_RS_S_x"));
    for (line, sample) in lines[1..].iter().zip(samples) {
        let numbers: Vec<f64> = line.split(',').map(|word| word.parse().unwrap()).collect();
        assert_eq!(numbers[1..4], sample.angular_velocity.to_array());
        assert_eq!(numbers[4..], sample.linear_acceleration.to_array());
    }
    let error = write_euroc(
        simulation(rest(0.01), ImuOptions::default()),
        &folder.path().join("no/imu.csv"),
        &|_| ControlFlow::Continue(()),
    );
    assert!(
        error
            .unwrap_err()
            .to_string()
            .contains("its folder does not exist")
    );
}
