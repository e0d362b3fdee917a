//! The metadata of layers and prims.

use openusd::sdf::schema::FieldKey;
use openusd::sdf::{LayerOffset, ListOp, Path, Payload, Permission, Reference, Value};
use openusd::tf::Token;

use super::super::ancestry::{self, beginning};
use super::Parser;
use super::lexer::{Lexer, Outcome};
use super::value::{boolean, dictionary, double, integer};

/// How a list changes the weaker lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ListEdit {
    Replace,
    Prepend,
    Append,
    Add,
    Delete,
    Reorder,
}

impl ListEdit {
    /// Takes the word before a list.
    pub(super) fn take(lexer: &mut Lexer) -> Self {
        for (word, edit) in [
            ("prepend", Self::Prepend),
            ("append", Self::Append),
            ("add", Self::Add),
            ("delete", Self::Delete),
            ("reorder", Self::Reorder),
        ] {
            let mut ahead = lexer.clone();
            // It may also be the name of the field itself.
            if ahead.eat_word(word) && ahead.peek() != Some(b'=') {
                *lexer = ahead;
                return edit;
            }
        }
        Self::Replace
    }

    pub(super) fn list<T: Default + Clone + PartialEq>(self, items: Vec<T>) -> ListOp<T> {
        match self {
            Self::Replace => ListOp::explicit(items),
            Self::Prepend => ListOp::prepended(items),
            Self::Append => ListOp::appended(items),
            Self::Add => ListOp::added(items),
            Self::Delete => ListOp::deleted(items),
            Self::Reorder => ListOp::ordered(items),
        }
    }
}

impl<'a> Parser<'a> {
    /// Reads the metadata of the layer after the opening parenthesis.
    pub(super) fn layer_metadata(&mut self) -> Outcome<()> {
        let root = Path::abs_root();
        while !self.lexer.eat(b')') {
            let Some((_, name)) = self.field()? else { continue };
            let lexer = &mut self.lexer;
            match name {
                "defaultPrim" | "upAxis" => {
                    let value = Value::Token(Token::from(lexer.string()?));
                    self.set(&root, name, value);
                }
                "metersPerUnit" | "startTimeCode" | "endTimeCode" | "timeCodesPerSecond"
                | "framesPerSecond" => {
                    let value = Value::Double(double(lexer)?);
                    self.set(&root, name, value);
                }
                "expressionVariables" => {
                    let value = Value::Dictionary(dictionary(lexer, 0)?);
                    self.set(&root, name, value);
                }
                "subLayers" => {
                    let sublayers = self.one_or_list(|lexer| Ok((lexer.asset()?, offset(lexer)?)))?;
                    let (paths, offsets) = sublayers.into_iter().unzip();
                    self.set(&root, FieldKey::SubLayers, Value::StringVec(paths));
                    self.set(&root, FieldKey::SubLayerOffsets, Value::LayerOffsetVec(offsets));
                }
                "relocates" => {
                    let value = Value::Relocates(self.relocates(&root)?);
                    self.set(&root, FieldKey::LayerRelocates, value);
                }
                _ => lexer.skip_value()?,
            }
            self.lexer.skip_separators();
        }
        Ok(())
    }

    /// Reads the metadata of a prim or a variant, if there are any.
    pub(super) fn prim_metadata(&mut self, prim: &Path) -> Outcome<()> {
        if !self.lexer.eat(b'(') {
            return Ok(());
        }
        while !self.lexer.eat(b')') {
            let Some((edit, name)) = self.field()? else {
                continue;
            };
            self.prim_field(prim, edit, name)?;
            self.lexer.skip_separators();
        }
        Ok(())
    }

    fn prim_field(&mut self, prim: &Path, edit: ListEdit, name: &str) -> Outcome<()> {
        let (field, value) = match name {
            "active" | "instanceable" => (name, Value::Bool(boolean(&mut self.lexer)?)),
            "kind" => (name, Value::Token(Token::from(self.lexer.string()?))),
            "permission" => {
                let permission = match self.lexer.word() {
                    Some("public") => Permission::Public,
                    Some("private") => Permission::Private,
                    _ => return self.lexer.expected("`public` or `private`"),
                };
                (name, Value::Permission(permission))
            }
            "apiSchemas" => {
                let names = self.one_or_list(Lexer::string)?;
                let names = names.into_iter().map(Token::from).collect();
                (name, Value::TokenListOp(edit.list(names)))
            }
            "variantSets" => {
                let names = self.one_or_list(Lexer::string)?;
                (
                    FieldKey::VariantSetNames.as_str(),
                    Value::StringListOp(edit.list(names)),
                )
            }
            "variants" => {
                let text = |(set, value)| match value {
                    Value::String(variant) => Some((set, variant)),
                    _ => None,
                };
                let selected = dictionary(&mut self.lexer, 0)?.into_iter().filter_map(text);
                (
                    FieldKey::VariantSelection.as_str(),
                    Value::VariantSelectionMap(selected.collect()),
                )
            }
            "inherits" | "specializes" => {
                let paths = self.paths(prim)?;
                let field = if name == "inherits" {
                    FieldKey::InheritPaths
                } else {
                    FieldKey::Specializes
                };
                (field.as_str(), Value::PathListOp(edit.list(paths)))
            }
            "references" => {
                let references = self.one_or_list(reference)?;
                (name, Value::ReferenceListOp(edit.list(references)))
            }
            "payload" => {
                let payloads = self.one_or_list(|lexer| {
                    let reference = reference(lexer)?;
                    Ok(Payload {
                        asset_path: reference.asset_path,
                        prim_path: reference.prim_path,
                        layer_offset: Some(reference.layer_offset),
                    })
                })?;
                (name, Value::PayloadListOp(edit.list(payloads)))
            }
            "relocates" => (name, Value::Relocates(self.relocates(prim)?)),
            "clips" => (name, Value::Dictionary(dictionary(&mut self.lexer, 0)?)),
            "clipSets" => {
                let names = self.one_or_list(Lexer::string)?;
                (name, Value::StringListOp(edit.list(names)))
            }
            "inactiveIds" => {
                let ids = self.one_or_list(integer)?;
                (name, Value::Int64ListOp(edit.list(ids)))
            }
            _ => return self.lexer.skip_value(),
        };
        if let Some(spec) = self.data.spec_mut(prim) {
            spec.add_list_op(field, value);
        }
        Ok(())
    }

    /// Takes the name of a field and the sign `=`; `None` for a comment.
    pub(super) fn field(&mut self) -> Outcome<Option<(ListEdit, &'a str)>> {
        if self.lexer.at_string() {
            self.lexer.string()?;
            self.lexer.skip_separators();
            return Ok(None);
        }
        let edit = ListEdit::take(&mut self.lexer);
        let Some(name) = self.lexer.word() else {
            return self.lexer.expected("the name of a metadata field or `)`");
        };
        self.lexer.expect(b'=')?;
        Ok(Some((edit, name)))
    }

    /// Takes one or more paths, which may be relative to a prim.
    pub(super) fn paths(&mut self, prim: &Path) -> Outcome<Vec<Path>> {
        let anchor = prim.strip_all_variant_selections();
        let paths = self.one_or_list(|lexer| absolute(lexer, &anchor))?;
        Ok(paths.into_iter().flatten().collect())
    }

    fn relocates(&mut self, prim: &Path) -> Outcome<Vec<(Path, Path)>> {
        let anchor = prim.strip_all_variant_selections();
        let mut pairs = Vec::new();
        self.lexer.expect(b'{')?;
        while !self.lexer.eat(b'}') {
            let source = absolute(&mut self.lexer, &anchor)?;
            self.lexer.expect(b':')?;
            let target = absolute(&mut self.lexer, &anchor)?;
            // An empty target removes the source.
            if let Some(source) = source {
                pairs.push((source, target.unwrap_or_default()));
            }
            self.lexer.skip_separators();
        }
        Ok(pairs)
    }
}

/// Takes a path and makes it absolute; `None` if it is empty or leads into the target of a relationship, to which
/// nothing in a scene refers.
fn absolute(lexer: &mut Lexer, anchor: &Path) -> Outcome<Option<Path>> {
    let at = lexer.position();
    let text = lexer.path()?;
    if text.is_empty() || text.contains('[') {
        return Ok(None);
    }
    let Ok(path) = Path::new(text) else {
        return lexer.error_at(at, format!("<{}> is not a valid path", beginning(text)));
    };
    sound(lexer, at, anchor.make_absolute(&path)).map(Some)
}

/// Returns a path that leads to the root.
fn sound(lexer: &Lexer, at: usize, path: Path) -> Outcome<Path> {
    match ancestry::defect(&path) {
        None => Ok(path),
        Some(defect) => lexer.error_at(at, format!("<{}> {defect}", beginning(path.as_str()))),
    }
}

/// Takes a reference: to a layer, to a prim of a layer, or to a prim of the same layer stack.
fn reference(lexer: &mut Lexer) -> Outcome<Reference> {
    let asset_path = match lexer.peek() {
        Some(b'@') => lexer.asset()?,
        Some(b'<') => String::new(),
        _ => return lexer.expected("a layer between `@` or a path between `<` and `>`"),
    };
    let mut prim_path = Path::default();
    if lexer.peek() == Some(b'<') {
        let at = lexer.position();
        let text = lexer.path()?;
        if !text.is_empty() {
            prim_path = match Path::new(text) {
                Ok(path) if path.is_abs() && !path.is_property_path() && !text.contains('{') => {
                    sound(lexer, at, path)?
                }
                _ => {
                    let what = format!("<{}> is not the absolute path of a prim", beginning(text));
                    return lexer.error_at(at, what);
                }
            };
        }
    }
    Ok(Reference {
        asset_path,
        prim_path,
        layer_offset: offset(lexer)?,
        ..Reference::default()
    })
}

/// Takes the offset and the scale of a layer's time, if there are any.
fn offset(lexer: &mut Lexer) -> Outcome<LayerOffset> {
    let mut offset = LayerOffset::default();
    if lexer.eat(b'(') {
        while !lexer.eat(b')') {
            let Some(name) = lexer.word() else {
                return lexer.expected("`offset`, `scale` or `)`");
            };
            lexer.expect(b'=')?;
            match name {
                "offset" => offset.offset = double(lexer)?,
                "scale" => offset.scale = double(lexer)?,
                _ => lexer.skip_value()?,
            }
            lexer.skip_separators();
        }
    }
    Ok(offset)
}
