use std::f64::consts::FRAC_PI_2;

use oaktwin_camera::math::{DVec2, DVec3};
use oaktwin_catalog::BodyShape;

use super::front::Panel;
use super::loft::{End, LoftFrame, loft};
use super::material;
use super::mesh::BodyMesh;
use super::outline::{COARSE, FINE, Outline, fraction, rounded_rectangle};
use super::{BodyPart, Envelope, fastener};

/// The number of segments of a rounded edge.
const FILLET: usize = 4;

/// Creates everything behind the front glass.
pub(super) fn parts(envelope: &Envelope, family: BodyShape, panel: &Panel) -> Vec<BodyPart> {
    match family {
        BodyShape::Bar => bar(envelope, panel),
        BodyShape::Comb => comb(envelope, panel),
        BodyShape::Compact => compact(envelope, panel),
        BodyShape::Plain => {
            let back = envelope.back_x();
            vec![shell(envelope, family, panel, back, material::ALUMINIUM)]
        }
    }
}

/// Creates a prism of the outer dimensions with cut corners. Its arrays have at most 64 elements: above that, NVIDIA's
/// validator requires OpenUSD's binary format.
pub(super) fn collider(envelope: &Envelope, family: BodyShape) -> BodyPart {
    let radius = envelope.corner_radius(family);
    let outline = || rounded_rectangle(envelope.centre(), envelope.half, radius, 2);
    let stations = [(envelope.back_x(), outline()), (envelope.front.x, outline())];
    loft(LoftFrame::FORWARD, &stations, End::Flat, End::Flat).into_part("collider", material::ALUMINIUM)
}

/// Creates the block that holds the glass, from `back_x` to the front face, as wide and high as the envelope.
fn shell(
    envelope: &Envelope,
    family: BodyShape,
    panel: &Panel,
    back_x: f64,
    metal: &'static str,
) -> BodyPart {
    let radius = envelope.corner_radius(family);
    let front_x = envelope.front.x;
    let outline = |inset: f64| -> Outline {
        rounded_rectangle(envelope.centre(), envelope.half - inset, radius - inset, FINE)
    };
    let small = (envelope.half.min_element() / 20.0).min(1.0);
    let back_fillet = 2.2 * small;
    let front_fillet = 1.0 * small;
    let mut stations = Vec::new();
    for step in 0..=FILLET {
        let angle = FRAC_PI_2 * fraction(step, FILLET);
        let x = back_x + back_fillet * (1.0 - angle.cos());
        stations.push((x, outline(back_fillet * (1.0 - angle.sin()))));
    }
    // The seam between the front frame and the housing.
    let seam = panel.floor_x.max(back_x + back_fillet + 1.0);
    if seam + 1.2 < front_x - front_fillet {
        let groove = 0.35 * small;
        stations.extend([
            (seam, outline(0.0)),
            (seam, outline(groove)),
            (seam + 0.5, outline(groove)),
            (seam + 0.5, outline(0.0)),
        ]);
    }
    for step in 0..=FILLET {
        let angle = FRAC_PI_2 * fraction(step, FILLET);
        let x = front_x - front_fillet * (1.0 - angle.sin());
        stations.push((x, outline(front_fillet * (1.0 - angle.cos()))));
    }
    stations.push((front_x, panel.pocket()));
    stations.push((panel.floor_x, panel.pocket()));
    loft(LoftFrame::FORWARD, &stations, End::Flat, End::Flat).into_part("shell", metal)
}

/// Creates a vertical fin centred at `y` that spans `x` and `z`.
fn fin(y: f64, thickness: f64, x: [f64; 2], z: [f64; 2]) -> BodyMesh {
    let centre = DVec2::new((z[0] + z[1]) / 2.0, (x[0] + x[1]) / 2.0);
    let half = DVec2::new((z[1] - z[0]).abs() / 2.0, (x[1] - x[0]).abs() / 2.0);
    let bevel = 0.25 * thickness;
    let outline = |inset: f64| rounded_rectangle(centre, half - inset, 2.0 - inset, COARSE);
    let stations = [
        (-thickness / 2.0, outline(bevel)),
        (bevel - thickness / 2.0, outline(0.0)),
        (thickness / 2.0 - bevel, outline(0.0)),
        (thickness / 2.0, outline(bevel)),
    ];
    loft(
        LoftFrame::left(DVec3::new(0.0, y, 0.0)),
        &stations,
        End::Flat,
        End::Flat,
    )
}

/// Returns evenly spaced positions from `-half` to `half`, about `pitch` apart.
fn spread(half: f64, pitch: f64) -> impl Iterator<Item = f64> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to a few dozen"
    )]
    let gaps = (2.0 * half / pitch).round().clamp(1.0, 40.0) as usize;
    (0..=gaps).map(move |i| half * (2.0 * fraction(i, gaps) - 1.0))
}

fn bar(envelope: &Envelope, panel: &Panel) -> Vec<BodyPart> {
    let (back, centre, half) = (envelope.back_x(), envelope.centre(), envelope.half);
    let fins = 0.19 * envelope.depth;
    let wall = back + fins;
    let mut parts = vec![shell(envelope, BodyShape::Bar, panel, wall, material::ALUMINIUM)];
    let reach = half.y - 4.0;
    let mut comb = BodyMesh::default();
    for y in spread(0.47 * half.x, 4.4) {
        let z = [centre.y - reach, centre.y + reach];
        comb.append(&fin(centre.x + y, 1.7, [back, wall + 1.5], z));
    }
    parts.push(comb.into_part("fins", material::ALUMINIUM));
    let on_wall = |y: f64, z: f64| DVec3::new(wall, centre.x + y, centre.y + z);
    parts.extend(fastener::socket(
        "connector_m12",
        on_wall(-0.72 * half.x, 0.0),
        6.0,
        fins - 0.4,
    ));
    parts.extend(fastener::socket(
        "connector_m8",
        on_wall(0.72 * half.x, 0.0),
        4.0,
        fins - 1.2,
    ));
    let corners = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
    parts.push(fastener::screws(
        corners.map(|(side, up)| on_wall(side * (half.x - 8.5), up * (half.y - 6.5))),
    ));
    parts
}

fn compact(envelope: &Envelope, panel: &Panel) -> Vec<BodyPart> {
    let (back, centre, half) = (envelope.back_x(), envelope.centre(), envelope.half);
    let fins = 0.13 * envelope.depth;
    let wall = back + fins;
    let mut parts = vec![shell(
        envelope,
        BodyShape::Compact,
        panel,
        wall,
        material::ALUMINIUM,
    )];
    let mut comb = BodyMesh::default();
    for y in spread(0.78 * half.x, 4.4) {
        let z = [centre.y - 0.08 * half.y, centre.y + half.y - 4.0];
        comb.append(&fin(centre.x + y, 1.7, [back, wall + 1.5], z));
    }
    parts.push(comb.into_part("fins", material::ALUMINIUM));
    let on_wall = |y: f64, z: f64| DVec3::new(wall, centre.x + y, centre.y + z);
    let low = -0.52 * half.y;
    parts.extend(fastener::socket(
        "connector_m12",
        on_wall(-0.36 * half.x, low),
        6.0,
        fins - 0.4,
    ));
    parts.extend(fastener::socket(
        "connector_m8",
        on_wall(0.36 * half.x, low),
        4.0,
        fins - 1.0,
    ));
    let low_corners = [1.0, -1.0].map(|side| on_wall(side * (half.x - 7.5), -(half.y - 7.5)));
    parts.push(fastener::screws(low_corners));
    parts
}

fn comb(envelope: &Envelope, panel: &Panel) -> Vec<BodyPart> {
    let (back, centre, half) = (envelope.back_x(), envelope.centre(), envelope.half);
    let metal = material::BLACK_ALUMINIUM;
    let block_back = (panel.floor_x - 3.0).max(back + 0.4 * envelope.depth);
    let mut parts = vec![shell(envelope, BodyShape::Comb, panel, block_back, metal)];

    // The core that carries the fins, and the bay for the connectors.
    let wall = back + 0.12 * envelope.depth;
    let fin_depth = 0.17 * half.y.min(40.0);
    let core_half = half - DVec2::new(0.5, fin_depth);
    let core = |inset: f64| rounded_rectangle(centre, core_half - inset, 3.0, FINE);
    let stations = [
        (wall, core(0.8)),
        (wall + 0.8, core(0.0)),
        (block_back + 3.0, core(0.0)),
    ];
    parts.push(loft(LoftFrame::FORWARD, &stations, End::Flat, End::Flat).into_part("core", metal));

    let radius = envelope.corner_radius(BodyShape::Comb);
    let bay_half = 0.36 * half.x;
    let thickness = 1.9;
    let reach = half.y;
    let mut fins = BodyMesh::default();
    // Fins cover the width over which the block's rounded corners leave its full height.
    for y in spread(half.x - radius.max(3.0) - thickness / 2.0, 4.8) {
        let bottom = if y.abs() < bay_half { 0.1 * half.y } else { -reach };
        let x = [back, block_back + 2.5];
        fins.append(&fin(
            centre.x + y,
            thickness,
            x,
            [centre.y + bottom, centre.y + reach],
        ));
        if y.abs() < bay_half {
            let x = [wall - 1.0, block_back + 2.5];
            let z = [centre.y - reach, centre.y - reach + 2.0 * fin_depth];
            fins.append(&fin(centre.x + y, thickness, x, z));
        }
    }
    parts.push(fins.into_part("fins", metal));
    let on_wall = |y: f64, z: f64| DVec3::new(wall, centre.x + y, centre.y + z);
    let height = wall - back;
    let low = -0.36 * half.y;
    parts.extend(fastener::socket(
        "connector_m12",
        on_wall(-0.2 * half.x, low),
        6.0,
        height - 0.6,
    ));
    parts.extend(fastener::socket(
        "connector_m8",
        on_wall(0.08 * half.x, low),
        4.0,
        height - 1.6,
    ));
    parts.push(fastener::usb_c(on_wall(0.25 * half.x, low), 0.8));
    parts
}
