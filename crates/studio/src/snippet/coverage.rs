//! The coverage over a motion as a command.

use std::fmt::Write;

use super::{begun, file, oak, option, shell};
use crate::coverage::RegionRequest;
use crate::motion::MotionRequest;
use crate::postures::Dropped;
use crate::protocol::{Failure, Pose};
use crate::scene::LoadedScene;
use crate::studio::Studio;

/// The largest list of postures that the command writes, bytes; a longer one has to be there.
const MAX_LIST: usize = 4096;

/// Returns a command that measures the coverage over a list of postures, by an OAK with a pose on its link or in the world.
pub(crate) fn coverage(
    studio: &Studio,
    request: &MotionRequest,
    scene: &LoadedScene,
    (motion, pose): (&Dropped, Pose),
) -> Result<String, Failure> {
    let (mut out, mut words) = begun(scene, "coverage");
    let list = file(&motion.info.name);
    match std::str::from_utf8(&motion.bytes) {
        Ok(text) if text.len() <= MAX_LIST => {
            let lines: Vec<String> = text.lines().map(shell).collect();
            let _ = writeln!(out, "printf '%s\\n' {} > {}", lines.join(" "), shell(&list));
        }
        _ => {
            let _ = writeln!(out, "# The list of postures must be here: {}", shell(&list));
        }
    }
    if let Some(robot) = &scene.robot {
        words.extend(robot.arguments.iter().map(|word| shell(word)));
    }
    option(&mut words, "joints", &list);
    if let Some(mount) = &request.mount {
        option(&mut words, "mount", mount);
    }
    match &request.region {
        RegionRequest::Object { object } => option(&mut words, "region", object),
        RegionRequest::Box { minimum, maximum } => {
            words.push("--region-box".to_owned());
            words.extend(minimum.iter().chain(maximum).map(|number| format!("{number:?}")));
        }
    }
    if let Some(tolerance) = request.tolerance_mm {
        option(&mut words, "tolerance", &format!("{tolerance:?}"));
    }
    // The page shows surfaces as their files have them.
    words.push("--micro-texture=off".to_owned());
    let state = &request.state;
    words.extend(oak(
        studio,
        state,
        ("sensor", state.sensor_kind()),
        None,
        &mut out,
    )?);
    words.push("--pose".to_owned());
    words.extend(pose.numbers().map(|number| format!("{number:?}")));
    option(&mut words, "output", "motion");
    let _ = writeln!(out, "{}", words.join(" "));
    Ok(out)
}
