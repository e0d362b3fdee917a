//! Reads the text format, `.usda`, into the data of a layer.
//!
//! Accepts every text that OpenUSD 26.11 reads, and some that it refuses, such as values without commas between them.
//! Metadata that neither composition nor a scene needs is skipped. The rules are those of OpenUSD's
//! `textFileFormatParser.h`; `tests/oracles/test_usd_text.py` compares with the library itself.

mod escapes;
mod kind;
mod lexer;
mod metadata;
mod property;
mod value;

use openusd::sdf::schema::{ChildrenKey, FieldKey};
use openusd::sdf::{AbstractData, Data, Path, SpecData, SpecType, Specifier, Value};
use openusd::tf::Token;

use lexer::{Lexer, Outcome};
pub(super) use property::SPLINE_FIELD;

use super::ancestry::MAX_DEPTH;

/// A layer, and the number of its prims.
pub(super) struct Parsed {
    pub(super) data: Data,
    pub(super) prims: u64,
}

/// Reads a layer from its text.
pub(super) fn parse(text: &str) -> Outcome<Parsed> {
    let mut parser = Parser {
        lexer: Lexer::new(text),
        data: Data::new(),
        prims: 0,
    };
    parser.layer()?;
    Ok(Parsed {
        data: parser.data,
        prims: parser.prims,
    })
}

struct Parser<'a> {
    lexer: Lexer<'a>,
    data: Data,
    prims: u64,
}

/// The names of what a prim or a variant contains, in order.
#[derive(Default)]
struct Contents {
    prims: Vec<Token>,
    properties: Vec<Token>,
    variant_sets: Vec<Token>,
}

impl<'a> Parser<'a> {
    fn layer(&mut self) -> Outcome<()> {
        self.header()?;
        let root = Path::abs_root();
        self.data.create_spec(root.clone(), SpecType::PseudoRoot);
        if self.lexer.eat(b'(') {
            self.layer_metadata()?;
        }
        let mut prims = Vec::new();
        while self.lexer.peek().is_some() {
            match self.lexer.word() {
                Some("reorder") => self.reorder(&root)?,
                Some(word) => self.prim(word, &root, &mut prims, 0)?,
                None => return self.lexer.expected("`def`, `over` or `class`"),
            }
            self.lexer.skip_separators();
        }
        self.set_names(&root, ChildrenKey::PrimChildren, prims);
        Ok(())
    }

    fn header(&mut self) -> Outcome<()> {
        let line = self.lexer.line();
        let version = line
            .strip_prefix("#usda ")
            .and_then(|version| version.split_whitespace().next());
        match version {
            Some(version) if version.starts_with("1.") => Ok(()),
            Some(version) => self
                .lexer
                .error(format!("has the version `{version}`; 1.0 is supported")),
            None => self.lexer.error("has no version after `#usda`"),
        }
    }

    /// Reads a prim after its specifier.
    fn prim(
        &mut self,
        specifier: &str,
        parent: &Path,
        siblings: &mut Vec<Token>,
        depth: usize,
    ) -> Outcome<()> {
        let at = self.lexer.position();
        let specifier = match specifier {
            "def" => Specifier::Def,
            "over" => Specifier::Over,
            "class" => Specifier::Class,
            other => {
                return self.lexer.error_at(
                    at,
                    format!("has `{other}` where `def`, `over` or `class` is expected"),
                );
            }
        };
        let type_name = self.lexer.prim_type();
        let name = self.lexer.string()?;
        let path = match parent.append_path(name.as_str()) {
            Ok(path) if Path::is_valid_identifier(&name) => path,
            _ => {
                return self
                    .lexer
                    .error_at(at, format!("`{name}` is not a valid name of a prim"));
            }
        };
        if self.data.has_spec(&path) {
            return self
                .lexer
                .error_at(at, format!("the prim <{path}> is defined twice"));
        }
        if depth >= MAX_DEPTH {
            return self
                .lexer
                .error_at(at, format!("prims nest more than {MAX_DEPTH} deep"));
        }
        self.prims += 1;
        siblings.push(Token::from(name));
        let mut spec = SpecData::new(SpecType::Prim);
        spec.add(FieldKey::Specifier, Value::Specifier(specifier));
        if let Some(type_name) = type_name {
            spec.add(FieldKey::TypeName, Value::Token(Token::from(type_name)));
        }
        self.insert(path.clone(), spec);
        self.prim_metadata(&path)?;
        self.body(&path, depth)
    }

    /// Reads the contents of a prim or a variant between braces.
    fn body(&mut self, path: &Path, depth: usize) -> Outcome<()> {
        let mut contents = Contents::default();
        self.lexer.expect(b'{')?;
        while !self.lexer.eat(b'}') {
            let before = self.lexer.clone();
            match self.lexer.word() {
                Some(word @ ("def" | "over" | "class")) => {
                    self.prim(word, path, &mut contents.prims, depth + 1)?;
                }
                Some("variantSet") => self.variant_set(path, &mut contents.variant_sets, depth + 1)?,
                Some("reorder") if self.is_reorder() => self.reorder(path)?,
                Some(_) => {
                    self.lexer = before;
                    self.property(path, &mut contents.properties)?;
                }
                None => return self.lexer.expected("a property, a prim or `}`"),
            }
            self.lexer.skip_separators();
        }
        self.set_names(path, ChildrenKey::PrimChildren, contents.prims);
        self.set_names(path, ChildrenKey::PropertyChildren, contents.properties);
        self.set_names(path, ChildrenKey::VariantSetChildren, contents.variant_sets);
        Ok(())
    }

    fn variant_set(&mut self, prim: &Path, sets: &mut Vec<Token>, depth: usize) -> Outcome<()> {
        let at = self.lexer.position();
        let set = self.lexer.string()?;
        if !Path::is_valid_identifier(&set) {
            return self
                .lexer
                .error_at(at, format!("`{set}` is not a valid name of a variant set"));
        }
        if depth >= MAX_DEPTH {
            return self
                .lexer
                .error_at(at, format!("variant sets nest more than {MAX_DEPTH} deep"));
        }
        self.lexer.expect(b'=')?;
        self.lexer.expect(b'{')?;
        let mut variants = Vec::new();
        while !self.lexer.eat(b'}') {
            let at = self.lexer.position();
            let variant = self.lexer.string()?;
            if !is_variant_name(&variant) {
                return self
                    .lexer
                    .error_at(at, format!("`{variant}` is not a valid name of a variant"));
            }
            let path = prim.append_variant_selection(&set, &variant);
            if self.data.has_spec(&path) {
                return self
                    .lexer
                    .error_at(at, format!("the variant <{path}> is defined twice"));
            }
            variants.push(Token::from(variant.as_str()));
            self.insert(path.clone(), SpecData::new(SpecType::Variant));
            self.prim_metadata(&path)?;
            self.body(&path, depth)?;
            self.lexer.skip_separators();
        }
        if !variants.is_empty() {
            sets.push(Token::from(set.as_str()));
            let path = prim.append_variant_selection(&set, "");
            self.insert(path.clone(), SpecData::new(SpecType::VariantSet));
            self.set_names(&path, ChildrenKey::VariantChildren, variants);
        }
        Ok(())
    }

    /// Whether the word `reorder` begins the order of children and not that of a list.
    fn is_reorder(&self) -> bool {
        let mut ahead = self.lexer.clone();
        matches!(ahead.word(), Some("nameChildren" | "properties" | "rootPrims")) && ahead.eat(b'=')
    }

    /// Reads an order of prims or properties, after the word `reorder`.
    fn reorder(&mut self, path: &Path) -> Outcome<()> {
        let field = match self.lexer.word() {
            Some("nameChildren" | "rootPrims") => FieldKey::PrimOrder,
            Some("properties") => FieldKey::PropertyOrder,
            _ => return self.lexer.expected("`nameChildren` or `properties`"),
        };
        self.lexer.expect(b'=')?;
        let names = self.one_or_list(Lexer::string)?;
        let names = names.into_iter().map(Token::from).collect();
        self.set(path, field, Value::TokenVec(names));
        Ok(())
    }

    /// Takes one item, a list of items, or `None`.
    fn one_or_list<T>(&mut self, item: impl FnMut(&mut Lexer<'a>) -> Outcome<T>) -> Outcome<Vec<T>> {
        let mut item = item;
        if self.lexer.eat_word("None") {
            return Ok(Vec::new());
        }
        if self.lexer.peek() != Some(b'[') {
            return Ok(vec![item(&mut self.lexer)?]);
        }
        self.lexer.expect(b'[')?;
        let mut items = Vec::new();
        while !self.lexer.eat(b']') {
            items.push(item(&mut self.lexer)?);
            self.lexer.eat(b',');
        }
        Ok(items)
    }

    fn insert(&mut self, path: Path, spec: SpecData) {
        let ty = spec.ty;
        *self.data.create_spec(path, ty) = spec;
    }

    fn set(&mut self, path: &Path, field: impl AsRef<str>, value: Value) {
        if let Some(spec) = self.data.spec_mut(path) {
            spec.add(field, value);
        }
    }

    fn set_names(&mut self, path: &Path, field: ChildrenKey, names: Vec<Token>) {
        if !names.is_empty() {
            self.set(path, field, Value::TokenVec(names));
        }
    }
}

/// Whether a variant may have this name, which may begin with a dot.
fn is_variant_name(name: &str) -> bool {
    let rest = name.strip_prefix('.').unwrap_or(name);
    let allowed = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '|');
    !rest.is_empty() && rest.chars().all(allowed)
}
