//! usdz packages: zip archives of uncompressed files whose data start at multiples of 64 bytes. The first file is the
//! root layer. The output is reproducible: the time stamp is always the format's earliest, 1980-01-01.

use thiserror::Error;

/// The reason why files cannot be packaged.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum UsdzError {
    /// The package exceeds the limits of zip without its 64-bit extension, which usdz readers need not support.
    #[error("{name}: the package would exceed 4 GiB or 65535 files; reduce its size")]
    TooLarge {
        /// The file at which the limit is exceeded.
        name: String,
    },
    /// A file name is invalid inside a package or occurs twice.
    #[error(
        "{name:?}: invalid or duplicate name in a package; use a unique relative path with forward slashes"
    )]
    Name {
        /// The name.
        name: String,
    },
}

/// The alignment of every file's data, bytes.
const ALIGNMENT: usize = 64;
/// 1980-01-01 in MS-DOS format: year 0, month 1, day 1.
const DOS_DATE: u16 = 1 << 5 | 1;
const LOCAL_HEADER: usize = 30;
/// The id of the padding field, which readers skip; OpenUSD uses the same.
const PADDING_ID: u16 = 0x1986;
/// Flag bit 11: names are UTF-8.
const UTF8_NAMES: u16 = 1 << 11;

/// Packs `(name, bytes)` files in order; the first is the root layer.
///
/// # Errors
/// Returns an error if a name is empty, absolute, contains `..` or occurs twice, or if the package exceeds 4 GiB.
pub fn pack(files: &[(&str, &[u8])]) -> Result<Vec<u8>, UsdzError> {
    let mut archive = Vec::with_capacity(files.iter().map(|(_, data)| data.len() + 512).sum());
    let mut directory = Vec::new();
    for (i, &(name, data)) in files.iter().enumerate() {
        if !is_package_name(name) || files[..i].iter().any(|(other, _)| *other == name) {
            return Err(UsdzError::Name { name: name.into() });
        }
        let too_large = || UsdzError::TooLarge { name: name.into() };
        let offset = u32::try_from(archive.len()).map_err(|_| too_large())?;
        let size = u32::try_from(data.len()).map_err(|_| too_large())?;
        let name_length = u16::try_from(name.len()).map_err(|_| too_large())?;
        let padding = padding_field(archive.len() + LOCAL_HEADER + name.len());
        let common = Entry {
            flags: if name.is_ascii() { 0 } else { UTF8_NAMES },
            crc: crc32fast::hash(data),
            size,
            name_length,
        };

        put_u32(&mut archive, 0x0403_4b50);
        common.write(&mut archive);
        put_u16(&mut archive, u16::try_from(padding.len()).unwrap_or(0));
        archive.extend_from_slice(name.as_bytes());
        archive.extend_from_slice(&padding);
        archive.extend_from_slice(data);

        put_u32(&mut directory, 0x0201_4b50);
        put_u16(&mut directory, 10); // made by: zip 1.0
        common.write(&mut directory);
        for _ in 0..4 {
            put_u16(&mut directory, 0); // extra, comment, disk, internal attributes
        }
        put_u32(&mut directory, 0); // external attributes
        put_u32(&mut directory, offset);
        directory.extend_from_slice(name.as_bytes());
    }
    let last = || files.last().map_or("", |(name, _)| name).to_owned();
    let too_large = || UsdzError::TooLarge { name: last() };
    let count = u16::try_from(files.len()).map_err(|_| too_large())?;
    let offset = u32::try_from(archive.len()).map_err(|_| too_large())?;
    let size = u32::try_from(directory.len()).map_err(|_| too_large())?;
    archive.append(&mut directory);
    put_u32(&mut archive, 0x0605_4b50);
    put_u16(&mut archive, 0);
    put_u16(&mut archive, 0);
    put_u16(&mut archive, count);
    put_u16(&mut archive, count);
    put_u32(&mut archive, size);
    put_u32(&mut archive, offset);
    put_u16(&mut archive, 0);
    Ok(archive)
}

/// The fields common to local headers and directory entries.
struct Entry {
    flags: u16,
    crc: u32,
    size: u32,
    name_length: u16,
}

impl Entry {
    fn write(&self, out: &mut Vec<u8>) {
        put_u16(out, 10); // needs zip 1.0
        put_u16(out, self.flags);
        put_u16(out, 0); // stored
        put_u16(out, 0); // midnight
        put_u16(out, DOS_DATE);
        put_u32(out, self.crc);
        put_u32(out, self.size);
        put_u32(out, self.size);
        put_u16(out, self.name_length);
    }
}

/// Returns an extra field that starts at `start` and ends at a multiple of 64: empty, or at least its 4-byte header.
fn padding_field(start: usize) -> Vec<u8> {
    let short = (ALIGNMENT - start % ALIGNMENT) % ALIGNMENT;
    if short == 0 {
        return Vec::new();
    }
    let length = if short < 4 { short + ALIGNMENT } else { short };
    let mut field = Vec::with_capacity(length);
    put_u16(&mut field, PADDING_ID);
    put_u16(&mut field, u16::try_from(length - 4).unwrap_or(0));
    field.resize(length, 0);
    field
}

fn is_package_name(name: &str) -> bool {
    !name.contains('\\')
        && !name.contains(':')
        && name
            .split('/')
            .all(|part| !part.is_empty() && part != "." && part != "..")
}

fn put_u16(out: &mut Vec<u8>, value: u16) {
    out.extend_from_slice(&value.to_le_bytes());
}

fn put_u32(out: &mut Vec<u8>, value: u32) {
    out.extend_from_slice(&value.to_le_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn u16_at(bytes: &[u8], at: usize) -> usize {
        u16::from_le_bytes(bytes[at..at + 2].try_into().unwrap()).into()
    }

    fn u32_at(bytes: &[u8], at: usize) -> usize {
        u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize
    }

    proptest! {
        #[test]
        fn aligns_every_file_to_64_bytes(names in prop::collection::btree_set("[a-z]{1,70}\\.usda", 1..5), data in prop::collection::vec(any::<u8>(), 0..300)) {
            let files: Vec<(&str, &[u8])> = names.iter().map(|name| (name.as_str(), &data[..])).collect();
            let archive = pack(&files).unwrap();
            prop_assert_eq!(&archive, &pack(&files).unwrap());
            // Walks the directory from the end record, as a zip reader does.
            let end = archive.len() - 22;
            prop_assert_eq!(u32_at(&archive, end), 0x0605_4b50);
            let mut entry = u32_at(&archive, end + 16);
            for (name, data) in files {
                let local = u32_at(&archive, entry + 42);
                let begin = local + 30 + u16_at(&archive, local + 26) + u16_at(&archive, local + 28);
                prop_assert_eq!(begin % 64, 0);
                prop_assert_eq!(&archive[begin..begin + u32_at(&archive, entry + 24)], data);
                prop_assert_eq!(&archive[entry + 46..entry + 46 + u16_at(&archive, entry + 28)], name.as_bytes());
                entry += 46 + u16_at(&archive, entry + 28);
            }
            prop_assert_eq!(entry, end);
        }
    }

    #[test]
    fn rejects_invalid_and_duplicate_names() {
        for name in ["", "/a.usda", "../a.usda", "a//b", "a\\b", "c:a", "a/./b"] {
            assert_eq!(pack(&[(name, b"")]), Err(UsdzError::Name { name: name.into() }));
        }
        assert!(pack(&[("a", b""), ("a", b"")]).is_err());
    }
}
