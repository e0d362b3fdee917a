//! The routes of the server.

use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use axum::body::{Body, Bytes};
use axum::extract::{Path, Query, Request, State, WebSocketUpgrade};
use axum::http::{HeaderMap, StatusCode, header};
use axum::middleware::{Next, from_fn_with_state};
use axum::response::Response;
use axum::routing::{get, post};
use oaktwin::depth::parameters::choose;
use oaktwin::render::OpenOptions;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use tokio::time::timeout;

use crate::answer::{binary, failure, file_or_failure, json, json_or_failure};
use crate::catalog::CatalogInfo;
use crate::coverage::{CoverageRequest, SurfaceRequest};
use crate::file::File;
use crate::job::{Budget, Job};
use crate::motion::MotionRequest;
use crate::protocol::{ExportRequest, Failure, OakState};
use crate::scene::LoadedScene;
use crate::session::{SaveRequest, SessionInfo};
use crate::studio::Studio;
use crate::{
    accuracy, calibration, coverage, dropped_robot, export, guard, job, live, mesh, motion, page, postures,
    session, trajectory, upload,
};

/// The maximum length of a request's JSON, and of a calibration, bytes.
const MAX_JSON_BYTES: usize = 1 << 20;
/// How long the JSON of a request, or a calibration, may take to arrive.
const JSON_TIME: Duration = Duration::from_secs(60);
/// The maximum number of triangles in a mesh of the page: its full detail.
const MAX_TRIANGLES: usize = 5_000_000;
/// The number of triangles of the mesh that a page shows first.
pub(crate) const DEFAULT_TRIANGLES: usize = 100_000;

type Server = State<Arc<Studio>>;

/// Returns the routes.
pub(crate) fn router(studio: &Arc<Studio>) -> Router {
    Router::new()
        .route("/", get(page::html))
        .route("/studio.js", get(page::script))
        .route("/studio.css", get(page::style))
        .route("/licenses.txt", get(page::licenses))
        .route("/api/catalog", get(catalog))
        .route("/api/scenes", post(drop_scene))
        .route("/api/robots", post(drop_robot))
        .route("/api/scenes/{id}", get(scene))
        .route("/api/scenes/{id}/mesh", get(scene_mesh))
        .route("/api/scenes/{id}/textures", get(scene_textures))
        .route("/api/calibrations", post(drop_calibration))
        .route("/api/trajectories", post(drop_trajectory))
        .route("/api/trajectories/{id}", get(known_trajectory))
        .route("/api/motions", post(drop_motion))
        .route("/api/motions/{id}", get(known_motion))
        .route("/api/motions/coverage", post(motion_coverage))
        .route("/api/motions/command", post(motion_command))
        .route("/api/session/save", post(save_session))
        .route("/api/session/open", post(open_session))
        .route("/api/models/{name}/body", get(body_mesh))
        .route("/api/export", post(take_away))
        .route("/api/accuracy", post(accuracy_curve))
        .route("/api/coverage", post(region_coverage))
        .route("/api/coverage/surface", post(region_surface))
        .route("/api/live", get(live_socket))
        .fallback(async || {
            failure(
                StatusCode::NOT_FOUND,
                Failure::from("there is no such page; open /".to_owned()),
            )
        })
        .layer(from_fn_with_state(Arc::clone(studio), admit))
        .layer(from_fn_with_state(studio.guard.clone(), guard::guard))
        .with_state(Arc::clone(studio))
}

/// Answers a request unless too many others wait for their answers.
async fn admit(State(studio): Server, request: Request, next: Next) -> Response {
    match studio.requests.try_acquire() {
        Ok(_admitted) => next.run(request).await,
        Err(_) => failure(StatusCode::SERVICE_UNAVAILABLE, too_many()),
    }
}

fn too_many() -> Failure {
    Failure::from("too many requests wait for their answers; try again later".to_owned())
}

async fn catalog(State(studio): Server) -> Response {
    let first = &studio.scenes.first().info.id;
    json(&CatalogInfo::new(
        &studio.catalog,
        first,
        &studio.model,
        upload::MAX_BYTES,
    ))
}

async fn scene(State(studio): Server, Path(id): Path<String>) -> Response {
    let found = move |studio: &Studio, _: &Job| Ok(studio.scenes.still(&id)?.info.clone());
    match job::run(&studio, job::VIEW, found).await {
        Ok(info) => json(&info),
        Err(error) => failure(StatusCode::NOT_FOUND, error),
    }
}

#[derive(Deserialize)]
struct MeshQuery {
    triangles: Option<usize>,
}

async fn scene_mesh(
    State(studio): Server,
    Path(id): Path<String>,
    Query(query): Query<MeshQuery>,
) -> Response {
    let triangles = query
        .triangles
        .unwrap_or(DEFAULT_TRIANGLES)
        .clamp(1, MAX_TRIANGLES);
    let made = move |studio: &Studio, job: &Job| studio.scenes.get(&id)?.mesh(triangles, job);
    match job::run(&studio, job::VIEW, made).await {
        Ok(bytes) => binary(bytes),
        Err(error) => failure(StatusCode::UNPROCESSABLE_ENTITY, error),
    }
}

async fn scene_textures(State(studio): Server, Path(id): Path<String>) -> Response {
    let made = move |studio: &Studio, job: &Job| studio.scenes.get(&id)?.textures(job);
    match job::run(&studio, job::VIEW, made).await {
        Ok(bytes) => binary(bytes),
        Err(error) => failure(StatusCode::UNPROCESSABLE_ENTITY, error),
    }
}

async fn body_mesh(State(studio): Server, Path(name): Path<String>) -> Response {
    match studio.catalog.device(&name) {
        Ok(device) => binary(mesh::of_body(&studio.catalog.nominal(device))),
        Err(error) => failure(StatusCode::NOT_FOUND, Failure::of("model", &error)),
    }
}

#[derive(Deserialize)]
struct DropQuery {
    name: String,
    /// The up axis and the metres per unit of a mesh file; its format's, and 1, by default.
    up: Option<String>,
    scale: Option<f64>,
}

impl DropQuery {
    fn open_options(&self) -> Result<OpenOptions, Failure> {
        let up = self.up.as_deref().map(|up| choose("up", up)).transpose();
        let up = up.map_err(|error| Failure::of("up", &error))?;
        if let Some(scale) = self.scale.filter(|scale| !(scale.is_finite() && *scale > 0.0)) {
            let error = format!("scale: must be a finite number > 0 (got {scale})");
            return Err(Failure::of("scale", &error));
        }
        Ok(OpenOptions {
            up,
            scale: self.scale,
            ..OpenOptions::default()
        })
    }
}

async fn drop_scene(
    State(studio): Server,
    Query(query): Query<DropQuery>,
    headers: HeaderMap,
    body: Body,
) -> Response {
    let length = headers
        .get(header::CONTENT_LENGTH)
        .and_then(|value| value.to_str().ok()?.parse().ok());
    if length.is_some_and(|length: u64| length > upload::MAX_BYTES) {
        return failure(
            StatusCode::PAYLOAD_TOO_LARGE,
            upload::too_large(upload::MAX_BYTES),
        );
    }
    json_or_failure(dropped_scene(studio, &query, body).await)
}

async fn dropped_scene(
    studio: Arc<Studio>,
    query: &DropQuery,
    body: Body,
) -> Result<crate::protocol::SceneInfo, Failure> {
    let name = upload::file_name(&query.name)?;
    let options = query.open_options()?;
    let folder = upload::folder(&studio.uploads)?;
    let path = folder.path().join(&name);
    // Few at once, because each takes space on the disk.
    let receiving = studio.receiving.acquire().await;
    upload::receive(body, &path, upload::MAX_BYTES).await?;
    drop(receiving);
    job::run(&studio, job::FILE, move |studio, _| {
        let id = upload::content_id(&name, &options, &path)?;
        if let Some(known) = studio.scenes.dropped(&id) {
            return Ok(known.info.clone());
        }
        let scene = LoadedScene::open(&path, &options, (&id, &name, &name))?;
        scene.check_triangles()?;
        Ok(studio.scenes.add(scene.keeping(folder)?).info.clone())
    })
    .await
}

#[derive(Deserialize)]
struct RobotQuery {
    name: String,
    /// The scene that a robot is put into, or whose robot a list of postures is for.
    scene: String,
}

/// Receives a small file, `kind`, and answers with what the page knows about it.
async fn dropped<T: Serialize + Send + 'static>(
    studio: Arc<Studio>,
    name: String,
    body: Body,
    (limit, kind): (usize, &str),
    read: impl FnOnce(&Studio, &str, Bytes) -> Result<T, Failure> + Send + 'static,
) -> Response {
    let Ok(Ok(bytes)) = timeout(JSON_TIME, axum::body::to_bytes(body, limit)).await else {
        let error = format!("the dropped file is too large for {kind}");
        return failure(StatusCode::PAYLOAD_TOO_LARGE, Failure::from(error));
    };
    let read = move |studio: &Studio, _: &Job| read(studio, &upload::file_name(&name)?, bytes);
    json_or_failure(job::run(&studio, job::FILE, read).await)
}

/// Puts a dropped robot into a scene, which becomes another one.
async fn drop_robot(State(studio): Server, Query(query): Query<RobotQuery>, body: Body) -> Response {
    let kind = "a robot, or did not arrive; drop a URDF or MJCF file";
    let limits = (dropped_robot::MAX_BYTES, kind);
    dropped(studio, query.name, body, limits, move |studio, name, bytes| {
        dropped_robot::dropped(studio, &query.scene, name, &bytes)
    })
    .await
}

async fn drop_calibration(State(studio): Server, Query(query): Query<DropQuery>, body: Body) -> Response {
    let kind = "a calibration, or did not arrive; drop the JSON file of one device";
    let limits = (MAX_JSON_BYTES, kind);
    dropped(studio, query.name, body, limits, |studio, name, bytes| {
        let read = calibration::Dropped::read(&studio.catalog, name, bytes.into())?;
        Ok(studio.calibrations.add(read))
    })
    .await
}

async fn drop_trajectory(State(studio): Server, Query(query): Query<DropQuery>, body: Body) -> Response {
    let limits = (
        trajectory::MAX_BYTES,
        "a trajectory, or did not arrive; drop a part of it",
    );
    dropped(studio, query.name, body, limits, |studio, name, bytes| {
        let read = trajectory::Dropped::read(name, bytes.into())?;
        Ok(studio.trajectories.add(read))
    })
    .await
}

async fn known_trajectory(State(studio): Server, Path(id): Path<String>) -> Response {
    match studio.trajectories.get(&id) {
        Ok(dropped) => json(&dropped.info),
        Err(error) => failure(StatusCode::NOT_FOUND, error),
    }
}

async fn drop_motion(State(studio): Server, Query(query): Query<RobotQuery>, body: Body) -> Response {
    let kind = "a list of postures, or did not arrive; drop a part of it, or use `oaktwin coverage --joints`";
    let limits = (postures::MAX_BYTES, kind);
    dropped(studio, query.name, body, limits, move |studio, name, bytes| {
        let scene = studio.scenes.get(&query.scene)?;
        let read = postures::Dropped::read(&scene, name, bytes.into())?;
        Ok(studio.motions.add(read))
    })
    .await
}

async fn known_motion(State(studio): Server, Path(id): Path<String>) -> Response {
    match studio.motions.get(&id) {
        Ok(dropped) => json(&dropped.info),
        Err(error) => failure(StatusCode::NOT_FOUND, error),
    }
}

/// Measures the coverage over a list of postures, and says meanwhile how many are done.
async fn motion_coverage(State(studio): Server, body: Body) -> Response {
    let Ok(permit) = Arc::clone(&studio.requests).try_acquire_owned() else {
        return failure(StatusCode::SERVICE_UNAVAILABLE, too_many());
    };
    match request::<MotionRequest>(body).await {
        Ok(asked) => binary(Body::from_stream(motion::lines(studio, asked, permit))),
        Err(error) => failure(StatusCode::UNPROCESSABLE_ENTITY, error),
    }
}

async fn motion_command(State(studio): Server, body: Body) -> Response {
    let made = computed(&studio, job::FILE, body, |studio, _, asked: MotionRequest| {
        motion::command(studio, &asked)
    });
    file_or_failure(made.await.map(|text| File::text("coverage.sh", text)))
}

async fn save_session(State(studio): Server, body: Body) -> Response {
    let made = computed(&studio, job::FILE, body, |studio, _, asked: SaveRequest| {
        session::save(studio, asked)
    });
    file_or_failure(made.await)
}

async fn open_session(State(studio): Server, Query(query): Query<DropQuery>, body: Body) -> Response {
    json_or_failure(opened_session(studio, &query, body).await)
}

async fn opened_session(studio: Arc<Studio>, query: &DropQuery, body: Body) -> Result<SessionInfo, Failure> {
    let name = upload::file_name(&query.name)?;
    let folder = upload::folder(&studio.uploads)?;
    let path = folder.path().join("session");
    let receiving = studio.receiving.acquire().await;
    upload::receive(body, &path, session::MAX_BYTES).await?;
    drop(receiving);
    job::run(&studio, job::FILE, move |studio, _| {
        let opened = session::open(studio, &path, &name);
        drop(folder);
        opened
    })
    .await
}

async fn take_away(State(studio): Server, body: Body) -> Response {
    let made = computed(&studio, job::FILE, body, |studio, _, asked: ExportRequest| {
        export::export(studio, &asked)
    });
    file_or_failure(made.await)
}

async fn accuracy_curve(State(studio): Server, body: Body) -> Response {
    let made = computed(&studio, job::ACCURACY, body, |studio, job, state: OakState| {
        accuracy::curve(studio, &state, job)
    });
    json_or_failure(made.await)
}

async fn region_coverage(State(studio): Server, body: Body) -> Response {
    let made = computed(
        &studio,
        job::COVERAGE,
        body,
        |studio, job, asked: CoverageRequest| job.in_full(|| coverage::coverage(studio, &asked, job)),
    );
    json_or_failure(made.await)
}

async fn region_surface(State(studio): Server, body: Body) -> Response {
    let made = computed(&studio, job::FILE, body, |studio, _, asked: SurfaceRequest| {
        coverage::surface(studio, &asked)
    });
    match made.await {
        Ok(bytes) => binary(bytes),
        Err(error) => failure(StatusCode::UNPROCESSABLE_ENTITY, error),
    }
}

/// Computes the answer to the request in a body.
async fn computed<R: DeserializeOwned + Send + 'static, T: Send + 'static>(
    studio: &Arc<Studio>,
    budget: Budget,
    body: Body,
    compute: impl FnOnce(&Studio, &Job, R) -> Result<T, Failure> + Send + 'static,
) -> Result<T, Failure> {
    let asked = request::<R>(body).await?;
    job::run(studio, budget, move |studio, job| compute(studio, job, asked)).await
}

async fn live_socket(State(studio): Server, upgrade: WebSocketUpgrade) -> Response {
    let Ok(page) = studio.page() else {
        let error = "too many pages are open; close some".to_owned();
        return failure(StatusCode::SERVICE_UNAVAILABLE, Failure::from(error));
    };
    upgrade
        .max_message_size(live::MAX_MESSAGE_BYTES)
        .max_frame_size(live::MAX_MESSAGE_BYTES)
        .on_upgrade(async move |socket| {
            live::serve(socket, studio).await;
            drop(page);
        })
}

/// Reads the JSON of a request.
async fn request<T: DeserializeOwned>(body: Body) -> Result<T, Failure> {
    let late = |_| Failure::from("the request did not arrive; try again".to_owned());
    let bytes = timeout(JSON_TIME, axum::body::to_bytes(body, MAX_JSON_BYTES)).await;
    let bytes = bytes.map_err(late)?;
    let bytes = bytes.map_err(|error| Failure::from(format!("the request cannot be read: {error}")))?;
    serde_json::from_slice(&bytes)
        .map_err(|error| Failure::from(format!("invalid request: {error}; load the page again")))
}
