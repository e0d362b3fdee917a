//! What is written of one image.

use super::geometry::positions;
use super::{CloudFrame, SenseOptions};
use crate::sensor::{Capture, Engine};
use oaktwin_camera::{Camera, ImageSize};
use oaktwin_depth::align::Align;
use oaktwin_image::annotation::Annotator;
use oaktwin_image::npy::Element;
use oaktwin_image::{CodecError, Image, ZDepth, millimetres, npy, ply, png, preview};

/// A result of one image: a file, or numbers that are one of a batch's arrays.
pub(super) struct Product {
    pub(super) annotator: &'static str,
    pub(super) name: String,
    pub(super) body: Body,
}

pub(super) enum Body {
    Numbers(Numbers),
    File { extension: &'static str, bytes: Vec<u8> },
}

/// The numbers of an array, as files hold them.
pub(super) struct Numbers {
    /// The beginning of a file of an array of such numbers.
    pub(super) begin: fn(&[usize]) -> Vec<u8>,
    /// Of one image.
    pub(super) shape: Vec<usize>,
    pub(super) bytes: Vec<u8>,
}

/// What was measured, where it is needed: with the axes of USD, and its colours.
struct Cloud {
    positions: Option<Image<[f32; 4]>>,
    colors: Option<Image<[u8; 4]>>,
}

/// How an image is looked at.
pub(super) struct Look<'a> {
    pub(super) options: &'a SenseOptions,
    /// What the sensor looked with.
    pub(super) camera: Camera,
    /// See [`shift_m`](super::rig::shift_m).
    pub(super) shift_m: f64,
    pub(super) align: Option<Align>,
}

impl Look<'_> {
    /// The outputs that are needed.
    pub(super) fn request(&self) -> Vec<Annotator> {
        let mut request = self.options.annotators.clone();
        if self.options.cloud.is_some() {
            request.push(Annotator::DepthSensorPointCloudPosition);
            request.push(Annotator::DepthSensorPointCloudColor);
        }
        request
    }

    /// The results of an image, the distance first.
    pub(super) fn products(
        &self,
        engine: &dyn Engine,
        capture: &Capture,
        rgb: Option<&Image<[u8; 4]>>,
    ) -> Result<Vec<Product>, CodecError> {
        let options = self.options;
        let distance = Annotator::DepthSensorDistance.name();
        let ZDepth(metres) = &capture.distance;
        let mut products = depth(distance, metres, options)?;
        if let (Some(align), Some(to)) = (&self.align, options.align) {
            // The aligner was made for this size.
            if let Ok(ZDepth(aligned)) = align.align(metres.into()) {
                products.extend(depth(
                    &format!("{distance}_aligned_{}", to.camera),
                    &aligned,
                    options,
                )?);
            }
        }
        let Cloud { positions, colors } = self.cloud(engine, capture, rgb);
        if let (Some(positions), Some(frame)) = (&positions, options.cloud) {
            products.push(ply_file(positions, colors.as_ref(), frame)?);
        }
        let asked = |annotator: Annotator| options.annotators.contains(&annotator).then(|| annotator.name());
        if let (Some(name), Some(positions)) = (asked(Annotator::DepthSensorPointCloudPosition), &positions) {
            products.push(many(name, positions));
        }
        if let (Some(name), Some(colors)) = (asked(Annotator::DepthSensorPointCloudColor), &colors) {
            products.push(many(name, colors));
        }
        if let Some(imager) = capture.extra::<Image<f32>>(Annotator::DepthSensorImager) {
            let name = Annotator::DepthSensorImager.name();
            products.push(one(name, name, imager));
        }
        if let Some(view) = capture.extra::<Image<[u8; 4]>>(Annotator::DepthSensorOutputVisualization) {
            let name = Annotator::DepthSensorOutputVisualization.name();
            products.push(picture(name, name.to_owned(), png::encode(view)?));
        }
        Ok(products)
    }

    /// The points that were measured and their colours, where those are needed.
    fn cloud(&self, engine: &dyn Engine, capture: &Capture, rgb: Option<&Image<[u8; 4]>>) -> Cloud {
        let request = self.request();
        let wants = |annotator| request.contains(&annotator);
        let ZDepth(metres) = &capture.distance;
        let positions = wants(Annotator::DepthSensorPointCloudPosition).then(|| {
            let moved = capture.extra::<Image<[f32; 4]>>(Annotator::DepthSensorPointCloudPosition);
            match moved.filter(|_| !capture.is_filtered) {
                Some(positions) => positions.clone(),
                None => self.seen(metres),
            }
        });
        let is_whole =
            |image: &Image<[u8; 4]>| (image.width(), image.height()) == (metres.width(), metres.height());
        let color = Annotator::DepthSensorPointCloudColor;
        let colors = if engine.outputs().contains(&color) {
            let colors = capture.extra::<Image<[u8; 4]>>(color);
            colors.cloned().filter(is_whole)
        } else {
            rgb.filter(|rgb| wants(color) && is_whole(rgb)).map(|rgb| {
                let mut colors = rgb.clone();
                for (color, z) in colors.pixels_mut().iter_mut().zip(metres.pixels()) {
                    if *z <= 0.0 {
                        *color = [0; 4];
                    }
                }
                colors
            })
        };
        Cloud { positions, colors }
    }

    /// The points of reported distances, in the frame of the sensor's camera.
    #[expect(clippy::cast_possible_truncation, reason = "points are float32")]
    fn seen(&self, metres: &Image<f32>) -> Image<[f32; 4]> {
        let mut points = positions(&self.reported(metres), metres);
        for point in points.pixels_mut().iter_mut().filter(|point| point[3] > 0.0) {
            point[0] = (f64::from(point[0]) - self.shift_m) as f32;
        }
        points
    }

    /// The camera of reported images: filters may have made them smaller.
    fn reported(&self, metres: &Image<f32>) -> Camera {
        reported(&self.camera, ImageSize::new(metres.width(), metres.height()))
    }
}

/// A camera's image, made smaller or not.
pub(super) fn reported(camera: &Camera, size: ImageSize) -> Camera {
    if camera.intrinsics.size == size {
        *camera
    } else {
        Camera::new(camera.intrinsics.resized(size, false), camera.lens)
    }
}

/// A depth image in all the forms that are asked for.
fn depth(name: &str, metres: &Image<f32>, options: &SenseOptions) -> Result<Vec<Product>, CodecError> {
    let annotator = Annotator::DepthSensorDistance.name();
    let mut products = vec![one(annotator, name, metres)];
    if options.png16 {
        let bytes = png::encode(&millimetres::from_metres(metres))?;
        products.push(picture(annotator, format!("{name}_millimetres"), bytes));
    }
    if options.preview {
        let bytes = png::encode(&preview::depth(metres, &preview::Options::default()))?;
        products.push(picture(annotator, format!("{name}_preview"), bytes));
    }
    Ok(products)
}

fn picture(annotator: &'static str, name: String, bytes: Vec<u8>) -> Product {
    Product {
        annotator,
        name,
        body: Body::File {
            extension: "png",
            bytes,
        },
    }
}

fn numbers<T: Element>(shape: Vec<usize>, values: &[T]) -> Body {
    let mut bytes = Vec::new();
    npy::put(values, &mut bytes);
    Body::Numbers(Numbers {
        begin: npy::begin::<T>,
        shape,
        bytes,
    })
}

/// `(H, W)`
fn one<T: Element>(annotator: &'static str, name: &str, image: &Image<T>) -> Product {
    Product {
        annotator,
        name: name.to_owned(),
        body: numbers(
            vec![image.height() as usize, image.width() as usize],
            image.pixels(),
        ),
    }
}

/// `(H, W, 4)`
fn many<T: Element>(annotator: &'static str, image: &Image<[T; 4]>) -> Product {
    Product {
        annotator,
        name: annotator.to_owned(),
        body: numbers(
            vec![image.height() as usize, image.width() as usize, 4],
            image.pixels().as_flattened(),
        ),
    }
}

/// PLY of the points that were measured; they come with USD's axes.
fn ply_file(
    positions: &Image<[f32; 4]>,
    colors: Option<&Image<[u8; 4]>>,
    frame: CloudFrame,
) -> Result<Product, CodecError> {
    let bytes = ply::encode_measured(positions, colors, |[x, y, z]| match frame {
        CloudFrame::Optical => [x, -y, -z],
        CloudFrame::Ros => [-z, -x, y],
    })?;
    Ok(Product {
        annotator: Annotator::DepthSensorPointCloudPosition.name(),
        name: "depth_sensor_point_cloud".to_owned(),
        body: Body::File {
            extension: "ply",
            bytes,
        },
    })
}
