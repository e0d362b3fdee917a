//! Runs the engines as processes and times their frames alternately.

use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::Duration;

use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::protocol::{Frames, Loaded, Request, ViewJson};
use crate::scenes::{self, SCENES, Scene};
use crate::table::{Agreement, BenchRow, Outcome};
use crate::triangles::{self, Files};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Only this scene (repeatable): sphere, plane, chess, heightfield
    #[arg(long)]
    scene: Vec<String>,
    /// Only this engine (repeatable): raster, ray, embree, open3d, mitsuba
    #[arg(long)]
    engine: Vec<String>,
    /// Number of frames per engine
    #[arg(long, default_value_t = 30)]
    frames: usize,
    /// Render few frames, and skip the largest scene
    #[arg(long)]
    quick: bool,
    /// Number of threads (default: all hardware threads)
    #[arg(long)]
    threads: Option<usize>,
    /// Skip the engines that are Python packages
    #[arg(long)]
    no_python: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    places: Places,
}

/// Locations of external files.
#[derive(clap::Args)]
pub(crate) struct Places {
    /// The Python environment of `cargo xtask bench render`, which also contains Embree's library
    #[arg(long)]
    environment: Option<PathBuf>,
}

/// Consecutive frames, so that an engine's data is in the caches for all but the first. After a pause, the scheduler runs
/// all threads on one processor for some milliseconds, which are several of our frames.
const FRAMES_PER_TURN: usize = 10;

/// The engines whose depth is the reference; the first available one is used.
const REFERENCES: [(&str, &str); 4] = [("open3d", ""), ("embree", "1"), ("mitsuba", ""), ("ray", "")];

pub(crate) fn run(args: &Args) -> Result<(), String> {
    let contest = Contest::new(args)?;
    let wanted: Vec<&Scene> = match (args.scene.as_slice(), args.quick) {
        ([], false) => SCENES.iter().collect(),
        ([], true) => SCENES
            .iter()
            .filter(|scene| scene.name != "heightfield")
            .collect(),
        (names, _) => names
            .iter()
            .map(|name| scenes::find(name))
            .collect::<Result<_, _>>()?,
    };
    let mut outcomes = Vec::new();
    for scene in wanted {
        let outcome = contest.hold(scene);
        if !args.json {
            outcome.print();
        }
        outcomes.push(outcome);
    }
    if args.json {
        println!("{}", serde_json::json!(outcomes));
    }
    Ok(())
}

struct Contest<'a> {
    args: &'a Args,
    folder: PathBuf,
    threads: usize,
    turns: usize,
}

/// The process of an engine.
struct Process {
    child: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
}

/// An engine that has loaded the scene, and its results so far.
struct Contestant {
    engine: &'static str,
    process: Process,
    loaded: Loaded,
    modes: Vec<(String, Times)>,
}

#[derive(Default)]
struct Times {
    all_threads: Frames,
    one_thread: Frames,
}

const ENGINES: [&str; 5] = ["raster", "ray", "embree", "open3d", "mitsuba"];

impl<'a> Contest<'a> {
    fn new(args: &'a Args) -> Result<Self, String> {
        if let Some(unknown) = args.engine.iter().find(|name| !ENGINES.contains(&name.as_str())) {
            return Err(format!(
                "unknown engine {unknown}; expected one of {}",
                ENGINES.join(", ")
            ));
        }
        let here = std::thread::available_parallelism().map_or(1, usize::from);
        let frames = if args.quick {
            args.frames.min(6)
        } else {
            args.frames
        };
        Ok(Self {
            args,
            folder: args.places.folder()?,
            threads: args.threads.unwrap_or(here).max(1),
            turns: frames.div_ceil(FRAMES_PER_TURN).max(1),
        })
    }

    fn hold(&self, scene: &Scene) -> Outcome {
        let view = scene.view(1280, 800);
        let mut outcome = Outcome::new(scene.title, &view, self.threads, self.turns * FRAMES_PER_TURN);
        let files = match scene.files(&self.folder) {
            Ok(files) => files,
            Err(reason) => {
                outcome.skipped.push((scene.title.to_owned(), reason));
                return outcome;
            }
        };
        outcome.triangles = std::fs::metadata(&files.triangles).map_or(0, |file| file.len() / 12);
        let mut contestants = Vec::new();
        for engine in ENGINES {
            if !self.args.engine.is_empty() && !self.args.engine.iter().any(|wanted| wanted == engine) {
                continue;
            }
            match self.start(engine, &files, &view) {
                Ok(contestant) => contestants.push(contestant),
                Err(reason) => outcome.skipped.push((engine.to_owned(), reason)),
            }
        }
        for _ in 0..self.turns {
            for contestant in &mut contestants {
                contestant.take_turn(self.threads);
            }
        }
        let depths = self.depths(scene, &mut contestants);
        let reference = REFERENCES.iter().find_map(|&(engine, mode)| {
            let found = depths.iter().find(|(e, m, _)| *e == engine && m == mode)?;
            Some((engine, mode, found.2.as_slice()))
        });
        outcome.reference = reference.map_or(String::new(), |(engine, mode, _)| format!("{engine} {mode}"));
        for contestant in contestants {
            for (mode, times) in contestant.modes {
                let depth = depths
                    .iter()
                    .find(|(engine, m, _)| *engine == contestant.engine && *m == mode);
                let agreement = match (depth, reference) {
                    (Some((_, _, depth)), Some((_, _, reference))) => {
                        Some(Agreement::between(depth, reference))
                    }
                    _ => None,
                };
                outcome.rows.push(BenchRow {
                    engine: contestant.engine.to_owned(),
                    mode,
                    loaded: contestant.loaded.clone(),
                    all_threads: times.all_threads,
                    one_thread: times.one_thread,
                    agreement,
                });
            }
        }
        outcome
    }

    fn start(&self, engine: &'static str, files: &Files, view: &ViewJson) -> Result<Contestant, String> {
        let mut process = Process::start(&mut self.command(engine)?)?;
        let loaded: Loaded = process.ask(&Request::Load {
            positions: files.positions.clone(),
            triangles: files.triangles.clone(),
            view: view.clone(),
            threads: self.threads,
        })?;
        let modes = loaded.modes.iter();
        Ok(Contestant {
            engine,
            process,
            modes: modes.map(|mode| (mode.clone(), Times::default())).collect(),
            loaded,
        })
    }

    fn command(&self, engine: &str) -> Result<Command, String> {
        if ["open3d", "mitsuba"].contains(&engine) {
            if self.args.no_python {
                return Err("--no-python".to_owned());
            }
            let script = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/oracles/bench_render.py");
            let mut command = Command::new(self.args.places.python()?);
            command
                .args([script, engine])
                .env_remove("PYTHONPATH")
                .env_remove("PYTHONHOME");
            return Ok(command);
        }
        let this = std::env::current_exe().map_err(|error| error.to_string())?;
        let mut command = Command::new(this);
        command.args(["worker", engine]);
        if engine == "embree" {
            command.arg("--library").arg(self.args.places.embree()?);
        }
        Ok(command)
    }

    /// The depth images by engine and mode.
    fn depths(&self, scene: &Scene, contestants: &mut [Contestant]) -> Vec<(&'static str, String, Vec<f32>)> {
        let mut depths = Vec::new();
        for contestant in contestants {
            for (mode, _) in &contestant.modes {
                let path = self
                    .folder
                    .join(format!("{}.{}{mode}.depth.f32", scene.name, contestant.engine));
                let asked = contestant.process.ask::<serde_json::Value>(&Request::Depth {
                    mode: mode.clone(),
                    path: path.clone(),
                });
                if let (Ok(_), Ok(depth)) = (asked, triangles::read_depth(&path)) {
                    depths.push((contestant.engine, mode.clone(), depth));
                }
            }
        }
        depths
    }
}

impl Contestant {
    fn take_turn(&mut self, threads: usize) {
        for (mode, times) in &mut self.modes {
            // Some thread pools spin for a moment after their work; this must not slow down the next engine.
            std::thread::sleep(Duration::from_millis(5));
            times
                .all_threads
                .append(self.process.frames(mode, threads, FRAMES_PER_TURN));
            if threads > 1 {
                times.one_thread.append(self.process.frames(mode, 1, 2));
            }
        }
    }
}

impl Frames {
    fn append(&mut self, other: Self) {
        self.wall_s.extend(other.wall_s);
        self.cpu_s.extend(other.cpu_s);
    }
}

impl Process {
    fn start(command: &mut Command) -> Result<Self, String> {
        let mut child = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("{}: {error}", command.get_program().display()))?;
        let (Some(input), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err("the engine has no standard input and output".to_owned());
        };
        Ok(Self {
            child,
            input,
            output: BufReader::new(output),
        })
    }

    fn frames(&mut self, mode: &str, threads: usize, count: usize) -> Frames {
        let mode = mode.to_owned();
        let request = Request::Frames { mode, threads, count };
        self.ask(&request).unwrap_or_default()
    }

    fn ask<T: DeserializeOwned>(&mut self, request: &Request) -> Result<T, String> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Answer<T> {
            Error { error: String },
            Value(T),
        }
        let line = serde_json::to_string(request).map_err(|error| error.to_string())?;
        let sent = writeln!(self.input, "{line}").and_then(|()| self.input.flush());
        let mut answer = String::new();
        let read = sent.and_then(|()| self.output.read_line(&mut answer));
        match (read, serde_json::from_str(&answer)) {
            (Err(error), _) => Err(format!("the engine ended early: {error}")),
            (Ok(0), _) => Err("the engine ended early".to_owned()),
            (Ok(_), Ok(Answer::Value(value))) => Ok(value),
            (Ok(_), Ok(Answer::Error { error })) => Err(error),
            (Ok(_), Err(error)) => Err(format!("{error}: {answer}")),
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // Does not wait for an engine that no longer answers.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Places {
    /// The folder for the triangles, beside the build's output.
    pub(crate) fn folder(&self) -> Result<PathBuf, String> {
        let folder = Self::target()?.join("bench-render");
        std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        Ok(folder)
    }

    fn target() -> Result<PathBuf, String> {
        let this = std::env::current_exe().map_err(|error| error.to_string())?;
        let target = this.parent().and_then(Path::parent);
        target
            .map(Path::to_owned)
            .ok_or_else(|| format!("{}: has no parent folder", this.display()))
    }

    fn environment(&self) -> Result<PathBuf, String> {
        let folder = match &self.environment {
            Some(folder) => folder.clone(),
            None => Self::target()?.join("oracles/render"),
        };
        if folder.is_dir() {
            Ok(folder)
        } else {
            Err(format!(
                "{}: does not exist; `cargo xtask bench render` creates it",
                folder.display()
            ))
        }
    }

    fn python(&self) -> Result<PathBuf, String> {
        Ok(self.environment()?.join("bin/python"))
    }

    /// Embree's library, from the Python package `embreex`.
    pub(crate) fn embree(&self) -> Result<PathBuf, String> {
        let environment = self.environment()?;
        let entries = |folder: PathBuf| {
            let found = std::fs::read_dir(folder).into_iter().flatten().flatten();
            found.map(|entry| entry.path()).collect::<Vec<_>>()
        };
        let packages = entries(environment.join("lib"));
        let mut libraries = packages
            .into_iter()
            .flat_map(|python| entries(python.join("site-packages/embreex.libs")));
        let is_it = |path: &PathBuf| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("libembree4") && name.contains(".so")
        };
        libraries
            .find(is_it)
            .ok_or_else(|| format!("{}: embreex.libs/libembree4 is missing", environment.display()))
    }
}
