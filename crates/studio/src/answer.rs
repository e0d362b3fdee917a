//! Answers over HTTP.

use axum::body::Body;
use axum::http::StatusCode;
use axum::http::header::{self, HeaderName};
use axum::response::{IntoResponse, Response};
use serde::Serialize;

use crate::file::File;
use crate::protocol::Failure;

/// Answers with JSON.
pub(crate) fn json(value: &impl Serialize) -> Response {
    json_with(StatusCode::OK, value)
}

/// Answers with an error that the page shows.
pub(crate) fn failure(status: StatusCode, error: impl Into<Failure>) -> Response {
    json_with(status, &error.into())
}

/// Answers with a value or, if there is none, with what is wrong with the request.
pub(crate) fn json_or_failure(result: Result<impl Serialize, Failure>) -> Response {
    match result {
        Ok(value) => json(&value),
        Err(error) => failure(StatusCode::UNPROCESSABLE_ENTITY, error),
    }
}

/// Answers with a file, or with an error.
pub(crate) fn file_or_failure(result: Result<File, Failure>) -> Response {
    match result {
        Ok(made) => file(made),
        Err(error) => failure(StatusCode::UNPROCESSABLE_ENTITY, error),
    }
}

/// Answers with bytes.
pub(crate) fn binary(bytes: impl Into<Body>) -> Response {
    ([(header::CONTENT_TYPE, "application/octet-stream")], bytes.into()).into_response()
}

/// Answers with a file to be saved under a name. A header has the findings, as JSON in ASCII.
fn file(file: File) -> Response {
    let File {
        name,
        bytes,
        findings,
    } = file;
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "._-".contains(letter);
    let name: String = name
        .chars()
        .map(|letter| if is_plain(letter) { letter } else { '_' })
        .collect();
    let headers = [
        (header::CONTENT_TYPE, "application/octet-stream".to_owned()),
        (
            header::CONTENT_DISPOSITION,
            format!("attachment; filename=\"{name}\""),
        ),
        (HeaderName::from_static("x-findings"), ascii(&findings)),
    ];
    (headers, bytes).into_response()
}

/// Writes JSON in which all characters outside ASCII are escaped.
fn ascii(value: &impl Serialize) -> String {
    let json = serde_json::to_string(value).unwrap_or_default();
    let mut units = [0; 2];
    json.chars()
        .map(|letter| match letter.is_ascii() {
            true => letter.to_string(),
            false => letter
                .encode_utf16(&mut units)
                .iter()
                .map(|unit| format!("\\u{unit:04x}"))
                .collect(),
        })
        .collect()
}

fn json_with(status: StatusCode, value: &impl Serialize) -> Response {
    match serde_json::to_vec(value) {
        Ok(bytes) => (status, [(header::CONTENT_TYPE, "application/json")], bytes).into_response(),
        Err(error) => (StatusCode::INTERNAL_SERVER_ERROR, error.to_string()).into_response(),
    }
}
