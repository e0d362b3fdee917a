//! Lists that people write: trajectories, measured curves, and positions over time.

use std::path::Path;

use oaktwin::accuracy::measured;
use oaktwin::latency::Track;
use oaktwin::render::trajectory;

use crate::file;

/// A trajectory: its poses are rotations and finite places.
pub(crate) fn trajectory(bytes: &[u8]) {
    let name = Path::new("path.txt");
    match trajectory::parse(name, bytes) {
        Ok(poses) => {
            assert!(!poses.is_empty());
            for pose in &poses {
                let at = &pose.world_from_mount;
                assert!(at.translation.is_finite(), "{pose:?}");
                assert!((at.rotation.determinant() - 1.0).abs() < 1e-6, "{pose:?}");
                assert!(pose.time_s.is_none_or(f64::is_finite), "{pose:?}");
            }
            assert_eq!(trajectory::times_s(&poses).len(), poses.len());
        }
        Err(error) => assert!(error.to_string().starts_with("path.txt"), "{error}"),
    }
}

pub(crate) fn trajectory_seeds() -> Vec<Vec<u8>> {
    vec![
        b"# t x y z qx qy qz qw\n0 0 0 0 0 0 0 1\n0.5 1 -2 3e0 0 0 0.7071 0.7071 # end\n".to_vec(),
        br#"[{"time": 1.5, "position": [1, 2, 3], "orientation": [0, 0, 0, 1]}, {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]}]"#
            .to_vec(),
    ]
}

/// A measured curve: its numbers are those that the manual allows.
pub(crate) fn curve(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return;
    };
    match measured::of_text(Path::new("curve.csv"), text) {
        Ok(curve) => {
            assert!(!curve.points.is_empty());
            for point in &curve.points {
                assert!(
                    point.distance_m > 0.0 && point.distance_m.is_finite(),
                    "{point:?}"
                );
                assert!(
                    point.error_percent > -100.0 && point.error_percent.is_finite(),
                    "{point:?}"
                );
            }
        }
        Err(error) => assert!(error.to_string().starts_with("curve.csv"), "{error}"),
    }
}

pub(crate) fn curve_seeds() -> Vec<Vec<u8>> {
    vec![
        b"distance_m,depth_error_percent\n0.5,1.2\n2,-3.4e-1\n".to_vec(),
        b"unit,\"depth_error_percent\",distance_m\r\nA, 1.5 ,2\r\n".to_vec(),
    ]
}

/// Positions over time: finite numbers, at times that increase.
pub(crate) fn track(bytes: &[u8]) {
    match file::with("track.csv", bytes, Track::read) {
        Ok(track) => {
            assert_eq!(track.time_s.len(), track.position.len());
            assert!(track.position.iter().all(|at| at.is_finite()), "{track:?}");
            assert!(track.time_s.windows(2).all(|pair| pair[0] < pair[1]), "{track:?}");
        }
        Err(error) => assert!(error.to_string().contains("track.csv"), "{error}"),
    }
}

pub(crate) fn track_seeds() -> Vec<Vec<u8>> {
    vec![
        b"time_s,position\n0,0\n0.1,2\n1,-3.4e-1\n".to_vec(),
        b"name,\"position\",time_s\r\nA, 1.5 ,2\r\nB,1,3\r\n".to_vec(),
    ]
}
