//! A session: what a page shows, with the files that were dropped onto it, as one file.
//!
//! It is a ZIP archive: `session.json` has the state of the page, and names the files beside it.

mod archive;
mod state;

use std::path::Path;
use std::sync::Arc;

use oaktwin::render::OpenOptions;
use oaktwin::scene::Up;
use oaktwin::usd::usdz;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;

use archive::Archive;
use state::{Entry, SceneEntry, State};

use crate::dropped_robot::{self, Received};
use crate::file::File;
use crate::postures::{self, MotionInfo};
use crate::protocol::{CalibrationInfo, Failure, SceneInfo, TrajectoryInfo};
use crate::robot::{posed, split};
use crate::scene::{LoadedScene, infrared};
use crate::studio::Studio;
use crate::{calibration, trajectory, upload};

/// The version of the format.
const VERSION: u64 = 1;
/// The file with the state.
const STATE: &str = "session.json";
/// The maximum length of a calibration, bytes.
const MAX_CALIBRATION_BYTES: u64 = 1 << 20;
/// The maximum number of calibrations: one for each OAK of a page.
const MAX_CALIBRATIONS: usize = 16;
/// The maximum size of a session, bytes: the largest scene that can be dropped, with the other files.
pub(crate) const MAX_BYTES: u64 = upload::MAX_BYTES + (64 << 20);

/// What a session has: the state of the page, which only the page understands, and the ids of what was dropped.
#[derive(Debug, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub(crate) struct SaveRequest {
    #[cfg_attr(test, ts(type = "unknown"))]
    document: Box<RawValue>,
    #[cfg_attr(test, ts(type = "unknown"))]
    display: Box<RawValue>,
    scene: String,
    calibrations: Vec<String>,
    trajectory: Option<String>,
    /// The list of postures of the scene's robot.
    motion: Option<String>,
}

/// What a page shows after a session was opened.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SessionInfo {
    #[cfg_attr(test, ts(type = "unknown"))]
    document: Box<RawValue>,
    #[cfg_attr(test, ts(type = "unknown"))]
    display: Box<RawValue>,
    scene: SceneInfo,
    calibrations: Vec<CalibrationInfo>,
    trajectory: Option<TrajectoryInfo>,
    motion: Option<MotionInfo>,
}

/// Makes the file of a session.
pub(crate) fn save(studio: &Studio, request: SaveRequest) -> Result<File, Failure> {
    if request.calibrations.len() > MAX_CALIBRATIONS {
        return Err(Failure::of("calibrations", "are too many; load the page again"));
    }
    let shown = studio.scenes.get(&request.scene)?;
    let dropped = shown.robot.as_ref().and_then(|robot| robot.dropped.clone());
    let (id, posture) = match split(&request.scene) {
        Some((id, posture)) => (id, Some(posture.to_owned())),
        None => (request.scene.as_str(), None),
    };
    let (own, infrared) = match infrared::split(id) {
        Some((own, reflectances)) => (own, Some(reflectances.to_owned())),
        None => (id, None),
    };
    // The scene as its file has it; a robot that was dropped is a file of its own.
    let scene = match &dropped {
        Some(dropped) => studio.scenes.as_opened(&dropped.base)?,
        None => studio.scenes.as_opened(own)?,
    };
    let mut files = Vec::new();
    let (up, scale) = (scene.options.up, scene.options.scale);
    let mut entry = SceneEntry {
        id: scene.info.id.clone(),
        name: scene.info.name.clone(),
        triangles: scene.info.triangles,
        up: up.map(|up| up.name().to_owned()),
        scale,
        file: None,
        robot: None,
        infrared,
        posture,
    };
    if let Some(dropped) = dropped {
        entry.robot = Some(Entry::put(
            &mut files,
            "robot",
            (own, &dropped.name),
            &dropped.bytes,
        ));
    }
    if scene.kept.is_some() {
        let place = format!("scene/{}", entry.name);
        files.push((place.clone(), scene.file()?));
        entry.file = Some(place);
    }
    let mut calibrations = Vec::new();
    for (number, id) in request.calibrations.iter().enumerate() {
        let dropped = studio.calibrations.get(id)?;
        let (folder, info) = (format!("calibrations/{number}"), &dropped.info);
        calibrations.push(Entry::put(
            &mut files,
            &folder,
            (&info.id, &info.name),
            &dropped.bytes,
        ));
    }
    let path = request.trajectory.as_ref().map(|id| studio.trajectories.get(id));
    let path = path.transpose()?.map(|dropped| {
        let info = &dropped.info;
        Entry::put(&mut files, "trajectory", (&info.id, &info.name), &dropped.bytes)
    });
    let motion = request.motion.as_ref().map(|id| studio.motions.get(id));
    let motion = motion.transpose()?.map(|dropped| {
        let info = &dropped.info;
        Entry::put(&mut files, "motion", (&info.id, &info.name), &dropped.bytes)
    });
    let stem = entry.name.split('.').next().unwrap_or_default().to_owned();
    let state = State {
        version: VERSION,
        program: env!("CARGO_PKG_VERSION").to_owned(),
        document: request.document,
        display: request.display,
        scene: entry,
        calibrations,
        trajectory: path,
        motion,
    };
    let bytes = packed(&state, &files)
        .map_err(|error| Failure::from(format!("the session cannot be saved: {error}")))?;
    Ok(File::new(format!("{stem}.oaktwin"), bytes))
}

/// Makes the archive of a state and files.
fn packed(state: &State, files: &[(String, Vec<u8>)]) -> Result<Vec<u8>, Box<dyn std::error::Error>> {
    let json = serde_json::to_vec_pretty(state)?;
    let files = files
        .iter()
        .map(|(place, bytes)| (place.as_str(), bytes.as_slice()));
    let all: Vec<(&str, &[u8])> = std::iter::once((STATE, json.as_slice())).chain(files).collect();
    Ok(usdz::pack(&all)?)
}

/// Opens a session that was received as a file with a name. A session that cannot be opened changes nothing.
pub(crate) fn open(studio: &Studio, path: &Path, name: &str) -> Result<SessionInfo, Failure> {
    let mut archive = Archive::open(path, name)?;
    let state = archive.state()?;
    let scene = match &state.scene.file {
        None => Scene::Known(first(studio, &state.scene, name)?),
        Some(file) => dropped_scene(studio, &mut archive, &state.scene, file)?,
    };
    let robot = match &state.scene.robot {
        Some(entry) => with_robot(studio, &mut archive, entry, scene.get())?,
        None => None,
    };
    let whole = robot.as_ref().unwrap_or(scene.get());
    let reflecting = state.scene.infrared.as_ref().map(|reflectances| {
        let id = infrared::reflecting(&whole.info.id, reflectances);
        whole.reflecting(&id, infrared::parse(reflectances)?)
    });
    let reflecting = reflecting.transpose()?;
    if let Some(posture) = &state.scene.posture {
        let posed = whole.robot.as_ref();
        let posed = posed.ok_or_else(|| archive.wrong("has a posture, but no robot"))?;
        posed.parse(posture)?;
    }
    if state.calibrations.len() > MAX_CALIBRATIONS {
        return Err(archive.wrong("has too many calibrations"));
    }
    let mut calibrations = Vec::new();
    for entry in &state.calibrations {
        let bytes = archive.file(&entry.file, MAX_CALIBRATION_BYTES)?;
        let read = calibration::Dropped::read(&studio.catalog, &upload::file_name(&entry.name)?, bytes)?;
        archive.check_id(&entry.id, &read.info.id, &entry.name)?;
        calibrations.push(read);
    }
    let path = state.trajectory.as_ref().map(|entry| {
        let bytes = archive.file(&entry.file, trajectory::MAX_BYTES as u64)?;
        let read = trajectory::Dropped::read(&upload::file_name(&entry.name)?, bytes)?;
        archive.check_id(&entry.id, &read.info.id, &entry.name)?;
        Ok::<_, Failure>(read)
    });
    let path = path.transpose()?;
    let motion = state.motion.as_ref().map(|entry| {
        let bytes = archive.file(&entry.file, postures::MAX_BYTES as u64)?;
        let name = upload::file_name(&entry.name)?;
        let read = postures::Dropped::read(whole, &name, bytes)?;
        archive.check_id(&entry.id, &read.info.id, &entry.name)?;
        Ok::<_, Failure>(read)
    });
    let motion = motion.transpose()?;
    // Everything was read.
    Ok(SessionInfo {
        document: state.document,
        display: state.display,
        scene: kept(studio, scene, [robot, reflecting], state.scene.posture.as_deref())?,
        calibrations: (calibrations.into_iter())
            .map(|dropped| studio.calibrations.add(dropped))
            .collect(),
        trajectory: path.map(|dropped| studio.trajectories.add(dropped)),
        motion: motion.map(|dropped| studio.motions.add(dropped)),
    })
}

/// The scene of a session.
enum Scene {
    Known(Arc<LoadedScene>),
    New(Box<LoadedScene>),
}

impl Scene {
    fn get(&self) -> &LoadedScene {
        match self {
            Self::Known(scene) => scene,
            Self::New(scene) => scene,
        }
    }
}

/// Returns a scene with the robot of a session, unless it is known.
fn with_robot(
    studio: &Studio,
    archive: &mut Archive<'_>,
    entry: &Entry,
    scene: &LoadedScene,
) -> Result<Option<LoadedScene>, Failure> {
    let bytes = archive.file(&entry.file, dropped_robot::MAX_BYTES as u64)?;
    let name = upload::file_name(&entry.name)?;
    let received = Received::new(studio, &name, &bytes)?;
    archive.check_id(&entry.id, &received.id_in(scene), &entry.name)?;
    received.put_into(scene).map(Some)
}

/// Keeps the scenes of a session, and returns what the page knows about the one that it shows.
fn kept(
    studio: &Studio,
    scene: Scene,
    [robot, reflecting]: [Option<LoadedScene>; 2],
    posture: Option<&str>,
) -> Result<SceneInfo, Failure> {
    let scene = match scene {
        Scene::Known(scene) => scene,
        Scene::New(scene) => studio.scenes.add(*scene),
    };
    let scene = robot.map_or(scene, |robot| studio.scenes.add(robot));
    let scene = reflecting.map_or(scene, |reflecting| studio.scenes.reflecting.add(reflecting));
    match posture {
        Some(posture) => Ok(studio.scenes.get(&posed(&scene.info.id, posture))?.info.clone()),
        None => Ok(scene.info.clone()),
    }
}

/// Returns the scene of the command line, if the session shows the same one.
fn first(studio: &Studio, entry: &SceneEntry, session: &str) -> Result<Arc<LoadedScene>, Failure> {
    let first = &studio.scenes.first().info;
    match first.id == entry.id && first.name == entry.name && first.triangles == entry.triangles {
        true => studio.scenes.as_opened(&first.id),
        false => Err(Failure::from(format!(
            "{session}: shows the scene {} with {} triangles, which was named on the command line and is not in the file; start `oaktwin studio` with that scene, and open the session there",
            entry.name, entry.triangles
        ))),
    }
}

fn dropped_scene(
    studio: &Studio,
    archive: &mut Archive<'_>,
    entry: &SceneEntry,
    file: &str,
) -> Result<Scene, Failure> {
    let name = upload::file_name(&entry.name)?;
    let options = OpenOptions {
        up: entry.up.as_deref().map(up).transpose()?,
        scale: entry.scale,
        ..OpenOptions::default()
    };
    let bytes = archive.file(file, upload::MAX_BYTES)?;
    let folder = upload::folder(&studio.uploads)?;
    let path = folder.path().join(&name);
    std::fs::write(&path, bytes).map_err(|error| {
        Failure::from(format!(
            "{name} cannot be written: {error}; free space on the disk"
        ))
    })?;
    let id = upload::content_id(&name, &options, &path)?;
    archive.check_id(&entry.id, &id, &name)?;
    if let Some(known) = studio.scenes.dropped(&id) {
        return Ok(Scene::Known(known));
    }
    let scene = LoadedScene::open(&path, &options, (&id, &name, &name))?;
    scene.check_triangles()?;
    Ok(Scene::New(Box::new(scene.keeping(folder)?)))
}

fn up(name: &str) -> Result<Up, Failure> {
    oaktwin::depth::parameters::choose("up", name).map_err(|error| Failure::of("up", &error))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::studio::tests::studio;
    use serde_json::Value;
    use serde_json::value::to_raw_value;

    const PATH: &str = "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n";

    /// A studio with a dropped scene and a trajectory, and their session.
    fn saved(studio: &Studio) -> Vec<u8> {
        let folder = upload::folder(&std::env::temp_dir()).unwrap();
        let path = folder.path().join("part.obj");
        std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        let options = OpenOptions {
            scale: Some(0.001),
            ..OpenOptions::default()
        };
        let id = upload::content_id("part.obj", &options, &path).unwrap();
        let scene = LoadedScene::open(&path, &options, (&id, "part.obj", "part.obj")).unwrap();
        studio.scenes.add(scene.keeping(folder).unwrap());
        let path = trajectory::Dropped::read("path.txt", PATH.into()).unwrap();
        let request = SaveRequest {
            document: to_raw_value(&serde_json::json!({ "scene": id, "x": 0.1 })).unwrap(),
            display: to_raw_value(&Value::Null).unwrap(),
            scene: id,
            calibrations: Vec::new(),
            trajectory: Some(studio.trajectories.add(path).id),
            motion: None,
        };
        let file = save(studio, request).unwrap();
        assert_eq!(file.name, "part.oaktwin");
        file.bytes
    }

    fn opened(studio: &Studio, bytes: &[u8]) -> Result<SessionInfo, String> {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), bytes).unwrap();
        open(studio, file.path(), "a.oaktwin").map_err(|failure| failure.error)
    }

    #[test]
    fn a_session_opens_on_another_server() {
        let bytes = saved(&studio());
        let other = studio();
        let info = opened(&other, &bytes).unwrap();
        assert_eq!(
            (info.scene.name.as_str(), info.scene.scale),
            ("part.obj", Some(0.001))
        );
        assert_eq!(
            info.document.get(),
            format!(r#"{{"scene":"{}","x":0.1}}"#, info.scene.id)
        );
        assert_eq!(info.trajectory.unwrap().poses.len(), 2);
        assert!(other.scenes.get(&info.scene.id).is_ok());
    }

    #[test]
    fn a_session_keeps_a_robot_and_its_posture() {
        let one = studio();
        saved(&one);
        let part = one.scenes.first().info.id.clone();
        let robot = "<robot name='r'><link name='a'/><link name='b'><visual><geometry><sphere radius='0.1'/></geometry></visual></link>
            <joint name='j' type='prismatic'><parent link='a'/><child link='b'/><axis xyz='1 0 0'/><limit lower='0' upper='2'/></joint></robot>";
        let placed = dropped_robot::dropped(&one, &part, "r.urdf", robot.as_bytes()).unwrap();
        let id = posed(&placed.id, "1.5");
        let scene = one.scenes.get(&id).unwrap();
        let motion = postures::Dropped::read(&scene, "m.csv", b"j\n0\n2\n".to_vec()).unwrap();
        let request = SaveRequest {
            document: to_raw_value(&serde_json::json!({ "scene": id })).unwrap(),
            display: to_raw_value(&Value::Null).unwrap(),
            scene: id.clone(),
            calibrations: Vec::new(),
            trajectory: None,
            motion: Some(one.motions.add(motion).id),
        };
        let bytes = save(&one, request).unwrap().bytes;
        let other = studio();
        let info = opened(&other, &bytes).unwrap();
        assert_eq!(info.scene.id, id);
        assert_eq!(info.scene.robot.unwrap().joints[0].position, 1.5);
        assert_eq!(info.motion.unwrap().postures, [[0.0], [2.0]]);
        let text = String::from_utf8_lossy(&bytes).replace("\"1.5\"", "\"9.5\"");
        let state = &text[text.find('{').unwrap()..=text.rfind('}').unwrap()];
        let files = [(STATE, state.as_bytes()), ("robot/r.urdf", robot.as_bytes())];
        let error = opened(&other, &usdz::pack(&files).unwrap()).unwrap_err();
        assert!(error.contains("outside its limits"), "{error}");
    }

    #[test]
    fn files_that_are_no_session_change_nothing() {
        let bytes = saved(&studio());
        let other = studio();
        let pack = |json: &str| usdz::pack(&[(STATE, json.as_bytes())]).unwrap();
        let mut changed = bytes.clone();
        let place = changed.windows(9).position(|part| part == b"1 1 0 0 0").unwrap();
        changed[place] = b'2';
        for (bytes, expected) in [
            (Vec::new(), "is not a session"),
            (b"solid part".to_vec(), "is not a session"),
            (bytes[..bytes.len() / 2].to_vec(), "not all of it"),
            (usdz::pack(&[("a.txt", b"a")]).unwrap(), "has no session.json"),
            (pack("{"), "session.json: EOF"),
            (pack("{}"), "has no version"),
            (pack(r#"{"oaktwinSession": 2}"#), "update oaktwin"),
            (pack(r#"{"oaktwinSession": 1}"#), "missing field"),
            (pack(&" ".repeat(5 << 20)), "is larger than"),
            (changed, "trajectory/path.txt: Invalid checksum"),
        ] {
            let error = opened(&other, &bytes).unwrap_err();
            assert!(
                error.starts_with("a.oaktwin: ") && error.contains(expected),
                "{error}"
            );
        }
        let state = String::from_utf8_lossy(&bytes);
        let id = state
            .split('"')
            .find(|part| part.starts_with("dropped-"))
            .unwrap();
        assert!(other.scenes.get(id).is_err());
        let foreign = r#"{"oaktwinSession": 1, "program": "", "document": {}, "display": {}, "calibrations": [],
            "scene": {"id": "first", "name": "b", "triangles": 1}}"#;
        let error = opened(&other, &pack(foreign)).unwrap_err();
        assert!(error.contains("shows the scene b with 1 triangles"), "{error}");
    }
}
