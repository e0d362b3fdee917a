//! Connectors and screws on the back, mm.

use oaktwin_camera::math::{DVec2, DVec3};

use super::BodyPart;
use super::loft::{End, LoftFrame, loft};
use super::material;
use super::mesh::BodyMesh;
use super::outline::{COARSE, MEDIUM, circle, rounded_rectangle};

/// Creates a round socket for a screw-on plug (M12 or M8, depending on the thread radius), `height` high on the wall at
/// `base`, facing backward.
pub(super) fn socket(name: &str, base: DVec3, thread_radius: f64, height: f64) -> [BodyPart; 2] {
    let frame = LoftFrame::backward(base);
    let ring = |radius: f64| circle(DVec2::ZERO, radius, MEDIUM);
    let flange = thread_radius + 1.7;
    let step = 0.4 * height;
    let shell = [
        (-0.5, ring(flange)),
        (step - 0.4, ring(flange)),
        (step, ring(flange - 0.4)),
        (step, ring(thread_radius)),
        (height - 0.3, ring(thread_radius)),
        (height, ring(thread_radius - 0.3)),
        (height, ring(thread_radius - 0.9)),
        (0.1 * height, ring(thread_radius - 0.9)),
    ];
    let core = thread_radius - 1.5;
    let insert = [
        (0.0, ring(core)),
        (0.8 * height - 0.2, ring(core)),
        (0.8 * height, ring(core - 0.2)),
    ];
    [
        loft(frame, &shell, End::Flat, End::Flat).into_part(name, material::NICKEL),
        loft(frame, &insert, End::Flat, End::Flat).into_part(&format!("{name}_insert"), material::PLASTIC),
    ]
}

/// Creates a USB-C receptacle in the wall at `base`, facing backward.
pub(super) fn usb_c(base: DVec3, height: f64) -> BodyPart {
    let frame = LoftFrame::backward(base);
    let slot = |grow: f64| rounded_rectangle(DVec2::ZERO, DVec2::new(4.2, 1.3) + grow, 1.3 + grow, COARSE);
    let stations = [
        (-0.5, slot(0.3)),
        (height, slot(0.3)),
        (height, slot(0.0)),
        (-0.3, slot(0.0)),
    ];
    loft(frame, &stations, End::Flat, End::Flat).into_part("usb_c", material::NICKEL)
}

/// Creates the heads of socket screws on walls at `bases`, facing backward.
pub(super) fn screws(bases: impl IntoIterator<Item = DVec3>) -> BodyPart {
    let ring = |radius: f64| circle(DVec2::ZERO, radius, COARSE);
    let stations = [
        (-0.3, ring(2.1)),
        (0.7, ring(2.1)),
        (0.95, ring(1.85)),
        (0.95, ring(1.1)),
        (-0.1, ring(1.0)),
    ];
    let mut mesh = BodyMesh::default();
    for base in bases {
        mesh.append(&loft(LoftFrame::backward(base), &stations, End::Flat, End::Flat));
    }
    mesh.into_part("screws", material::NICKEL)
}
