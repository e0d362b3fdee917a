use crate::import::error::Fault;
use crate::import::text;

/// The encoding of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NumberKind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl NumberKind {
    fn named(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    pub(super) const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

#[derive(Debug)]
pub(super) struct Property {
    pub(super) name: String,
    /// The type of a list's length; `None` for a scalar property.
    pub(super) list: Option<NumberKind>,
    pub(super) kind: NumberKind,
}

#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: usize,
    pub(super) properties: Vec<Property>,
}

impl Element {
    /// The minimum number of bytes per row.
    pub(super) fn min_size(&self, encoding: Encoding) -> usize {
        let size = |property: &Property| match encoding {
            // A digit and a separator.
            Encoding::Text => 2,
            _ => property.list.unwrap_or(property.kind).size(),
        };
        self.properties.iter().map(size).sum()
    }

    pub(super) fn find(&self, names: &[&str]) -> Option<usize> {
        self.properties
            .iter()
            .position(|property| names.contains(&property.name.as_str()))
    }
}

#[derive(Debug)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// The number of bytes before the body.
    pub(super) length: usize,
    /// The line number at which the body starts.
    pub(super) lines: usize,
    /// The first line with an unknown keyword, with its number.
    pub(super) unknown: Option<(usize, String)>,
}

impl Header {
    /// Whether the rows of a text file are on separate lines, so that surplus values can be recognized.
    pub(super) fn has_line_per_row(&self, body: &[u8]) -> bool {
        let rows = self
            .elements
            .iter()
            .filter(|element| !element.properties.is_empty())
            .fold(0_usize, |rows, element| rows.saturating_add(element.count));
        let lines = text::lines(body).filter(|(_, line)| !line.trim_ascii().is_empty());
        self.encoding == Encoding::Text && lines.take(rows).count() == rows
    }

    pub(super) fn read(bytes: &[u8]) -> Result<Self, Fault> {
        let mut header = Self {
            encoding: Encoding::Text,
            elements: Vec::new(),
            length: 0,
            lines: 0,
            unknown: None,
        };
        let mut format = None;
        for (number, line) in text::lines(bytes) {
            header.length += line.len() + 1;
            header.lines = number + 1;
            let mut words = text::words(line);
            let fault = |message: &str| {
                let message = format!("{message}: {}", text::shown(line));
                Err(Fault::damaged(format!("line {number}"), message))
            };
            match (number, words.next()) {
                (1, Some(b"ply")) => {}
                (1, _) => {
                    return Err(Fault::damaged(
                        "line 1",
                        "is not a PLY file: it does not start with `ply`",
                    ));
                }
                (_, Some(b"format")) => {
                    format = match words.next() {
                        Some(b"ascii") => Some(Encoding::Text),
                        Some(b"binary_little_endian") => Some(Encoding::LittleEndian),
                        Some(b"binary_big_endian") => Some(Encoding::BigEndian),
                        _ => return fault("unknown format"),
                    };
                }
                (_, Some(b"element")) => match (words.next(), words.next().and_then(text::number)) {
                    (Some(name), Some(count)) => header.elements.push(Element {
                        name: String::from_utf8_lossy(name).into_owned(),
                        count,
                        properties: Vec::new(),
                    }),
                    _ => return fault("invalid element: a name and a count are required"),
                },
                (_, Some(b"property")) => match (header.elements.last_mut(), property(&mut words)) {
                    (Some(element), Some(property)) => element.properties.push(property),
                    _ => return fault("invalid property"),
                },
                (_, Some(b"end_header")) => {
                    header.length = header.length.min(bytes.len());
                    let Some(format) = format else {
                        return Err(Fault::damaged("header", "the format is missing"));
                    };
                    header.encoding = format;
                    return Ok(header);
                }
                (_, None | Some(b"comment" | b"obj_info")) => {}
                // Some programs write comments without the keyword.
                _ => {
                    header.unknown.get_or_insert_with(|| (number, text::shown(line)));
                }
            }
        }
        Err(Fault::damaged("header", "end_header is missing"))
    }
}

fn property<'a>(words: &mut impl Iterator<Item = &'a [u8]>) -> Option<Property> {
    let (list, kind) = match words.next()? {
        b"list" => (Some(NumberKind::named(words.next()?)?), words.next()?),
        kind => (None, kind),
    };
    Some(Property {
        kind: NumberKind::named(kind)?,
        list,
        name: String::from_utf8_lossy(words.next()?).into_owned(),
    })
}
