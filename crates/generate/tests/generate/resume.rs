//! Data sets in parts: by several workers and processes, interrupted, resumed, extended and damaged.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::case::{Case, TABLE};
use oaktwin_generate::GenerateOptions;
use oaktwin_image::{Image, png};
use oaktwin_pipeline::progress::Progress;
use serde_json::Value;

#[test]
fn a_frame_does_not_depend_on_other_frames_or_workers() {
    let case = Case::new(TABLE);
    let whole = case.generate("whole", &GenerateOptions::default()).unwrap();
    assert_eq!((whole.made, whole.missing, whole.is_interrupted), (5, 0, false));
    let parallel = GenerateOptions {
        workers: Some(3),
        ..GenerateOptions::default()
    };
    case.generate("parallel", &parallel).unwrap();
    // Backwards, one at a time, in separate runs.
    for frame in (0..5).rev() {
        let options = GenerateOptions {
            frames: Some(frame..frame + 1),
            resume: true,
            workers: Some(1),
            ..GenerateOptions::default()
        };
        let part = case.generate("parts", &options).unwrap();
        assert_eq!((part.made, part.missing), (1, frame));
    }
    let files = case.files("whole");
    assert_eq!(
        files.len() as u64,
        whole.files + 9,
        "the manifest, the recipe, its inputs, the lock and five records"
    );
    assert!(files == case.files("parallel") && files == case.files("parts"));
}

#[test]
fn an_interrupted_data_set_is_completed() {
    let case = Case::new(TABLE);
    case.generate("whole", &GenerateOptions::default()).unwrap();
    let calls = AtomicU64::new(0);
    let watch = |_: Progress| match calls.fetch_add(1, Ordering::Relaxed) {
        0..2 => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    };
    let root = case.folder.path().join("broken");
    let one = GenerateOptions {
        workers: Some(1),
        ..GenerateOptions::default()
    };
    let broken = case.open().unwrap().generate(&root, &one, &watch).unwrap();
    assert!(broken.is_interrupted && broken.made == 2);
    assert!(!root.join("manifest.json").exists());
    // A lost file, and one that was cut short.
    fs::remove_file(root.join("rgb_0000.png")).unwrap();
    fs::write(root.join("depth_sensor_distance_0001.npy"), "x").unwrap();
    let resume = GenerateOptions {
        resume: true,
        ..GenerateOptions::default()
    };
    let resumed = case.generate("broken", &resume).unwrap();
    assert_eq!((resumed.made, resumed.skipped), (5, 0));
    assert!(case.files("whole") == case.files("broken"));
    let again = case.generate("broken", &resume).unwrap();
    assert_eq!((again.made, again.skipped), (0, 5));
    let error = case.generate("broken", &GenerateOptions::default()).unwrap_err();
    assert!(error.contains("already has a data set"), "{error}");
    case.write(&TABLE.replace("[160, 100]", "[160, 90]"));
    let error = case.generate("broken", &resume).unwrap_err();
    assert!(error.contains("camera.resolution.1: 100 became 90"), "{error}");
}

#[test]
fn other_processes_make_frames() {
    let case = Case::new(TABLE);
    let whole = case.generate("whole", &GenerateOptions::default()).unwrap();
    let root = case.folder.path().join("parts");
    let generator = case.open().unwrap();
    let mut generation = generator.start(&root, &GenerateOptions::default()).unwrap();
    assert_eq!(generation.total(), 5);
    assert_eq!(generation.batches(), [0..2, 2..4, 4..5]);
    let error = case.generate(
        "parts",
        &GenerateOptions {
            resume: true,
            ..GenerateOptions::default()
        },
    );
    assert!(error.unwrap_err().contains("another process is writing"));
    let error = generation.add(&(0..2)).unwrap_err().to_string();
    assert!(
        error.contains("frame 0 was made on another machine, but is not here"),
        "{error}"
    );
    for batch in generation.batches().to_vec() {
        let part = GenerateOptions {
            frames: Some(batch.clone()),
            only_frames: true,
            ..GenerateOptions::default()
        };
        case.generate("parts", &part).unwrap();
        generation.add(&batch).unwrap();
    }
    let parts = generation.finish().unwrap();
    assert_eq!(parts, whole);
    assert!(case.files("whole") == case.files("parts"));
}

#[test]
fn full_shards_replace_their_samples() {
    let recipe = |frames: u64| {
        let output = "[output]\nformats = ['basic', 'webdataset']\nshard_frames = 2\n[camera]";
        TABLE
            .replace("frames = 5", &format!("frames = {frames}"))
            .replace("[camera]", output)
    };
    let case = Case::new(&recipe(5));
    let whole = case.generate("whole", &GenerateOptions::default()).unwrap();
    let names = |name: &str| {
        let files = case
            .files(name)
            .into_keys()
            .map(|path| path.display().to_string());
        let own = files.filter(|name| name.starts_with("webdataset"));
        own.collect::<Vec<_>>()
    };
    let expected = [
        "samples/00000004.tar",
        "shard-000000.tar",
        "shard-000001.tar",
        "shard-000002.tar",
    ];
    assert_eq!(names("whole"), expected.map(|name| format!("webdataset/{name}")));
    let listed: Value = serde_json::from_slice(&case.files("whole")[Path::new("manifest.json")]).unwrap();
    let listed = listed["files"].as_array().unwrap();
    assert_eq!(listed.len() as u64, whole.files);
    assert!(
        listed
            .iter()
            .all(|file| file["path"] != "webdataset/samples/00000001.tar")
    );
    // In parts, of which the first is a data set of fewer frames.
    case.write(&recipe(3));
    case.generate("parts", &GenerateOptions::default()).unwrap();
    assert_eq!(names("parts").len(), 3);
    case.write(&recipe(5));
    let resume = GenerateOptions {
        resume: true,
        ..GenerateOptions::default()
    };
    let parts = case.generate("parts", &resume).unwrap();
    assert_eq!((parts.made, parts.skipped), (2, 3));
    assert!(case.files("whole") == case.files("parts"));
    // The process was killed while it removed samples; a shard was lost.
    let root = case.folder.path().join("parts/webdataset");
    fs::create_dir_all(root.join("samples")).unwrap();
    fs::write(root.join("samples/00000001.tar"), "left").unwrap();
    fs::remove_file(root.join("shard-000001.tar")).unwrap();
    let again = case.generate("parts", &resume).unwrap();
    assert_eq!((again.made, again.skipped), (2, 3));
    assert!(case.files("whole") == case.files("parts"));
    fs::remove_file(root.join("shard-000001.tar")).unwrap();
    let one = GenerateOptions {
        frames: Some(2..3),
        ..resume
    };
    let error = case.generate("parts", &one).unwrap_err();
    assert!(
        error.contains("00000003.tar: is missing, or not the sample"),
        "{error}"
    );
}

#[test]
fn findings_are_those_of_the_data_set() {
    let case = Case::new(&TABLE.replace("[camera]", "[sensor]\npreset = 'robotics'\n[camera]"));
    let whole = case.generate("whole", &GenerateOptions::default()).unwrap();
    let codes: Vec<&str> = whole.findings.iter().map(|finding| finding.code).collect();
    assert_eq!(codes, ["preset"]);
    let resume = GenerateOptions {
        resume: true,
        ..GenerateOptions::default()
    };
    let again = case.generate("whole", &resume).unwrap();
    assert_eq!((again.made, again.findings), (0, whole.findings));
}

#[test]
fn saved_scenes_do_not_depend_on_the_frames_made_before() {
    let case = Case::new(
        "frames = 6\nframes_per_scene = 2\nseed = 2\nscene = 'table.usda'\n[camera]\nresolution = [48, 30]\n\
         [output]\nannotators = 'distance_to_image_plane'\nscenes = true\n[[objects]]\nfiles = 'objects'\ncount = 2\n\
         on = '/World/Table'\nlook = { textures = 'images' }\n",
    );
    let images = case.folder.path().join("images");
    fs::create_dir(&images).unwrap();
    for grey in 0..8u8 {
        let image = Image::filled(2, 2, [32 * grey, 0, 0]);
        fs::write(images.join(format!("{grey}.png")), png::encode(&image).unwrap()).unwrap();
    }
    let one = GenerateOptions {
        workers: Some(1),
        ..GenerateOptions::default()
    };
    case.generate("whole", &one).unwrap();
    for frames in [4..6, 2..4, 0..2] {
        let options = GenerateOptions {
            frames: Some(frames),
            resume: case.folder.path().join("parts").exists(),
            ..one.clone()
        };
        case.generate("parts", &options).unwrap();
    }
    let scenes = |name| {
        let mut files = case.files(name);
        files.retain(|path, _| path.starts_with("scenes"));
        files
    };
    assert_eq!(scenes("whole"), scenes("parts"));
    assert!(
        scenes("whole")
            .keys()
            .any(|path| path.extension().is_some_and(|extension| extension == "png"))
    );
}
