//! Imports OBJ with MTL: polygons by object or group, texture coordinates, normals, and vertex colours.
//!
//! `#` begins a comment at the start of a line and after the numbers of a statement. In the names of objects, groups, materials and
//! files it is a character like others, as in trimesh: 3ds Max calls materials `Material #25`. Where no material or file
//! has such a name, what follows ` #` is a comment.

mod mtl;
mod optics;
mod part;
mod words;

use std::collections::BTreeMap;
use std::path::Path;

use oaktwin_camera::math::{DAffine3, DVec3};

use self::mtl::Library;
use self::part::{Corner, Part, Pool};
use super::builder::{Builder, step};
use super::error::Fault;
use super::origin::{FAR_M, FAR_PART_M};
use super::text;
use oaktwin_image::srgb;

pub(super) fn read(bytes: &[u8], path: &Path, builder: &mut Builder) -> Result<(), Fault> {
    let mut reader = Reader {
        folder: path.parent().unwrap_or(Path::new("")),
        builder,
        pool: Pool::default(),
        parts: Vec::new(),
        part_of_name: BTreeMap::new(),
        current: None,
        object: String::new(),
        group: String::new(),
        library: Library::default(),
        material: None,
        left_out: BTreeMap::new(),
        bad_corners: 0,
    };
    let mut known = 0_usize;
    for (number, line) in text::continued_lines(&text::decoded(bytes)) {
        known += usize::from(reader.line(&line, number)?);
    }
    if known == 0 {
        return Err(Fault::new(
            "",
            "is not an OBJ file: it has no OBJ statement",
            "use an OBJ file",
        ));
    }
    reader.finish();
    Ok(())
}

struct Reader<'a> {
    folder: &'a Path,
    builder: &'a mut Builder,
    pool: Pool,
    parts: Vec<Part>,
    part_of_name: BTreeMap<String, usize>,
    /// The part that faces are added to; `None` after a new name.
    current: Option<usize>,
    object: String,
    group: String,
    library: Library,
    material: Option<u32>,
    /// Unsupported statements with their number.
    left_out: BTreeMap<&'static str, usize>,
    bad_corners: usize,
}

impl Reader<'_> {
    /// Returns false for an unknown statement.
    fn line(&mut self, line: &[u8], number: usize) -> Result<bool, Fault> {
        // A comment ends a statement of numbers; a name is the rest of its line, and may contain the sign.
        let name = line.trim_ascii();
        let line = line.split(|&byte| byte == b'#').next().unwrap_or_default();
        let mut words = text::words(line);
        let bad = |what: &str| {
            let message = format!("{what}: {}", text::shown(line));
            Err(Fault::damaged(format!("line {number}"), message))
        };
        let Some(word) = words.next() else {
            return Ok(false);
        };
        match word {
            b"v" => match text::numbers(&mut words) {
                Some(point) => self.pool.push_point(point, point_color(&mut words)),
                None => return bad("expected three coordinates"),
            },
            b"vt" => match text::numbers::<f32, 1>(&mut words) {
                Some([u]) => self
                    .pool
                    .uvs
                    .push([u, words.next().and_then(text::number).unwrap_or(0.0)]),
                None => return bad("expected a texture coordinate"),
            },
            b"vn" => match text::numbers(&mut words) {
                Some(normal) => self.pool.normals.push(normal),
                None => return bad("expected three numbers of a normal"),
            },
            // `fo` is the name of faces in version 2.11 of the format.
            b"f" | b"fo" => {
                if self.face(&mut words).is_none() {
                    return bad("invalid index of a corner");
                }
            }
            b"o" => {
                self.object = rest(name, 1);
                self.current = None;
            }
            b"g" => {
                self.group = rest(name, 1);
                self.current = None;
            }
            b"usemtl" => self.material = Some(self.library.find(&rest(name, 6), self.builder)),
            b"mtllib" => self.library.load(&rest(name, 6), self.folder, self.builder),
            b"p" => *self.left_out.entry("points").or_default() += 1,
            b"l" => *self.left_out.entry("lines").or_default() += 1,
            b"curv" | b"curv2" | b"surf" => *self.left_out.entry("curves and surfaces").or_default() += 1,
            b"s" | b"vp" | b"cstype" | b"deg" | b"parm" | b"trim" | b"hole" | b"end" | b"mg" => {}
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn face<'w>(&mut self, words: &mut impl Iterator<Item = &'w [u8]>) -> Option<()> {
        let current = self.current_part();
        let part = &mut self.parts[current];
        let first = part.corners.len();
        for word in words {
            let mut fields = word.split(|&byte| byte == b'/');
            let point = self.pool.point(text::number(fields.next()?)?);
            // An empty field means that the index is absent.
            let mut optional = |count| match fields.next() {
                None | Some(b"") => Some(Corner::NONE),
                Some(field) => Some(index(text::number(field)?, count)),
            };
            let uv = optional(self.pool.uvs.len())?;
            let normal = optional(self.pool.normals.len())?;
            self.bad_corners += usize::from(uv == Corner::BAD) + usize::from(normal == Corner::BAD);
            part.corners.push(Corner { point, uv, normal });
        }
        part.counts
            .push(i32::try_from(part.corners.len() - first).unwrap_or(i32::MAX));
        part.set_material(self.material);
        Some(())
    }

    fn current_part(&mut self) -> usize {
        let (object, group, parts) = (&self.object, &self.group, &mut self.parts);
        let part_of_name = &mut self.part_of_name;
        *self.current.get_or_insert_with(|| {
            let name = match (object.is_empty(), group.is_empty()) {
                (false, false) if object != group => format!("/{}/{}", step(object), step(group)),
                (false, _) => format!("/{}", step(object)),
                (true, false) => format!("/{}", step(group)),
                (true, true) => String::new(),
            };
            *part_of_name.entry(name).or_insert_with_key(|name| {
                parts.push(Part::new(name));
                parts.len() - 1
            })
        })
    }

    fn finish(self) {
        let builder = self.builder;
        for (what, count) in self.left_out {
            builder.warn("obj-unsupported", what, format!("not supported: {count} skipped"));
        }
        if self.bad_corners > 0 {
            builder.warn(
                "obj-index",
                "f",
                format!(
                    "{} indices of texture coordinates and normals are out of range",
                    self.bad_corners
                ),
            );
        }
        let mut pool = self.pool;
        let all = self
            .parts
            .iter()
            .map(|part| pool.points_of(&part.corners, DVec3::ZERO));
        let common = builder.origin(all.flatten(), FAR_M);
        for part in self.parts {
            let path = if part.path.is_empty() {
                format!("/{}", step(&builder.stem))
            } else {
                part.path.clone()
            };
            let own = builder.origin(pool.points_of(&part.corners, common), FAR_PART_M);
            let origin = common + own;
            let (mesh, findings) = part.polygons(&mut pool, origin).into_mesh(&path);
            builder.findings.extend(findings);
            if let Some(mesh) = builder.add_mesh(mesh) {
                builder.place(mesh, &path, DAffine3::from_translation(origin));
            }
        }
    }
}

/// Converts an OBJ index, which counts from 1 or backwards from −1, to a zero-based one.
fn index(index: i64, count: usize) -> i32 {
    let count = i64::try_from(count).unwrap_or(i64::MAX);
    let zero_based = match index {
        1.. => index - 1,
        0 => -1,
        _ => index.saturating_add(count),
    };
    if (0..count).contains(&zero_based) {
        i32::try_from(zero_based).unwrap_or(Corner::BAD)
    } else {
        Corner::BAD
    }
}

/// The colour that some programs write after a point, possibly after a weight.
fn point_color<'a>(words: &mut impl Iterator<Item = &'a [u8]>) -> Option<[f32; 3]> {
    let numbers: Vec<f32> = words.take(4).map_while(text::number).collect();
    match *numbers.as_slice() {
        [r, g, b] | [_, r, g, b] => Some([r, g, b].map(srgb::linear)),
        _ => None,
    }
}

/// What a name may be, the longest first: the whole, or what comes before a comment.
fn names(whole: &str) -> impl Iterator<Item = &str> {
    let starts = whole.rmatch_indices('#').map(|(at, _)| &whole[..at]);
    let shorter = starts
        .filter(|name| name.ends_with([' ', '\t']))
        .map(str::trim_end);
    std::iter::once(whole).chain(shorter)
}

/// The remainder of a line after its first word, including spaces.
fn rest(line: &[u8], word: usize) -> String {
    let line = line.trim_ascii();
    String::from_utf8_lossy(line.get(word..).unwrap_or_default().trim_ascii()).into_owned()
}
