use std::fmt::Write;

use super::number::{push_f32, push_f64, push_i32};
use super::order::{dictionary_order, is_identifier};
use super::quote::{push_asset, push_string};
use super::{AttributeSpec, Dictionary, Layer, PrimSpec, Property, Relationship, SpecValue, Specifier};

impl Layer {
    /// Returns the layer in OpenUSD's text format, laid out as OpenUSD exports it.
    #[must_use]
    pub fn text(&self) -> String {
        let mut emitter = Emitter {
            out: String::new(),
            depth: 0,
        };
        emitter.layer(self);
        emitter.out
    }
}

struct Emitter {
    out: String,
    depth: usize,
}

impl Emitter {
    fn layer(&mut self, layer: &Layer) {
        self.out.push_str("#usda 1.0\n(\n");
        self.depth = 1;
        self.dictionary_metadata("customLayerData", &layer.custom_layer_data);
        self.string_metadata("defaultPrim", layer.default_prim.as_deref());
        self.string_metadata("doc", layer.documentation.as_deref());
        self.number_metadata("kilogramsPerUnit", layer.kilograms_per_unit);
        self.number_metadata("metersPerUnit", layer.meters_per_unit);
        if !layer.sub_layers.is_empty() {
            self.line("subLayers = [");
            self.depth += 1;
            for (i, path) in layer.sub_layers.iter().enumerate() {
                self.indent();
                push_asset(&mut self.out, path);
                self.out.push_str(if i + 1 < layer.sub_layers.len() {
                    ",\n"
                } else {
                    "\n"
                });
            }
            self.depth -= 1;
            self.line("]");
        }
        self.string_metadata("upAxis", layer.up_axis.map(super::UpAxis::token));
        self.depth = 0;
        self.out.push_str(")\n\n");
        for prim in &layer.prims {
            self.prim(prim);
            self.out.push('\n');
        }
    }

    fn prim(&mut self, prim: &PrimSpec) {
        self.indent();
        self.out.push_str(match prim.specifier {
            Specifier::Def => "def ",
            Specifier::Over => "over ",
        });
        if !prim.type_name.is_empty() {
            self.out.push_str(&prim.type_name);
            self.out.push(' ');
        }
        push_string(&mut self.out, &prim.name);
        if prim.has_metadata() {
            self.out.push_str(" (\n");
            self.depth += 1;
            self.prim_metadata(prim);
            self.depth -= 1;
            self.line(")");
        } else {
            self.out.push('\n');
        }
        self.line("{");
        self.depth += 1;
        let mut properties: Vec<&Property> = prim.properties.iter().collect();
        properties.sort_by(|a, b| dictionary_order(a.name(), b.name()));
        for property in &properties {
            match property {
                Property::Attribute(attribute) => self.attribute(attribute),
                Property::Relationship(relationship) => self.relationship(relationship),
            }
        }
        for (i, child) in prim.children.iter().enumerate() {
            if i > 0 || !properties.is_empty() {
                self.out.push('\n');
            }
            self.prim(child);
        }
        self.depth -= 1;
        self.line("}");
    }

    /// Emits the metadata sorted by the fields' full names, as OpenUSD does.
    fn prim_metadata(&mut self, prim: &PrimSpec) {
        if !prim.api_schemas.is_empty() {
            self.indent();
            self.out.push_str("prepend apiSchemas = ");
            self.strings(&prim.api_schemas);
            self.out.push('\n');
        }
        self.dictionary_metadata("assetInfo", &prim.asset_info);
        self.dictionary_metadata("customData", &prim.custom_data);
        self.string_metadata("doc", prim.documentation.as_deref());
        self.string_metadata("kind", prim.kind.as_deref());
        if !prim.references.is_empty() {
            let references: Vec<String> = prim
                .references
                .iter()
                .map(|reference| {
                    let mut text = String::new();
                    if !reference.asset.is_empty() {
                        push_asset(&mut text, &reference.asset);
                    }
                    if !reference.prim.is_empty() {
                        let _ = write!(text, "<{}>", reference.prim);
                    }
                    text
                })
                .collect();
            self.list("prepend references = ", &references);
            self.out.push('\n');
        }
    }

    fn attribute(&mut self, attribute: &AttributeSpec) {
        let has_metadata = attribute.documentation.is_some() || attribute.interpolation.is_some();
        if attribute.value.is_some() || has_metadata || attribute.connections.is_empty() {
            self.attribute_head(attribute);
            if let Some(value) = &attribute.value {
                self.out.push_str(" = ");
                self.value(value);
            }
            if has_metadata {
                self.out.push_str(" (\n");
                self.depth += 1;
                self.string_metadata("doc", attribute.documentation.as_deref());
                self.string_metadata("interpolation", attribute.interpolation);
                self.depth -= 1;
                self.indent();
                self.out.push(')');
            }
            self.out.push('\n');
        }
        if !attribute.connections.is_empty() {
            self.attribute_head(attribute);
            let targets: Vec<String> = attribute.connections.iter().map(|p| format!("<{p}>")).collect();
            self.list_after(".connect = ", &targets);
            self.out.push('\n');
        }
    }

    fn attribute_head(&mut self, attribute: &AttributeSpec) {
        self.indent();
        if attribute.custom {
            self.out.push_str("custom ");
        }
        if attribute.uniform {
            self.out.push_str("uniform ");
        }
        self.out.push_str(attribute.type_name);
        self.out.push(' ');
        self.out.push_str(&attribute.name);
    }

    fn relationship(&mut self, relationship: &Relationship) {
        self.indent();
        self.out.push_str("rel ");
        self.out.push_str(&relationship.name);
        if !relationship.targets.is_empty() {
            let targets: Vec<String> = relationship.targets.iter().map(|p| format!("<{p}>")).collect();
            self.list_after(" = ", &targets);
        }
        if let Some(text) = &relationship.documentation {
            self.out.push_str(" (\n");
            self.depth += 1;
            self.string_metadata("doc", Some(text));
            self.depth -= 1;
            self.indent();
            self.out.push(')');
        }
        self.out.push('\n');
    }

    /// Emits `head` and a single item, or a bracketed list with one item per line.
    fn list(&mut self, head: &str, items: &[String]) {
        self.indent();
        self.list_after(head, items);
    }

    fn list_after(&mut self, head: &str, items: &[String]) {
        self.out.push_str(head);
        if let [item] = items {
            self.out.push_str(item);
            return;
        }
        self.out.push_str("[\n");
        self.depth += 1;
        for item in items {
            self.indent();
            self.out.push_str(item);
            self.out.push_str(",\n");
        }
        self.depth -= 1;
        self.indent();
        self.out.push(']');
    }

    fn string_metadata(&mut self, name: &str, text: Option<&str>) {
        if let Some(text) = text {
            self.indent();
            self.out.push_str(name);
            self.out.push_str(" = ");
            push_string(&mut self.out, text);
            self.out.push('\n');
        }
    }

    fn number_metadata(&mut self, name: &str, number: Option<f64>) {
        if let Some(number) = number {
            self.indent();
            self.out.push_str(name);
            self.out.push_str(" = ");
            push_f64(&mut self.out, number);
            self.out.push('\n');
        }
    }

    fn dictionary_metadata(&mut self, name: &str, dictionary: &Dictionary) {
        if !dictionary.is_empty() {
            self.indent();
            self.out.push_str(name);
            self.out.push_str(" = ");
            self.dictionary(dictionary);
            self.out.push('\n');
        }
    }

    fn dictionary(&mut self, dictionary: &Dictionary) {
        self.out.push_str("{\n");
        self.depth += 1;
        for (key, value) in dictionary {
            self.indent();
            self.out.push_str(value.type_name());
            self.out.push(' ');
            if is_identifier(key) {
                self.out.push_str(key);
            } else {
                push_string(&mut self.out, key);
            }
            self.out.push_str(" = ");
            self.value(value);
            self.out.push('\n');
        }
        self.depth -= 1;
        self.indent();
        self.out.push('}');
    }

    fn value(&mut self, value: &SpecValue) {
        let out = &mut self.out;
        match value {
            SpecValue::Bool(v) => out.push(if *v { '1' } else { '0' }),
            SpecValue::Int(v) => push_i32(out, *v),
            SpecValue::Float(v) => push_f32(out, *v),
            SpecValue::Double(v) => push_f64(out, *v),
            SpecValue::String(v) | SpecValue::Token(v) => push_string(out, v),
            SpecValue::Asset(v) => push_asset(out, v),
            SpecValue::Int2(v) => push_tuple(out, v, push_i32),
            SpecValue::Float2(v) => push_tuple(out, v, push_f32),
            SpecValue::Float4(v) => push_tuple(out, v, push_f32),
            SpecValue::Color3f(v) => push_tuple(out, v, push_f32),
            SpecValue::Double3(v) => push_tuple(out, v, push_f64),
            SpecValue::Quatd(v) => push_tuple(out, v, push_f64),
            SpecValue::Matrix4d(rows) => {
                out.push_str("( ");
                push_separated(out, rows, |out, row| push_tuple(out, &row, push_f64));
                out.push_str(" )");
            }
            SpecValue::TokenArray(v) => self.strings(v),
            SpecValue::IntArray(v) => push_array(out, v, push_i32),
            SpecValue::FloatArray(v) => push_array(out, v, push_f32),
            SpecValue::Float3Array(v)
            | SpecValue::Point3fArray(v)
            | SpecValue::Normal3fArray(v)
            | SpecValue::Color3fArray(v) => push_vectors(out, v),
            SpecValue::TexCoord2fArray(v) => push_vectors(out, v),
            SpecValue::Dictionary(entries) => self.dictionary(entries),
        }
    }

    fn strings(&mut self, strings: &[String]) {
        self.out.push('[');
        for (i, text) in strings.iter().enumerate() {
            if i > 0 {
                self.out.push_str(", ");
            }
            push_string(&mut self.out, text);
        }
        self.out.push(']');
    }

    fn line(&mut self, text: &str) {
        self.indent();
        self.out.push_str(text);
        self.out.push('\n');
    }

    fn indent(&mut self) {
        self.out.extend(std::iter::repeat_n("    ", self.depth));
    }
}

impl PrimSpec {
    fn has_metadata(&self) -> bool {
        !self.api_schemas.is_empty()
            || !self.asset_info.is_empty()
            || !self.custom_data.is_empty()
            || self.documentation.is_some()
            || self.kind.is_some()
            || !self.references.is_empty()
    }
}

fn push_separated<T: Copy>(out: &mut String, items: &[T], push: impl Fn(&mut String, T)) {
    for (i, &item) in items.iter().enumerate() {
        if i > 0 {
            out.push_str(", ");
        }
        push(out, item);
    }
}

fn push_tuple<T: Copy>(out: &mut String, items: &[T], push: impl Fn(&mut String, T)) {
    out.push('(');
    push_separated(out, items, push);
    out.push(')');
}

fn push_array<T: Copy>(out: &mut String, items: &[T], push: impl Fn(&mut String, T)) {
    out.push('[');
    push_separated(out, items, push);
    out.push(']');
}

fn push_vectors<const N: usize>(out: &mut String, vectors: &[[f32; N]]) {
    push_array(out, vectors, |out, vector| push_tuple(out, &vector, push_f32));
}
