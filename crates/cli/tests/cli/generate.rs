//! Data sets from recipes.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::program::Program;

fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().collect()
}

/// A table with blocks, at any size of image.
fn case(resolution: &str) -> Program {
    let program = Program::new();
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/recipes");
    program.put("table.usda", fs::read(examples.join("table.usda")).unwrap());
    program.put(
        "block.usda",
        fs::read(examples.join("objects/block.usda")).unwrap(),
    );
    program.put(
        "recipe.toml",
        format!(
            "frames = 6\nscene = 'table.usda'\n[[objects]]\nfiles = 'block.usda'\ncount = 3\non = '/World/Table'\n\
             [camera]\nresolution = {resolution}\n"
        ),
    );
    program
}

/// The files of a data set with their bytes.
fn files(program: &Program, folder: &str) -> Vec<(String, Vec<u8>)> {
    let names = program.names().into_iter();
    let own = names
        .filter(|name| program.path(name).is_file())
        .filter_map(|name| Some((name.strip_prefix(folder)?.to_owned(), name)));
    let read = |(short, name): (String, String)| (short, fs::read(program.path(&name)).unwrap());
    own.map(read).collect()
}

#[test]
fn generates_explains_and_previews() {
    let program = case("[80, 50]");
    let done = program.good(&words("generate recipe.toml -o set --formats bop,coco --json"));
    let report: Value = serde_json::from_str(&done).unwrap();
    assert_eq!(
        (&report["frames"], &report["interrupted"]),
        (&6.into(), &false.into())
    );
    assert!(program.path("set/bop/train/000005/scene_gt.json").exists());
    assert!(program.path("set/coco/annotations/instances.json").exists());
    let drawn = program.good(&words("generate recipe.toml --explain 5"));
    let drawn: Value = serde_json::from_str(&drawn).unwrap();
    assert_eq!(drawn["arrangement"]["objects"].as_array().unwrap().len(), 3);
    program.good(&words("generate recipe.toml --preview 2 -o sheet.png"));
    assert!(program.path("sheet.png").exists());
    let schema = program.good(&words("generate --schema"));
    let schema: Value = serde_json::from_str(&schema).unwrap();
    assert_eq!(schema["title"], "A recipe of oaktwin generate");
}

#[test]
fn a_frame_is_what_render_makes_of_its_scene() {
    let program = case("[80, 50]");
    program.good(&words("generate recipe.toml -o set --save-scenes"));
    let drawn = program.good(&words("generate recipe.toml --explain 0"));
    let drawn: Value = serde_json::from_str(&drawn).unwrap();
    let pose = &drawn["camera"]["world_from_body"];
    let numbers = ["position", "orientation"].map(|part| pose[part].as_array().unwrap());
    let pose: Vec<String> = numbers.into_iter().flatten().map(Value::to_string).collect();
    let mut arguments = words(
        "render set/scenes/000000.usda --model OAK-D-Pro-PoE --resolution 80x50 --projector 1 --micro-texture --rgb-imager on \
         --annotators rgb,distance_to_image_plane,depth_sensor_distance -o render --pose",
    );
    arguments.extend(pose.iter().map(String::as_str));
    program.good(&arguments);
    for file in [
        "rgb_0000.png",
        "distance_to_image_plane_0000.npy",
        "depth_sensor_distance_0000.npy",
    ] {
        let read = |folder: &str| fs::read(program.path(&format!("{folder}/{file}"))).unwrap();
        assert!(read("set") == read("render"), "{file}");
    }
}

#[cfg(unix)]
#[test]
fn a_killed_run_is_completed_to_the_same_bytes() {
    let program = case("[640, 400]");
    program.good(&words("generate recipe.toml -o whole"));
    let ended = program.signalled(
        &["KILL"],
        &words("generate recipe.toml -o killed --workers 1"),
        |program| program.path("killed/.oaktwin/frames/00000001.json").exists(),
    );
    assert_eq!(ended.code, -9);
    assert!(!program.path("killed/manifest.json").exists());
    let done = program.good(&words("generate recipe.toml -o killed --resume"));
    assert!(done.contains("were complete already"), "{done}");
    assert!(files(&program, "whole/") == files(&program, "killed/"));
    // Too many frames to be complete before the signal.
    let recipe = fs::read_to_string(program.path("recipe.toml")).unwrap();
    program.put("long.toml", recipe.replace("frames = 6", "frames = 600"));
    let ended = program.signalled(
        &["INT"],
        &words("generate long.toml -o stopped --workers 1"),
        |program| program.path("stopped/.oaktwin/frames/00000000.json").exists(),
    );
    assert_eq!(ended.code, 130);
    assert!(
        ended.stdout.contains("continue with --resume"),
        "{}",
        ended.stdout
    );
}

#[test]
fn damaged_records_and_shards_are_made_again() {
    let program = case("[80, 50]");
    let recipe = fs::read_to_string(program.path("recipe.toml")).unwrap();
    let output = "[output]\nformats = ['basic', 'webdataset']\nshard_frames = 2\n";
    program.put("recipe.toml", format!("{recipe}{output}"));
    program.good(&words("generate recipe.toml -o whole"));
    let whole = files(&program, "whole/");
    let frame = |number: u32| program.path(&format!("whole/.oaktwin/frames/{number:08}.json"));
    let shard = || program.path("whole/webdataset/shard-000001.tar");
    let resumed = || {
        program.good(&words("generate recipe.toml -o whole --resume"));
        assert!(files(&program, "whole/") == whole);
    };
    // Two records in each other's place.
    let [third, fifth] = [3, 5].map(|number| fs::read(frame(number)).unwrap());
    fs::write(frame(3), &fifth).unwrap();
    fs::write(frame(5), &third).unwrap();
    resumed();
    let mut flipped = third;
    let middle = flipped.len() / 2;
    flipped[middle] ^= 1;
    fs::write(frame(3), &flipped).unwrap();
    resumed();
    fs::write(shard(), "short").unwrap();
    resumed();
    fs::remove_file(shard()).unwrap();
    resumed();
    // As long as before, so only their contents tell.
    let damage = |path: std::path::PathBuf| {
        let mut bytes = fs::read(&path).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        fs::write(&path, bytes).unwrap();
    };
    let (image, _) = whole.iter().find(|(name, _)| name.ends_with(".png")).unwrap();
    damage(program.path(&format!("whole/{image}")));
    damage(shard());
    program.good(&words("generate recipe.toml -o whole --resume"));
    assert!(files(&program, "whole/") != whole);
    let said = program.good(&words("generate recipe.toml -o whole --resume --verify"));
    assert!(said.contains("were complete already"), "{said}");
    assert!(files(&program, "whole/") == whole);
    fs::write(program.path("whole/.oaktwin/recipe.json"), "{").unwrap();
    let refused = program.refused(&words("generate recipe.toml -o whole --resume"));
    assert!(
        refused.contains("recipe.json: is damaged") && refused.contains("restore it"),
        "{refused}"
    );
}

#[test]
fn several_runs_share_a_folder() {
    let program = case("[80, 50]");
    program.good(&words("generate recipe.toml -o whole"));
    for frames in ["4..6", "0..2", "2..4"] {
        let done = program.good(&words(&format!(
            "generate recipe.toml -o parts --frames {frames} --only-frames"
        )));
        assert!(done.contains("completed by --resume"), "{done}");
    }
    program.good(&words("generate recipe.toml -o parts --resume"));
    assert!(files(&program, "whole/") == files(&program, "parts/"));
}

#[test]
fn bad_input_is_explained() {
    let program = case("[80, 50]");
    program.put("wrong.toml", "frames = 6\ncamra = {}\n");
    for (command, expected) in [
        (
            "generate wrong.toml -o set",
            "wrong.toml:2: unknown key 'camra'; did you mean 'camera'?",
        ),
        ("generate none.toml -o set", "none.toml: there is no such file"),
        (
            "generate recipe.toml -o set --frames 5..9",
            "frames: frames 5..9 are beyond the 6 frames of the recipe",
        ),
        ("generate recipe.toml -o set --frames 5..5", "has no frames"),
        (
            "generate recipe.toml -o set --formats bip",
            "a similar value exists: 'bop'",
        ),
        ("generate recipe.toml --preview 0 -o sheet.png", "0 is not in 1.."),
        ("generate recipe.toml", "--output"),
        (
            "generate recipe.toml -o recipe.toml",
            "recipe.toml: is a file, not a folder; choose another folder",
        ),
    ] {
        let ended = program.run(&words(command));
        assert_eq!(ended.code, 2, "{command}: {}", ended.stderr);
        assert!(ended.stderr.contains(expected), "{command}: {}", ended.stderr);
    }
}
