use oaktwin_diagnostic::{Finding, Level};
use openusd::{pcp, usd};

use super::error::one_line;

/// What went wrong while the stage was composed, sorted, each once.
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
    let said = |arc: &pcp::ArcType| format!("{arc:?}").to_lowercase();
    let level = Level::Warning;
    let mut remedy = "put the file where the path says, or correct the path; what it holds is left out";
    let (place, message) = match error {
        E::UnresolvedLayer {
            asset_path,
            arc,
            site_path,
            ..
        } => {
            let message = if let Some(url) = url(asset_path) {
                remedy = "download it beside the file and reference it there; what it holds is left out";
                format!("the {} @{url}@ is not on this machine", said(arc))
            } else {
                format!("the {} @{asset_path}@ cannot be found", said(arc))
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
                format!("the {} @{asset_path}@ is no USD layer", said(arc))
            } else {
                format!("the {} @{asset_path}@ cannot be read: {reason}", said(arc))
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
            format!("the {} @{target_layer}@ has no prim <{prim_path}>", said(arc)),
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
            remedy = "name the prim in the reference, or give that layer a defaultPrim";
            (
                site_path.to_string(),
                format!(
                    "the {} @{layer_id}@ names no prim, and the layer has no default prim",
                    said(arc)
                ),
            )
        }
        E::ArcCycle(chain) => {
            remedy = "remove one of them; OpenUSD ignores the last";
            (
                chain.composing.to_string(),
                "references or inherits lead back to themselves".to_owned(),
            )
        }
        other => ("composition".to_owned(), other.to_string()),
    };
    Finding::new("composition", level, place, one_line(&message), remedy)
}

/// The address in an asset path that the library took for a file's, with the slash back that it dropped.
fn url(asset_path: &str) -> Option<String> {
    ["https:/", "http:/", "omniverse:/"]
        .into_iter()
        .find_map(|scheme| {
            let (_, rest) = asset_path.split_once(scheme)?;
            Some(format!("{scheme}/{}", rest.trim_start_matches('/')))
        })
}
