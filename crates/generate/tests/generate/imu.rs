//! The samples of the inertial sensor of a data set along a trajectory.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "tests")]

use std::fs;

use crate::case::Case;
use oaktwin_generate::GenerateOptions;

const RECIPE: &str = "
frames = 6
frames_per_scene = 3
seed = 4
scene = 'table.usda'
[camera]
model = 'OAK-D Pro PoE'
cameras = 'rgb'
resolution = [64, 36]
trajectory = 'poses.tum'
imu = { rate_hz = 200 }
[output]
interval_s = 0.1
annotators = ['rgb', 'distance_to_image_plane']
formats = ['euroc', 'tum']
";

/// Poses that turn to the left by 0.5 rad/s and move forwards. Their own times do not count, because the recipe has an interval.
fn case(recipe: &str) -> Case {
    let case = Case::new(recipe);
    let line = |index: u32| {
        let time = 0.1 * f64::from(index);
        let half = 0.25 * time;
        format!(
            "{} {} 0 1.2 0 0 {} {}\n",
            7 * index,
            0.3 * time,
            half.sin(),
            half.cos()
        )
    };
    let poses: String = (0..4).map(line).collect();
    fs::write(case.folder.path().join("poses.tum"), poses).unwrap();
    case
}

fn read(case: &Case, path: &str) -> String {
    fs::read_to_string(case.folder.path().join(path)).expect(path)
}

fn samples(text: &str) -> Vec<[f64; 7]> {
    let rows = text.lines().skip(1);
    rows.map(|line| {
        let numbers: Vec<f64> = line.split(',').map(|word| word.parse().unwrap()).collect();
        numbers.try_into().unwrap()
    })
    .collect()
}

#[test]
fn each_sequence_has_its_samples() {
    let case = case(RECIPE);
    let generated = case.generate("set", &GenerateOptions::default()).unwrap();
    assert_eq!((generated.made, generated.missing), (6, 0));
    let [first, second] = [0, 1].map(|sequence| {
        let text = read(&case, &format!("set/euroc/{sequence:06}/mav0/imu0/data.csv"));
        assert!(text.starts_with("#timestamp [ns],w_RS_S_x [rad s^-1]"));
        samples(&text)
    });
    // Three frames, 0.1 s apart.
    assert_eq!(first.len(), 41);
    assert_eq!(first[40][0] - first[0][0], 2e8);
    let frames = read(&case, "set/euroc/000000/mav0/cam0/data.csv");
    assert!(frames.lines().last().unwrap().starts_with("1500000000200000000,"));
    // The same motion with other noise.
    let times = |samples: &[[f64; 7]]| samples.iter().map(|sample| sample[0]).collect::<Vec<_>>();
    assert_eq!(times(&first), times(&second));
    assert_ne!(first, second);
    // The lengths of vectors do not depend on how the part is mounted.
    for samples in [&first, &second] {
        let mean = |from: usize| {
            let length = |sample: &[f64; 7]| sample[from..from + 3].iter().map(|x| x * x).sum::<f64>().sqrt();
            samples.iter().map(length).sum::<f64>() / samples.len() as f64
        };
        assert!((mean(1) - 0.5).abs() < 0.03, "{}", mean(1));
        assert!((mean(4) - 9.81).abs() < 0.3, "{}", mean(4));
    }
    let sensor = read(&case, "set/euroc/000000/mav0/imu0/sensor.yaml");
    assert!(sensor.starts_with("sensor_type: imu\ncomment: "), "{sensor}");
    for key in [
        "T_BS:",
        "rate_hz: 200.0",
        "gyroscope_noise_density: ",
        "accelerometer_random_walk: ",
    ] {
        assert!(sensor.contains(key), "{key}: {sensor}");
    }
    // The state at the second frame has the bias of its sample.
    let state = read(
        &case,
        "set/euroc/000000/mav0/state_groundtruth_estimate0/data.csv",
    );
    let state: Vec<f64> = (state
        .lines()
        .nth(2)
        .unwrap()
        .split(',')
        .map(|word| word.parse().unwrap()))
    .collect();
    assert_eq!(state.len(), 17);
    assert!(
        state[11..].iter().all(|bias| *bias != 0.0 && bias.abs() < 0.02),
        "{state:?}"
    );
    let speed = state[8..11].iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!((speed - 0.3).abs() < 1e-6, "{state:?}");
    assert!(!case.folder.path().join("set/tum/000000/mav0").exists());
    let manifest = read(&case, "set/manifest.json");
    assert!(manifest.contains("euroc/000001/mav0/imu0/data.csv"));
}

#[test]
fn they_do_not_depend_on_the_order_of_frames() {
    let case = case(RECIPE);
    case.generate("whole", &GenerateOptions::default()).unwrap();
    for frames in [4..6, 0..1, 1..4] {
        let options = GenerateOptions {
            frames: Some(frames),
            resume: case.folder.path().join("parts").exists(),
            ..GenerateOptions::default()
        };
        case.generate("parts", &options).unwrap();
    }
    assert!(case.files("whole") == case.files("parts"));
}

#[test]
fn recipes_without_samples_are_rejected() {
    let refused = |from: &str, to: &str| {
        assert!(RECIPE.contains(from));
        let case = case(&RECIPE.replace(from, to));
        case.open().map(|_| ()).unwrap_err()
    };
    for (from, to, expected) in [
        (
            "'euroc', 'tum'",
            "'tum'",
            "camera.imu: only the format euroc has samples; add it to output.formats",
        ),
        (
            "frames_per_scene = 3",
            "frames_per_scene = 5",
            "frames_per_scene is 5, and the trajectory has 4 poses",
        ),
        (
            "frames_per_scene = 3",
            "frames_per_scene = 1",
            "frames_per_scene is 1, and the trajectory has 4 poses",
        ),
        (
            "rate_hz = 200",
            "part = 'BMI27'",
            "camera.imu.part: unknown inertial part 'BMI27'; did you mean 'BMI270'?",
        ),
        (
            "rate_hz = 200",
            "rate_hz = 0",
            "rate_hz: can be 0, which is out of range",
        ),
        ("rate_hz = 200", "rate = 200", "unknown key 'rate'"),
        (
            "'OAK-D Pro PoE'",
            "'OAK-1'",
            "camera.imu.part: no source names the inertial part of the OAK-1",
        ),
    ] {
        let error = refused(from, to);
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn frames_have_the_times_of_the_trajectory() {
    let recipe = RECIPE
        .replace("interval_s = 0.1\n", "")
        .replace("imu = { rate_hz = 200 }\n", "");
    let case = case(&recipe.replace("frames_per_scene = 3", "frames_per_scene = 6"));
    case.generate("set", &GenerateOptions::default()).unwrap();
    let poses = read(&case, "set/tum/000000/groundtruth.txt");
    let times: Vec<&str> = (poses.lines().skip(1))
        .map(|line| line.split(' ').next().unwrap())
        .collect();
    // Four poses, 7 s apart; then they begin again.
    let expected = [0, 7, 14, 21, 28, 35].map(|second| format!("{second}.000000000"));
    assert_eq!(times, expected);
}

#[test]
fn times_must_increase() {
    let case = case(&RECIPE.replace("interval_s = 0.1\n", ""));
    let poses = "5 0 0 1.2 0 0 0 1\n5 0.1 0 1.2 0 0 0 1\n6 0.2 0 1.2 0 0 0 1\n";
    fs::write(case.folder.path().join("poses.tum"), poses).unwrap();
    let error = case.generate("set", &GenerateOptions::default()).unwrap_err();
    assert!(
        error.contains("the times of the poses 0 and 1 are negative or do not increase"),
        "{error}"
    );
}
