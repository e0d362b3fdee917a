use oaktwin_camera::math::{DVec2, DVec3};
use oaktwin_camera::{PixelPoint, Usd};
use oaktwin_catalog::{Role, TwinCamera};

use super::outline::{FINE, Outline, blend, circle, rounded_rectangle};

/// The margin between a camera's view frustum and the edge of its opening at the front, mm.
const MARGIN: f64 = 0.7;
/// The maximum radius of a round opening, mm.
const MAX_ROUND: f64 = 14.0;
/// The minimum distance between two openings, mm.
const WEB: f64 = 0.6;

/// The opening in front of one camera, mm: it widens from the lens, at the optical centre, to the front face, around
/// the camera's view frustum.
#[derive(Clone, Debug)]
pub(super) struct Window {
    pub(super) role: Role,
    /// The centre in the y-z plane.
    pub(super) centre: DVec2,
    /// x of the optical centre.
    pub(super) lens_x: f64,
    pub(super) lens_radius: f64,
    front_x: f64,
    shape: WindowShape,
}

#[derive(Clone, Copy, Debug)]
enum WindowShape {
    Round(f64),
    Rectangle(DVec2),
}

impl WindowShape {
    fn outline(self, centre: DVec2, grow: f64) -> Outline {
        match self {
            Self::Round(radius) => circle(centre, radius + grow, FINE),
            // Up to a corner radius of 3.4 margins, the frustum's corner stays clear.
            Self::Rectangle(half) => rounded_rectangle(centre, half + grow, 3.0 * MARGIN + grow, FINE),
        }
    }

    fn half(self) -> DVec2 {
        match self {
            Self::Round(radius) => DVec2::splat(radius),
            Self::Rectangle(half) => half,
        }
    }

    fn limited(self, half: DVec2) -> Self {
        match self {
            Self::Round(radius) => Self::Round(radius.min(half.min_element())),
            Self::Rectangle(wanted) => Self::Rectangle(wanted.min(half)),
        }
    }

    fn scaled(self, factor: f64) -> Self {
        match self {
            Self::Round(radius) => Self::Round(radius * factor),
            Self::Rectangle(half) => Self::Rectangle(half * factor),
        }
    }
}

impl Window {
    /// Returns the opening's cross-section at `x`, enlarged by `grow` on all sides.
    pub(super) fn outline(&self, x: f64, grow: f64) -> Outline {
        let lens = circle(self.centre, self.lens_radius + grow, FINE);
        let span = self.front_x - self.lens_x;
        if span <= 0.0 {
            return lens;
        }
        let front = self.shape.outline(self.centre, grow);
        blend(&lens, &front, ((x - self.lens_x) / span).clamp(0.0, 1.0))
    }

    /// Returns half the opening's extent at the front.
    pub(super) fn half(&self) -> DVec2 {
        self.shape.half()
    }

    /// Returns the suffix of the names of this camera's parts.
    pub(super) fn suffix(&self) -> &'static str {
        match self.role {
            Role::Rgb => "rgb",
            Role::Left => "left",
            Role::Right => "right",
            Role::Tof => "tof",
        }
    }
}

/// The opening that one camera requires.
struct Candidate {
    window: Window,
    rectangle: DVec2,
}

impl Candidate {
    fn of(camera: &TwinCamera, front_x: f64) -> Option<Self> {
        let centre = camera.body_from_camera.translation * 1e3;
        let reach = (front_x - centre.x).max(0.0);
        let mut extent = DVec2::ZERO;
        let mut radius: f64 = 0.0;
        for direction in border(camera) {
            if direction.x <= 1e-3 {
                continue; // It never reaches the front; the limits below apply.
            }
            let offset = DVec2::new(direction.y, direction.z) * (reach / direction.x);
            extent = extent.max(offset.abs());
            radius = radius.max(offset.length());
        }
        // A fisheye sees more, but at a front nearer than 10 mm its corners are within the near plane.
        if let Some(span) = camera.spec.fisheye_hfov_deg {
            let side = reach * (span.min(170.0) / 2.0).to_radians().tan();
            extent.x = extent.x.max(side);
            radius = radius.max(side);
        }
        let lens_radius = match (camera.spec.role, camera.spec.fisheye_hfov_deg) {
            (Role::Rgb | Role::Tof, _) => 4.0,
            (_, Some(_)) => 4.2,
            _ => 3.3,
        };
        let min_half = lens_radius + MARGIN;
        (centre.is_finite() && extent.is_finite() && radius.is_finite()).then(|| Self {
            window: Window {
                role: camera.spec.role,
                centre: DVec2::new(centre.y, centre.z),
                lens_x: centre.x,
                lens_radius,
                front_x,
                shape: WindowShape::Round((radius + MARGIN).max(min_half)),
            },
            rectangle: (extent + MARGIN).max(DVec2::splat(min_half)),
        })
    }
}

/// Returns the rays through the corners, edge midpoints and centre of a camera's image, in the body frame.
fn border(camera: &TwinCamera) -> impl Iterator<Item = DVec3> + '_ {
    let size = camera.intrinsics.size;
    let (width, height) = (f64::from(size.width), f64::from(size.height));
    [0.0, 0.5, 1.0].into_iter().flat_map(move |u| {
        [0.0, 0.5, 1.0].into_iter().map(move |v| {
            let pixel = PixelPoint::<Usd>::new(u * width, v * height);
            let normalized = camera.intrinsics.normalized_from_pixel(pixel);
            camera.body_from_camera.rotation * normalized.extend(1.0)
        })
    })
}

/// Returns the openings of all cameras that fit the panel, from left to right, and the cuts between them.
pub(super) fn fit(
    cameras: &[TwinCamera],
    front_x: f64,
    panel_centre: DVec2,
    panel_half: DVec2,
    panel_radius: f64,
) -> (Vec<Window>, Vec<f64>) {
    let room = |centre: DVec2| panel_half - WEB - (centre - panel_centre).abs();
    let mut candidates: Vec<Candidate> = cameras
        .iter()
        .filter_map(|camera| Candidate::of(camera, front_x))
        .filter(|candidate| room(candidate.window.centre).min_element() > 1.5)
        .collect();
    candidates.sort_by(|a, b| b.window.centre.x.total_cmp(&a.window.centre.x));
    candidates.dedup_by(|b, a| a.window.centre.x - b.window.centre.x < 4.0);
    // Openings are round if there is room, else rectangles as narrow as the image.
    let tight: Vec<bool> = (0..candidates.len())
        .map(|i| {
            let Window { centre, shape, .. } = &candidates[i].window;
            let radius = shape.half().x;
            let meets = |other: &Candidate| {
                let distance = (other.window.centre.x - centre.x).abs();
                distance < radius + other.window.shape.half().x + WEB
            };
            radius > MAX_ROUND
                || radius > room(*centre).min_element()
                || i.checked_sub(1).is_some_and(|before| meets(&candidates[before]))
                || candidates.get(i + 1).is_some_and(meets)
        })
        .collect();
    for (candidate, tight) in candidates.iter_mut().zip(tight) {
        if tight {
            candidate.window.shape = WindowShape::Rectangle(candidate.rectangle);
        }
    }
    let mut windows: Vec<Window> = candidates.into_iter().map(|candidate| candidate.window).collect();
    let cuts: Vec<f64> = windows
        .windows(2)
        .map(|pair| {
            let right_edge = pair[0].centre.x - pair[0].half().x;
            let left_edge = pair[1].centre.x + pair[1].half().x;
            let middle = (right_edge + left_edge) / 2.0;
            middle.clamp(pair[1].centre.x + 1.9, pair[0].centre.x - 1.9)
        })
        .collect();
    for (i, window) in windows.iter_mut().enumerate() {
        let left = i
            .checked_sub(1)
            .map_or(f64::INFINITY, |before| cuts[before] - window.centre.x);
        let right = cuts.get(i).map_or(f64::INFINITY, |cut| window.centre.x - cut);
        let half = DVec2::new(left.min(right) - WEB / 2.0, f64::INFINITY).min(room(window.centre));
        window.shape = window.shape.limited(half);
        for _ in 0..24 {
            let outline = window.shape.outline(window.centre, 0.0);
            if outline
                .iter()
                .all(|&point| depth_inside(point - panel_centre, panel_half, panel_radius) > WEB / 2.0)
            {
                break;
            }
            window.shape = window.shape.scaled(0.93);
        }
        window.lens_radius = window.lens_radius.min(0.85 * window.half().min_element());
    }
    (windows, cuts)
}

/// Returns the distance of a point inside a rounded rectangle from its border.
fn depth_inside(point: DVec2, half: DVec2, radius: f64) -> f64 {
    let corner = point.abs() - (half - radius);
    radius - corner.max(DVec2::ZERO).length() - corner.max_element().min(0.0)
}
