use openusd::sdf::{Path, Value};

use super::super::super::reader::Reader;

/// The maximum length of a chain of connections.
const MAX_CONNECTIONS: usize = 64;

/// The outputs of a material for its surface, most portable first.
const SURFACES: [&str; 4] = [
    "outputs:surface",
    "outputs:mtlx:surface",
    "outputs:glslfx:surface",
    "outputs:mdl:surface",
];

/// A shader of a network.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    pub(super) shader: Path,
    /// The name of its output.
    pub(super) output: String,
}

/// The source of an input.
pub(super) enum Input {
    /// A value and the attribute that defines it.
    Value(Value, Path),
    /// A shader's output.
    Node(Node),
}

/// Returns the surface shader of a material.
pub(super) fn surface_shader(reader: &Reader, material: &Path) -> Option<Node> {
    SURFACES
        .into_iter()
        .find_map(|output| match input(reader, material, output)? {
            Input::Node(node) => Some(node),
            Input::Value(..) => None,
        })
}

/// Returns the source of a property, following connections through materials and node graphs.
pub(super) fn input(reader: &Reader, prim: &Path, name: &str) -> Option<Input> {
    let mut at = prim.append_property(name).ok()?;
    for _ in 0..MAX_CONNECTIONS {
        let connections = reader
            .stage
            .attribute(at.clone())
            .connections()
            .unwrap_or_default();
        let Some(source) = connections.into_iter().next() else {
            let (prim, name) = at.split_property()?;
            return Some(Input::Value(
                reader.attribute_value(&prim, name.trim_start_matches('.'))?,
                at.clone(),
            ));
        };
        let (source_prim, source_name) = source.split_property()?;
        if let Some(output) = source_name.trim_start_matches('.').strip_prefix("outputs:") {
            let kind = reader.stage.prim(source_prim.clone()).type_name().ok().flatten();
            if kind.is_some_and(|kind| kind.as_str() == "Shader") {
                let output = output.to_owned();
                return Some(Input::Node(Node {
                    shader: source_prim,
                    output,
                }));
            }
        }
        at = source;
    }
    None
}
