//! The state that all pages share.

use std::borrow::Cow;
use std::path::PathBuf;
use std::sync::Arc;

use oaktwin::catalog::Catalog;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, TryAcquireError, watch};

use crate::calibration::Calibrations;
use crate::curves::Curves;
use crate::guard::Guard;
use crate::postures::Motions;
use crate::scene::Scenes;
use crate::trajectory::Trajectories;

/// The number of frames that are computed at the same time, each of which uses all cores.
const COMPUTING: usize = 2;
/// The number of other computations that run at the same time: meshes, files to be saved, curves and coverages.
const JOBS: usize = 4;
/// The number of files that are received at the same time, each of which takes space on the disk.
const UPLOADS: usize = 2;
/// The number of requests that are received, computed or wait.
const MAX_REQUESTS: usize = 64;
/// The number of pages that can be open.
const MAX_PAGES: usize = 32;

/// The state of the server.
#[derive(Debug)]
pub(crate) struct Studio {
    pub(crate) catalog: Cow<'static, Catalog>,
    /// The model that is shown first.
    pub(crate) model: String,
    pub(crate) scenes: Scenes,
    pub(crate) calibrations: Calibrations,
    pub(crate) trajectories: Trajectories,
    pub(crate) motions: Motions,
    pub(crate) curves: Curves,
    pub(crate) guard: Guard,
    /// The folder for files that are being received, which is removed when the server ends.
    pub(crate) uploads: PathBuf,
    pub(crate) computing: Arc<Semaphore>,
    pub(crate) jobs: Arc<Semaphore>,
    pub(crate) receiving: Semaphore,
    pub(crate) requests: Arc<Semaphore>,
    pages: Arc<Semaphore>,
    stop: watch::Sender<bool>,
}

impl Studio {
    pub(crate) fn new(
        catalog: Cow<'static, Catalog>,
        model: String,
        scenes: Scenes,
        guard: Guard,
        uploads: PathBuf,
    ) -> Self {
        Self {
            catalog,
            model,
            scenes,
            calibrations: Calibrations::default(),
            trajectories: Trajectories::default(),
            motions: Motions::default(),
            curves: Curves::default(),
            guard,
            uploads,
            computing: Arc::new(Semaphore::new(COMPUTING)),
            jobs: Arc::new(Semaphore::new(JOBS)),
            receiving: Semaphore::new(UPLOADS),
            requests: Arc::new(Semaphore::new(MAX_REQUESTS)),
            pages: Arc::new(Semaphore::new(MAX_PAGES)),
            stop: watch::Sender::new(false),
        }
    }

    /// Admits a page for as long as the permit lives, unless too many are open.
    pub(crate) fn page(&self) -> Result<OwnedSemaphorePermit, TryAcquireError> {
        Arc::clone(&self.pages).try_acquire_owned()
    }

    /// Asks everything that waits for [`Studio::stopped`] to end.
    pub(crate) fn stop(&self) {
        self.stop.send_replace(true);
    }

    /// Becomes true when the server stops.
    pub(crate) fn stopping(&self) -> watch::Receiver<bool> {
        self.stop.subscribe()
    }

    /// Completes when the server stops.
    pub(crate) async fn stopped(&self) {
        let mut stop = self.stop.subscribe();
        // The sender lives as long as `self`.
        let _ = stop.wait_for(|stop| *stop).await;
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::scene::LoadedScene;

    use oaktwin::render::OpenOptions;

    /// The state of a server that shows a triangle, without a network.
    pub(crate) fn studio() -> Arc<Studio> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("triangle.obj");
        std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        let scene = LoadedScene::open(&path, &OpenOptions::default(), ("first", "a", "a")).unwrap();
        Arc::new(Studio::new(
            Cow::Borrowed(Catalog::builtin()),
            "OAK4-D".to_owned(),
            Scenes::new(scene),
            Guard::new(([127, 0, 0, 1], 8080).into(), None),
            std::env::temp_dir(),
        ))
    }
}
