//! A usdz package: a zip archive of stored files, each file's bytes on a multiple of 64, the first file the layer
//! that opens. Same files, same bytes: the time stamp is the format's earliest, 1980-01-01.

use thiserror::Error;

/// What keeps files from becoming a package.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum UsdzError {
    /// Zip without its 64-bit extension, which usdz readers do not promise to take.
    #[error("{name}: the package would exceed 4 GiB or 65535 files; make it smaller")]
    TooLarge {
        /// The file at which the limit is passed.
        name: String,
    },
    /// A name that no archive may hold.
    #[error("{name:?}: not a file name inside a package; use a relative path with forward slashes, once")]
    Name {
        /// As given.
        name: String,
    },
}

/// Every file's data begin on a multiple of this many bytes.
const ALIGNMENT: usize = 64;
/// 1980-01-01 as MS-DOS has it: year 0, month 1, day 1.
const DOS_DATE: u16 = 1 << 5 | 1;
const LOCAL_HEADER: usize = 30;
/// Readers skip extra fields they do not know; OpenUSD pads with this id as well.
const PADDING_ID: u16 = 0x1986;
/// Bit 11: names are UTF-8.
const UTF8_NAMES: u16 = 1 << 11;

/// Packs `(name, bytes)` files in their order; the first is the layer that opens the package.
///
/// # Errors
/// A name that is empty, absolute, goes up, or occurs twice; a package beyond 4 GiB.
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

/// What a local header and a directory entry have in common.
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

/// An extra field that ends on a multiple of 64 when it begins at `start`: empty, or at least its 4-byte head.
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
        fn every_file_lies_on_64_bytes(names in prop::collection::btree_set("[a-z]{1,70}\\.usda", 1..5), data in prop::collection::vec(any::<u8>(), 0..300)) {
            let files: Vec<(&str, &[u8])> = names.iter().map(|name| (name.as_str(), &data[..])).collect();
            let archive = pack(&files).unwrap();
            prop_assert_eq!(&archive, &pack(&files).unwrap());
            // Walk the directory from the end record, as a zip reader does.
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
    fn names_that_would_leave_the_package() {
        for name in ["", "/a.usda", "../a.usda", "a//b", "a\\b", "c:a", "a/./b"] {
            assert_eq!(pack(&[(name, b"")]), Err(UsdzError::Name { name: name.into() }));
        }
        assert!(pack(&[("a", b""), ("a", b"")]).is_err());
    }
}
