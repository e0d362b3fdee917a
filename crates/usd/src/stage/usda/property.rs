//! Attributes and relationships.

use openusd::sdf::schema::FieldKey;
use openusd::sdf::{AbstractData, Path, SpecData, SpecType, Value, Variability};
use openusd::tf::Token;

use super::Parser;
use super::lexer::Outcome;
use super::metadata::ListEdit;
use super::value::{Declared, double, integer, time_samples, value};

/// The field of attributes that a spline animates. Its value only says that there is one.
pub(in crate::stage) const SPLINE_FIELD: &str = "spline";

impl Parser<'_> {
    /// Reads an attribute or a relationship of a prim or a variant.
    pub(super) fn property(&mut self, prim: &Path, names: &mut Vec<Token>) -> Outcome<()> {
        let edit = ListEdit::take(&mut self.lexer);
        let is_custom = self.lexer.eat_word("custom");
        let is_uniform = self.lexer.eat_word("uniform") || self.lexer.eat_word("config");
        let is_varying = self.lexer.eat_word("varying");
        if self.lexer.eat_word("rel") {
            return self.relationship(prim, edit, is_custom && !is_varying, names);
        }
        let Some(declared) = Declared::take(&mut self.lexer)? else {
            return self.lexer.expected("the type of an attribute");
        };
        let path = self.declare(prim, SpecType::Attribute, names)?;
        if let Some(spec) = self.data.spec_mut(&path) {
            spec.add(FieldKey::TypeName, declared.token());
            if is_custom {
                spec.add(FieldKey::Custom, Value::Bool(true));
            }
            if is_uniform {
                spec.add(FieldKey::Variability, Value::Variability(Variability::Uniform));
            }
        }
        if self.lexer.eat(b'.') {
            return match self.lexer.word() {
                Some("timeSamples") => {
                    self.lexer.expect(b'=')?;
                    let samples = time_samples(&mut self.lexer, declared)?;
                    self.set(&path, FieldKey::TimeSamples, Value::TimeSamples(samples));
                    Ok(())
                }
                Some("connect") => self.targets(prim, &path, edit, FieldKey::ConnectionPaths),
                Some("spline") => {
                    self.lexer.expect(b'=')?;
                    self.set(&path, SPLINE_FIELD, Value::Bool(true));
                    self.lexer.skip_value()
                }
                Some("default") => self.default(&path, declared),
                _ => self.lexer.expected("`timeSamples`, `connect` or `spline`"),
            };
        }
        self.default(&path, declared)?;
        self.property_metadata(&path)
    }

    /// Takes the name of a property and adds it to its prim.
    fn declare(&mut self, prim: &Path, kind: SpecType, names: &mut Vec<Token>) -> Outcome<Path> {
        let at = self.lexer.position();
        let name = self.lexer.property_name()?;
        let Ok(path) = prim.append_property(name) else {
            return self
                .lexer
                .error_at(at, format!("`{name}` is not a valid name of a property"));
        };
        if !self.data.has_spec(&path) {
            names.push(Token::from(name));
            self.insert(path.clone(), SpecData::new(kind));
        }
        Ok(path)
    }

    /// Reads the default value of an attribute, if there is one.
    fn default(&mut self, path: &Path, declared: Declared) -> Outcome<()> {
        if self.lexer.eat(b'=')
            && let Some(value) = value(&mut self.lexer, declared)?
        {
            self.set(path, FieldKey::Default, value);
        }
        Ok(())
    }

    fn relationship(
        &mut self,
        prim: &Path,
        edit: ListEdit,
        is_custom: bool,
        names: &mut Vec<Token>,
    ) -> Outcome<()> {
        let path = self.declare(prim, SpecType::Relationship, names)?;
        if is_custom {
            self.set(&path, FieldKey::Custom, Value::Bool(true));
        }
        if self.lexer.eat(b'.') {
            // Defaults of relationships are obsolete, and no longer have a meaning.
            if self.lexer.word().is_none() {
                return self.lexer.expected("`default`");
            }
            self.lexer.expect(b'=')?;
            return self.lexer.skip_value();
        }
        if self.lexer.peek() == Some(b'=') {
            self.targets(prim, &path, edit, FieldKey::TargetPaths)?;
        }
        self.property_metadata(&path)
    }

    /// Reads the targets of a relationship or the sources of a connection, if there are any.
    fn targets(&mut self, prim: &Path, path: &Path, edit: ListEdit, field: FieldKey) -> Outcome<()> {
        if self.lexer.eat(b'=') {
            let targets = self.paths(prim)?;
            if let Some(spec) = self.data.spec_mut(path) {
                spec.add_list_op(field, Value::PathListOp(edit.list(targets)));
            }
        }
        Ok(())
    }

    /// Reads the metadata of a property, if there are any.
    fn property_metadata(&mut self, path: &Path) -> Outcome<()> {
        if !self.lexer.eat(b'(') {
            return Ok(());
        }
        while !self.lexer.eat(b')') {
            let Some((_, name)) = self.field()? else { continue };
            let lexer = &mut self.lexer;
            let value = match name {
                "interpolation" | "colorSpace" | "bindMaterialAs" => {
                    Some(Value::Token(Token::from(lexer.string()?)))
                }
                "elementSize" | "unauthoredValuesIndex" => Some(Value::Int(integer(lexer)?)),
                // Of the in-betweens of blend shapes.
                "weight" => Some(Value::Double(double(lexer)?)),
                _ => {
                    lexer.skip_value()?;
                    None
                }
            };
            if let Some(value) = value {
                self.set(path, name, value);
            }
            self.lexer.skip_separators();
        }
        Ok(())
    }
}
