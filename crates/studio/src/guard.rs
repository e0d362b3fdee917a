//! Which requests are answered.
//!
//! A server on the local machine can be reached by every page that its browser shows: by a name that resolves to this machine
//! (DNS rebinding), or across sites. So every route requires the server's own `Host`, and an `Origin`, if there is one, that
//! matches it. Beyond the local machine, a token is required too.

use std::net::SocketAddr;

use axum::extract::{Request, State};
use axum::http::StatusCode;
use axum::http::header::{self, HeaderMap, HeaderName, HeaderValue};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use crate::answer::failure;
use crate::protocol::Failure;

const COOKIE: &str = "oaktwin-studio";
const POLICY: &str = "default-src 'self'; img-src 'self' blob: data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Who may talk to the server.
#[derive(Clone, Debug)]
pub(crate) struct Guard {
    /// The accepted hosts; empty if any is, with a token.
    hosts: Vec<String>,
    token: Option<String>,
}

impl Guard {
    /// Creates the guard of a server at an address; a token is required if there is one.
    pub(crate) fn new(address: SocketAddr, token: Option<String>) -> Self {
        let port = address.port();
        let hosts = match &token {
            Some(_) => Vec::new(),
            None => ["127.0.0.1", "localhost", "[::1]"]
                .iter()
                .map(|host| format!("{host}:{port}"))
                .collect(),
        };
        Self { hosts, token }
    }

    /// Checks the headers and the query of a request.
    fn check(&self, headers: &HeaderMap, query: Option<&str>) -> Result<(), &'static str> {
        let host = single(headers, &header::HOST)?.ok_or("a request without a Host header")?;
        if self.token.is_none() && !self.hosts.iter().any(|own| own == host) {
            return Err("a request for another host");
        }
        match single(headers, &header::ORIGIN)? {
            Some(origin) if origin.strip_prefix("http://") != Some(host) => {
                return Err("a request from another site");
            }
            _ => {}
        }
        let Some(token) = &self.token else {
            return Ok(());
        };
        let cookies = headers
            .get_all(header::COOKIE)
            .into_iter()
            .filter_map(|value| value.to_str().ok());
        let cookie = cookies
            .flat_map(|cookies| cookies.split(';'))
            .find_map(|cookie| cookie.trim().strip_prefix(COOKIE)?.strip_prefix('='));
        match cookie.or(in_query(query)) {
            Some(given) if is_equal(given, token) => Ok(()),
            _ => Err("a request without the token of the printed link"),
        }
    }
}

/// The token in the query of a link.
fn in_query(query: Option<&str>) -> Option<&str> {
    query?.split('&').find_map(|pair| pair.strip_prefix("token="))
}

/// Compares without revealing by its duration how much is equal.
fn is_equal(a: &str, b: &str) -> bool {
    let different = a.bytes().zip(b.bytes()).fold(0, |sum, (a, b)| sum | (a ^ b));
    a.len() == b.len() && different == 0
}

/// Returns the value of a header that may occur once.
fn single<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Result<Option<&'a str>, &'static str> {
    let mut all = headers.get_all(name).into_iter();
    match (all.next(), all.next()) {
        (None, _) => Ok(None),
        (Some(value), None) => value
            .to_str()
            .map(Some)
            .map_err(|_| "a request with an unreadable header"),
        (Some(_), Some(_)) => Err("a request with a repeated header"),
    }
}

/// Answers a request if it may be, and adds the headers of all answers.
pub(crate) async fn guard(State(guard): State<Guard>, request: Request, next: Next) -> Response {
    let query = request.uri().query();
    let mut response = match guard.check(request.headers(), query) {
        Err(what) => {
            let error = format!("{what} is not answered; open the link that oaktwin studio prints");
            failure(StatusCode::FORBIDDEN, Failure::from(error))
        }
        Ok(()) => match (&guard.token, in_query(query)) {
            // The token moves from the address, which people copy, into a cookie.
            (Some(token), Some(_)) => remembered(token),
            _ => next.run(request).await,
        },
    };
    let headers = response.headers_mut();
    let mut set = |name, value| headers.insert(name, HeaderValue::from_static(value));
    set(header::CACHE_CONTROL, "no-store");
    set(header::CONTENT_SECURITY_POLICY, POLICY);
    set(header::REFERRER_POLICY, "no-referrer");
    set(header::X_CONTENT_TYPE_OPTIONS, "nosniff");
    set(
        HeaderName::from_static("cross-origin-resource-policy"),
        "same-origin",
    );
    response
}

fn remembered(token: &str) -> Response {
    let cookie = format!("{COOKIE}={token}; HttpOnly; SameSite=Strict; Path=/");
    (
        StatusCode::SEE_OTHER,
        [(header::LOCATION, "/".to_owned()), (header::SET_COOKIE, cookie)],
    )
        .into_response()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn headers(all: &[(&'static str, &'static str)]) -> HeaderMap {
        let mut headers = HeaderMap::new();
        for (name, value) in all {
            headers.append(HeaderName::from_static(name), HeaderValue::from_static(value));
        }
        headers
    }

    fn local() -> Guard {
        Guard::new(([127, 0, 0, 1], 8080).into(), None)
    }

    #[test]
    fn accepts_its_own_page_and_scripts() {
        for host in ["127.0.0.1:8080", "localhost:8080", "[::1]:8080"] {
            assert!(local().check(&headers(&[("host", host)]), None).is_ok());
        }
        let own = headers(&[("host", "localhost:8080"), ("origin", "http://localhost:8080")]);
        assert!(local().check(&own, None).is_ok());
    }

    #[test]
    fn rejects_other_hosts_and_sites() {
        for wrong in [
            &[][..],
            &[("host", "evil.test:8080")],
            &[("host", "127.0.0.1")],
            &[("host", "127.0.0.1:8081")],
            &[("host", "127.0.0.1:8080.evil.test")],
            &[("host", "127.0.0.1:8080"), ("host", "127.0.0.1:8080")],
            &[("host", "127.0.0.1:8080"), ("origin", "null")],
            &[("host", "127.0.0.1:8080"), ("origin", "https://127.0.0.1:8080")],
            &[("host", "127.0.0.1:8080"), ("origin", "http://127.0.0.1:8081")],
            &[("host", "127.0.0.1:8080"), ("origin", "http://localhost:8080")],
        ] {
            assert!(local().check(&headers(wrong), None).is_err(), "{wrong:?}");
        }
    }

    #[test]
    fn requires_the_token_beyond_this_machine() {
        let guard = Guard::new(([0, 0, 0, 0], 80).into(), Some("secret".to_owned()));
        let with = |all: &[(&'static str, &'static str)], query| guard.check(&headers(all), query).is_ok();
        assert!(with(&[("host", "robot:80")], Some("token=secret")));
        assert!(with(
            &[("host", "robot:80"), ("cookie", "a=b; oaktwin-studio=secret")],
            None
        ));
        assert!(!with(&[("host", "robot:80")], None));
        assert!(!with(&[("host", "robot:80")], Some("token=secre")));
        assert!(!with(
            &[("host", "robot:80"), ("cookie", "oaktwin-studio=other")],
            Some("token=secret")
        ));
        assert!(!with(
            &[("host", "robot:80"), ("origin", "http://evil.test")],
            Some("token=secret")
        ));
    }
}
