//! `web/src/protocol.ts`, the interface between the page and the server, made from the types of this crate. The test fails if it is not
//! current; `OAKTWIN_UPDATE_PROTOCOL=1` writes it.

use std::fs;
use std::path::Path;

use oaktwin::diagnostic::{Finding, Level};
use serde_json::json;
use ts_rs::{Config, TS, TypeVisitor};

use crate::catalog::CatalogInfo;
use crate::coverage::{CoverageAnswer, CoverageRequest, SurfaceRequest};
use crate::mesh::textured;
use crate::motion::{Line, MotionRequest};
use crate::postures::MotionInfo;
use crate::protocol::{
    AccuracyCurve, ExportRequest, Failure, FrameHeader, FrameRequest, MeshHeader, ProbeRequest, ServerMessage,
};
use crate::session::{SaveRequest, SessionInfo};

/// What the types do not say.
const START: &str = include_str!("protocol_start.ts");

/// The declarations so far, with their names.
struct Declarations {
    config: Config,
    all: Vec<(String, String)>,
}

impl TypeVisitor for Declarations {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        let name = T::ident(&self.config);
        // What has no file of its own is a type of the language.
        if T::output_path().is_none() || self.all.iter().any(|(known, _)| *known == name) {
            return;
        }
        let docs = T::docs().unwrap_or_default();
        let text = laid_out(&format!(
            "{docs}export {};",
            T::decl(&self.config).trim_end_matches(';')
        ));
        self.all.push((name, text));
        T::visit_dependencies(self);
    }
}

/// Lays out a declaration: a line for each field of an object, and comments before the fields.
fn laid_out(declaration: &str) -> String {
    let mut out = String::new();
    let mut depth = 0;
    // The alternatives of a union stay on one line.
    let is_object = !declaration.contains("} & ") && !declaration.contains("} | ");
    let mut rest = declaration;
    while let Some(letter) = rest.chars().next() {
        if let Some(end) = rest.starts_with("/**").then(|| rest.find("*/")).flatten() {
            comment(
                &mut out,
                &rest[3..end],
                if depth > 0 && is_object { "  " } else { "" },
            );
            rest = rest[end + 2..].trim_start();
            continue;
        }
        rest = &rest[letter.len_utf8()..];
        match letter {
            '{' | '[' | '<' => {
                depth += 1;
                out.push(letter);
                if letter == '{' && depth == 1 && is_object {
                    out.push('\n');
                    rest = rest.trim_start();
                }
            }
            '}' | ']' | '>' => {
                depth -= 1;
                out.push(letter);
            }
            ',' if depth == 1 && is_object => {
                out.push_str(";\n");
                rest = rest.trim_start();
            }
            _ => {
                if depth == 1 && is_object && out.ends_with('\n') {
                    out.push_str("  ");
                }
                out.push(letter);
            }
        }
    }
    out
}

/// Adds a comment: on one line if it fits.
fn comment(out: &mut String, text: &str, indentation: &str) {
    let lines: Vec<&str> = text
        .lines()
        .map(|line| line.trim().trim_start_matches('*').trim_start())
        .filter(|line| !line.is_empty())
        .collect();
    match lines.as_slice() {
        [line] => *out += &format!("{indentation}/** {line} */\n"),
        lines => {
            *out += &format!("{indentation}/**\n");
            for line in lines {
                *out += &format!("{indentation} * {line}\n");
            }
            *out += &format!("{indentation} */\n");
        }
    }
}

#[test]
fn the_pages_types_are_current() {
    let mut declarations = Declarations {
        config: Config::new().with_large_int("number"),
        all: Vec::new(),
    };
    declarations.visit::<CatalogInfo>();
    declarations.visit::<Failure>();
    declarations.visit::<FrameRequest>();
    declarations.visit::<ProbeRequest>();
    declarations.visit::<ServerMessage>();
    declarations.visit::<FrameHeader>();
    declarations.visit::<MeshHeader>();
    declarations.visit::<textured::Header>();
    declarations.visit::<ExportRequest>();
    declarations.visit::<AccuracyCurve>();
    declarations.visit::<CoverageRequest>();
    declarations.visit::<CoverageAnswer>();
    declarations.visit::<SurfaceRequest>();
    declarations.visit::<MotionInfo>();
    declarations.visit::<MotionRequest>();
    declarations.visit::<Line>();
    declarations.visit::<SaveRequest>();
    declarations.visit::<SessionInfo>();
    // The order in which a type's dependencies are visited differs from build to build.
    declarations.all.sort();
    let texts: Vec<&str> = declarations.all.iter().map(|(_, text)| text.as_str()).collect();
    let expected = format!("{START}\n{}\n", texts.join("\n\n"));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/src/protocol.ts");
    if std::env::var_os("OAKTWIN_UPDATE_PROTOCOL").is_some() {
        fs::write(&path, &expected).unwrap();
    }
    let found = fs::read_to_string(&path).unwrap();
    assert!(
        found == expected,
        "{} is not current; run this test with OAKTWIN_UPDATE_PROTOCOL=1",
        path.display()
    );
}

/// Findings are of another crate, and declared by hand.
#[test]
fn a_finding_has_the_fields_that_the_page_reads() {
    let finding = Finding::new("code", Level::Warning, "place", "message", "remedy");
    let expected = json!({"code": "code", "level": "warning", "place": "place", "message": "message", "remedy": "remedy"});
    assert_eq!(serde_json::to_value(finding).unwrap(), expected);
    assert!(START.contains("  level: \"note\" | \"warning\" | \"error\";"));
    for field in expected.as_object().unwrap().keys() {
        assert!(START.contains(&format!("\n  {field}: ")), "{field}");
    }
}
