use oaktwin_image::Image;

/// Converts normals to colours like `BasicWriter`: `(n · 0.5 + 0.5) · 255`, truncated (Replicator's `colorize_normals`).
///
/// Replicator's normals have a fourth component, 1, which becomes the opacity. Its value for a miss is not documented; here all
/// pixels are opaque, and a miss (a normal of 0) is grey 127.
pub(crate) fn colorize(normals: &Image<[f32; 3]>) -> Image<[u8; 4]> {
    normals.map(|normal| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates"
        )]
        let [r, g, b] = normal.map(|component| ((component * 0.5 + 0.5) * 255.0) as u8);
        [r, g, b, 255]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn converts_like_replicator() {
        let normals = Image::new(3, 1, vec![[1.0, -1.0, 0.0], [0.0; 3], [0.6, -0.8, -0.0]]).unwrap();
        assert_eq!(
            colorize(&normals).pixels(),
            [[255, 0, 127, 255], [127, 127, 127, 255], [204, 25, 127, 255]]
        );
    }
}
