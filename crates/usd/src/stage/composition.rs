use oaktwin_base::diagnostic::{Finding, Level};
use openusd::{pcp, usd};

use super::error::one_line;

/// Returns the errors of the stage's composition, sorted and without duplicates.
pub(super) fn findings(stage: &usd::Stage) -> Vec<Finding> {
    let mut findings: Vec<Finding> = stage
        .composition_errors()
        .iter()
        .map(composition_finding)
        .collect();
    findings.sort_by(|a, b| (&a.place, &a.message).cmp(&(&b.place, &b.message)));
    findings.dedup();
    findings
}

fn composition_finding(error: &pcp::Error) -> Finding {
    use pcp::Error as E;
    let name = |arc: &pcp::ArcType| format!("{arc:?}").to_lowercase();
    let level = Level::Warning;
    let mut remedy = "put the file at that path, or correct the path; its content is missing";
    let (place, message) = match error {
        E::UnresolvedLayer {
            asset_path,
            arc,
            site_path,
            ..
        } => {
            let message = if let Some(url) = url(asset_path) {
                remedy = "download it next to the file and reference it there; its content is missing";
                format!("the {} @{url}@ is not a local file", name(arc))
            } else {
                format!("the {} @{asset_path}@ cannot be found", name(arc))
            };
            (site_path.to_string(), message)
        }
        E::MalformedLayer {
            asset_path,
            arc,
            site_path,
            reason,
            ..
        } => {
            let message = if reason.contains("no file format registered") {
                format!("the {} @{asset_path}@ is not a USD layer", name(arc))
            } else {
                let reason = reason.trim_start_matches("cannot be read: ");
                remedy =
                    "if OpenUSD reads it, convert it with `usdcat --out NEW.usdc`; its content is missing";
                format!("the {} @{asset_path}@ cannot be read: {reason}", name(arc))
            };
            (site_path.to_string(), message)
        }
        E::UnresolvedPrimPath {
            arc,
            target_layer,
            prim_path,
            site_path,
            ..
        } => (
            site_path.to_string(),
            format!("the {} @{target_layer}@ has no prim <{prim_path}>", name(arc)),
        ),
        E::MissingDefaultPrim {
            layer_id,
            arc,
            site_path,
        }
        | E::InvalidDefaultPrim {
            layer_id,
            arc,
            site_path,
        } => {
            remedy = "name the prim in the reference, or author that layer's defaultPrim";
            (
                site_path.to_string(),
                format!(
                    "the {} @{layer_id}@ names no prim, and the layer has no default prim",
                    name(arc)
                ),
            )
        }
        E::ArcCycle(chain) => {
            remedy = "remove one of them; OpenUSD ignores the last";
            (
                chain.composing.to_string(),
                "references or inherits form a cycle".to_owned(),
            )
        }
        other => ("composition".to_owned(), other.to_string()),
    };
    Finding::new("composition", level, place, one_line(&message), remedy)
}

/// Returns the URL in an asset path that the library parsed as a file path, with the dropped slash restored.
fn url(asset_path: &str) -> Option<String> {
    ["https:/", "http:/", "omniverse:/"]
        .into_iter()
        .find_map(|scheme| {
            let (_, rest) = asset_path.split_once(scheme)?;
            Some(format!("{scheme}/{}", rest.trim_start_matches('/')))
        })
}
