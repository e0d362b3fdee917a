use oaktwin_camera::math::DVec2;
use oaktwin_catalog::{BodyShape, Role, Twin};

use super::loft::{End, LoftFrame, loft};
use super::material;
use super::outline::{FINE, Outline, circle, fraction, rounded_rectangle};
use super::plate::{Opening, plate};
use super::window::{self, Window};
use super::{BodyPart, Envelope};

/// The distance of the glass behind the front face, mm.
const INSET: f64 = 0.35;
/// The thickness of the glass, mm.
const THICKNESS: f64 = 1.4;

/// The front glass and its openings, mm.
#[derive(Clone, Debug)]
pub(super) struct Panel {
    centre: DVec2,
    half: DVec2,
    radius: f64,
    /// x of the front of the glass.
    front_x: f64,
    /// x of the back of the glass.
    back_x: f64,
    /// x of the floor of the pocket behind the glass.
    pub(super) floor_x: f64,
    windows: Vec<Window>,
    cuts: Vec<f64>,
}

impl Panel {
    pub(super) fn of(twin: &Twin, envelope: &Envelope, family: BodyShape) -> Self {
        let rim = match family {
            BodyShape::Bar | BodyShape::Compact | BodyShape::Plain => 1.6,
            BodyShape::Comb => 2.6,
        } * (envelope.half.min_element() / 20.0).min(1.0);
        let whole = envelope.half - rim;
        // On a tall front, the glass covers the area around the cameras only.
        let half = DVec2::new(whole.x, whole.y.min(0.48 * whole.x));
        let cameras = twin
            .cameras
            .iter()
            .map(|camera| camera.body_from_camera.translation.z * 1e3);
        let lowest = cameras.clone().fold(f64::INFINITY, f64::min);
        let highest = cameras.fold(f64::NEG_INFINITY, f64::max);
        let middle = if lowest.is_finite() && highest.is_finite() {
            (lowest + highest) / 2.0
        } else {
            envelope.front.z
        };
        let slack = whole.y - half.y;
        let offset = (middle - envelope.front.z).clamp(-slack, slack);
        let centre = envelope.centre() + DVec2::new(0.0, offset);
        let radius = if slack > 0.0 {
            0.35 * half.y
        } else {
            envelope.corner_radius(family) - rim
        };
        let (windows, cuts) = window::fit(&twin.cameras, envelope.front.x, centre, half, radius);
        let lens_x = windows
            .iter()
            .map(|window| window.lens_x)
            .fold(envelope.front.x, f64::min);
        let deepest = envelope.front.x - 0.5 * envelope.depth;
        Self {
            centre,
            half,
            radius,
            front_x: envelope.front.x - INSET,
            back_x: envelope.front.x - INSET - THICKNESS,
            floor_x: (lens_x.min(envelope.front.x - INSET - THICKNESS) - 3.0).max(deepest),
            windows,
            cuts,
        }
    }

    /// Returns the outline of the pocket that holds the glass.
    pub(super) fn pocket(&self) -> Outline {
        self.outline(0.0)
    }

    fn outline(&self, inset: f64) -> Outline {
        rounded_rectangle(self.centre, self.half - inset, self.radius - inset, FINE)
    }
}

/// Creates the glass and the parts visible in and behind it.
pub(super) fn parts(twin: &Twin, envelope: &Envelope, panel: &Panel) -> Vec<BodyPart> {
    let mut parts = vec![glass(panel)];
    for window in &panel.windows {
        parts.extend(hood(window, panel));
        parts.push(bezel(window, panel));
        parts.extend(lens(window, panel));
    }
    parts.extend(lights(twin, envelope, panel));
    parts
}

fn glass(panel: &Panel) -> BodyPart {
    let bevel = 0.3;
    let outer = [
        panel.outline(0.12),
        panel.outline(0.12),
        panel.outline(0.12 + bevel),
    ];
    let levels = [panel.back_x, panel.front_x - bevel, panel.front_x];
    let openings: Vec<Opening> = panel
        .windows
        .iter()
        .map(|window| Opening {
            front: window.outline(panel.front_x, 0.0),
            back: window.outline(panel.back_x, 0.0),
        })
        .collect();
    let mesh = if openings.is_empty() {
        let stations: Vec<_> = levels.into_iter().zip(outer).collect();
        loft(LoftFrame::FORWARD, &stations, End::Flat, End::Flat)
    } else {
        plate(&outer, levels, &openings, &panel.cuts)
    };
    mesh.into_part("front_glass", material::GLASS)
}

/// Creates the stepped wall of the opening, from the lens to the glass.
fn hood(window: &Window, panel: &Panel) -> Option<BodyPart> {
    let height = panel.back_x - window.lens_x;
    if height < 0.3 {
        return None;
    }
    let outer = window.outline(panel.back_x, 0.6);
    let back_x = window.lens_x - 0.8;
    let mut stations = vec![(back_x, outer.clone()), (panel.back_x, outer)];
    let steps = [1.0, 2.1, 5.0]
        .into_iter()
        .filter(|min| height > *min)
        .count()
        .max(1);
    for step in (0..steps).rev() {
        let top = window.lens_x + height * fraction(step + 1, steps);
        let bottom = window.lens_x + height * fraction(step, steps);
        // Each step is as wide as its top over its full height, so it stays outside the camera's view.
        let wall = window.outline(top, 0.0);
        stations.push((top, wall.clone()));
        stations.push((bottom, wall));
    }
    let lens = window.outline(window.lens_x, 0.0);
    stations.push((window.lens_x, lens.clone()));
    stations.push((back_x, lens));
    let mesh = loft(LoftFrame::FORWARD, &stations, End::Closed, End::Closed);
    Some(mesh.into_part(&format!("hood_{}", window.suffix()), material::PLASTIC))
}

/// Creates a thin ring on the glass around the opening.
fn bezel(window: &Window, panel: &Panel) -> BodyPart {
    let x = panel.front_x;
    let ring = |grow| window.outline(x, grow);
    let stations = [
        (x - 0.1, ring(0.29)),
        (x + 0.1, ring(0.24)),
        (x + 0.1, ring(0.1)),
        (x - 0.1, ring(0.05)),
    ];
    loft(LoftFrame::FORWARD, &stations, End::Closed, End::Closed)
        .into_part(&format!("bezel_{}", window.suffix()), material::NICKEL)
}

/// Creates the barrel and the front element, just behind the optical centre.
fn lens(window: &Window, panel: &Panel) -> [BodyPart; 2] {
    let top = window.lens_x.min(panel.front_x) - 0.05;
    let radius = window.lens_radius - 0.03;
    let ring = |share: f64| circle(window.centre, share * radius, FINE);
    let floor = panel.floor_x.min(top - 1.6) - 0.3;
    let barrel = [
        (floor, ring(1.0)),
        (top - 0.35, ring(1.0)),
        (top, ring(0.92)),
        (top, ring(0.82)),
        (top - 1.2, ring(0.74)),
    ];
    let barrel = loft(LoftFrame::FORWARD, &barrel, End::Flat, End::Flat);
    // A spherical cap whose sagitta is 0.3 times the radius of its base.
    let (base_x, base, sagitta) = (top - 1.35, 0.76 * radius, 0.3 * 0.76 * radius);
    let sphere = (base * base + sagitta * sagitta) / (2.0 * sagitta);
    let widest = (base / sphere).asin();
    let mut element = Vec::new();
    for step in (1..=4).rev() {
        let angle = widest * fraction(step, 4);
        let x = base_x + sphere * (angle.cos() - widest.cos());
        element.push((x, circle(window.centre, sphere * angle.sin(), FINE)));
    }
    let element = loft(
        LoftFrame::FORWARD,
        &element,
        End::Flat,
        End::Pole(base_x + sagitta),
    );
    [
        barrel.into_part(&format!("barrel_{}", window.suffix()), material::PLASTIC),
        element.into_part(&format!("lens_{}", window.suffix()), material::LENS),
    ]
}

/// Creates the dot projector and the flood light, or the emitter of a time-of-flight camera.
fn lights(twin: &Twin, envelope: &Envelope, panel: &Panel) -> Vec<BodyPart> {
    let mut parts = Vec::new();
    let place = |role| {
        twin.camera(role).map(|camera| {
            let centre = camera.body_from_camera.translation * 1e3;
            DVec2::new(centre.y, centre.z)
        })
    };
    let x = panel.front_x;
    let window = |centre: DVec2, half: DVec2, radius: f64, grow: f64| {
        rounded_rectangle(centre, half + grow, radius + grow, FINE)
    };
    let mut rectangle = |name: &str, centre: DVec2, half: DVec2| {
        if !is_free(panel, centre, half) {
            return;
        }
        let frame = [
            (x - 0.1, window(centre, half, 1.0, 0.5)),
            (x + 0.12, window(centre, half, 1.0, 0.4)),
            (x + 0.12, window(centre, half, 1.0, 0.0)),
            (x - 0.05, window(centre, half, 1.0, -0.1)),
        ];
        let pane = [
            (x - 0.1, window(centre, half, 1.0, 0.1)),
            (x + 0.06, window(centre, half, 1.0, 0.1)),
        ];
        parts.push(
            loft(LoftFrame::FORWARD, &frame, End::Closed, End::Closed)
                .into_part(&format!("{name}_frame"), material::PLASTIC),
        );
        parts.push(loft(LoftFrame::FORWARD, &pane, End::Flat, End::Flat).into_part(name, material::INFRARED));
    };
    if let Some([_, y, z]) = twin.device.body.projector_mm {
        let projector = DVec2::new(y, z);
        rectangle("dot_projector", projector, DVec2::new(2.9, 2.1));
        // No source states the flood light's position: it mirrors the projector about the colour camera.
        let about = place(Role::Rgb).map_or(envelope.front.y, |centre| centre.x);
        let flood = DVec2::new(2.0 * about - y, z);
        if is_free(panel, flood, DVec2::splat(2.6)) {
            parts.extend(flood_light(flood, x));
        }
    } else if let Some(tof) = place(Role::Tof) {
        // No source states the emitter's position: it is above its camera, midway to the edge of the glass.
        let opening = panel.windows.iter().find(|window| window.role == Role::Tof);
        let lower = tof.y + opening.map_or(0.0, |window| window.half().y);
        let upper = panel.centre.y + panel.half.y;
        rectangle(
            "tof_emitter",
            DVec2::new(tof.x, (lower + upper) / 2.0),
            DVec2::new(3.6, 2.7),
        );
    }
    parts
}

fn flood_light(centre: DVec2, x: f64) -> [BodyPart; 2] {
    let ring = |radius| circle(centre, radius, FINE);
    let seat = [
        (x - 0.1, ring(2.4)),
        (x + 0.12, ring(2.3)),
        (x + 0.12, ring(1.7)),
        (x - 0.02, ring(1.5)),
    ];
    let dome = [
        (x - 0.1, ring(1.25)),
        (x + 0.08, ring(1.2)),
        (x + 0.18, ring(0.9)),
    ];
    [
        loft(LoftFrame::FORWARD, &seat, End::Flat, End::Flat).into_part("flood_led_seat", material::PLASTIC),
        loft(LoftFrame::FORWARD, &dome, End::Flat, End::Pole(x + 0.25)).into_part("flood_led", material::LED),
    ]
}

/// Whether a light of this size fits on the panel without touching an opening.
fn is_free(panel: &Panel, centre: DVec2, half: DVec2) -> bool {
    let half = half + 1.0;
    let inside = ((centre - panel.centre).abs() + half).cmple(panel.half).all();
    inside
        && panel
            .windows
            .iter()
            .all(|window| (centre - window.centre).abs().cmpgt(window.half() + half).any())
}
