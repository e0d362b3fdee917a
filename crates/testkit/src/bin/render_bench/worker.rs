//! Runs an engine.

use std::io::{self, BufRead, Write};
use std::path::Path;
use std::time::Instant;

use oaktwin_render::Backend;
use oaktwin_testkit::process;
use serde_json::{Value, json};

use crate::contest::Places;
#[cfg(target_os = "linux")]
use crate::embree::Embree;
use crate::engine::{Engine, Pools};
use crate::ours::Ours;

use crate::protocol::{Frames, Loaded, Request, ViewJson};
use crate::scenes;
use crate::triangles::{self, Files};

/// Answers requests until the input ends.
pub(crate) fn serve(engine: &str, library: Option<&Path>) -> Result<(), String> {
    let mut worker = Worker::new(engine, library);
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let line = line.map_err(|error| error.to_string())?;
        let answer = serde_json::from_str(&line).map_err(|error| error.to_string());
        let answer = answer.and_then(|request| worker.answer(request));
        let answer = answer.unwrap_or_else(|error| json!({ "error": error }));
        writeln!(out, "{answer}")
            .and_then(|()| out.flush())
            .map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// Renders frames of one scene in this process.
pub(crate) fn profile(
    engine: &str,
    scene: &str,
    frames: usize,
    threads: usize,
    places: &Places,
) -> Result<(), String> {
    let scene = scenes::find(scene)?;
    let folder = places.folder()?;
    let files = scene.files(&folder)?;
    let library = places.embree();
    let mut worker = Worker::new(engine, library.as_deref().ok());
    let loaded = worker.load(&files, &scene.view(1280, 800), threads)?;
    println!(
        "{engine}, {}: built in {:.1} ms",
        scene.name,
        loaded.build_s * 1e3
    );
    for mode in loaded.modes {
        let mut times = worker.frames(&mode, threads, frames)?;
        times.wall_s.sort_by(f64::total_cmp);
        times.cpu_s.sort_by(f64::total_cmp);
        let middle = |values: &[f64]| values.get(values.len() / 2).copied().unwrap_or(f64::NAN) * 1e3;
        let (wall, cpu) = (middle(&times.wall_s), middle(&times.cpu_s));
        println!("{engine} {mode}: median of {frames}: {wall:.2} ms, processor time {cpu:.2} ms");
    }
    Ok(())
}

struct Worker<'a> {
    name: &'a str,
    library: Option<&'a Path>,
    pools: Pools,
    engine: Option<Box<dyn Engine + Sync>>,
    threads: usize,
}

impl<'a> Worker<'a> {
    fn new(name: &'a str, library: Option<&'a Path>) -> Self {
        Self {
            name,
            library,
            pools: Pools::default(),
            engine: None,
            threads: 1,
        }
    }

    fn answer(&mut self, request: Request) -> Result<Value, String> {
        let value = match request {
            Request::Load {
                positions,
                triangles,
                view,
                threads,
            } => {
                let files = Files { positions, triangles };
                serde_json::to_value(self.load(&files, &view, threads)?)
            }
            Request::Frames { mode, threads, count } => {
                serde_json::to_value(self.frames(&mode, threads, count)?)
            }
            Request::Depth { mode, path } => {
                let depth = self.frame(&mode, self.threads)?;
                triangles::write_depth(&path, &depth)
                    .map_err(|error| format!("{}: {error}", path.display()))?;
                Ok(json!({}))
            }
        };
        value.map_err(|error| error.to_string())
    }

    fn load(&mut self, files: &Files, view: &ViewJson, threads: usize) -> Result<Loaded, String> {
        let before = process::resident_bytes();
        let mesh = files
            .read()
            .map_err(|error| format!("{}: {error}", files.positions.display()))?;
        self.threads = threads;
        let (name, library) = (self.name, self.library);
        let start = Instant::now();
        let engine = self
            .pools
            .run(threads, || -> Result<Box<dyn Engine + Sync + Send>, String> {
                Ok(match name {
                    "raster" => Box::new(Ours::build(Backend::Raster, mesh, view)),
                    "ray" => Box::new(Ours::build(Backend::Ray, mesh, view)),
                    #[cfg(target_os = "linux")]
                    "embree" => {
                        let library = library.ok_or("Embree's library was not found")?;
                        Box::new(Embree::build(library, mesh, view, threads)?)
                    }
                    _ => {
                        return Err(format!(
                            "unknown engine {name}; expected one of raster, ray, embree"
                        ));
                    }
                })
            })??;
        let build_s = start.elapsed().as_secs_f64();
        let modes = engine.modes();
        self.engine = Some(engine);
        for mode in &modes {
            self.frame(mode, threads)?;
        }
        Ok(Loaded {
            modes,
            build_s,
            resident_bytes: process::resident_bytes().saturating_sub(before),
            peak_bytes: process::peak_bytes().saturating_sub(before),
        })
    }

    fn frames(&mut self, mode: &str, threads: usize, count: usize) -> Result<Frames, String> {
        let mut frames = Frames::default();
        for _ in 0..count {
            // Dropping the frame is not timed.
            let (depth, elapsed) = process::timed(|| self.frame(mode, threads));
            depth?;
            frames.wall_s.push(elapsed.wall_s);
            frames.cpu_s.push(elapsed.cpu_s);
        }
        Ok(frames)
    }

    fn frame(&mut self, mode: &str, threads: usize) -> Result<Vec<f32>, String> {
        let engine = self.engine.as_deref().ok_or("nothing is loaded")?;
        self.pools.run(threads, || engine.frame(mode))
    }
}
