//! A server without a network.

use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::extract::ws::Message;
use axum::http::{Request, header};
use oaktwin::catalog::Catalog;
use oaktwin::render::OpenOptions;
use tokio::runtime::Runtime;
use tower_service::Service;

use crate::guard::Guard;
use crate::live::{self, Stations};
use crate::scene::{LoadedScene, Scenes};
use crate::studio::Studio;
use crate::{StudioError, server};

/// A server and one page, without a network: for tests of the protocol in one process.
#[derive(Debug)]
pub struct Offline {
    runtime: Runtime,
    router: Router,
    studio: Arc<Studio>,
    stations: Stations,
    /// Removed with the server.
    uploads: tempfile::TempDir,
}

impl Offline {
    /// Creates a server that shows a scene, whose id is `first`.
    ///
    /// # Errors
    /// Returns an error if the scene cannot be read, or the system has no threads.
    pub fn new(scene: &Path) -> Result<Self, StudioError> {
        let system = |error: std::io::Error| StudioError::System(error.to_string());
        let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build();
        let names = ("first", "scene", "scene");
        let scene = LoadedScene::open(scene, &OpenOptions::default(), names)
            .map_err(|failure| StudioError::Scene(failure.error))?;
        let uploads = tempfile::tempdir().map_err(system)?;
        let studio = Arc::new(Studio::new(
            Cow::Borrowed(Catalog::builtin()),
            "OAK4-D".to_owned(),
            Scenes::new(scene),
            Guard::new(([127, 0, 0, 1], 80).into(), None),
            uploads.path().to_owned(),
        ));
        Ok(Self {
            runtime: runtime.map_err(system)?,
            router: server::router(&studio),
            studio,
            stations: Stations::default(),
            uploads,
        })
    }

    /// Answers a request with the status and the body; `None` if the method or the address is none of HTTP.
    #[must_use]
    pub fn http(&self, method: &str, address: &str, body: Vec<u8>) -> Option<(u16, Vec<u8>)> {
        let request = Request::builder()
            .method(method)
            .uri(address)
            .header(header::HOST, "127.0.0.1:80")
            .body(Body::from(body))
            .ok()?;
        let mut router = self.router.clone();
        self.runtime.block_on(async {
            let Ok(response) = router.call(request).await;
            let status = response.status().as_u16();
            let body = to_bytes(response.into_body(), usize::MAX).await.ok()?;
            Some((status, body.to_vec()))
        })
    }

    /// Answers a message on the page's socket.
    #[must_use]
    pub fn message(&self, text: &str) -> Vec<u8> {
        let answer = match live::read(text) {
            Ok(request) => {
                let started = async { live::start(&self.studio, &self.stations, request).await };
                self.runtime.block_on(started).ok()
            }
            Err(rejected) => Some(rejected),
        };
        answer.map_or_else(Vec::new, |answer: Message| answer.into_data().to_vec())
    }

    /// The number of files that were received and are still there.
    #[must_use]
    pub fn uploads(&self) -> usize {
        std::fs::read_dir(self.uploads.path()).map_or(0, Iterator::count)
    }
}
