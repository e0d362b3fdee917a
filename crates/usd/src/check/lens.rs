use oaktwin_camera::{ImageSize, Intrinsics, OpenCv, PixelPoint};
use oaktwin_diagnostic::{Finding, Level};

use super::num;
use super::rule::Rule;
use super::scene::CheckedCamera;
use crate::stage::Prim;

pub(super) const LENS_MODEL: Rule = Rule {
    code: "lens-model",
    level: Level::Warning,
    what: "`omni:lensdistortion:model` names another model than the applied lens schema, or several are applied",
    remedy: "apply one lens schema and set `omni:lensdistortion:model` to its token",
};
pub(super) const LENS_VALUE: Rule = Rule {
    code: "lens-value",
    level: Level::Error,
    what: "a lens schema's focal length, principal point, image size or coefficient is no usable number",
    remedy: "author finite values, a positive focal length and the image size they hold for",
};
pub(super) const LENS_FOCAL_LENGTH: Rule = Rule {
    code: "lens-focal-length",
    level: Level::Warning,
    what: "the lens schema's fx and focalLength / horizontalAperture disagree by more than 1 %",
    remedy: "derive both from the same intrinsics, at the schema's imageSize",
};
pub(super) const LEGACY_DISTORTION: Rule = Rule {
    code: "legacy-distortion",
    level: Level::Note,
    what: "distortion attributes of Isaac Sim before 5.0 are authored: deprecated, and without effect on a pinhole",
    remedy: "",
};
pub(super) const PROJECTION_TYPE: Rule = Rule {
    code: "projection-type",
    level: Level::Warning,
    what: "`cameraProjectionType` asks for a projection that Isaac Sim no longer has",
    remedy: "set it to `pinhole`, and describe the lens with a lens-distortion schema",
};

/// The common part of the lens schemas' attribute names.
pub(super) const NAMESPACE: &str = "omni:lensdistortion:";
const MODEL: &str = "omni:lensdistortion:model";

/// A schema and its model token.
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
/// What the schema gives an unauthored k1 of the fisheye model.
const FISHEYE_K1: f64 = 0.00245;

/// `cameraProjectionType` values that Isaac Sim dropped.
const DROPPED_PROJECTIONS: [&str; 4] = [
    "fisheyeOrthographic",
    "fisheyeEquidistant",
    "fisheyeEquisolid",
    "fisheyeSpherical",
];

/// A camera's lens-distortion schema.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Lens {
    pub schema: &'static str,
    pub model: &'static str,
    /// fx, fy, cx, cy of the OpenCV models, in OpenCV's convention.
    pub parameters: Option<[f64; 4]>,
    pub image_size: Option<ImageSize>,
    pub coefficients: Vec<f64>,
}

impl Lens {
    pub(super) fn of(prim: &Prim) -> Option<Self> {
        let (schema, model) = SCHEMAS.into_iter().find(|(schema, _)| prim.has_api(schema))?;
        let number = |name: &str, fallback: f64| {
            prim.number(&format!("{NAMESPACE}{model}:{name}"))
                .unwrap_or(fallback)
        };
        let coefficients = match model {
            "opencvPinhole" => PINHOLE_COEFFICIENTS.map(|name| number(name, 0.0)).to_vec(),
            "opencvFisheye" => FISHEYE_COEFFICIENTS
                .map(|name| number(name, if name == "k1" { FISHEYE_K1 } else { 0.0 }))
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

    /// The OpenCV models' intrinsics, where they are usable.
    pub(super) fn intrinsics(&self) -> Option<Intrinsics> {
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

pub(super) fn rules(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    legacy(camera, findings);
    let prim = &camera.camera.prim;
    let path = camera.path();
    let Some(lens) = &camera.lens else { return };
    let applied: Vec<&str> = SCHEMAS
        .iter()
        .map(|(schema, _)| *schema)
        .filter(|schema| prim.has_api(schema))
        .collect();
    if applied.len() > 1 {
        findings.push(LENS_MODEL.at(
            path,
            format!(
                "{} lens schemas are applied: {}",
                applied.len(),
                applied.join(", ")
            ),
        ));
    }
    let model = prim.text(MODEL);
    if model != Some(lens.model) {
        let says = model.map_or_else(|| "not authored".to_owned(), |model| format!("`{model}`"));
        findings.push(LENS_MODEL.with_remedy(
            path,
            format!("{MODEL} is {says}, but {} is applied", lens.schema),
            format!("set it to `{}`", lens.model),
        ));
    }
    if lens.parameters.is_none() {
        return;
    }
    let Some(intrinsics) = lens.intrinsics() else {
        findings.push(LENS_VALUE.at(
            path,
            format!("fx, fy, cx, cy or imageSize of {} is not usable", lens.schema),
        ));
        return;
    };
    if !lens.coefficients.iter().all(|k| k.is_finite()) {
        findings.push(LENS_VALUE.at(path, format!("a coefficient of {} is not finite", lens.schema)));
    }
    // A fisheye's fx is pixels per radian and need not be the pinhole's.
    if lens.model == "opencvPinhole" {
        let by_aperture = camera.camera.optics().isaac_intrinsics(intrinsics.size).fx;
        if (intrinsics.mean_focal_length() / by_aperture - 1.0).abs() > 0.01 {
            findings.push(LENS_FOCAL_LENGTH.at(
                path,
                format!(
                    "the lens schema's fx and fy are {} and {} px, focalLength / horizontalAperture gives {by_aperture:.2} \
                     px at {}",
                    num(intrinsics.fx),
                    num(intrinsics.fy),
                    intrinsics.size
                ),
            ));
        }
    }
}

fn legacy(camera: &CheckedCamera<'_>, findings: &mut Vec<Finding>) {
    let prim = &camera.camera.prim;
    let path = camera.path();
    let projection = prim.text("cameraProjectionType");
    if let Some(projection) = projection.filter(|projection| DROPPED_PROJECTIONS.contains(projection)) {
        findings.push(PROJECTION_TYPE.at(path, format!("cameraProjectionType is `{projection}`")));
    }
    let is_legacy = |name: &&String| {
        name.starts_with("ftheta")
            || name.starts_with("physicalDistortion")
            || matches!(name.as_str(), "p0" | "p1" | "s0" | "s1" | "s2" | "s3")
    };
    let count = prim.attributes.keys().filter(is_legacy).count();
    if count > 0 {
        let effect = match projection {
            None | Some("pinhole") => "without effect on a pinhole",
            Some(_) => "a lens-distortion schema takes their place",
        };
        findings.push(LEGACY_DISTORTION.note(
            path,
            format!("{count} distortion attributes of Isaac Sim before 5.0: deprecated, {effect}"),
        ));
    }
}
