use std::io::Cursor as IoCursor;
use std::panic::{AssertUnwindSafe, catch_unwind};

use openusd::usdc::CrateFile;

use super::values::Values;
use super::{DEEPEST, Problem, TAKE_ANOTHER};

/// More prims, paths or fields than any stage that fits in memory here; bounds what a table may make a reader allocate.
const MOST_ENTRIES: u64 = 1 << 25;
/// LZ4 makes at most 255 bytes of one.
pub(super) const LZ4_RATIO: u64 = 255;
/// Integers are packed to no less than a quarter of a byte before LZ4.
pub(super) const INTS_PER_BYTE: u64 = 4 * LZ4_RATIO;

const WRITE_AGAIN: &str = "write it again with OpenUSD: `usdcat --out NEW.usdc OLD.usdc`";

/// A binary layer: its table of contents, the tables' claims and every value's length against the bytes there are.
///
/// The library allocates what a length claims before it reads, and a failed allocation ends the process.
pub(super) fn inspect(bytes: &[u8]) -> Result<(), Problem> {
    let damaged = |place: &str, what: &str| Problem::new(place, what, TAKE_ANOTHER);
    let mut cursor = Cursor::new(bytes, 8);
    let version = (|| Some((cursor.u8()?, cursor.u8()?, cursor.u8()?)))();
    let toc = Cursor::new(bytes, 16).u64();
    let (Some(version), Some(toc)) = (version, toc) else {
        return Err(damaged("header", "is cut short"));
    };
    if !((0, 4, 0)..(0, 13, 0)).contains(&version) {
        let (major, minor, patch) = version;
        return Err(Problem::new(
            "header",
            format!("binary version {major}.{minor}.{patch} cannot be read (0.4.0 to 0.12.0 can)"),
            WRITE_AGAIN,
        ));
    }
    let mut contents = Cursor::new(bytes, toc);
    let count = contents
        .u64()
        .ok_or_else(|| damaged("table of contents", "lies outside the file: it is cut short"))?;
    if count == 0 || count > 64 {
        return Err(damaged("table of contents", &format!("claims {count} sections")));
    }
    for _ in 0..count {
        let section = contents
            .take(16)
            .and_then(|name| Some((name, contents.u64()?, contents.u64()?)));
        let Some((name, start, size)) = section else {
            return Err(damaged("table of contents", "is cut short"));
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
            return Err(damaged(&place, "claims more entries than its bytes can hold"));
        }
    }
    // The library's own reader decodes the tables; whatever it trips over there, it would trip over later.
    let decoded = catch_unwind(AssertUnwindSafe(|| CrateFile::open(IoCursor::new(bytes))));
    let file = match decoded {
        Ok(Ok(file)) => file,
        Ok(Err(error)) => {
            return Err(damaged(
                "tables",
                &crate::stage::error::one_line(&format!("{error:#}")),
            ));
        }
        Err(_) => return Err(damaged("tables", "contradict each other")),
    };
    let deep = |path: &str| path.bytes().filter(|byte| *byte == b'/').count() > DEEPEST;
    if let Some(path) = file.paths.iter().find(|path| deep(path.as_str())) {
        let start: String = path.as_str().chars().take(60).collect();
        return Err(Problem::new(
            format!("{start}…"),
            format!("prims nest more than {DEEPEST} deep"),
            "flatten the stage",
        ));
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
    Ok(())
}

/// Whether a table's own counts fit its bytes.
fn table_fits(name: &str, section: &[u8], file_length: usize) -> bool {
    let length = u64::try_from(section.len()).unwrap_or(u64::MAX);
    let file_length = u64::try_from(file_length).unwrap_or(u64::MAX);
    let mut cursor = Cursor::new(section, 0);
    let entries = |cursor: &mut Cursor| {
        cursor.u64().filter(|count| {
            *count <= length.saturating_mul(INTS_PER_BYTE)
                && *count <= file_length.saturating_mul(64)
                && *count <= MOST_ENTRIES
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

/// A place in bytes, little-endian; every read past the end is `None`.
#[derive(Clone, Copy)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: u64,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(bytes: &'a [u8], at: u64) -> Self {
        Self { bytes, at }
    }

    pub(super) fn position(&self) -> u64 {
        self.at
    }

    pub(super) fn remaining(&self) -> u64 {
        u64::try_from(self.bytes.len())
            .unwrap_or(u64::MAX)
            .saturating_sub(self.at)
    }

    pub(super) fn take(&mut self, count: u64) -> Option<&'a [u8]> {
        let end = self.at.checked_add(count)?;
        let taken = self
            .bytes
            .get(usize::try_from(self.at).ok()?..usize::try_from(end).ok()?)?;
        self.at = end;
        Some(taken)
    }

    pub(super) fn u8(&mut self) -> Option<u8> {
        self.take(1)?.first().copied()
    }

    pub(super) fn u32(&mut self) -> Option<u32> {
        Some(u32::from_le_bytes(self.take(4)?.try_into().ok()?))
    }

    pub(super) fn u64(&mut self) -> Option<u64> {
        Some(u64::from_le_bytes(self.take(8)?.try_into().ok()?))
    }

    pub(super) fn i64(&mut self) -> Option<i64> {
        Some(i64::from_le_bytes(self.take(8)?.try_into().ok()?))
    }

    /// Past blocks that are each preceded by their length.
    fn chunks(&mut self, count: usize) -> Option<()> {
        for _ in 0..count {
            let length = self.u64()?;
            self.take(length)?;
        }
        Some(())
    }
}
