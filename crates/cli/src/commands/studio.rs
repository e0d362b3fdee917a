use std::path::Path;

use oaktwin::files;
use oaktwin::render::OpenOptions;
use oaktwin_demo as demo_room;
use oaktwin_studio::{FirstScene, ServerOptions, serve};
use serde::Serialize;
use tempfile::TempDir;

use crate::args::{StudioArgs, checked_scale};
use crate::context::{Context, Exit, Result};
use crate::{output, signals};

/// Where `oaktwin demo` writes the room.
const ROOM: &str = "oaktwin-demo/demo_room/demo_room.usda";
/// The command that writes it.
const MADE_BY: &str = "oaktwin demo";

#[derive(Serialize)]
struct Link<'a> {
    url: &'a str,
}

pub(crate) fn run(context: &Context, args: &StudioArgs) -> Result<Exit> {
    args.threads.apply();
    let model = context.device(&args.model)?.name.clone();
    // The room's textures are read when they are first seen.
    let (mut scene, _folder) = match &args.scene {
        Some(path) => (named(path, args)?, None),
        None => {
            let (scene, folder) = room()?;
            (scene, Some(folder))
        }
    };
    scene.robot = args.robot.file()?;
    let options = ServerOptions {
        catalog: context.catalog.clone(),
        model,
        scene,
        host: args.host,
        port: args.port,
    };
    let mut printed = Ok(());
    signals::while_checked(|| {
        serve(
            options,
            |link| {
                printed = announce(args, link);
            },
            signals::is_received,
        )
    })?;
    printed?;
    Ok(Exit::Interrupted)
}

/// Prints the link and opens it.
fn announce(args: &StudioArgs, link: &str) -> Result<()> {
    if args.json {
        output::print_json(&Link { url: link })?;
    } else {
        output::print(&format!("{link}\n"))?;
        output::say("Press Ctrl-C to stop.");
    }
    if args.host.is_some_and(|host| !host.is_loopback()) {
        output::say("note: other machines can open the page; its link has a token, and is not encrypted");
    }
    if !args.no_open && open::that_detached(link).is_err() {
        output::say("no browser could be opened; open the link in one");
    }
    Ok(())
}

/// The scene of the command line.
fn named(path: &Path, args: &StudioArgs) -> Result<FirstScene> {
    let name = path
        .file_name()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned();
    Ok(FirstScene {
        argument: path.display().to_string(),
        made_by: None,
        path: path.to_owned(),
        options: OpenOptions {
            limit: args.scene_limit,
            allow_outside: args.allow_outside,
            up: args.up,
            scale: checked_scale(args.scale)?,
            ..OpenOptions::default()
        },
        name,
        world_from_body: None,
        robot: None,
    })
}

/// The demo room in a temporary folder, which is removed when it is dropped.
fn room() -> Result<(FirstScene, TempDir)> {
    let folder = tempfile::tempdir().map_err(|error| format!("the demo room cannot be written: {error}"))?;
    for (name, bytes) in demo_room::files()? {
        files::write(&folder.path().join(name), &bytes)?;
    }
    let scene = FirstScene {
        path: folder.path().join(demo_room::STAGE),
        options: OpenOptions::default(),
        name: "demo room".to_owned(),
        argument: ROOM.to_owned(),
        made_by: Some(MADE_BY.to_owned()),
        world_from_body: Some(demo_room::world_from_body()),
        robot: None,
    };
    Ok((scene, folder))
}
