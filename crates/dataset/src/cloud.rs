//! The arrays of `pointcloud`.

use oaktwin_image::npy;

use crate::file::Fault;

/// Encodes points as `(N, 3)` float32.
pub(crate) fn points(points: &[[f32; 3]]) -> Result<Vec<u8>, Fault> {
    Ok(npy::encode(&[points.len(), 3], points.as_flattened())?)
}

/// Encodes normals as `(N, 4)` float32; the fourth component is 1, as in Replicator.
pub(crate) fn normals(normals: &[[f32; 3]]) -> Result<Vec<u8>, Fault> {
    let padded: Vec<[f32; 4]> = normals.iter().map(|&[x, y, z]| [x, y, z, 1.0]).collect();
    Ok(npy::encode(&[normals.len(), 4], padded.as_flattened())?)
}

/// Encodes colours as `(N, 4)` uint8.
pub(crate) fn rgb(rgb: &[[u8; 4]]) -> Result<Vec<u8>, Fault> {
    Ok(npy::encode(&[rgb.len(), 4], rgb.as_flattened())?)
}

/// Encodes ids as `(N,)` uint8, as in Replicator, or uint32 if an id exceeds 255.
pub(crate) fn ids(ids: &[u32]) -> Result<Vec<u8>, Fault> {
    let bytes: Option<Vec<u8>> = ids.iter().map(|&id| u8::try_from(id).ok()).collect();
    Ok(match bytes {
        Some(bytes) => npy::encode(&[ids.len()], &bytes)?,
        None => npy::encode(&[ids.len()], ids)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(file: Result<Vec<u8>, Fault>) -> String {
        let Ok(file) = file else { panic!("not encoded") };
        String::from_utf8_lossy(&file[10..])
            .split_inclusive('}')
            .next()
            .unwrap()
            .to_owned()
    }

    #[test]
    fn writes_types_and_shapes() {
        let says =
            |descr, shape| format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}");
        assert_eq!(header(points(&[[0.0; 3]; 5])), says("<f4", "(5, 3)"));
        assert_eq!(header(normals(&[[0.0; 3]; 5])), says("<f4", "(5, 4)"));
        assert_eq!(header(rgb(&[[0; 4]; 5])), says("|u1", "(5, 4)"));
        assert_eq!(header(ids(&[0, 255])), says("|u1", "(2,)"));
        assert_eq!(header(ids(&[0, 256])), says("<u4", "(2,)"));
        assert_eq!(header(points(&[])), says("<f4", "(0, 3)"));
    }
}
