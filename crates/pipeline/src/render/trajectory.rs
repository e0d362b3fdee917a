//! Trajectories from files.
//!
//! Two formats are supported and detected by the first character of the file:
//! * TUM, one pose per line: `t x y z qx qy qz qw`, separated by spaces; `#` starts a comment.
//! * JSON, a list of poses: `[{"time": 0.0, "position": [x, y, z], "orientation": [qx, qy, qz, qw]}, …]`; `time` is
//!   optional.
//!
//! Times are in seconds, lengths in metres; quaternions have length 1.

use std::path::Path;

use serde::Deserialize;

use super::pose::pose;
use oaktwin_camera::RigidTransform;
use oaktwin_files::{self as files, FileError};

/// The maximum file size: some million poses.
const MAX_BYTES: u64 = 256 << 20;

/// A pose of a trajectory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimedPose {
    /// The time in seconds, if the file has it.
    pub time_s: Option<f64>,
    /// The pose of the moving body or camera, metres.
    pub world_from_mount: RigidTransform,
}

/// Returns the times of the poses, s; `None` of a pose without one.
#[must_use]
pub fn times_s(path: &[TimedPose]) -> Vec<Option<f64>> {
    path.iter().map(|pose| pose.time_s).collect()
}

/// Reads a trajectory.
///
/// # Errors
/// Returns an error if the file cannot be read, has no poses or has an invalid pose, with its line or index.
pub fn read(path: &Path) -> Result<Vec<TimedPose>, FileError> {
    parse(path, &files::read(path, MAX_BYTES, "a trajectory")?)
}

/// Reads the content of a trajectory; `path` is its name in errors.
///
/// # Errors
/// Returns an error if there are no poses, or one is invalid, with its line or index.
pub fn parse(path: &Path, bytes: &[u8]) -> Result<Vec<TimedPose>, FileError> {
    let poses = parse_numbers(path, bytes)?.into_iter();
    Ok(poses.map(|(pose, _)| pose).collect())
}

/// Reads the content of a trajectory as [`parse`] does, with the seven numbers of each pose as the file has them: the position, and the
/// quaternion x, y, z, w.
///
/// # Errors
/// Returns an error in the cases of [`parse`].
pub fn parse_numbers(path: &Path, bytes: &[u8]) -> Result<Vec<(TimedPose, [f64; 7])>, FileError> {
    let wrong = |message: String, remedy: &str| FileError::new(path, message, remedy);
    let text = std::str::from_utf8(bytes)
        .map_err(|_| wrong("is not text".to_owned(), "give a TUM or JSON trajectory"))?;
    let text = text.trim_start_matches('\u{feff}');
    let poses = if text.trim_start().starts_with(['[', '{']) {
        from_json(text)
    } else {
        from_tum(text)
    };
    let poses = poses.map_err(|TrajectoryProblem { message, remedy }| wrong(message, remedy))?;
    if poses.is_empty() {
        return Err(wrong(
            "has no poses".to_owned(),
            "give lines of `t x y z qx qy qz qw`, or a JSON list",
        ));
    }
    Ok(poses)
}

struct TrajectoryProblem {
    message: String,
    remedy: &'static str,
}

const TUM_REMEDY: &str = "a TUM line is `t x y z qx qy qz qw`";
const JSON_REMEDY: &str =
    "give a list of {\"position\": [x, y, z], \"orientation\": [qx, qy, qz, qw]}, \"time\" if there is one";

fn from_tum(text: &str) -> Result<Vec<(TimedPose, [f64; 7])>, TrajectoryProblem> {
    let mut poses = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.split_once('#').map_or(line, |(before, _)| before).trim();
        if line.is_empty() {
            continue;
        }
        let wrong = |message: String| TrajectoryProblem {
            message: format!("line {number}: {message}"),
            remedy: TUM_REMEDY,
        };
        let numbers = line
            .split_whitespace()
            .map(|word| {
                word.parse::<f64>()
                    .map_err(|_| wrong(format!("`{}` is not a number", shortened(word))))
            })
            .collect::<Result<Vec<f64>, TrajectoryProblem>>()?;
        let [t, x, y, z, qx, qy, qz, qw] = numbers[..] else {
            return Err(wrong(format!("{} numbers instead of 8", numbers.len())));
        };
        poses.push(timed(Some(t), [x, y, z, qx, qy, qz, qw]).map_err(wrong)?);
    }
    Ok(poses)
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct JsonPose {
    time: Option<f64>,
    position: [f64; 3],
    orientation: [f64; 4],
}

fn from_json(text: &str) -> Result<Vec<(TimedPose, [f64; 7])>, TrajectoryProblem> {
    let poses: Vec<JsonPose> = serde_json::from_str(text).map_err(|error| TrajectoryProblem {
        message: error.to_string(),
        remedy: JSON_REMEDY,
    })?;
    (0..)
        .zip(poses)
        .map(|(index, one): (u32, _)| {
            let ([x, y, z], [qx, qy, qz, qw]) = (one.position, one.orientation);
            timed(one.time, [x, y, z, qx, qy, qz, qw]).map_err(|message| TrajectoryProblem {
                message: format!("pose {index}: {message}"),
                remedy: JSON_REMEDY,
            })
        })
        .collect()
}

fn timed(time_s: Option<f64>, numbers: [f64; 7]) -> Result<(TimedPose, [f64; 7]), String> {
    if let Some(time) = time_s.filter(|time| !time.is_finite()) {
        return Err(format!("the time {time} is not finite"));
    }
    let world_from_mount = pose(numbers).map_err(|error| error.to_string())?;
    Ok((
        TimedPose {
            time_s,
            world_from_mount,
        },
        numbers,
    ))
}

fn shortened(word: &str) -> String {
    const LONGEST: usize = 40;
    match word.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &word[..end]),
        None => word.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::math::DVec3;
    use proptest::prelude::*;

    fn of(text: &str) -> Result<Vec<TimedPose>, String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("path");
        std::fs::write(&path, text).unwrap();
        read(&path).map_err(|error| error.to_string().replace(&format!("{}: ", path.display()), ""))
    }

    #[test]
    fn skips_comments_and_empty_lines() {
        let poses =
            of("\u{feff}# t x y z qx qy qz qw\n\n1.5 1 2 3 0 0 0 1 # here\r\n  2\t0 0 0 0 0 1 0\n").unwrap();
        assert_eq!(poses.len(), 2);
        assert_eq!(poses[0].time_s, Some(1.5));
        assert_eq!(poses[0].world_from_mount.translation, DVec3::new(1.0, 2.0, 3.0));
        assert_eq!(poses[1].world_from_mount.rotation * DVec3::X, DVec3::NEG_X);
    }

    #[test]
    fn reads_json() {
        let poses = of(
            r#"[{"time": 1.5, "position": [1, 2, 3], "orientation": [0, 0, 0, 1]},
            {"position": [0, 0, 0], "orientation": [0, 0, 1, 0]}]"#,
        )
        .unwrap();
        let tum = of("1.5 1 2 3 0 0 0 1\n0 0 0 0 0 0 1 0").unwrap();
        assert_eq!(poses[0], tum[0]);
        assert_eq!(
            (poses[1].time_s, poses[1].world_from_mount),
            (None, tum[1].world_from_mount)
        );
    }

    #[test]
    fn errors_name_the_line_or_pose() {
        for (text, expected) in [
            ("", "has no poses"),
            ("# nothing\n\n", "has no poses"),
            ("[]", "has no poses"),
            ("0 0 0 0 0 0 0 1\n0 0 0\n", "line 2: 3 numbers instead of 8"),
            ("0 0 0 x 0 0 0 1", "line 1: `x` is not a number"),
            ("0 0 0 nan 0 0 0 1", "line 1: NaN is not finite"),
            ("inf 0 0 0 0 0 0 1", "line 1: the time inf is not finite"),
            (
                "\n0 0 0 0 0 0 0 2",
                "line 2: the quaternion (0, 0, 0, 2) has length 2",
            ),
            (
                "[{\"position\": [0, 0], \"orientation\": [0, 0, 0, 1]}]",
                "line 1 column",
            ),
            ("{\"poses\": []}", "line 1 column"),
            (
                "[{\"position\": [0, 0, 0], \"orientation\": [0, 0, 0, 0]}]",
                "pose 0: the quaternion",
            ),
            (
                "[{\"position\": [0, 0, 0], \"orientation\": [0, 0, 0, 1], \"at\": 1}]",
                "unknown field `at`",
            ),
            ("\u{0}\u{1}garbage", "is not a number"),
        ] {
            let error = of(text).unwrap_err();
            assert!(error.contains(expected), "{text:?}: {error}");
        }
    }

    proptest! {
        #[test]
        fn what_is_written_is_read(
            poses in prop::collection::vec((
                -1e9..1e9f64, prop::array::uniform3(-1e3..1e3f64), prop::array::uniform4(-1.0..1.0f64),
            ), 1..20),
        ) {
            let (mut tum, mut json, mut expected) = (String::new(), Vec::new(), Vec::new());
            for (t, [x, y, z], q) in poses {
                let length = q.iter().map(|c| c * c).sum::<f64>().sqrt();
                prop_assume!(length > 0.1);
                let [a, b, c, d] = q.map(|part| part / length);
                tum += &format!("{t} {x} {y} {z} {a} {b} {c} {d}\n");
                json.push(serde_json::json!({"time": t, "position": [x, y, z], "orientation": [a, b, c, d]}));
                expected.push(TimedPose { time_s: Some(t), world_from_mount: pose([x, y, z, a, b, c, d]).unwrap() });
            }
            prop_assert_eq!(&of(&tum).unwrap(), &expected);
            let read = of(&serde_json::Value::from(json).to_string()).unwrap();
            prop_assert_eq!(read.len(), expected.len());
            for (a, b) in read.iter().zip(&expected) {
                let d = a.world_from_mount.translation - b.world_from_mount.translation;
                prop_assert!(d.length() < 1e-12 && a.world_from_mount.orthonormality_error() < 1e-12);
            }
        }

        #[test]
        fn any_text_is_read_or_rejected(text in "[-\\[\\]{}\" 0-9.,#a-z\n]{0,200}") {
            match of(&text) {
                Ok(poses) => prop_assert!(!poses.is_empty()),
                Err(error) => prop_assert!(error.contains("; ")),
            }
        }
    }
}
