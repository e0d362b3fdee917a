//! Coverage by day and by night, as a page for people.

use std::fmt::Write;

use super::table::table;
use super::{CandidateCoverage, Coverage};

/// The lights of a report: a name, and the factor on the scene's lights.
pub const LIGHTS: [(&str, f64); 2] = [("day", 1.0), ("night", 0.0)];

/// The largest number of reasons in a row.
const MAX_REASONS: usize = 3;

const STYLE: &str = "
body { font: 15px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; color: #191e25; }
table { border-collapse: collapse; width: 100%; } th, td { padding: .35rem .6rem; border-bottom: 1px solid #d3d9e1; text-align: right; }
.text { text-align: left; } .best { font-weight: 700; } figure { margin: 1.5rem 0; break-inside: avoid; } img { width: 100%; }
@page { size: A4 landscape; margin: 12mm; }";

/// The coverage in one light.
#[derive(Clone, Debug)]
pub struct InLight {
    /// The name of the light.
    pub name: &'static str,
    /// The factor on the scene's lights.
    pub ambient: f64,
    /// The coverage, by the same candidates as in the other lights.
    pub coverage: Coverage,
}

/// The coverage of a region by the same candidates in several lights.
#[derive(Clone, Debug)]
pub struct InLights {
    /// The name of the scene.
    pub scene: String,
    /// The error up to which a point counts as measured, millimetres.
    pub tolerance_mm: Option<f64>,
    /// The lights.
    pub lights: Vec<InLight>,
}

impl InLights {
    /// Returns the indices of the candidates to show: each model at the pose at which it measures most, on average over the lights. The best
    /// model comes first.
    #[must_use]
    pub fn best(&self) -> Vec<usize> {
        let Some(first) = self.lights.first() else {
            return Vec::new();
        };
        let mean = |index: usize| {
            let lights = self.lights.iter();
            let measured = lights.filter_map(|light| light.coverage.candidates.get(index));
            measured.map(|candidate| candidate.shares.measured).sum::<f64>()
        };
        let mut best: Vec<(usize, f64, &str)> = Vec::new();
        for (index, candidate) in first.coverage.candidates.iter().enumerate() {
            let own = (index, mean(index), candidate.model.as_str());
            match best.iter_mut().find(|known| known.2 == own.2) {
                Some(known) if known.1 < own.1 => *known = own,
                Some(_) => {}
                None => best.push(own),
            }
        }
        best.sort_by(|a, b| b.1.total_cmp(&a.1));
        best.into_iter().map(|(index, ..)| index).collect()
    }

    /// Returns all candidates in all lights as a table in CSV, with the light and its factor in the first columns.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let values: Vec<[String; 2]> = (self.lights.iter())
            .map(|light| [light.name.to_owned(), light.ambient.to_string()])
            .collect();
        let parts: Vec<(&[String], &Coverage)> = (values.iter().zip(&self.lights))
            .map(|(values, light)| (&values[..], &light.coverage))
            .collect();
        table(&["light", "ambient"], &parts)
    }

    /// Returns a page in HTML with a table of the [best](Self::best) poses and their pictures. `picture` returns the address of a candidate's
    /// picture in a light, by their indices.
    #[must_use]
    pub fn to_html(&self, picture: impl Fn(usize, usize) -> String) -> String {
        let title = format!("Coverage of {}", escaped(&self.region()));
        let tolerance = self.tolerance_mm.map_or_else(
            || "with any error".to_owned(),
            |most| format!("with an error of at most {most} mm"),
        );
        let (mut rows, mut figures) = (String::new(), String::new());
        let best = self.best();
        for &candidate in &best {
            for (light, in_light) in self.lights.iter().enumerate() {
                let Some(found) = in_light.coverage.candidates.get(candidate) else {
                    continue;
                };
                let is_best = most(in_light, &best) <= found.shares.measured;
                rows += &row(found, in_light.name, is_best);
                let caption = format!(
                    "{}, {}, {}",
                    escaped(&found.model),
                    in_light.name,
                    escaped(&found.name)
                );
                let _ = writeln!(
                    figures,
                    "<figure><figcaption>{caption}</figcaption><img alt=\"{caption}\" src=\"{}\"></figure>",
                    escaped(&picture(candidate, light))
                );
            }
        }
        format!(
            "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title><style>{STYLE}</style></head><body>\n\
             <h1>{title}</h1>\n<p>Scene: {}. A point of the surface counts as measured {tolerance}. Each model is at the pose at which it \
             measures most, on average over the lights. The best model in each light is bold.</p>\n\
             <table><thead><tr><th class=\"text\">Model</th><th class=\"text\">Light</th><th class=\"text\">Engine</th>\
             <th class=\"text\">Pose</th><th>Visible, %</th><th>Measured, %</th><th>Measured of visible, %</th>\
             <th>Median |error|, mm</th><th class=\"text\">Lost most</th></tr></thead>\n<tbody>\n{rows}</tbody></table>\n{figures}\
             <p>Simulated by oaktwin {}. By night, only the dot projector and time-of-flight sensors light the scene.</p>\n</body></html>\n",
            escaped(&self.scene),
            env!("CARGO_PKG_VERSION")
        )
    }

    fn region(&self) -> String {
        let Some(region) = self.lights.first().map(|light| &light.coverage.region) else {
            return String::new();
        };
        let mut places = match &region.objects[..] {
            [] => "the whole scene".to_owned(),
            objects => objects.join(", "),
        };
        if let (Some(minimum), Some(maximum)) = (region.minimum_m, region.maximum_m) {
            let corner = |point: [f64; 3]| point.map(|x| x.to_string()).join(", ");
            let _ = write!(places, " within ({}) to ({}) m", corner(minimum), corner(maximum));
        }
        places
    }
}

/// The largest share that one of the candidates measures in a light.
fn most(light: &InLight, candidates: &[usize]) -> f64 {
    let shown = candidates
        .iter()
        .filter_map(|index| light.coverage.candidates.get(*index));
    shown
        .map(|candidate| candidate.shares.measured)
        .fold(0.0, f64::max)
}

fn row(candidate: &CandidateCoverage, light: &str, is_best: bool) -> String {
    let shares = &candidate.shares;
    let percent = |share: f64| format!("{:.1}", share * 100.0);
    let of_seen = if shares.seen > 0.0 {
        percent(shares.measured / shares.seen)
    } else {
        "–".to_owned()
    };
    let error = shares
        .median_absolute_error_mm
        .map_or_else(|| "–".to_owned(), |error| format!("{error:.1}"));
    let losses: Vec<String> = (shares.losses().into_iter().take(MAX_REASONS))
        .map(|(name, share)| format!("{} {} %", name.replace('_', " "), percent(share)))
        .collect();
    let texts = [&*candidate.model, light, &candidate.engine, &candidate.name].map(escaped);
    let class = if is_best { " class=\"best\"" } else { "" };
    let mut out = format!("<tr{class}>");
    for text in texts {
        let _ = write!(out, "<td class=\"text\">{text}</td>");
    }
    for number in [percent(shares.seen), percent(shares.measured), of_seen, error] {
        let _ = write!(out, "<td>{number}</td>");
    }
    let _ = writeln!(
        out,
        "<td class=\"text\">{}</td></tr>",
        escaped(&losses.join(", "))
    );
    out
}

/// Text in HTML, also in attributes.
fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}
