//! The light that comes back to a lamp beside the camera, from every surface on the way.

use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_image::Image;
use oaktwin_image::annotation::Returns;
use oaktwin_image::srgb::srgb_from_linear;
use rayon::prelude::*;

use super::optic::OwnLightFactors;
use super::paint::Paint;
use super::path::{Arrival, Origin, Tracer, Vertex};
use super::rig::luminance;
use super::{ShadingContext, ShadingInput};
use crate::ray::Stack;

/// The least reflectance at 940 nm that is estimated from a colour.
const LEAST_ESTIMATE: f32 = 0.02;

/// A return: the length of its path, metres, and its strength.
#[derive(Clone, Copy, Debug, Default)]
struct Echo {
    route: u64,
    /// The sum of the lengths of its rays, times their strengths.
    length: f64,
    strength: f64,
}

impl<'a> ShadingContext<'a> {
    /// Returns the two strongest returns of each pixel whose surface reflects rays, lets them pass or has a given reflectance.
    pub(super) fn returns(&self, input: &ShadingInput<'_>) -> Returns {
        let z = &input.seen.z.0;
        let (width, height) = (z.width(), z.height());
        let mut out = Image::filled(width, height, [f32::INFINITY, f32::NAN, f32::INFINITY, 0.0]);
        let row_length = (width as usize).max(1);
        let seen = (z.pixels().par_chunks(row_length)).zip(input.seen.hits.pixels().par_chunks(row_length));
        let rows = out.pixels_mut().par_chunks_mut(row_length);
        let pose = &self.view.world_from_camera;
        rows.zip(seen).zip(0..height).for_each_init(
            || (Stack::default(), Vec::new()),
            |(stack, arrivals), ((row, (depths, hits)), y)| {
                stack.forget();
                for (((pixel, z), hit), x) in row.iter_mut().zip(depths).zip(hits).zip(0..) {
                    pixel[0] = *z;
                    let ray = input.rays.centre(x, y).filter(|_| !hit.is_miss());
                    let paint = self.paint(*hit);
                    let Some(ray) = ray.filter(|_| paint.optic().is_some() || paint.infrared().is_some())
                    else {
                        continue;
                    };
                    let length = ray.length();
                    let in_world = |ray: DVec3| pose.rotation * ray / length;
                    let next = input.rays.next(x, y, ray).map(|next| next.map(in_world));
                    let range = f64::from(*z) * length / ray.z;
                    let vertex = Vertex::new(self.scene, pose.translation, in_world(ray), next, *hit, range);
                    if let Some(vertex) = vertex {
                        let [first, second] = self.echoes(&vertex, paint, stack, arrivals);
                        let axial = ray.z / length;
                        *pixel = [
                            first.depth(axial),
                            first.strength(),
                            second.depth(axial),
                            second.strength(),
                        ];
                    }
                }
            },
        );
        let channel = |index: usize| out.map(|pixel| pixel[index]);
        Returns {
            depths: [channel(0), channel(2)],
            strengths: [channel(1), channel(3)],
        }
    }

    /// Returns the two strongest returns along a ray, the stronger one first.
    fn echoes(
        &self,
        vertex: &Vertex<'a>,
        paint: &Paint<'_>,
        stack: &mut Stack,
        arrivals: &mut Vec<Arrival<'a>>,
    ) -> [Echo; 2] {
        arrivals.clear();
        let own = match paint.optic() {
            Some(optic) => {
                let color = self.color_at(paint, vertex);
                Tracer::new(self, stack, arrivals).follow(vertex, optic, color)
            }
            None => OwnLightFactors::ALL,
        };
        let mut echoes = vec![self.echo(vertex, own, Vec3::ONE, 0)];
        for arrival in &*arrivals {
            let Origin::Surface(vertex, own) = &arrival.from else {
                continue;
            };
            let one = self.echo(vertex, *own, arrival.factor, arrival.route);
            // The rays of a blurred reflection are one return. Each lights and sees what lies along it.
            match echoes.iter_mut().find(|echo| echo.route == one.route) {
                Some(echo) => {
                    echo.length += one.length;
                    echo.strength += one.strength;
                }
                None => echoes.push(one),
            }
        }
        let received = |echo: &Echo| match echo.strength > 0.0 {
            true => echo.strength * (echo.strength / echo.length).powi(2),
            false => 0.0,
        };
        echoes.sort_by(|a, b| received(b).total_cmp(&received(a)));
        [0, 1].map(|index| echoes.get(index).copied().unwrap_or_default())
    }

    /// Returns what comes back from a surface at the end of a path with a factor, which light passes twice.
    fn echo(&self, vertex: &Vertex<'a>, own: OwnLightFactors, factor: Vec3, route: u64) -> Echo {
        let paint = self.paint(vertex.hit);
        let albedo = paint
            .infrared()
            .unwrap_or_else(|| estimated(self.color_at(paint, vertex)));
        let share = f64::from(luminance(factor));
        let cosine = vertex.surface.normal.dot(vertex.ray).abs();
        let strength = f64::from(albedo * own.scattered * (1.0 - paint.metallic())) * cosine * share * share;
        Echo {
            route,
            length: vertex.length * strength,
            strength,
        }
    }
}

impl Echo {
    /// Returns the depth, metres, of a surface that would be at the end of its path; infinite if nothing returns.
    #[expect(clippy::cast_possible_truncation, reason = "images are float32")]
    fn depth(&self, axial: f64) -> f32 {
        match self.strength > 0.0 {
            true => (self.length / self.strength * axial) as f32,
            false => f32::INFINITY,
        }
    }

    #[expect(clippy::cast_possible_truncation, reason = "images are float32")]
    fn strength(&self) -> f32 {
        self.strength as f32
    }
}

/// Estimates the reflectance at 940 nm of a colour as time-of-flight engines do: the luma of sRGB, because dyes that look dark reflect more
/// there.
fn estimated(color: Vec3) -> f32 {
    let [r, g, b] = color.to_array().map(|value| f32::from(srgb_from_linear(value)));
    let luma = (77.0 * r + 150.0 * g + 29.0 * b) / (256.0 * 255.0);
    luma.max(LEAST_ESTIMATE)
}
