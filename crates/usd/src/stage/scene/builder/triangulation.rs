//! Triangulates meshes on other threads while the stage is read.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};

use oaktwin_base::diagnostic::Finding;
use oaktwin_scene::Mesh;
use oaktwin_scene::polygon::PolygonMesh;

const MAX_THREADS: usize = 8;

struct Job {
    index: u32,
    polygons: PolygonMesh,
    path: String,
}

/// A mesh of the scene, and the findings about it.
pub(super) struct Triangulated {
    pub(super) index: u32,
    pub(super) mesh: Mesh,
    pub(super) findings: Vec<Finding>,
}

/// The meshes that are being triangulated. Separate threads, unlike a pool's, also work in a forked process.
pub(super) struct Triangulation {
    jobs: Sender<Job>,
    queue: Arc<Mutex<Receiver<Job>>>,
    max_threads: usize,
    threads: Vec<JoinHandle<Vec<Triangulated>>>,
    /// Meshes for which there was no thread.
    own: Vec<Triangulated>,
}

impl Default for Triangulation {
    fn default() -> Self {
        let (jobs, queue) = channel();
        let cores = thread::available_parallelism().map_or(1, NonZero::get);
        Self {
            jobs,
            queue: Arc::new(Mutex::new(queue)),
            // Threads would take most of the time of the fuzzer's small stages.
            max_threads: if cfg!(fuzzing) { 0 } else { cores.min(MAX_THREADS) },
            threads: Vec::new(),
            own: Vec::new(),
        }
    }
}

impl Triangulation {
    /// Begins to triangulate the mesh with this index in the scene.
    pub(super) fn begin(&mut self, index: u32, polygons: PolygonMesh, path: &str) {
        if self.threads.len() < self.max_threads {
            let queue = self.queue.clone();
            let named = thread::Builder::new().name("triangulation".to_owned());
            self.threads.extend(named.spawn(move || work(&queue)));
        }
        let job = Job {
            index,
            polygons,
            path: path.to_owned(),
        };
        if self.threads.is_empty() {
            self.own.push(job.run());
        } else {
            // The queue lives as long as this value.
            let _ = self.jobs.send(job);
        }
    }

    /// Returns all meshes, by index.
    pub(super) fn finish(self) -> Vec<Triangulated> {
        drop(self.jobs);
        let mut all = self.own;
        for thread in self.threads {
            all.extend(thread.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        all.sort_unstable_by_key(|done| done.index);
        all
    }
}

impl Job {
    fn run(self) -> Triangulated {
        let (mesh, findings) = self.polygons.into_mesh(&self.path);
        Triangulated {
            index: self.index,
            mesh,
            findings,
        }
    }
}

fn work(queue: &Mutex<Receiver<Job>>) -> Vec<Triangulated> {
    let mut done = Vec::new();
    loop {
        let next = queue.lock().unwrap_or_else(PoisonError::into_inner).recv();
        match next {
            Ok(job) => done.push(job.run()),
            Err(_) => return done,
        }
    }
}
