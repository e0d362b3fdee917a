//! The board in front of the camera.

use std::sync::{Arc, LazyLock};

use oaktwin_render::{Backend, Clip, Renderer, View};

use oaktwin_camera::math::DAffine3;
use oaktwin_camera::{Camera, Intrinsics, LensModel, PixelPoint, RigidTransform, Usd};
use oaktwin_image::annotation::Annotator;
use oaktwin_image::{Image, noise};
use oaktwin_pipeline::render::AnnotateOptions;
use oaktwin_scene::{
    Instance, Light, LightKind, Material, MaterialSpan, Mesh, MeshAttribute, Scene, Texture, TextureSource,
    TextureUse, Up,
};

/// The side of the smallest squares in pixels of the image at every distance: coarse enough to be resolved, and fine enough
/// that every matching window contains several.
const GRAIN_PX: f64 = 3.0;

/// The angle that the smallest squares subtend in a stereo pair, the same for every lens: 13.4 px at the focal length of 794 px of
/// the 800P unit to whose error curve it is fitted. The vendor's board is not published.
const PAIR_GRAIN_RAD: f64 = 13.4 / 794.0;

/// How far the board extends beyond the image, px.
const MARGIN_PX: f64 = 8.0;

/// The number of the smallest squares on a side of the pattern, which repeats.
const SQUARES: u16 = 256;

/// The number of sizes of squares, each twice the previous one. All have the same contrast, so detail is equally strong at
/// every scale, as in natural images (Field 1987).
const SIZES: u16 = 4;

/// Grey levels between the darkest and the brightest square of one size, chosen so that little of their sum is clipped.
const CONTRAST: f32 = 114.0;

/// A board in front of a stereo pair.
pub(super) struct Board {
    renderer: Renderer,
}

impl Board {
    /// Creates a board perpendicular to the optical axis at a distance, which fills both images.
    pub(super) fn new(intrinsics: Intrinsics, distance_m: f64) -> Self {
        // The right camera's view extends farther to the right, by less than this.
        let beyond = 8.0 + 2.0 * f64::from(intrinsics.size.width);
        let grain = PAIR_GRAIN_RAD * intrinsics.fx;
        Self {
            renderer: Renderer::new(scene(&intrinsics, distance_m, (grain, beyond))),
        }
    }

    /// Renders the light that reaches a camera at a pose in the frame of the first one.
    pub(super) fn light(&self, intrinsics: Intrinsics, pose: &RigidTransform) -> Image<f32> {
        let view = View {
            camera: Camera::new(intrinsics, LensModel::Pinhole),
            world_from_camera: *pose,
            clip: Clip::default(),
        };
        self.renderer.luminance(&view, Backend::Auto, None).0.scene
    }
}

/// Renders a board of random grey squares, perpendicular to the optical axis, that extends beyond the image. It looks the same at
/// every distance.
pub(super) fn picture(intrinsics: Intrinsics) -> Option<Image<[u8; 4]>> {
    let view = View {
        camera: Camera::new(intrinsics, LensModel::Pinhole),
        world_from_camera: RigidTransform::IDENTITY,
        clip: Clip::default(),
    };
    let renderer = Renderer::new(scene(&intrinsics, 1.0, (GRAIN_PX, MARGIN_PX)));
    let wanted = [Annotator::Rgb];
    let (frame, _) = renderer.annotate(&view, &wanted, Backend::Auto, &AnnotateOptions::default());
    frame.rgb
}

#[expect(clippy::cast_possible_truncation, reason = "a mesh is float32")]
fn scene(intrinsics: &Intrinsics, distance_m: f64, (grain_px, beyond_px): (f64, f64)) -> Scene {
    let size = intrinsics.size;
    let [left, right] = [-MARGIN_PX, f64::from(size.width) + beyond_px];
    let [top, bottom] = [-MARGIN_PX, f64::from(size.height) + MARGIN_PX];
    // Counter-clockwise for the camera, whose y points down.
    let corners = [[left, top], [left, bottom], [right, bottom], [right, top]];
    let position = |[x, y]: [f64; 2]| {
        let point = intrinsics.normalized_from_pixel(PixelPoint::<Usd>::new(x, y)) * distance_m;
        [point.x as f32, point.y as f32, distance_m as f32]
    };
    // Texture coordinates start at the optical axis, so that a part of an image shows the same board as the whole image.
    let axis = intrinsics.principal_point::<Usd>();
    let uv =
        |[x, y]: [f64; 2]| [x - axis.x, y - axis.y].map(|c| (c / (grain_px * f64::from(SQUARES))) as f32);
    let mesh = Mesh {
        positions: corners.map(position).to_vec(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        uvs: Some(MeshAttribute::Vertex(corners.map(uv).to_vec())),
        materials: vec![MaterialSpan {
            end: 2,
            material: Some(0),
        }],
        double_sided: true,
        ..Mesh::default()
    };
    Scene {
        meshes: vec![mesh],
        instances: vec![Instance {
            mesh: 0,
            path: "/Board".to_owned(),
            world_from_mesh: DAffine3::IDENTITY,
            labels: Vec::new(),
            material_offset: 0,
        }],
        materials: vec![Material {
            name: "board".to_owned(),
            base_color_texture: Some(TextureUse::new(0)),
            roughness: 1.0,
            ..Material::default()
        }],
        textures: vec![Texture {
            source: TextureSource::Pixels(Arc::clone(&PATTERN)),
            color_space: oaktwin_scene::ColorSpace::Srgb,
        }],
        lights: vec![Light {
            path: "/Sky".to_owned(),
            kind: LightKind::Dome { texture: None },
            radiance: [1.0; 3],
            normalize: false,
            world_from_light: DAffine3::IDENTITY,
        }],
        up: Up::Y,
        ..Scene::default()
    }
}

/// The picture on every board.
static PATTERN: LazyLock<Arc<Image<[u8; 4]>>> = LazyLock::new(|| Arc::new(pattern()));

/// Returns squares of random grey values in several superimposed sizes.
fn pattern() -> Image<[u8; 4]> {
    let squares = (0..SQUARES).flat_map(|y| (0..SQUARES).map(move |x| (x, y)));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    let grey = squares.map(|(x, y)| {
        let square = |size: u16| {
            // Each size is offset so that the corners of different sizes do not coincide.
            let [x, y] = [(x, 7), (y, 13)].map(|(at, by)| ((at + by * size) % SQUARES) >> size);
            noise::white(x.into(), y.into(), 77 + u32::from(size)) - 0.5
        };
        (127.5 + CONTRAST * (0..SIZES).map(square).sum::<f32>()) as u8
    });
    let mut image = Image::filled(u32::from(SQUARES), u32::from(SQUARES), [255; 4]);
    for (pixel, grey) in image.pixels_mut().iter_mut().zip(grey) {
        *pixel = [grey, grey, grey, 255];
    }
    image
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::{ImageSize, OpenCv};

    #[test]
    fn board_is_textured_and_fills_the_image() {
        let size = ImageSize::new(96, 64);
        let intrinsics = Intrinsics::new(size, 805.0, 805.0, PixelPoint::<Usd>::new(150.0, -40.0));
        let picture = picture(intrinsics).unwrap();
        assert!(picture.pixels().iter().all(|pixel| pixel[3] == 255));
        let grey: Vec<f64> = picture.pixels().iter().map(|pixel| f64::from(pixel[1])).collect();
        let mean = grey.iter().sum::<f64>() / grey.len() as f64;
        let variance = grey.iter().map(|g| (g - mean).powi(2)).sum::<f64>() / grey.len() as f64;
        assert!(
            (80.0..180.0).contains(&mean) && variance.sqrt() > 35.0,
            "{mean} {variance}"
        );
    }

    #[test]
    fn a_part_shows_what_the_whole_does() {
        let axis = PixelPoint::<OpenCv>::new(100.3, 60.8);
        let whole = Intrinsics::new(ImageSize::new(200, 120), 805.0, 803.0, axis);
        let part = whole.cropped(PixelPoint::<OpenCv>::new(40.0, 30.0), ImageSize::new(90, 50));
        let (whole, part) = (picture(whole).unwrap(), picture(part).unwrap());
        let mut differences = 0;
        for (y, row) in (30u32..).zip(part.rows()) {
            for (x, pixel) in (40u32..).zip(row) {
                let other = whole.get(x, y).unwrap();
                let apart = pixel[1].abs_diff(other[1]);
                assert!(apart <= 1, "{x} {y}: {pixel:?} {other:?}");
                differences += u32::from(apart);
            }
        }
        assert!(differences < 45, "{differences}");
    }
}
