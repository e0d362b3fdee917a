use std::borrow::Cow;
use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

use crate::{Engine, ParameterError, Setup};

/// What is known of an engine before it is created. [`ENGINES`](crate::engines::ENGINES) lists the kinds of this crate; other crates
/// declare their own, as statics or made at run time.
#[derive(Clone, Debug)]
pub struct EngineKind {
    /// The name in options and files: `stereo-noise`.
    pub name: Cow<'static, str>,
    /// One line of help.
    pub help: Cow<'static, str>,
    /// The required input.
    pub input: EngineInput,
    /// The technology of the cameras that the engine models; `None` if it models no physical device.
    pub models: Option<Technology>,
    /// Whether the engine is the default for cameras of that technology.
    pub is_default: bool,
    /// The names of all parameters.
    pub parameters: fn() -> Vec<&'static str>,
    /// How [`EngineKind::create`] creates the engine; the setup's parameters are named as in `parameters`.
    pub factory: Factory,
}

impl PartialEq for EngineKind {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for EngineKind {}

impl fmt::Display for EngineKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.name)
    }
}

/// A closure that creates an engine.
pub type Create = dyn Fn(&Setup) -> Result<Arc<dyn Engine>, ParameterError> + Send + Sync;

/// A function or a closure that creates an engine.
#[derive(Clone)]
pub enum Factory {
    /// A function, for kinds that are statics.
    Function(fn(&Setup) -> Result<Arc<dyn Engine>, ParameterError>),
    /// A closure, for kinds that are made at run time.
    Closure(Arc<Create>),
}

impl Factory {
    pub(crate) fn create(&self, setup: &Setup) -> Result<Arc<dyn Engine>, ParameterError> {
        match self {
            Self::Function(create) => create(setup),
            Self::Closure(create) => create(setup),
        }
    }
}

impl fmt::Debug for Factory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Function(_) => "Function",
            Self::Closure(_) => "Closure",
        })
    }
}

/// A chosen kind of engine: one of this crate's, or one that was made at run time.
#[derive(Clone, Debug)]
pub enum EngineRef {
    /// A static kind.
    Static(&'static EngineKind),
    /// A kind that was made at run time.
    Shared(Arc<EngineKind>),
}

impl Deref for EngineRef {
    type Target = EngineKind;

    fn deref(&self) -> &EngineKind {
        match self {
            Self::Static(kind) => kind,
            Self::Shared(kind) => kind,
        }
    }
}

impl From<&'static EngineKind> for EngineRef {
    fn from(kind: &'static EngineKind) -> Self {
        Self::Static(kind)
    }
}

impl From<EngineKind> for EngineRef {
    fn from(kind: EngineKind) -> Self {
        Self::Shared(Arc::new(kind))
    }
}

impl PartialEq for EngineRef {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl PartialEq<EngineKind> for EngineRef {
    fn eq(&self, other: &EngineKind) -> bool {
        **self == *other
    }
}

impl fmt::Display for EngineRef {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

/// The measuring principle of a depth camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Technology {
    /// A stereo pair.
    Stereo,
    /// Time of flight.
    TimeOfFlight,
}

/// The kind of input that an engine requires.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EngineInput {
    /// A depth image, with or without a colour image.
    Depth,
    /// A rectified stereo pair.
    Pair,
}
