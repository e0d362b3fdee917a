//! Triangle files that every engine can read: little-endian numbers without a header.

use std::fs::File;
use std::io::{self, BufReader, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

use oaktwin_scene::Mesh;

/// The files of a scene's triangles.
#[derive(Clone, Debug)]
pub(crate) struct Files {
    pub(crate) positions: PathBuf,
    pub(crate) triangles: PathBuf,
}

impl Files {
    pub(crate) fn of(folder: &Path, scene: &str) -> Self {
        Self {
            positions: folder.join(format!("{scene}.positions.f32")),
            triangles: folder.join(format!("{scene}.triangles.u32")),
        }
    }

    pub(crate) fn exist(&self) -> bool {
        self.positions.exists() && self.triangles.exists()
    }

    pub(crate) fn write(&self, mesh: &Mesh) -> io::Result<()> {
        write(
            &self.positions,
            mesh.positions.iter().flatten().map(|x| x.to_le_bytes()),
        )?;
        write(
            &self.triangles,
            mesh.triangles.iter().flatten().map(|x| x.to_le_bytes()),
        )
    }

    pub(crate) fn read(&self) -> io::Result<Mesh> {
        Ok(Mesh {
            positions: read(&self.positions, |bytes| bytes.map(f32::from_le_bytes))?,
            triangles: read(&self.triangles, |bytes| bytes.map(u32::from_le_bytes))?,
            ..Mesh::default()
        })
    }
}

fn write(path: &Path, words: impl Iterator<Item = [u8; 4]>) -> io::Result<()> {
    let mut file = BufWriter::new(File::create(path)?);
    for word in words {
        file.write_all(&word)?;
    }
    file.flush()
}

/// Reads piecewise, so that the file is never in memory twice: memory is measured.
fn read<T>(path: &Path, parse: impl Fn([[u8; 4]; 3]) -> [T; 3]) -> io::Result<Vec<[T; 3]>> {
    let file = File::open(path)?;
    let count = usize::try_from(file.metadata()?.len() / 12).unwrap_or(usize::MAX);
    let mut file = BufReader::with_capacity(1 << 16, file);
    let mut items = Vec::with_capacity(count);
    let mut item = [[0; 4]; 3];
    for _ in 0..count {
        file.read_exact(item.as_flattened_mut())?;
        items.push(parse(item));
    }
    Ok(items)
}

pub(crate) fn write_depth(path: &Path, depth: &[f32]) -> io::Result<()> {
    write(path, depth.iter().map(|x| x.to_le_bytes()))
}

pub(crate) fn read_depth(path: &Path) -> io::Result<Vec<f32>> {
    let bytes = std::fs::read(path)?;
    let word = |bytes: &[u8]| f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
    Ok(bytes.chunks_exact(4).map(word).collect())
}
