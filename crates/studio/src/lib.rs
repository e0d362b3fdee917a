//! The server of `oaktwin studio`: a local web page to choose, tune and place OAKs.
//!
//! [`serve`] answers a browser on the local machine. All numbers and images come from the crate `oaktwin`; this crate keeps what was
//! rendered, encodes it for the page and decides who may ask. The page's sources are in `web/`, and `web/src/protocol.ts`
//! documents the interface.

mod accuracy;
mod answer;
mod calibration;
mod catalog;
mod coverage;
mod curves;
mod dropped_robot;
mod export;
mod file;
mod frame;
mod guard;
mod image;
mod job;
mod kept;
mod live;
mod mesh;
mod motion;
mod oak;
mod offline;
mod page;
mod pose;
mod postures;
mod probe;
mod protocol;
mod reasons;
mod robot;
mod scene;
mod server;
mod session;
mod size;
mod snippet;
mod station;
mod statistics;
mod studio;
mod task;
mod trajectory;
#[cfg(test)]
mod typescript;
mod unit;
mod upload;
mod wire;

use std::borrow::Cow;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, UdpSocket};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use oaktwin::camera::RigidTransform;
use oaktwin::catalog::Catalog;
use oaktwin::render::OpenOptions;

use guard::Guard;
pub use offline::Offline;
pub use robot::RobotFile;
use scene::{LoadedScene, Scenes};
use studio::Studio;

/// How often a running server checks whether it should stop.
const POLL: Duration = Duration::from_millis(100);
/// The number of bytes of a token.
const TOKEN_BYTES: usize = 16;

/// The scene that is shown first.
#[derive(Clone, Debug)]
pub struct FirstScene {
    /// The file.
    pub path: PathBuf,
    /// The options of reading it.
    pub options: OpenOptions,
    /// The name on the page.
    pub name: String,
    /// The name on a command line.
    pub argument: String,
    /// The command that writes the file of this name, if it is not there yet.
    pub made_by: Option<String>,
    /// The pose of the body from which it is shown; by default an overview.
    pub world_from_body: Option<RigidTransform>,
    /// The robot in it.
    pub robot: Option<RobotFile>,
}

/// The options of a server.
#[derive(Clone, Debug)]
pub struct ServerOptions {
    /// The models.
    pub catalog: Cow<'static, Catalog>,
    /// The name of the model that is shown first.
    pub model: String,
    /// The scene that is shown first.
    pub scene: FirstScene,
    /// The address to listen on. Beyond the local machine, the link has a token.
    pub host: Option<IpAddr>,
    /// The port; 0 chooses a free one.
    pub port: u16,
}

/// An error that prevents the server from running.
#[derive(Debug, thiserror::Error)]
pub enum StudioError {
    /// The address is not available.
    #[error("{address}: cannot be listened on ({error}); choose another port, or 0 for any free one")]
    Address {
        /// The address.
        address: SocketAddr,
        /// The system's error.
        error: std::io::Error,
    },
    /// The scene cannot be read.
    #[error("{0}")]
    Scene(String),
    /// The system has no threads or random numbers.
    #[error("the server cannot be started: {0}")]
    System(String),
}

/// Serves the page until `is_stopped` returns true. `ready` is called with the link to the page as soon as it can be opened.
///
/// # Errors
/// Returns an error if the scene cannot be read or the address is not available.
pub fn serve(
    options: ServerOptions,
    ready: impl FnOnce(&str),
    is_stopped: impl Fn() -> bool,
) -> Result<(), StudioError> {
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build();
    let runtime = runtime.map_err(|error| StudioError::System(error.to_string()))?;
    let host = options.host.unwrap_or(IpAddr::V4(Ipv4Addr::LOCALHOST));
    let address = SocketAddr::new(host, options.port);
    let uploads = tempfile::Builder::new().prefix("oaktwin-studio-").tempdir();
    let uploads = uploads.map_err(|error| {
        StudioError::System(format!(
            "no temporary folder can be created ({error}); set TMPDIR to a writable folder"
        ))
    })?;
    let not_listening = |error| StudioError::Address { address, error };
    let served = runtime.block_on(async {
        let listener = tokio::net::TcpListener::bind(address)
            .await
            .map_err(not_listening)?;
        let address = listener.local_addr().map_err(not_listening)?;
        let token = (!host.is_loopback()).then(token).transpose()?;
        let link = link(address, token.as_deref());
        let first = options.scene;
        let scene = LoadedScene::open(
            &first.path,
            &first.options,
            ("first", &first.name, &first.argument),
        );
        let scene = scene.and_then(|scene| match &first.robot {
            Some(robot) => scene.with_robot(robot, "first", &robot.path.display().to_string()),
            None => Ok(scene),
        });
        let scene = scene.map_err(|failure| StudioError::Scene(failure.error))?;
        let scene = match first.world_from_body {
            Some(world_from_body) => scene.shown_from(pose::pose_of(&world_from_body)),
            None => scene,
        }
        .made_by(first.made_by);
        let guard = Guard::new(address, token);
        let studio = Arc::new(Studio::new(
            options.catalog,
            options.model,
            Scenes::new(scene),
            guard,
            uploads.path().to_owned(),
        ));
        let serving = axum::serve(listener, server::router(&studio)).into_future();
        ready(&link);
        // While the browser starts.
        let warm = Arc::clone(&studio);
        drop(tokio::spawn(async move {
            let mesh =
                |studio: &Studio, job: &job::Job| studio.scenes.first().mesh(server::DEFAULT_TRIANGLES, job);
            job::run(&warm, job::VIEW, mesh).await
        }));
        tokio::select! {
            ended = serving => ended.map_err(|error| StudioError::System(error.to_string())),
            () = until(is_stopped) => {
                studio.stop();
                Ok(())
            }
        }
    });
    // A frame that is being computed is not waited for.
    runtime.shutdown_background();
    served
}

async fn until(is_stopped: impl Fn() -> bool) {
    while !is_stopped() {
        tokio::time::sleep(POLL).await;
    }
}

/// The link to the page.
fn link(address: SocketAddr, token: Option<&str>) -> String {
    let host = match address.ip() {
        // Other machines need an address of this one.
        ip if ip.is_unspecified() => {
            SocketAddr::new(outward().unwrap_or(Ipv4Addr::LOCALHOST.into()), address.port())
        }
        ip => SocketAddr::new(ip, address.port()),
    };
    match token {
        Some(token) => format!("http://{host}/?token={token}"),
        None => format!("http://{host}/"),
    }
}

/// The address of this machine in its network. Nothing is sent: a datagram's socket only looks for a route.
fn outward() -> Option<IpAddr> {
    /// An address for documentation (RFC 5737).
    const ELSEWHERE: (Ipv4Addr, u16) = (Ipv4Addr::new(192, 0, 2, 1), 9);
    let socket = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0)).ok()?;
    socket.connect(ELSEWHERE).ok()?;
    let ip = socket.local_addr().ok()?.ip();
    (!ip.is_unspecified()).then_some(ip)
}

fn token() -> Result<String, StudioError> {
    let mut bytes = [0; TOKEN_BYTES];
    getrandom::fill(&mut bytes).map_err(|error| StudioError::System(error.to_string()))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
