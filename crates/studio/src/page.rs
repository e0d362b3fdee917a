//! The page itself, which `npm run build` in `web/` bundles.

use axum::http::header;
use axum::response::{IntoResponse, Response};

const HTML: &[u8] = include_bytes!("../dist/index.html");
const SCRIPT: &[u8] = include_bytes!("../dist/studio.js");
const LICENSES: &[u8] = include_bytes!("../dist/licenses.txt");
const STYLE: &[u8] = include_bytes!("../dist/studio.css");

pub(crate) async fn html() -> Response {
    asset("text/html; charset=utf-8", HTML)
}

pub(crate) async fn script() -> Response {
    asset("text/javascript; charset=utf-8", SCRIPT)
}

pub(crate) async fn style() -> Response {
    asset("text/css; charset=utf-8", STYLE)
}

/// The licences of the packages in the bundle.
pub(crate) async fn licenses() -> Response {
    asset("text/plain; charset=utf-8", LICENSES)
}

fn asset(content_type: &'static str, bytes: &'static [u8]) -> Response {
    ([(header::CONTENT_TYPE, content_type)], bytes).into_response()
}
