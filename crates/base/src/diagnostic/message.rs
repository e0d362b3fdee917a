use std::borrow::Cow;
use std::cell::Cell;
use std::fmt;
use std::iter;
use std::ops::Deref;

use serde::{Serialize, Serializer};

/// The spelling of options in a front end: `--fx` on a command line, `fx=` in Python.
pub type OptionStyle = fn(&Opt) -> String;

thread_local! {
    static STYLE: Cell<Option<OptionStyle>> = const { Cell::new(None) };
}

/// Runs `print` with `style` as the spelling of the options in every [`Message`] that this thread displays or serializes
/// meanwhile, however deep in an error it is.
///
/// ```
/// use oaktwin_base::diagnostic::{message, opt, with_style};
///
/// let message = message!["run--fx/a.npy: no ", opt("fx")];
/// assert_eq!(message.to_string(), "run--fx/a.npy: no 'fx'");
/// let printed = with_style(|option| format!("--{}", option.name()), || format!("error: {message}"));
/// assert_eq!(printed, "error: run--fx/a.npy: no --fx");
/// ```
pub fn with_style<T>(style: OptionStyle, print: impl FnOnce() -> T) -> T {
    struct Restore(Option<OptionStyle>);
    impl Drop for Restore {
        fn drop(&mut self) {
            STYLE.set(self.0);
        }
    }
    let _restore = Restore(STYLE.replace(Some(style)));
    print()
}

/// A reference to an option of the program or an argument of the Python package, perhaps with a value to set it to.
///
/// Its name is the one that the command line uses, without hyphens in front: `depth-scale`. A front end chooses the
/// spelling when it prints a [`Message`], [`with_style`]: `--depth-scale 0.001`, `depth_scale=0.001`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Opt {
    name: &'static str,
    value: Option<String>,
    is_command: bool,
}

/// A reference to the option `name`.
#[must_use]
pub const fn opt(name: &'static str) -> Opt {
    Opt {
        name,
        value: None,
        is_command: false,
    }
}

/// A reference to the program's command `name`, which is a function of the Python package.
#[must_use]
pub const fn command(name: &'static str) -> Opt {
    Opt {
        name,
        value: None,
        is_command: true,
    }
}

impl Opt {
    /// The same option set to `value`.
    #[must_use]
    pub fn with(self, value: impl fmt::Display) -> Self {
        Self {
            value: Some(value.to_string()),
            ..self
        }
    }

    /// The name, such as `depth-scale`.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// Whether it is a command, not an option.
    #[must_use]
    pub const fn is_command(&self) -> bool {
        self.is_command
    }

    /// The value to set it to.
    #[must_use]
    pub fn value(&self) -> Option<&str> {
        self.value.as_deref()
    }
}

/// The spelling that suits no front end in particular: `'depth-scale'`, `'depth-scale=0.001'`.
impl fmt::Display for Opt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.value {
            None => write!(f, "'{}'", self.name),
            Some(value) => write!(f, "'{}={value}'", self.name),
        }
    }
}

/// A text with references to options in it.
///
/// The text is complete with each option in its neutral spelling (see [`Opt`]), so a message can be used like a `str`.
/// The positions of the options are kept beside it: [`with_style`] replaces only these, whatever a path
/// or a name in the text may look like. [`message!`](crate::message) builds one from its parts. An error stores
/// its message as a `Message`: formatting it into a string would fix the options in their neutral spelling.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Message {
    text: String,
    /// The options with their positions in `text`, in order.
    options: Vec<(usize, usize, Opt)>,
}

impl Message {
    /// Appends a text, an option or another message.
    pub fn push(&mut self, part: impl Into<Self>) {
        let part = part.into();
        let offset = self.text.len();
        self.text.push_str(&part.text);
        let moved = part.options.into_iter();
        self.options
            .extend(moved.map(|(start, end, option)| (start + offset, end + offset, option)));
    }

    /// The message with other texts between its options.
    #[must_use]
    pub fn map_texts(&self, change: impl Fn(&str) -> String) -> Self {
        let mut changed = Self::default();
        for (text, option) in self.pieces() {
            changed.push(change(text));
            if let Some(option) = option {
                changed.push(option.clone());
            }
        }
        changed
    }

    /// The text with each option spelled by `style`.
    #[must_use]
    pub fn render(&self, style: impl Fn(&Opt) -> String) -> String {
        let mut rendered = String::with_capacity(self.text.len());
        for (text, option) in self.pieces() {
            rendered.push_str(text);
            rendered.extend(option.map(&style));
        }
        rendered
    }

    /// The texts between the options, each with the option after it; the last has none.
    pub(crate) fn pieces(&self) -> impl Iterator<Item = (&str, Option<&Opt>)> {
        let starts = iter::once(0).chain(self.options.iter().map(|(_, end, _)| *end));
        let ends = self
            .options
            .iter()
            .map(|(start, _, option)| (*start, Some(option)));
        let ends = ends.chain(iter::once((self.text.len(), None)));
        starts
            .zip(ends)
            .map(|(from, (to, option))| (&self.text[from..to], option))
    }

    /// The text with each option in its neutral spelling.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// The options that the text refers to, in order.
    pub fn options(&self) -> impl Iterator<Item = &Opt> {
        self.options.iter().map(|(.., option)| option)
    }
}

/// Concatenates texts, [options](Opt) and messages into a [`Message`].
///
/// ```
/// use oaktwin_base::diagnostic::{message, opt};
///
/// let error = message![opt("fx"), format!(": must be a finite number > 0 (got {})", -3)];
/// assert_eq!(error.to_string(), "'fx': must be a finite number > 0 (got -3)");
/// let on_a_command_line = error.render(|option| format!("--{}", option.name()));
/// assert_eq!(on_a_command_line, "--fx: must be a finite number > 0 (got -3)");
/// ```
#[macro_export]
macro_rules! message {
    ($($part:expr),+ $(,)?) => {{
        let mut message = $crate::diagnostic::Message::default();
        $(message.push($part);)+
        message
    }};
}

impl From<String> for Message {
    fn from(text: String) -> Self {
        Self {
            text,
            options: Vec::new(),
        }
    }
}

impl From<&str> for Message {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl From<&String> for Message {
    fn from(text: &String) -> Self {
        text.clone().into()
    }
}

impl From<Cow<'_, str>> for Message {
    fn from(text: Cow<'_, str>) -> Self {
        text.into_owned().into()
    }
}

impl From<&Self> for Message {
    fn from(message: &Self) -> Self {
        message.clone()
    }
}

impl From<Opt> for Message {
    fn from(option: Opt) -> Self {
        let text = option.to_string();
        let options = vec![(0, text.len(), option)];
        Self { text, options }
    }
}

impl Deref for Message {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

/// Each option in the front end's spelling [`with_style`], else in its neutral one.
impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match STYLE.get() {
            Some(style) if !self.options.is_empty() => f.pad(&self.render(style)),
            _ => f.pad(&self.text),
        }
    }
}

impl PartialEq<str> for Message {
    fn eq(&self, other: &str) -> bool {
        self.text == other
    }
}

impl PartialEq<&str> for Message {
    fn eq(&self, other: &&str) -> bool {
        self.text == *other
    }
}

/// The string that is displayed.
impl Serialize for Message {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flag(option: &Opt) -> String {
        match option.value() {
            None => format!("--{}", option.name()),
            Some(value) => format!("--{} {value}", option.name()),
        }
    }

    fn argument(option: &Opt) -> String {
        let name = option.name().replace('-', "_");
        format!("{name}={}", option.value().unwrap_or("…"))
    }

    #[test]
    fn renders_options_in_the_style_of_a_front_end() {
        let remedy = message![
            "set ",
            opt("input-kind").with("z"),
            " or ",
            opt("depth-scale"),
            String::from(", not both"),
        ];
        assert_eq!(
            remedy.to_string(),
            "set 'input-kind=z' or 'depth-scale', not both"
        );
        assert_eq!(
            remedy.render(flag),
            "set --input-kind z or --depth-scale, not both"
        );
        assert_eq!(
            remedy.render(argument),
            "set input_kind=z or depth_scale=…, not both"
        );
        assert!(remedy.options().map(Opt::name).eq(["input-kind", "depth-scale"]));
    }

    #[test]
    fn keeps_paths_that_look_like_options() {
        let path = "run--time/'time'/--time";
        let error = message![path, ": not found; set ", opt("time")];
        assert_eq!(error.render(flag), format!("{path}: not found; set --time"));
        assert_eq!(error.render(argument), format!("{path}: not found; set time=…"));
    }

    #[test]
    fn nested_messages_keep_their_options() {
        let inner = message!["use ", opt("fx")];
        let mut outer = message!["ä: ", &inner];
        outer.push("; ");
        outer.push(inner);
        assert_eq!(outer, "ä: use 'fx'; use 'fx'");
        assert_eq!(outer.render(flag), "ä: use --fx; use --fx");
    }

    #[test]
    fn styles_apply_within_their_scope() {
        #[derive(Debug)]
        struct Error(Message);
        impl fmt::Display for Error {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "run--fx/a.npy: {}", self.0)
            }
        }
        let error = Error(message!["set ", opt("fx")]);
        let printed = with_style(flag, || {
            let inner = with_style(argument, || error.to_string());
            format!("{inner}; {error}")
        });
        assert_eq!(printed, "run--fx/a.npy: set fx=…; run--fx/a.npy: set --fx");
        assert_eq!(error.to_string(), "run--fx/a.npy: set 'fx'");
    }

    #[test]
    fn plain_text_is_unchanged() {
        let message = Message::from("--fx is a file here");
        assert_eq!(message.render(flag), "--fx is a file here");
        assert!(Message::default().is_empty() && message.options().next().is_none());
    }
}
