//! The outputs of Replicator's annotators, and the frame that holds them.

use std::collections::BTreeMap;

use crate::{Image, RangeDepth, ZDepth};

/// The origin of an annotator's data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnnotationSource {
    /// Ground truth of a scene.
    Scene,
    /// A simulated depth sensor, as Isaac Sim 6 names its outputs.
    DepthSensor,
    /// A stereo matcher. Replicator has no such annotator.
    StereoMatcher,
}

/// Declares the types of annotations: documentation, variant, data, bytes per pixel in memory.
macro_rules! kinds {
    ($($doc:literal $kind:ident($data:ty) $bytes:literal;)+) => {
        /// The type of an annotator's data.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum AnnotationKind {
            $(#[doc = $doc] $kind,)+
        }

        impl AnnotationKind {
            /// Returns the size in memory, bytes per pixel of the image.
            #[must_use]
            pub const fn bytes_per_pixel(self) -> u64 {
                match self {
                    $(Self::$kind => $bytes,)+
                }
            }
        }

        /// The data of an annotator.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Annotation {
            $(#[doc = $doc] $kind($data),)+
        }

        /// A reference to the data of an annotator.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum AnnotationRef<'a> {
            $(#[doc = $doc] $kind(&'a $data),)+
        }
    };
}

kinds! {
    "An sRGB image with alpha." Color(Image<[u8; 4]>) 4;
    "Distances along the optical axis, metres." ZDepth(ZDepth) 4;
    "Distances from the optical centre, metres." RangeDepth(RangeDepth) 4;
    "Unit vectors." Normals(Image<[f32; 3]>) 12;
    "Ids of prims." InstanceIds(Segmentation) 4;
    "Ids of semantic labels." SemanticIds(SemanticSegmentation) 4;
    "Bounding boxes." Boxes(Boxes2d) 0;
    "A point cloud." Points(PointCloud) 36;
    "A homogeneous point for each pixel." PixelPoints(Image<[f32; 4]>) 16;
    "An sRGB colour for each of [`PixelPoints`](Self::PixelPoints)." PixelColors(Image<[u8; 4]>) 4;
    "A scalar image." Scalar(Image<f32>) 4;
    "Codes with a legend." Reasons(Reasons) 1;
    "Whole numbers of 16 bits." Levels(Image<u16>) 2;
}

/// The light that comes back to a time-of-flight camera from up to two surfaces in each pixel, such as a pane and the wall behind it.
#[derive(Clone, Debug, PartialEq)]
pub struct Returns {
    /// Along the optical axis, metres, where a surface at the end of the path would be; `+inf` if nothing returns. The stronger return is first.
    pub depths: [Image<f32>; 2],
    /// The light, relative to a white surface at that depth that faces the camera. NaN of the first where depth and colours determine it: a
    /// single, opaque surface.
    pub strengths: [Image<f32>; 2],
}

/// Declares the annotators in the order of their output: documentation, variant, name, source, and the kind and type of the
/// data, if a [`Frame`] holds it.
macro_rules! annotators {
    ($($doc:literal $variant:ident $name:ident $source:ident $($kind:ident($data:ty))?;)+) => {
        /// An annotator of Replicator; see [`Annotator::all`].
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Annotator {
            $(#[doc = $doc] $variant,)+
        }

        impl Annotator {
            const TABLE: &[Self] = &[$(Self::$variant),+];

            /// Returns the name in Replicator, or in Isaac Sim 6 for outputs of a depth sensor.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => stringify!($name),)+
                }
            }

            /// Returns a description in one line.
            #[must_use]
            pub const fn doc(self) -> &'static str {
                match self {
                    $(Self::$variant => $doc,)+
                }
            }

            /// Returns the origin of the data.
            #[must_use]
            pub const fn source(self) -> AnnotationSource {
                match self {
                    $(Self::$variant => AnnotationSource::$source,)+
                }
            }

            /// Returns the type of the data, or `None` if no [`Frame`] holds it.
            #[must_use]
            pub const fn kind(self) -> Option<AnnotationKind> {
                match self {
                    $($(Self::$variant => Some(AnnotationKind::$kind),)?)+
                    _ => None,
                }
            }
        }

        annotators! { @frame [] $($doc $name $variant [$($kind $data)?])+ }
    };
    (@frame [$($fields:tt)*] $doc:literal $name:ident $variant:ident [] $($rest:tt)*) => {
        annotators! { @frame [$($fields)*] $($rest)* }
    };
    (@frame [$($fields:tt)*] $doc:literal $name:ident $variant:ident [$kind:ident $data:ty] $($rest:tt)*) => {
        annotators! { @frame [$($fields)* $doc $name $variant $kind ($data),] $($rest)* }
    };
    (@frame [$($doc:literal $name:ident $variant:ident $kind:ident ($data:ty),)+]) => {
        /// The annotations of one camera at one moment. All images have the camera's size, and its depth sensor's images the
        /// size of the sensor's output.
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct Frame {
            $(#[doc = $doc] pub $name: Option<$data>,)+
            /// The distance that a depth camera sees where mirrors or transparent surfaces are: along the optical axis, metres, to the apparent
            /// place of the brightest light in each pixel, and `+inf` for the sky. It is not an annotation. `None` if it would equal
            /// `distance_to_image_plane` everywhere.
            pub apparent_depth: Option<ZDepth>,
            /// The linear light of `rgb`, red, green and blue, before the tone curve, and coverage. It is not an annotation. `None` unless an
            /// image sensor is to record it.
            pub light: Option<Image<[f32; 4]>>,
            /// The returns of a time-of-flight camera. They are not an annotation. `None` if depth and colours determine them.
            pub returns: Option<Returns>,
            /// The colours with given reflectances at 940 nm, which the models of depth cameras see. They are not an annotation. `None` if they
            /// would equal `rgb`.
            pub infrared: Option<Image<[u8; 4]>>,
            /// The mean radial velocity of what each pixel sees since each of the two measurements of a time-of-flight camera, m/s, away from
            /// the camera, 0 where either sees nothing. It is not an annotation. `None` unless the frame takes time.
            pub radial_velocities: Option<[Image<f32>; 2]>,
        }

        impl Frame {
            /// Returns the annotations of the frame in the order of [`Annotator`].
            pub fn annotations(&self) -> impl Iterator<Item = (Annotator, AnnotationRef<'_>)> {
                let all = [$(
                    self.$name.as_ref().map(|data| (Annotator::$variant, AnnotationRef::$kind(data))),
                )+];
                all.into_iter().flatten()
            }

            /// Replaces the annotations that another frame contains, and keeps the rest.
            pub fn update(&mut self, other: Self) {
                self.apparent_depth = other.apparent_depth.or(self.apparent_depth.take());
                self.returns = other.returns.or(self.returns.take());
                self.infrared = other.infrared.or(self.infrared.take());
                self.light = other.light.or(self.light.take());
                self.radial_velocities = other.radial_velocities.or(self.radial_velocities.take());
                $(
                    if other.$name.is_some() {
                        self.$name = other.$name;
                    }
                )+
            }

            /// Adds the data of an annotator, or replaces them. Data of another type than the annotator's are ignored.
            pub fn put(&mut self, annotator: Annotator, data: Annotation) {
                match (annotator, data) {
                    $((Annotator::$variant, Annotation::$kind(data)) => self.$name = Some(data),)+
                    _ => {}
                }
            }

            /// Removes and returns an annotation, or returns `None` if the frame does not contain it.
            pub fn take(&mut self, annotator: Annotator) -> Option<Annotation> {
                match annotator {
                    $(Annotator::$variant => self.$name.take().map(Annotation::$kind),)+
                    _ => None,
                }
            }
        }
    };
}

annotators! {
    "The colour image: sRGB, and coverage (255, or 0 for a miss)."
    Rgb rgb Scene Color(Image<[u8; 4]>);
    "Metres along the optical axis, `+inf` for a miss."
    DistanceToImagePlane distance_to_image_plane Scene ZDepth(ZDepth);
    "Metres from the optical centre, `+inf` for a miss."
    DistanceToCamera distance_to_camera Scene RangeDepth(RangeDepth);
    "Unit normals in world axes, 0 for a miss."
    Normals normals Scene Normals(Image<[f32; 3]>);
    "An id for each visible prim."
    InstanceIdSegmentation instance_id_segmentation Scene InstanceIds(Segmentation);
    "An id for each visible set of semantic labels."
    SemanticSegmentation semantic_segmentation Scene SemanticIds(SemanticSegmentation);
    "Bounding boxes of the visible part of each labelled prim."
    BoundingBox2dTight bounding_box_2d_tight Scene Boxes(Boxes2d);
    "Bounding boxes of each labelled prim, ignoring occlusion."
    BoundingBox2dLoose bounding_box_2d_loose Scene Boxes(Boxes2d);
    "The points of all pixels in the world, with normals, colours and ids."
    Pointcloud pointcloud Scene Points(PointCloud);
    "The camera's parameters."
    CameraParams camera_params Scene;
    "Measured metres along the optical axis, 0 where nothing was measured."
    DepthSensorDistance depth_sensor_distance DepthSensor ZDepth(ZDepth);
    "Measured points in the camera's frame with USD's axes (x right, y up, z backward), metres, and 1; 0 if invalid."
    DepthSensorPointCloudPosition depth_sensor_point_cloud_position DepthSensor PixelPoints(Image<[f32; 4]>);
    "sRGB colours of the measured points, 0 if invalid."
    DepthSensorPointCloudColor depth_sensor_point_cloud_color DepthSensor PixelColors(Image<[u8; 4]>);
    "The imager's luminance of the colour image, 0 to 1."
    DepthSensorImager depth_sensor_imager DepthSensor Scalar(Image<f32>);
    "The view that `rgbDepthOutputMode` selects, sRGB."
    DepthSensorOutputVisualization depth_sensor_output_visualization DepthSensor Color(Image<[u8; 4]>);
    "Why a pixel of the sensor has no value, as codes with a legend. Isaac Sim has no such output."
    DepthSensorReason depth_sensor_reason DepthSensor Reasons(Reasons);
    "The engine's confidence in each pixel, higher is better. Isaac Sim has no such output."
    DepthSensorConfidence depth_sensor_confidence DepthSensor Levels(Image<u16>);
    "The disparity of a stereo matcher."
    Disparity disparity StereoMatcher;
    "The confidence of a stereo matcher."
    Confidence confidence StereoMatcher;
}

impl Annotator {
    /// Returns all annotators of Replicator and Isaac Sim.
    pub fn all() -> impl Iterator<Item = Self> {
        let own = |one: &Self| one.source() != AnnotationSource::StereoMatcher;
        Self::TABLE.iter().copied().filter(own)
    }

    /// Whether the annotator is an output of Isaac Sim's depth sensor rather than ground truth.
    #[must_use]
    pub const fn is_depth_sensor(self) -> bool {
        matches!(self.source(), AnnotationSource::DepthSensor)
    }
}

/// An image of prim ids. 0 is the background. Ids follow the order of the scene, so that they are the same for every camera
/// and frame of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Segmentation {
    /// The id of each pixel.
    pub ids: Image<u32>,
    /// The prim path of each id in the image.
    pub prim_paths: BTreeMap<u32, String>,
}

/// Semantic labels by taxonomy: `class` → `chair`. Several labels of a taxonomy are sorted and joined by commas, as in
/// Replicator.
pub type Labels = BTreeMap<String, String>;

/// An image of semantic ids. 0 is the background, 1 a surface without labels.
#[derive(Clone, Debug, PartialEq)]
pub struct SemanticSegmentation {
    /// The id of each pixel.
    pub ids: Image<u32>,
    /// The labels of each id in the image: `{"class": "BACKGROUND"}` for 0, `{"class": "UNLABELLED"}` for 1.
    pub labels: BTreeMap<u32, Labels>,
}

/// An image of codes. 0 is a measured pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Reasons {
    /// The code of each pixel.
    pub codes: Image<u8>,
    /// The meaning of all codes.
    pub legend: BTreeMap<u8, ReasonLabel>,
}

/// The meaning of a code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReasonLabel {
    /// A name for machines: `too_near`.
    pub name: String,
    /// A sentence.
    pub documentation: String,
}

/// The bounding boxes of an image.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Boxes2d {
    /// The boxes, in the order of the scene.
    pub boxes: Vec<Box2d>,
    /// The prim path of each box.
    pub prim_paths: Vec<String>,
    /// The labels of each semantic id.
    pub labels: BTreeMap<u32, Labels>,
}

/// A bounding box, px; both ends are inclusive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Box2d {
    /// The key in [`Boxes2d::labels`].
    pub semantic_id: u32,
    /// The first column.
    pub x_min: i32,
    /// The first row.
    pub y_min: i32,
    /// The last column.
    pub x_max: i32,
    /// The last row.
    pub y_max: i32,
    /// The occluded fraction of the prim, 0 to 1; NaN if unknown.
    pub occlusion_ratio: f32,
}

/// A point for each pixel that sees a surface, row by row. Each vector is empty or as long as `points`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointCloud {
    /// World positions, scene units.
    pub points: Vec<[f32; 3]>,
    /// Unit normals in world axes.
    pub normals: Vec<[f32; 3]>,
    /// sRGB and 255.
    pub rgb: Vec<[u8; 4]>,
    /// Semantic ids.
    pub semantic: Vec<u32>,
    /// Instance ids.
    pub instance: Vec<u32>,
}
