//! PLY: point clouds, binary and little endian.
//!
//! Source: Greg Turk's description of the format; `Open3D` reads these names of properties.

use crate::{CodecError, Image};

const FORMAT: &str = "PLY";

/// A point cloud. Normals and colours are as long as `points`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cloud<'a> {
    /// The properties `x`, `y`, `z`.
    pub points: &'a [[f32; 3]],
    /// The properties `nx`, `ny`, `nz`.
    pub normals: Option<&'a [[f32; 3]]>,
    /// The properties `red`, `green`, `blue`; the fourth value is ignored.
    pub rgb: Option<&'a [[u8; 4]]>,
}

/// Encodes a point cloud.
///
/// # Errors
/// Returns an error if the number of normals or colours differs from the number of points.
pub fn encode(cloud: &Cloud<'_>) -> Result<Vec<u8>, CodecError> {
    let count = cloud.points.len();
    let counts = [
        ("normals", cloud.normals.map(<[_]>::len)),
        ("colours", cloud.rgb.map(<[_]>::len)),
    ];
    for (name, length) in counts {
        if let Some(length) = length.filter(|&length| length != count) {
            return Err(CodecError::new(
                FORMAT,
                "vertex",
                format!("{length} {name} for {count} points"),
                "pass one for each point",
            ));
        }
    }
    let mut header = format!("ply\nformat binary_little_endian 1.0\nelement vertex {count}\n");
    let mut properties = |kind: &str, [a, b, c]: [&str; 3]| {
        header += &format!("property {kind} {a}\nproperty {kind} {b}\nproperty {kind} {c}\n");
    };
    properties("float", ["x", "y", "z"]);
    if cloud.normals.is_some() {
        properties("float", ["nx", "ny", "nz"]);
    }
    if cloud.rgb.is_some() {
        properties("uchar", ["red", "green", "blue"]);
    }
    header += "end_header\n";
    let mut out = header.into_bytes();
    let vertex = 12 + cloud.normals.map_or(0, |_| 12) + cloud.rgb.map_or(0, |_| 3);
    out.reserve_exact(count * vertex);
    for (i, point) in cloud.points.iter().enumerate() {
        out.extend(point.map(f32::to_le_bytes).as_flattened());
        if let Some(normals) = cloud.normals {
            out.extend(normals[i].map(f32::to_le_bytes).as_flattened());
        }
        if let Some([r, g, b, _]) = cloud.rgb.map(|rgb| rgb[i]) {
            out.extend([r, g, b]);
        }
    }
    Ok(out)
}

/// Encodes the valid points of an image, whose fourth number is above 0, converted to other axes, with the colours of an optional
/// image of the same size.
///
/// # Errors
/// Returns an error if the image of colours has another size.
pub fn encode_measured(
    positions: &Image<[f32; 4]>,
    colors: Option<&Image<[u8; 4]>>,
    axes: impl Fn([f32; 3]) -> [f32; 3],
) -> Result<Vec<u8>, CodecError> {
    let is_point = |point: &[f32; 4]| point[3] > 0.0;
    let places = positions.pixels().iter();
    let points: Vec<[f32; 3]> = places
        .filter(|point| is_point(point))
        .map(|&[x, y, z, _]| axes([x, y, z]))
        .collect();
    let rgb: Option<Vec<[u8; 4]>> = colors.map(|colors| {
        let both = colors.pixels().iter().zip(positions.pixels());
        both.filter(|(_, point)| is_point(point))
            .map(|(color, _)| *color)
            .collect()
    });
    encode(&Cloud {
        points: &points,
        normals: None,
        rgb: rgb.as_deref(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn encodes_two_points() {
        let mut cloud = Cloud {
            points: &[[1.0, 2.0, -0.5], [0.0; 3]],
            normals: Some(&[[0.0, 0.0, 1.0]; 2]),
            rgb: Some(&[[1, 2, 3, 255], [4, 5, 6, 0]]),
        };
        let file = encode(&cloud).unwrap();
        let header = "ply\nformat binary_little_endian 1.0\nelement vertex 2\n\
            property float x\nproperty float y\nproperty float z\n\
            property float nx\nproperty float ny\nproperty float nz\n\
            property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
        let (text, data) = file.split_at(header.len());
        assert_eq!(text, header.as_bytes());
        assert_eq!(data.len(), 2 * 27);
        assert_eq!(data[..12], [0, 0, 0x80, 0x3F, 0, 0, 0, 0x40, 0, 0, 0, 0xBF]);
        assert_eq!(data[20..27], [0, 0, 0x80, 0x3F, 1, 2, 3]);
        assert_eq!(data[51..], [4, 5, 6]);
        cloud.rgb = None;
        cloud.normals = None;
        let bare = encode(&cloud).unwrap();
        assert!(
            bare.ends_with(&[0; 12]) && bare.len() == header.find("property float nx").unwrap() + 11 + 24
        );
        cloud.normals = Some(&[]);
        assert_eq!(
            encode(&cloud).unwrap_err().to_string(),
            "PLY: vertex: 0 normals for 2 points; pass one for each point"
        );
    }
}
