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

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    /// What turns a text into elements or into a script.
    const MAKERS: [&str; 9] = [
        "innerHTML",
        "outerHTML",
        "insertAdjacentHTML",
        "dangerouslySetInnerHTML",
        "document.write",
        "srcdoc",
        "DOMParser",
        "eval(",
        "new Function",
    ];

    fn check(folder: &Path, files: &mut u32) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                check(&path, files);
                continue;
            }
            *files += 1;
            let text = fs::read_to_string(&path).unwrap();
            for maker in MAKERS {
                assert!(!text.contains(maker), "{}: {maker}", path.display());
            }
        }
    }

    #[test]
    fn the_page_makes_no_html_of_text() {
        let mut files = 0;
        check(
            &Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/src"),
            &mut files,
        );
        assert!(files > 30, "{files} files");
    }
}
