//! NVIDIA's lens-distortion schemas on a camera prim.

use oaktwin_camera::{FTheta, ImageSize, Intrinsics, LensError, OpenCv, PixelPoint, Usd};

use crate::stage::Prim;

/// The common part of the schemas' attribute names.
pub(crate) const NAMESPACE: &str = "omni:lensdistortion:";
/// The attribute with the token of the active schema.
pub(crate) const MODEL: &str = "omni:lensdistortion:model";

/// The schemas and their model tokens.
const SCHEMAS: [(&str, &str); 6] = [
    ("OmniLensDistortionOpenCvPinholeAPI", "opencvPinhole"),
    ("OmniLensDistortionOpenCvFisheyeAPI", "opencvFisheye"),
    ("OmniLensDistortionFthetaAPI", "ftheta"),
    ("OmniLensDistortionKannalaBrandtK3API", "kannalaBrandtK3"),
    ("OmniLensDistortionRadTanThinPrismAPI", "radTanThinPrism"),
    ("OmniLensDistortionLutAPI", "lut"),
];
const PINHOLE_COEFFICIENTS: [&str; 12] = [
    "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4",
];
const FISHEYE_COEFFICIENTS: [&str; 4] = ["k1", "k2", "k3", "k4"];
const FTHETA_COEFFICIENTS: [&str; 5] = ["k0", "k1", "k2", "k3", "k4"];
/// The fallback for k1 in the schemas of the fisheye and f-theta models.
const FALLBACK_K1: f64 = 0.00245;

/// Returns the lens schemas applied to a prim, and their tokens.
pub(crate) fn applied(prim: &Prim) -> impl Iterator<Item = (&'static str, &'static str)> {
    SCHEMAS.into_iter().filter(|(schema, _)| prim.has_api(schema))
}

/// A camera's lens-distortion schema.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Lens {
    pub(crate) schema: &'static str,
    pub(crate) model: &'static str,
    /// fx, fy, cx and cy of the OpenCV models, in OpenCV's convention.
    pub(crate) parameters: Option<[f64; 4]>,
    pub(crate) image_size: Option<ImageSize>,
    pub(crate) coefficients: Vec<f64>,
}

impl Lens {
    /// Reads the applied schema that the model token names, else the first applied one.
    pub(crate) fn of(prim: &Prim) -> Option<Self> {
        let named = prim.text(MODEL);
        let (schema, model) = applied(prim)
            .find(|(_, model)| Some(*model) == named)
            .or_else(|| applied(prim).next())?;
        let number = |name: &str, fallback: f64| number(prim, model, name, fallback);
        let coefficients = match model {
            "opencvPinhole" => PINHOLE_COEFFICIENTS.map(|name| number(name, 0.0)).to_vec(),
            "opencvFisheye" => FISHEYE_COEFFICIENTS
                .map(|name| number(name, if name == "k1" { FALLBACK_K1 } else { 0.0 }))
                .to_vec(),
            _ => Vec::new(),
        };
        let opencv = !coefficients.is_empty();
        Some(Self {
            schema,
            model,
            parameters: opencv.then(|| {
                [
                    number("fx", 900.0),
                    number("fy", 800.0),
                    number("cx", 1024.0),
                    number("cy", 512.0),
                ]
            }),
            image_size: if opencv {
                let name = format!("{NAMESPACE}{model}:imageSize");
                if prim.attributes.contains_key(&name) {
                    prim.size(&name)
                } else {
                    Some(ImageSize::new(2048, 1024))
                }
            } else {
                None
            },
            coefficients,
        })
    }

    /// Returns the intrinsics of the OpenCV models if they are valid.
    pub(crate) fn intrinsics(&self) -> Option<Intrinsics> {
        let [fx, fy, cx, cy] = self.parameters?;
        let sound = [fx, fy, cx, cy].iter().all(|value| value.is_finite()) && fx > 0.0 && fy > 0.0;
        sound.then_some(Intrinsics::new(
            self.image_size?,
            fx,
            fy,
            PixelPoint::<OpenCv>::new(cx, cy),
        ))
    }
}

/// Reads the f-theta schema of a prim. Sizes and centre are not checked.
pub(crate) fn f_theta(prim: &Prim) -> Result<FTheta, LensError> {
    let number = |name: &str, fallback: f64| number(prim, "ftheta", name, fallback);
    let k = FTHETA_COEFFICIENTS.map(|name| number(name, if name == "k1" { FALLBACK_K1 } else { 0.0 }));
    let centre = prim
        .pair(&format!("{NAMESPACE}ftheta:opticalCenter"))
        .unwrap_or((970.942_44, 600.374_8));
    FTheta::new(
        &k,
        ImageSize::new(
            pixels(number("nominalWidth", 1936.0)),
            pixels(number("nominalHeight", 1216.0)),
        ),
        PixelPoint::<Usd>::new(centre.0, centre.1),
        number("maxFov", 200.0).to_radians(),
    )
}

fn number(prim: &Prim, model: &str, name: &str, fallback: f64) -> f64 {
    prim.number(&format!("{NAMESPACE}{model}:{name}"))
        .unwrap_or(fallback)
}

/// Converts to an integer number of pixels; invalid values become 0.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the cast saturates, and 0 is rejected later"
)]
fn pixels(value: f64) -> u32 {
    value.round() as u32
}
