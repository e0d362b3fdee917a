//! Files that another file names, such as the textures of a scene. Whoever wrote the scene chose them, so they are opened
//! with care: a pipe could make the program wait forever, and a device may be endless or act when it is opened.

use std::fs::{self, File, Metadata};
use std::io::{self, Read};
use std::path::Path;

use crate::error::or_current;

/// Opens a regular file.
///
/// # Errors
/// Returns an error if the file cannot be opened or is not a regular file.
pub fn open_regular(path: &Path) -> io::Result<File> {
    let check = |metadata: &Metadata| match metadata.is_file() {
        true => Ok(()),
        false if metadata.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        false => Err(io::Error::other("is not a regular file")),
    };
    check(&fs::metadata(path)?)?;
    let mut options = File::options();
    options.read(true);
    // Another kind of file may have taken its place in the meantime: then opening it must not block either.
    #[cfg(unix)]
    {
        use rustix::fs::OFlags;
        use std::os::unix::fs::OpenOptionsExt;
        let flags = OFlags::NONBLOCK | OFlags::NOCTTY;
        options.custom_flags(flags.bits().cast_signed());
    }
    let file = options.open(path)?;
    check(&file.metadata()?)?;
    Ok(file)
}

/// Reads a regular file of at most `limit` bytes.
///
/// # Errors
/// Returns an error if the file cannot be read, is not a regular file or is larger than the limit.
pub fn read_regular(path: &Path, limit: u64) -> io::Result<Vec<u8>> {
    let file = open_regular(path)?;
    let length = file.metadata()?.len();
    let too_large = || io::Error::other(format!("is larger than {} MiB", limit >> 20));
    if length > limit {
        return Err(too_large());
    }
    let mut bytes = Vec::new();
    bytes.try_reserve(usize::try_from(length).map_err(|_| too_large())?)?;
    // It may grow while it is read.
    file.take(limit + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limit {
        return Err(too_large());
    }
    Ok(bytes)
}

/// Whether a file is in a folder or below it, after symbolic links are followed; `false` if either does not exist.
#[must_use]
pub fn is_below(file: &Path, folder: &Path) -> bool {
    match (file.canonicalize(), or_current(folder).canonicalize()) {
        (Ok(file), Ok(folder)) => file.starts_with(folder),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_the_size() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, vec![7; (1 << 20) + 1]).unwrap();
        assert_eq!(read_regular(&path, (1 << 20) + 1).unwrap().len(), (1 << 20) + 1);
        let error = read_regular(&path, 1 << 20).unwrap_err();
        assert_eq!(error.to_string(), "is larger than 1 MiB");
    }

    #[cfg(unix)]
    #[test]
    fn refuses_everything_but_regular_files() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        let mode = rustix::fs::Mode::from_raw_mode(0o600);
        rustix::fs::mkfifoat(rustix::fs::CWD, &pipe, mode).unwrap();
        for path in [&pipe, Path::new("/dev/zero"), Path::new("/dev/tty")] {
            let error = open_regular(path).unwrap_err();
            assert_eq!(error.to_string(), "is not a regular file", "{}", path.display());
        }
        let error = open_regular(folder.path()).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::IsADirectory);
        assert_eq!(
            open_regular(&folder.path().join("no")).unwrap_err().kind(),
            io::ErrorKind::NotFound
        );
    }

    #[cfg(unix)]
    #[test]
    fn links_that_lead_outside_are_outside() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir_all(at("scene/textures")).unwrap();
        fs::write(at("secret"), "x").unwrap();
        fs::write(at("scene/textures/a.png"), "x").unwrap();
        std::os::unix::fs::symlink("../../secret", at("scene/textures/link")).unwrap();
        std::os::unix::fs::symlink("a.png", at("scene/textures/inside")).unwrap();
        let is_inside = |name: &str| is_below(&at(name), &at("scene"));
        assert!(is_inside("scene/textures/a.png") && is_inside("scene/textures/inside"));
        assert!(is_inside("scene/../scene/textures/a.png"));
        for name in ["secret", "scene/../secret", "scene/textures/link", "scene/no"] {
            assert!(!is_inside(name), "{name}");
        }
    }
}
