use super::{Dictionary, SpecValue};

/// A layer: metadata and root prims.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layer {
    /// `customLayerData`.
    pub custom_layer_data: Dictionary,
    /// `defaultPrim`.
    pub default_prim: Option<String>,
    /// `doc`.
    pub documentation: Option<String>,
    /// `kilogramsPerUnit`.
    pub kilograms_per_unit: Option<f64>,
    /// `metersPerUnit`.
    pub meters_per_unit: Option<f64>,
    /// `subLayers`, strongest first.
    pub sub_layers: Vec<String>,
    /// `upAxis`.
    pub up_axis: Option<UpAxis>,
    /// The root prims.
    pub prims: Vec<PrimSpec>,
}

/// The up axis of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UpAxis {
    /// +y, OpenUSD's default.
    Y,
    /// +z, Isaac Sim's default.
    Z,
}

/// Whether a layer defines a prim or overrides one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Specifier {
    /// `def`.
    Def,
    /// `over`.
    Over,
}

/// A prim and its descendants.
#[derive(Clone, Debug, PartialEq)]
pub struct PrimSpec {
    /// `def` or `over`.
    pub specifier: Specifier,
    /// The type, such as `Camera`; empty if none is authored.
    pub type_name: String,
    /// The last element of the prim's path.
    pub name: String,
    /// `prepend apiSchemas`, strongest first.
    pub api_schemas: Vec<String>,
    /// `assetInfo`.
    pub asset_info: Dictionary,
    /// `customData`.
    pub custom_data: Dictionary,
    /// `doc`.
    pub documentation: Option<String>,
    /// `kind`.
    pub kind: Option<String>,
    /// `prepend references`.
    pub references: Vec<Reference>,
    /// The properties, in any order: the text sorts them.
    pub properties: Vec<Property>,
    /// The children, in the order in which they are written.
    pub children: Vec<Self>,
}

/// A reference to a prim of another layer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reference {
    /// The layer's path.
    pub asset: String,
    /// The prim's path; empty for the layer's default prim.
    pub prim: String,
}

/// An attribute or a relationship.
#[derive(Clone, Debug, PartialEq)]
pub enum Property {
    /// An attribute.
    Attribute(AttributeSpec),
    /// A relationship.
    Relationship(Relationship),
}

/// An attribute.
#[derive(Clone, Debug, PartialEq)]
pub struct AttributeSpec {
    /// The name with its namespaces, such as `omni:lensdistortion:model`.
    pub name: String,
    /// The name of the type; the type of `value` if there is one.
    pub type_name: &'static str,
    /// The default value.
    pub value: Option<SpecValue>,
    /// Whether it is `uniform`: constant over time.
    pub uniform: bool,
    /// Whether it is `custom`: not part of a schema.
    pub custom: bool,
    /// `doc`.
    pub documentation: Option<String>,
    /// `interpolation` of a primitive variable.
    pub interpolation: Option<&'static str>,
    /// The paths of the attributes that it is connected to.
    pub connections: Vec<String>,
}

/// A relationship.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Relationship {
    /// The name with its namespaces, such as `material:binding`.
    pub name: String,
    /// The absolute paths of the targets.
    pub targets: Vec<String>,
    /// `doc`.
    pub documentation: Option<String>,
}

impl PrimSpec {
    /// Creates an empty `def TYPE "NAME"`.
    pub fn def(type_name: impl Into<String>, name: impl Into<String>) -> Self {
        Self::new(Specifier::Def, type_name.into(), name.into())
    }

    /// Creates an empty `over "NAME"`.
    pub fn over(name: impl Into<String>) -> Self {
        Self::new(Specifier::Over, String::new(), name.into())
    }

    fn new(specifier: Specifier, type_name: String, name: String) -> Self {
        Self {
            specifier,
            type_name,
            name,
            api_schemas: Vec::new(),
            asset_info: Dictionary::new(),
            custom_data: Dictionary::new(),
            documentation: None,
            kind: None,
            references: Vec::new(),
            properties: Vec::new(),
            children: Vec::new(),
        }
    }

    /// Returns the same with a documentation string.
    #[must_use]
    pub fn documented(mut self, text: impl Into<String>) -> Self {
        self.documentation = Some(text.into());
        self
    }

    /// Returns the prim with another child.
    #[must_use]
    pub fn with_child(mut self, child: Self) -> Self {
        self.children.push(child);
        self
    }

    /// Adds a schema attribute that may vary over time.
    pub fn set(&mut self, name: impl Into<String>, value: SpecValue) {
        self.add(AttributeSpec::new(name, value));
    }

    /// Adds a `uniform` schema attribute.
    pub fn set_uniform(&mut self, name: impl Into<String>, value: SpecValue) {
        self.add(AttributeSpec::new(name, value).uniform());
    }

    /// Adds an attribute.
    pub fn add(&mut self, attribute: AttributeSpec) {
        self.properties.push(Property::Attribute(attribute));
    }

    /// Adds a relationship.
    pub fn relate(&mut self, name: impl Into<String>, targets: Vec<String>) {
        self.properties.push(Property::Relationship(Relationship {
            name: name.into(),
            targets,
            documentation: None,
        }));
    }

    /// Returns the attribute called `name` if it is authored.
    #[must_use]
    pub fn attribute(&self, name: &str) -> Option<&AttributeSpec> {
        self.properties.iter().find_map(|property| match property {
            Property::Attribute(attribute) if attribute.name == name => Some(attribute),
            _ => None,
        })
    }

    /// Returns the child called `name`.
    #[must_use]
    pub fn child(&self, name: &str) -> Option<&Self> {
        self.children.iter().find(|child| child.name == name)
    }
}

impl AttributeSpec {
    /// Creates a schema attribute with a value.
    pub fn new(name: impl Into<String>, value: SpecValue) -> Self {
        Self {
            type_name: value.type_name(),
            value: Some(value),
            ..Self::without_value(name, "")
        }
    }

    /// Creates a schema attribute with a type but no value.
    pub fn without_value(name: impl Into<String>, type_name: &'static str) -> Self {
        Self {
            name: name.into(),
            type_name,
            value: None,
            uniform: false,
            custom: false,
            documentation: None,
            interpolation: None,
            connections: Vec::new(),
        }
    }

    /// Returns the attribute as `uniform`.
    #[must_use]
    pub fn uniform(mut self) -> Self {
        self.uniform = true;
        self
    }

    /// Returns the same with a documentation string.
    #[must_use]
    pub fn documented(mut self, text: impl Into<String>) -> Self {
        self.documentation = Some(text.into());
        self
    }
}

impl Property {
    /// The name with its namespaces.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Attribute(attribute) => &attribute.name,
            Self::Relationship(relationship) => &relationship.name,
        }
    }
}

impl UpAxis {
    /// Returns the token `Y` or `Z`.
    #[must_use]
    pub const fn token(self) -> &'static str {
        match self {
            Self::Y => "Y",
            Self::Z => "Z",
        }
    }
}
