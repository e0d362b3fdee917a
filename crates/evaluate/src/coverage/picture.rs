//! A picture of the coverage by a candidate, painted onto the surface.

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Camera, ImageSize, PixelPoint, Usd};
use oaktwin_image::Image;
use oaktwin_image::annotation::Annotator;
use oaktwin_image::contact_sheet::{GAP, INK, PAPER, paste};
use oaktwin_image::text::{self, TextStyle};
use oaktwin_pipeline::render::{AnnotateOptions, Backend, Renderer, View};
use oaktwin_render::Hit;

use super::assessment::assess_points;
use super::vantage::vantage;
use super::{Candidate, CoverageError, Outcome, Region, Samples, Shares, SurfacePoint, reasons};

/// The height of a panel and the width of that from outside, px.
const HEIGHT: u32 = 560;
const WIDTH: u32 = 740;

/// The number of points that choose the view.
const VIEW_SAMPLES: u32 = 600;

/// The height of capitals, px.
const TEXT: u32 = 13;

/// The colour of pixels without a surface.
const BACKGROUND: [u8; 3] = [40, 40, 44];

/// The colours of outcomes, sRGB: Okabe and Ito's, which colour-blind people can tell apart.
const MEASURED: [u8; 3] = [0, 158, 115];
const NOT_RESOLVED: [u8; 3] = [240, 228, 66];
const HIDDEN: [u8; 3] = [0, 114, 178];
const FACES_AWAY: [u8; 3] = [120, 120, 125];
const OUTSIDE_VIEW: [u8; 3] = [204, 121, 167];

/// The colours of the engine's reasons, the most frequent first; the last one is for all others.
const NOT_MEASURED: [[u8; 3]; 4] = [[213, 94, 0], [230, 159, 0], [86, 180, 233], [150, 75, 50]];

/// Draws the region of the renderer's scene from the candidate and from outside, with the outcome of the candidate at each pixel, and a
/// legend with the shares.
///
/// # Errors
/// Returns an error if the region is invalid or has no surface.
pub fn picture(
    renderer: &Renderer,
    region: &Region,
    candidate: &Candidate<'_>,
    shares: &Shares,
) -> Result<Image<[u8; 3]>, CoverageError> {
    let samples = Samples::new(renderer.scene(), region, VIEW_SAMPLES)?;
    let members = region.instances(renderer.scene())?;
    let own = own_view(candidate);
    let outcomes = assess_points(renderer, candidate, &samples.points)?.outcomes;
    let outside = vantage(
        renderer,
        &samples.points,
        &outcomes,
        ImageSize::new(WIDTH, HEIGHT),
    );
    let panels = [
        ("From the camera", own),
        ("The region, with the camera's field of view", outside),
    ];
    let palette = Palette::new(shares);
    let titled: Vec<(&str, Image<[u8; 3]>)> = panels
        .into_iter()
        .map(|(title, view)| {
            let mut panel = painted(renderer, region, &members, candidate, &view, &palette)?;
            if view == outside {
                draw_frustum(&mut panel, &view, candidate);
            }
            Ok((title, panel))
        })
        .collect::<Result<_, CoverageError>>()?;
    let legend = legend(shares, &palette);
    Ok(sheet(&heading(candidate, shares), &titled, &legend))
}

/// The view of a candidate, at the size of a panel.
pub(super) fn own_view(candidate: &Candidate<'_>) -> View {
    let own = candidate.view();
    let size = own.camera.intrinsics.size.scaled_to_height(HEIGHT);
    let size = size.unwrap_or(ImageSize::new(WIDTH, HEIGHT));
    View {
        camera: Camera::new(own.camera.intrinsics.resized(size, false), own.camera.lens),
        ..own
    }
}

/// The scene in a view, with the outcome at each pixel of the region.
fn painted(
    renderer: &Renderer,
    region: &Region,
    members: &[usize],
    candidate: &Candidate<'_>,
    view: &View,
    palette: &Palette,
) -> Result<Image<[u8; 3]>, CoverageError> {
    let seen = renderer.visibility(view, Backend::Auto);
    let options = AnnotateOptions::default();
    let (frame, _) = renderer.annotate(view, &[Annotator::Rgb], Backend::Auto, &options);
    let mut places = Vec::new();
    let mut points = Vec::new();
    let width = seen.hits.width().max(1);
    for (index, hit) in (0..).zip(seen.hits.pixels()) {
        let pixel = (index % width, index / width);
        let point = surface_point(renderer, view, pixel, *hit);
        let is_member = |point: &SurfacePoint| {
            members.binary_search(&(point.instance as usize)).is_ok()
                && region.within.is_none_or(|within| {
                    point.position.cmpge(within.min).all() && point.position.cmple(within.max).all()
                })
        };
        if let Some(point) = point.filter(is_member) {
            places.push(index as usize);
            points.push(point);
        }
    }
    let outcomes = assess_points(renderer, candidate, &points)?.outcomes;
    let mut image = frame.rgb.map_or_else(
        || Image::filled(seen.hits.width(), seen.hits.height(), PAPER),
        |rgb| rgb.map(|pixel| [grey(*pixel, 0.5); 3]),
    );
    for (pixel, hit) in image.pixels_mut().iter_mut().zip(seen.hits.pixels()) {
        if hit.is_miss() {
            *pixel = BACKGROUND;
        }
    }
    let pixels = image.pixels_mut();
    for (place, outcome) in places.into_iter().zip(outcomes) {
        // Twice the grey of the surroundings.
        let light = 0.35 + 0.65 * f32::from(pixels[place][0]) / 127.0;
        pixels[place] = palette
            .color(outcome)
            .map(|channel| byte(f32::from(channel) * light));
    }
    Ok(image)
}

/// The point of the surface at the centre of a pixel.
fn surface_point(renderer: &Renderer, view: &View, (x, y): (u32, u32), hit: Hit) -> Option<SurfacePoint> {
    let scene = renderer.scene();
    let instance = scene.instances.get(hit.instance as usize)?;
    let mesh = scene.meshes.get(instance.mesh as usize)?;
    let corners = mesh.corners(hit.triangle as usize)?;
    let placed = |p: [f32; 3]| {
        instance
            .world_from_mesh
            .transform_point3(DVec3::from(p.map(f64::from)))
    };
    let [a, b, c] = corners.map(placed);
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let centre = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
    let origin = view.world_from_camera.translation;
    let direction = view.world_from_camera.rotation * view.camera.unproject(centre)?;
    let t = (a - origin).dot(normal) / direction.dot(normal);
    let is_mirrored = instance.world_from_mesh.matrix3.determinant() < 0.0;
    t.is_finite().then(|| SurfacePoint {
        position: origin + direction * t,
        normal: if is_mirrored { -normal } else { normal },
        is_double_sided: mesh.double_sided,
        instance: hit.instance,
        triangle: hit.triangle,
    })
}

/// Draws the edges of the candidate's field of view up to 1 m.
fn draw_frustum(image: &mut Image<[u8; 3]>, view: &View, candidate: &Candidate<'_>) {
    let own = candidate.view();
    let size = own.camera.intrinsics.size;
    let (width, height) = (f64::from(size.width), f64::from(size.height));
    let eye = own.world_from_camera.translation;
    let corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)].map(|(x, y)| {
        let ray = own.camera.unproject(PixelPoint::<Usd>::new(x, y))?;
        Some(own.world_from_camera.apply(ray / ray.z.max(0.2)))
    });
    for (i, corner) in corners.iter().enumerate() {
        let (Some(corner), Some(next)) = (corner, corners[(i + 1) % 4]) else {
            continue;
        };
        draw_line(image, view, eye, *corner);
        draw_line(image, view, *corner, next);
    }
}

/// Draws a line of the world in front of everything.
fn draw_line(image: &mut Image<[u8; 3]>, view: &View, from: DVec3, to: DVec3) {
    /// Steps per line: more than pixels.
    const STEPS: u32 = 2000;
    let camera_from_world = view.camera_from_world();
    let (width, height) = (image.width(), image.height());
    for i in 0..=STEPS {
        let point = from.lerp(to, f64::from(i) / f64::from(STEPS));
        let Some(at) = view.camera.project(camera_from_world.transform_point3(point)) else {
            continue;
        };
        let at = at.to::<Usd>();
        for (dx, dy) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let (x, y) = (at.x + dx, at.y + dy);
            if x < 0.0 || y < 0.0 || x >= f64::from(width) || y >= f64::from(height) {
                continue;
            }
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "inside the image"
            )]
            let index = y as usize * width as usize + x as usize;
            image.pixels_mut()[index] = INK;
        }
    }
}

fn heading(candidate: &Candidate<'_>, shares: &Shares) -> String {
    let error = shares.median_absolute_error_mm;
    let error = error.map_or_else(String::new, |error| format!(", median error {error:.1} mm"));
    format!(
        "{}, {}: {:.1} % measured, {:.1} % seen{error}",
        candidate.rig.name(),
        candidate.name,
        100.0 * shares.measured,
        100.0 * shares.seen
    )
}

/// The names and colours of the outcomes that occur.
fn legend(shares: &Shares, palette: &Palette) -> Vec<(String, [u8; 3])> {
    let share = |name: &str| match name {
        "measured" => shares.measured,
        name => shares.lost.get(name).copied().unwrap_or(0.0),
    };
    let occurring = reasons().iter().filter(|reason| share(&reason.name) > 0.0);
    occurring
        .map(|reason| {
            let percent = 100.0 * share(&reason.name);
            let name = reason.name.replace('_', " ");
            (
                format!("{name} {percent:.1} %"),
                palette.color(Outcome(reason.code)),
            )
        })
        .collect()
}

/// The colours of outcomes.
struct Palette {
    /// The names of the engine's reasons, the most frequent first.
    engine: Vec<&'static str>,
}

impl Palette {
    fn new(shares: &Shares) -> Self {
        let names = shares.losses().into_iter().map(|(name, _)| name);
        Self {
            engine: names.filter(|name| is_of_engine(name)).collect(),
        }
    }

    fn color(&self, outcome: Outcome) -> [u8; 3] {
        match outcome {
            Outcome::MEASURED => MEASURED,
            Outcome::NOT_RESOLVED => NOT_RESOLVED,
            Outcome::HIDDEN => HIDDEN,
            Outcome::FACES_AWAY => FACES_AWAY,
            Outcome::OUTSIDE_VIEW => OUTSIDE_VIEW,
            other => {
                let place = self.engine.iter().position(|name| *name == other.name());
                NOT_MEASURED[place.unwrap_or(NOT_MEASURED.len()).min(NOT_MEASURED.len() - 1)]
            }
        }
    }
}

/// Whether a reason is one of pixels without a value.
fn is_of_engine(name: &str) -> bool {
    let codes = Outcome::MEASURED.0 + 1..Outcome::NOT_RESOLVED.0;
    let mut reasons = reasons().iter().filter(|reason| codes.contains(&reason.code));
    reasons.any(|reason| reason.name == name)
}

/// Arranges the panels in a row, with the heading above and the legend below.
pub(super) fn sheet(
    heading: &str,
    panels: &[(&str, Image<[u8; 3]>)],
    legend: &[(String, [u8; 3])],
) -> Image<[u8; 3]> {
    let width = panels.iter().map(|(_, panel)| panel.width() + GAP).sum::<u32>() + GAP;
    let line = TEXT + GAP;
    let first = GAP + 2 * line;
    let bottom = first + HEIGHT + GAP;
    let mut sheet = Image::filled(width, bottom + line + GAP, PAPER);
    let style = TextStyle {
        height: TEXT as f32,
        color: INK,
    };
    text::draw(&mut sheet, heading, (GAP as f32, GAP as f32), style);
    let mut left = GAP;
    for (title, panel) in panels {
        text::draw(&mut sheet, title, (left as f32, (GAP + line) as f32), style);
        paste(&mut sheet, panel, left, first);
        left += panel.width() + GAP;
    }
    let mut left = GAP;
    for (name, color) in legend {
        paste(&mut sheet, &Image::filled(2 * TEXT, TEXT, *color), left, bottom);
        left += 2 * TEXT + GAP;
        text::draw(&mut sheet, name, (left as f32, bottom as f32), style);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "the width of a text"
        )]
        let wide = text::width(name, TEXT as f32).ceil() as u32;
        left += wide + 3 * GAP;
    }
    sheet
}

/// A pixel's luma, scaled.
pub(super) fn grey([r, g, b, _]: [u8; 4], scale: f32) -> u8 {
    byte((0.2126 * f32::from(r) + 0.7152 * f32::from(g) + 0.0722 * f32::from(b)) * scale)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped to 0 to 255"
)]
fn byte(value: f32) -> u8 {
    value.clamp(0.0, 255.0) as u8
}
