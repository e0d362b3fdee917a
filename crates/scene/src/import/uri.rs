use std::borrow::Cow;
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::{Message, message, opt};
use oaktwin_files as files;

/// The target of a URI.
pub(super) enum ResolvedUri<'a> {
    /// The decoded bytes of a data URI.
    Data(Vec<u8>),
    /// A file, relative to the file that refers to it.
    File(PathBuf),
    /// A file outside the folder, which is not opened.
    Outside(PathBuf),
    /// An unsupported URI, with the reason.
    Unsupported(&'a str),
}

/// The folder of a glTF file, in which the files that it names are found.
pub(super) struct Folder {
    path: PathBuf,
    /// Whether files elsewhere may be named.
    allow_outside: bool,
}

impl Folder {
    /// The folder of a file.
    pub(super) fn of(file: &Path, allow_outside: bool) -> Self {
        Self {
            path: file.parent().unwrap_or(Path::new("")).to_owned(),
            allow_outside,
        }
    }

    /// Returns the target of a URI. A file that does not exist is reported when it is read.
    pub(super) fn resolve<'a>(&self, uri: &'a str) -> ResolvedUri<'a> {
        let target = resolve(uri, &self.path);
        match target {
            ResolvedUri::File(file)
                if !self.allow_outside && file.exists() && !files::is_below(&file, &self.path) =>
            {
                ResolvedUri::Outside(file)
            }
            target => target,
        }
    }
}

/// What is wrong with a file outside the folder.
pub(super) fn outside(file: &Path) -> String {
    format!("{}: is outside the folder of the glTF file", file.display())
}

/// The remedy for a file outside the folder.
pub(super) fn inside() -> Message {
    message![
        "move it there, or add ",
        opt("allow-outside"),
        " if the scene is trusted"
    ]
}

fn resolve<'a>(uri: &'a str, folder: &Path) -> ResolvedUri<'a> {
    if let Some(data) = uri.strip_prefix("data:") {
        let Some((kind, content)) = data.split_once(',') else {
            return ResolvedUri::Unsupported("a data URI without content");
        };
        if !kind.trim_end().ends_with(";base64") {
            return ResolvedUri::Data(unescaped(content).into_owned());
        }
        return match base64(content.as_bytes()) {
            Some(bytes) => ResolvedUri::Data(bytes),
            None => ResolvedUri::Unsupported("a data URI that is not base64"),
        };
    }
    let name = match uri.split_once(':') {
        // `C:` is a drive, a longer prefix a scheme.
        Some(("file", path)) => {
            let path = path.strip_prefix("//").unwrap_or(path);
            // A drive follows a slash: `file:///C:/a.bin`.
            path.strip_prefix('/')
                .filter(|path| path.get(1..3) == Some(":/"))
                .unwrap_or(path)
        }
        Some((scheme, _))
            if scheme.len() > 1
                && scheme
                    .bytes()
                    .all(|b| b.is_ascii_alphanumeric() || b"+-.".contains(&b)) =>
        {
            return ResolvedUri::Unsupported("a URI that does not refer to a local file");
        }
        _ => uri,
    };
    // Some exporters do not escape names: a file with the literal name takes precedence.
    let as_it_stands = folder.join(name);
    if as_it_stands.exists() {
        return ResolvedUri::File(as_it_stands);
    }
    match String::from_utf8(unescaped(name).into_owned()) {
        Ok(name) => ResolvedUri::File(folder.join(name)),
        Err(_) => ResolvedUri::Unsupported("a name that is not UTF-8"),
    }
}

/// Decodes percent-escapes such as `%20`.
fn unescaped(text: &str) -> Cow<'_, [u8]> {
    if !text.contains('%') {
        return Cow::Borrowed(text.as_bytes());
    }
    let digit = |byte: Option<&u8>| char::from(*byte?).to_digit(16);
    let bytes = text.as_bytes();
    let mut plain = Vec::with_capacity(bytes.len());
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        match (byte, digit(bytes.get(at + 1)), digit(bytes.get(at + 2))) {
            (b'%', Some(high), Some(low)) => {
                plain.push(u8::try_from(16 * high + low).unwrap_or(byte));
                at += 3;
            }
            _ => {
                plain.push(byte);
                at += 1;
            }
        }
    }
    Cow::Owned(plain)
}

/// Decodes Base64 (RFC 4648), padded or not, with either alphabet.
fn base64(text: &[u8]) -> Option<Vec<u8>> {
    let end = text.iter().position(|&byte| byte == b'=').unwrap_or(text.len());
    let mut bytes = Vec::with_capacity(end / 4 * 3 + 2);
    let (mut bits, mut held) = (0_u32, 0);
    for &byte in &text[..end] {
        let value = match byte {
            b'A'..=b'Z' => byte - b'A',
            b'a'..=b'z' => byte - b'a' + 26,
            b'0'..=b'9' => byte - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            b'\r' | b'\n' | b' ' => continue,
            _ => return None,
        };
        bits = bits << 6 | u32::from(value);
        held += 6;
        if held >= 8 {
            held -= 8;
            bytes.push(u8::try_from(bits >> held & 0xff).ok()?);
            bits &= (1 << held) - 1;
        }
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn data(uri: &str) -> Option<Vec<u8>> {
        match resolve(uri, Path::new("")) {
            ResolvedUri::Data(bytes) => Some(bytes),
            _ => None,
        }
    }

    #[test]
    fn data_uris_are_decoded() {
        // The test vectors of RFC 4648, section 10.
        for (text, plain) in [
            ("", ""),
            ("Zg==", "f"),
            ("Zm8=", "fo"),
            ("Zm9v", "foo"),
            ("Zm9vYmFy", "foobar"),
            ("Zm9vYg", "foob"),
        ] {
            let uri = format!("data:application/octet-stream;base64,{text}");
            assert_eq!(data(&uri).unwrap(), plain.as_bytes());
        }
        assert_eq!(data("data:,a%20b%zz").unwrap(), b"a b%zz");
        assert_eq!(data("data:;base64,Zm9*"), None);
        assert_eq!(data("data:nothing"), None);
    }

    #[test]
    fn names_are_unescaped() {
        let file = |uri| match resolve(uri, Path::new("folder")) {
            ResolvedUri::File(path) => Some(path),
            _ => None,
        };
        assert_eq!(file("my%20mesh.bin"), Some("folder/my mesh.bin".into()));
        assert_eq!(file("../other/a.bin"), Some("folder/../other/a.bin".into()));
        assert_eq!(file("file:///tmp/a.bin"), Some("/tmp/a.bin".into()));
        assert_eq!(
            file("file:///C:/a.bin"),
            Some(Path::new("folder").join("C:/a.bin"))
        );
        assert_eq!(file("https://example.org/a.bin"), None);
        assert_eq!(file("%ff.bin"), None);
    }
}
