use std::io::Cursor as IoCursor;

use oaktwin_base::panics;
use openusd::sdf::SpecType;
use openusd::usdc::CrateFile;

use super::super::ancestry;
use super::cursor::{Cursor, INTS_PER_BYTE, LZ4_RATIO};
use super::outline::{ANIMATION_FIELDS, ARC_FIELDS, Arcs, Outline, ROOT_FIELDS};
use super::values::Values;
use super::{Problem, USE_ANOTHER_COPY};

/// The maximum number of prims, paths or fields, which bounds the allocations of a reader.
const MAX_ENTRIES: u64 = 1 << 25;
const CONTRADICT: &str = "contradict each other";
const WRITE_AGAIN: &str = "rewrite it with OpenUSD: `usdcat --out NEW.usdc OLD.usdc`";

/// Validates a binary layer: compares its table of contents, the sizes of the tables and the length of every value with
/// the file's size. Returns its outline.
///
/// The library allocates the claimed length before it reads, and a failed allocation aborts the process.
pub(super) fn inspect(bytes: &[u8]) -> Result<Outline, Problem> {
    let damaged = |place: &str, what: &str| Problem::new(place, what, USE_ANOTHER_COPY);
    let mut cursor = Cursor::new(bytes, 8);
    let version = (|| Some((cursor.u8()?, cursor.u8()?, cursor.u8()?)))();
    let toc = Cursor::new(bytes, 16).u64();
    let (Some(version), Some(toc)) = (version, toc) else {
        return Err(damaged("header", "is truncated"));
    };
    if !((0, 4, 0)..(0, 13, 0)).contains(&version) {
        let (major, minor, patch) = version;
        return Err(Problem::new(
            "header",
            format!("binary version {major}.{minor}.{patch} is not supported (0.4.0 to 0.12.0 are)"),
            WRITE_AGAIN,
        ));
    }
    let mut contents = Cursor::new(bytes, toc);
    let count = contents
        .u64()
        .ok_or_else(|| damaged("table of contents", "is outside the file, which is truncated"))?;
    if count == 0 || count > 64 {
        return Err(damaged("table of contents", &format!("claims {count} sections")));
    }
    for _ in 0..count {
        let section = contents
            .take(16)
            .and_then(|name| Some((name, contents.u64()?, contents.u64()?)));
        let Some((name, start, size)) = section else {
            return Err(damaged("table of contents", "is truncated"));
        };
        let name = String::from_utf8_lossy(name.split(|byte| *byte == 0).next().unwrap_or_default());
        let bounds = start
            .checked_add(size)
            .and_then(|end| bytes.get(usize::try_from(start).ok()?..usize::try_from(end).ok()?));
        let place = format!("section {name}");
        let Some(section) = bounds else {
            return Err(damaged(
                &place,
                &format!("claims {size} bytes at {start}, but the file has {}", bytes.len()),
            ));
        };
        if !table_fits(&name, section, bytes.len()) {
            return Err(damaged(&place, "claims more entries than fit in its bytes"));
        }
    }
    // Decode the tables with the library's own reader to detect panics early.
    let decoded = panics::contain(|| CrateFile::open(IoCursor::new(bytes)));
    let mut file = match decoded {
        Ok(Ok(file)) => file,
        Ok(Err(error)) => {
            return Err(damaged(
                "tables",
                &crate::stage::error::one_line(&format!("{error:#}")),
            ));
        }
        Err(_) => return Err(damaged("tables", CONTRADICT)),
    };
    for path in &file.paths {
        if let Some(defect) = ancestry::defect(path) {
            let place = format!("path `{}`", ancestry::beginning(path.as_str()));
            return Err(damaged(&place, &defect));
        }
    }
    let mut values = Values::new(bytes, version);
    for field in &file.fields {
        if values.check(field.value_rep.0, 0).is_none() {
            let name = file.tokens.get(field.token_index).map_or("?", String::as_str);
            return Err(damaged(
                &format!("field `{name}`"),
                "its value claims more bytes than the file has",
            ));
        }
    }
    panics::contain(|| outline(&mut file)).unwrap_or_else(|_| Err(damaged("tables", CONTRADICT)))
}

/// Returns the outline of a layer whose values are valid.
fn outline(file: &mut CrateFile<IoCursor<&[u8]>>) -> Result<Outline, Problem> {
    let token = |name: &&'static str| {
        let index = file.tokens.iter().position(|token| token == name);
        index.map(|index| (index, *name))
    };
    let of_layer: Vec<(usize, &str)> = ROOT_FIELDS.iter().filter_map(token).collect();
    let of_prims: Vec<(usize, &str)> = ARC_FIELDS.iter().filter_map(token).collect();
    let mut prims = 0;
    let (mut in_layer, mut in_prims) = (Vec::new(), Vec::new());
    for spec in &file.specs {
        let (wanted, found) = match spec.spec_type {
            SpecType::PseudoRoot => (&of_layer, &mut in_layer),
            SpecType::Prim | SpecType::Variant => (&of_prims, &mut in_prims),
            _ => continue,
        };
        prims += u64::from(spec.spec_type == SpecType::Prim);
        if wanted.is_empty() {
            continue;
        }
        let fields = file.fieldsets[spec.fieldset_index..]
            .iter()
            .map_while(|field| *field);
        for field in fields.filter_map(|field| file.fields.get(field)) {
            if let Some((_, name)) = wanted.iter().find(|(token, _)| *token == field.token_index) {
                found.push((spec.path_index, *name, field.value_rep));
            }
        }
    }
    let mut arcs = Arcs::new(prims);
    arcs.outline.is_animated = file
        .tokens
        .iter()
        .any(|token| ANIMATION_FIELDS.contains(&token.as_str()));
    for (_, name, value) in in_layer {
        if let Ok(value) = file.value(value) {
            arcs.root(name, &value)?;
        }
    }
    for (path, name, value) in in_prims {
        if let Ok(value) = file.value(value) {
            arcs.add(&file.paths[path], name, &value)?;
        }
    }
    Ok(arcs.outline)
}

/// Whether a table's counts fit its bytes.
fn table_fits(name: &str, section: &[u8], file_length: usize) -> bool {
    let length = u64::try_from(section.len()).unwrap_or(u64::MAX);
    let file_length = u64::try_from(file_length).unwrap_or(u64::MAX);
    let mut cursor = Cursor::new(section, 0);
    let entries = |cursor: &mut Cursor| {
        cursor.u64().filter(|count| {
            *count <= length.saturating_mul(INTS_PER_BYTE)
                && *count <= file_length.saturating_mul(64)
                && *count <= MAX_ENTRIES
        })
    };
    let fits = match name {
        "TOKENS" => (|| {
            let (count, plain, packed) = (cursor.u64()?, cursor.u64()?, cursor.u64()?);
            let fits = count <= plain && packed <= length && plain <= packed.saturating_mul(LZ4_RATIO);
            fits.then_some(())
        })(),
        "STRINGS" => (|| (cursor.u64()? <= length / 4).then_some(()))(),
        "FIELDS" => entries(&mut cursor).and_then(|_| cursor.chunks(2)),
        "FIELDSETS" => entries(&mut cursor).and_then(|_| cursor.chunks(1)),
        "PATHS" => (|| {
            entries(&mut cursor)?;
            entries(&mut cursor)?;
            cursor.chunks(3)
        })(),
        "SPECS" => entries(&mut cursor).and_then(|_| cursor.chunks(3)),
        _ => Some(()),
    };
    fits.is_some()
}
