//! The routes of the server.

use std::sync::Arc;

use axum::Router;
use axum::body::Body;
use axum::extract::{Path, Query, State, WebSocketUpgrade};
use axum::http::{HeaderMap, StatusCode, header};
use axum::middleware::from_fn_with_state;
use axum::response::Response;
use axum::routing::{get, post};
use oaktwin::render::OpenOptions;
use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::answer::{binary, failure, file, json, json_or_failure};
use crate::blocking::{Presence, blocking};
use crate::catalog::CatalogInfo;
use crate::coverage::{CoverageRequest, SurfaceRequest};
use crate::protocol::{ExportRequest, Failure, OakState};
use crate::scene::LoadedScene;
use crate::studio::Studio;
use crate::{accuracy, coverage, export, guard, live, mesh, page, upload};

/// The maximum length of a request's JSON, and of a calibration, bytes.
const MAX_JSON_BYTES: usize = 1 << 20;
/// The maximum number of triangles in a mesh of the page.
const MAX_TRIANGLES: usize = 10_000_000;
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
        .route("/api/scenes/{id}", get(scene))
        .route("/api/scenes/{id}/mesh", get(scene_mesh))
        .route("/api/calibrations", post(drop_calibration))
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
        .layer(from_fn_with_state(studio.guard.clone(), guard::guard))
        .with_state(Arc::clone(studio))
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
    match studio.scenes.get(&id) {
        Ok(scene) => json(&scene.info),
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
    match studio.scenes.get(&id) {
        Ok(scene) => match blocking(move || Ok(scene.mesh(triangles))).await {
            Ok(bytes) => binary(bytes),
            Err(error) => failure(StatusCode::INTERNAL_SERVER_ERROR, error),
        },
        Err(error) => failure(StatusCode::NOT_FOUND, error),
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
    json_or_failure(dropped_scene(studio, &query.name, body).await)
}

async fn dropped_scene(
    studio: Arc<Studio>,
    name: &str,
    body: Body,
) -> Result<crate::protocol::SceneInfo, Failure> {
    let name = upload::file_name(name)?;
    let folder = tempfile::tempdir_in(&studio.uploads).map_err(|error| {
        Failure::from(format!(
            "no temporary folder can be created ({error}); free space on the disk"
        ))
    })?;
    let path = folder.path().join(&name);
    upload::receive(body, &path, upload::MAX_BYTES).await?;
    blocking(move || {
        let id = studio.scenes.next_id();
        let scene = LoadedScene::open(&path, &OpenOptions::default(), (&id, &name, &name))?;
        // Files that the scene names are not beside it; whatever it contains is in memory now.
        drop(folder);
        Ok(studio.scenes.add(scene).info.clone())
    })
    .await
}

async fn drop_calibration(State(studio): Server, Query(query): Query<DropQuery>, body: Body) -> Response {
    let Ok(bytes) = axum::body::to_bytes(body, MAX_JSON_BYTES).await else {
        let error =
            "the dropped file is too large for a calibration; drop the JSON file of one device".to_owned();
        return failure(StatusCode::PAYLOAD_TOO_LARGE, Failure::from(error));
    };
    json_or_failure(
        blocking(move || {
            let name = upload::file_name(&query.name)?;
            studio.calibrations.add(&studio.catalog, &name, &bytes)
        })
        .await,
    )
}

async fn take_away(State(studio): Server, body: Body) -> Response {
    let made = match request::<ExportRequest>(body).await {
        Ok(request) => blocking(move || export::export(&studio, &request)).await,
        Err(error) => Err(error),
    };
    match made {
        Ok(made) => file(made),
        Err(error) => failure(StatusCode::UNPROCESSABLE_ENTITY, error),
    }
}

async fn accuracy_curve(State(studio): Server, body: Body) -> Response {
    let state = request::<OakState>(body).await;
    json_or_failure(match state {
        Ok(state) => blocking(move || accuracy::curve(&studio, &state)).await,
        Err(error) => Err(error),
    })
}

async fn region_coverage(State(studio): Server, body: Body) -> Response {
    let asked = request::<CoverageRequest>(body).await;
    // Dropped with this future if the client leaves.
    let (_here, has_left) = Presence::new();
    json_or_failure(match asked {
        Ok(asked) => blocking(move || coverage::coverage(&studio, &asked, &has_left)).await,
        Err(error) => Err(error),
    })
}

async fn region_surface(State(studio): Server, body: Body) -> Response {
    let made = match request::<SurfaceRequest>(body).await {
        Ok(asked) => blocking(move || coverage::surface(&studio, &asked)).await,
        Err(error) => Err(error),
    };
    match made {
        Ok(bytes) => binary(bytes),
        Err(error) => failure(StatusCode::UNPROCESSABLE_ENTITY, error),
    }
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
    let bytes = axum::body::to_bytes(body, MAX_JSON_BYTES).await;
    let bytes = bytes.map_err(|error| Failure::from(format!("the request cannot be read: {error}")))?;
    serde_json::from_slice(&bytes)
        .map_err(|error| Failure::from(format!("invalid request: {error}; load the page again")))
}
