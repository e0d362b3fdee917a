//! Converts `MaterialX` documents to USD layers with the layout of OpenUSD's plug-in: each material is a `Material` prim
//! `/MaterialX/Materials/NAME` that contains its nodes as `Shader` prims.
//!
//! Only the network is converted, with the types that a base colour needs. A node's definition is named
//! `ND_CATEGORY_TYPE`, as in the standard library. References to other documents (`xi:include`) and custom node
//! definitions are not followed.

mod document;

use std::collections::BTreeSet;

use document::Element;

use crate::text::{AttributeSpec, Layer, PrimSpec, SpecValue, is_identifier};

/// The reason why a document could not be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("not a MaterialX document: byte {offset}: {what}")]
pub struct MaterialXError {
    /// The position in bytes from the start.
    pub offset: u64,
    /// The problem.
    pub what: String,
}

/// The maximum depth of connections.
const MAX_DEPTH: usize = 128;

/// Converts a document to a layer.
///
/// # Errors
/// Returns an error if the XML is malformed or has no `materialx` element.
pub fn to_layer(document: &[u8]) -> Result<Layer, MaterialXError> {
    let document = document::parse(document)?;
    let mut materials = PrimSpec::def("", "Materials");
    for element in &document.children {
        if element.category == "surfacematerial" && !identifier(element.name()).is_empty() {
            materials.children.push(material(&document, element));
        }
    }
    Ok(Layer {
        default_prim: Some("MaterialX".to_owned()),
        prims: vec![PrimSpec::def("", "MaterialX").with_child(materials)],
        ..Layer::default()
    })
}

fn material(document: &Element, element: &Element) -> PrimSpec {
    let name = identifier(element.name());
    let mut network = Network {
        document,
        path: format!("/MaterialX/Materials/{name}"),
        prim: PrimSpec::def("Material", name),
        known: BTreeSet::new(),
    };
    if let Some(surface) = element
        .input("surfaceshader")
        .and_then(|input| network.source(document, input, "", 0))
    {
        let mut output = AttributeSpec::without_value("outputs:mtlx:surface", "token");
        output.connections.push(surface);
        network.prim.add(output);
    }
    network.prim
}

/// The nodes that a material uses.
struct Network<'a> {
    document: &'a Element,
    /// The path of the material.
    path: String,
    prim: PrimSpec,
    /// The graphs and names of the nodes converted so far.
    known: BTreeSet<(String, String)>,
}

impl Network<'_> {
    /// Returns the output connected to an input of a node in `scope` (the document, or the graph named `graph`).
    fn source(&mut self, scope: &Element, input: &Element, graph: &str, depth: usize) -> Option<String> {
        if depth > MAX_DEPTH {
            return None;
        }
        if let Some(name) = input.get("nodegraph") {
            let inside = self
                .document
                .children
                .iter()
                .find(|child| child.category == "nodegraph" && child.name() == name)?;
            let mut outputs = inside.children.iter().filter(|child| child.category == "output");
            let output = match input.get("output") {
                Some(name) => outputs.find(|output| output.name() == name),
                None => outputs.next(),
            }?;
            return self.source(inside, output, name, depth + 1);
        }
        let name = input.get("nodename")?;
        let node = scope.child(name)?;
        let folder = if graph.is_empty() {
            self.path.clone()
        } else {
            format!("{}/{}", self.path, identifier(graph))
        };
        let output = format!("{folder}/{}.outputs:out", identifier(name));
        if self.known.insert((graph.to_owned(), name.to_owned())) {
            let shader = self.shader(scope, node, graph, depth + 1);
            if graph.is_empty() {
                self.prim.children.push(shader);
            } else {
                self.graph(&identifier(graph)).children.push(shader);
            }
        }
        Some(output)
    }

    fn graph(&mut self, name: &str) -> &mut PrimSpec {
        let children = &mut self.prim.children;
        let at = children.iter().position(|child| child.name == name);
        let at = at.unwrap_or_else(|| {
            children.push(PrimSpec::def("NodeGraph", name));
            children.len() - 1
        });
        &mut children[at]
    }

    fn shader(&mut self, scope: &Element, node: &Element, graph: &str, depth: usize) -> PrimSpec {
        let mut shader = PrimSpec::def("Shader", identifier(node.name()));
        let kind = node.get("type").unwrap_or_default();
        let definition = match node.get("nodedef") {
            Some(definition) => definition.to_owned(),
            None => format!("ND_{}_{kind}", node.category),
        };
        shader.set_uniform("info:id", SpecValue::Token(definition));
        for input in node.inputs() {
            // The value of an exposed input is authored on the graph.
            let value = match input.get("interfacename") {
                Some(outer) => scope.input(outer).unwrap_or(input),
                None => input,
            };
            let name = format!("inputs:{}", namespaced(input.name()));
            if name.ends_with(':') {
                continue;
            }
            if let Some(source) = self.source(scope, value, graph, depth) {
                let mut attribute = AttributeSpec::without_value(name, "token");
                attribute.connections.push(source);
                shader.add(attribute);
            } else if let Some(parsed) = self.value(scope, node, value) {
                if let (SpecValue::Asset(_), Some(space)) = (&parsed, value.get("colorspace")) {
                    shader.set("inputs:sourceColorSpace", SpecValue::token(space));
                }
                shader.set(name, parsed);
            }
        }
        shader.add(AttributeSpec::without_value("outputs:out", "token"));
        shader
    }

    fn value(&self, scope: &Element, node: &Element, input: &Element) -> Option<SpecValue> {
        let text = input.get("value")?;
        let numbers = || -> Option<Vec<f32>> {
            text.split(',')
                .map(|number| {
                    number
                        .trim()
                        .parse()
                        .ok()
                        .filter(|number: &f32| number.is_finite())
                })
                .collect()
        };
        match input.get("type")? {
            "filename" => {
                // The path is prefixed with the `fileprefix` of the nearest enclosing element.
                let prefix = [input, node, scope, self.document]
                    .into_iter()
                    .find_map(|element| element.get("fileprefix"))
                    .unwrap_or_default();
                Some(SpecValue::Asset(format!("{prefix}{text}")))
            }
            "color3" | "color4" | "vector3" | "vector4" => match numbers()?[..] {
                [r, g, b] | [r, g, b, _] => Some(SpecValue::Color3f([r, g, b])),
                _ => None,
            },
            "vector2" => match numbers()?[..] {
                [x, y] => Some(SpecValue::Float2([x, y])),
                _ => None,
            },
            "float" => numbers()?.first().copied().map(SpecValue::Float),
            "integer" => text.trim().parse().ok().map(SpecValue::Int),
            "boolean" => text.trim().parse().ok().map(SpecValue::Bool),
            "string" => Some(SpecValue::string(text)),
            _ => None,
        }
    }
}

/// Converts to a valid prim name: invalid characters become `_`. Empty if that fails.
fn identifier(name: &str) -> String {
    let mut valid: String = name
        .chars()
        .map(|c| if c.is_alphanumeric() || c == '_' { c } else { '_' })
        .collect();
    if !is_identifier(&valid) && !valid.is_empty() {
        valid.insert(0, '_');
    }
    if is_identifier(&valid) {
        valid
    } else {
        String::new()
    }
}

/// Applies [`identifier`] to each part of a namespaced name.
fn namespaced(name: &str) -> String {
    name.split(':').map(identifier).collect::<Vec<_>>().join(":")
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOCUMENT: &[u8] = br#"<?xml version="1.0"?>
<materialx version="1.38" fileprefix="textures/">
  <!-- a node graph, exposed input, values -->
  <nodegraph name="NG">
    <input name="picture" type="filename" value="wood.png" colorspace="srgb_texture" />
    <image name="base" type="color3">
      <input name="file" type="filename" interfacename="picture" />
      <input name="uaddressmode" type="string" value="clamp" />
    </image>
    <output name="other" type="float" nodename="missing" />
    <output name="colour" type="color3" nodename="base" />
  </nodegraph>
  <standard_surface name="SS" type="surfaceshader">
    <input name="base_color" type="color3" nodegraph="NG" output="colour" />
    <input name="base" type="float" value="0.5" />
    <input name="specular_roughness" type="float" value="nan" />
  </standard_surface>
  <surfacematerial name="wood 1" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="SS" />
  </surfacematerial>
</materialx>"#;

    #[test]
    fn converts_a_network_to_prims() {
        let layer = to_layer(DOCUMENT).unwrap();
        let material = layer.prims[0]
            .child("Materials")
            .unwrap()
            .child("wood_1")
            .unwrap();
        assert_eq!(material.type_name, "Material");
        assert_eq!(
            material.attribute("outputs:mtlx:surface").unwrap().connections,
            ["/MaterialX/Materials/wood_1/SS.outputs:out"]
        );
        let surface = material.child("SS").unwrap();
        assert_eq!(
            surface.attribute("info:id").unwrap().value,
            Some(SpecValue::token("ND_standard_surface_surfaceshader"))
        );
        assert_eq!(
            surface.attribute("inputs:base_color").unwrap().connections,
            ["/MaterialX/Materials/wood_1/NG/base.outputs:out"]
        );
        assert_eq!(
            surface.attribute("inputs:base").unwrap().value,
            Some(SpecValue::Float(0.5))
        );
        assert!(surface.attribute("inputs:specular_roughness").is_none());
        let image = material.child("NG").unwrap().child("base").unwrap();
        assert_eq!(
            image.attribute("inputs:file").unwrap().value,
            Some(SpecValue::Asset("textures/wood.png".into()))
        );
        assert_eq!(
            image.attribute("inputs:sourceColorSpace").unwrap().value,
            Some(SpecValue::token("srgb_texture"))
        );
    }

    #[test]
    fn rejects_malformed_documents_and_stops_at_cycles() {
        for bad in [
            "",
            "no xml",
            "<materialx>",
            "<materialx><a></b></materialx>",
            "<other/>",
            "<materialx a='&undefined;'/>",
        ] {
            assert!(to_layer(bad.as_bytes()).is_err(), "{bad}");
        }
        let deep = "<a>".repeat(1000);
        assert!(to_layer(deep.as_bytes()).unwrap_err().what.contains("deep"));
        let looped = br#"<materialx>
            <mix name="a" type="color3"><input name="fg" type="color3" nodename="b"/></mix>
            <mix name="b" type="color3"><input name="fg" type="color3" nodename="a"/></mix>
            <surfacematerial name="m" type="material"><input name="surfaceshader" nodename="a"/></surfacematerial>
        </materialx>"#;
        let layer = to_layer(looped).unwrap();
        assert_eq!(layer.prims[0].children[0].children[0].children.len(), 2);
    }
}
