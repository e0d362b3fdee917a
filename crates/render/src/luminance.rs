use oaktwin_base::diagnostic::Finding;
use oaktwin_image::{Image, ZDepth};

use crate::shade::Beam;
use crate::{Backend, Renderer, View};

/// Linear luminance on a sensor; 1 is a white diffuse surface in the scene's typical light.
#[derive(Clone, Debug, PartialEq)]
pub struct Luminance {
    /// The Rec. 709 luminance from the scene's own lights, without a tone curve; 0 where the lens has no ray.
    pub scene: Image<f32>,
    /// The luminance that the beam adds, if there is one.
    pub beam: Option<Image<f32>>,
    /// Z-depth in metres, `+inf` for a miss.
    pub z: ZDepth,
}

impl Renderer {
    /// Renders the luminance of a view's pixels; the findings are textures that cannot be shown.
    ///
    /// Outlines are antialiased in the scene's light. A beam casts shadows and is reflected once, by diffuse surfaces only.
    #[must_use]
    pub fn luminance(
        &self,
        view: &View,
        backend: Backend,
        beam: Option<&Beam<'_>>,
    ) -> (Luminance, Vec<Finding>) {
        let seen = self.visibility(view, backend);
        let corners = self.corners(view, backend);
        let rays = self.rays(view);
        let input = self.shading(view, &rays, &seen);
        let (parts, mut findings) = self.shader().luminance(input, Some(&corners), beam);
        findings.extend(self.unread_masks());
        self.spare_visibility(view, backend).keep(None, seen.hits);
        let found = Luminance {
            scene: parts.scene,
            beam: parts.beam,
            z: seen.z,
        };
        (found, findings)
    }
}

#[cfg(test)]
mod tests {
    use oaktwin_camera::RigidTransform;
    use oaktwin_camera::math::{DMat3, DVec3};
    use oaktwin_image::annotation::Annotator;
    use oaktwin_image::srgb;
    use oaktwin_scene::{Material, MaterialSpan, Scene};

    use super::*;
    use crate::rays::Rays;
    use crate::{AnnotateOptions, BeamPattern, fixture};

    /// A cone of uniform luminance.
    struct Spot {
        luminance: f32,
        radius: f32,
    }

    impl BeamPattern for Spot {
        fn luminance(&self, at: [f32; 2]) -> f32 {
            if at[0].hypot(at[1]) < self.radius {
                self.luminance
            } else {
                0.0
            }
        }

        fn is_dark_around(&self, at: [f32; 2], radius: f32) -> bool {
            at[0].hypot(at[1]) > self.radius + radius
        }
    }

    fn room() -> Scene {
        let materials = [0.3, 0.8].map(|grey| Material {
            base_color: Some([grey; 3]),
            roughness: 1.0,
            ..Material::default()
        });
        let mut scene = Scene {
            materials: materials.to_vec(),
            ..Scene::default()
        };
        for (material, x, z) in [(0, [-9.0, 9.0], 2.0), (1, [-0.2, 0.1], 1.2)] {
            let mut mesh = fixture::rectangle(x, [-9.0, 9.0], z);
            mesh.materials = vec![MaterialSpan {
                end: 2,
                material: Some(material),
            }];
            fixture::placed(&mut scene, "/Plate", mesh);
        }
        scene
    }

    #[test]
    fn luminance_equals_the_colours_before_the_tone_curve() {
        let renderer = Renderer::new(room());
        let view = fixture::view();
        let (light, findings) = renderer.luminance(&view, Backend::Auto, None);
        assert!(findings.is_empty() && light.beam.is_none());
        let annotators = [Annotator::Rgb, Annotator::DistanceToImagePlane];
        let (frame, _) = renderer.annotate(&view, &annotators, Backend::Auto, &AnnotateOptions::default());
        assert_eq!(frame.distance_to_image_plane, Some(light.z));
        let table = srgb::linear_from_srgb();
        let rgb = frame.rgb.unwrap();
        let mut compared = 0;
        for (pixel, light) in rgb.pixels().iter().zip(light.scene.pixels()) {
            // 0.8 is white in typical light; up to 0.6 the tone curve is the identity.
            let [r, g, b] = [0, 1, 2].map(|i| table[usize::from(pixel[i])]);
            let expected = 0.2126 * r + 0.7152 * g + 0.0722 * b;
            if expected < 0.5 {
                compared += 1;
                assert!((light * 0.8 - expected).abs() < 0.006, "{light} {expected}");
            }
        }
        assert!(compared > 10_000);
    }

    #[test]
    fn a_beam_falls_off_with_distance_and_angle_and_casts_shadows() {
        let renderer = Renderer::new(room());
        let place = DVec3::new(-0.5, 0.1, 0.0);
        let rotation = DMat3::from_rotation_y(0.2);
        let spot = Spot {
            luminance: 2.0,
            radius: 0.6,
        };
        let beam = Beam {
            world_from_beam: RigidTransform::new(rotation, place),
            pattern: &spot,
        };
        for view in [fixture::view(), fixture::fisheye()] {
            let (light, _) = renderer.luminance(&view, Backend::Auto, Some(&beam));
            let lit = light.beam.unwrap();
            let rays = Rays::new(&view);
            let (mut bright, mut dark, mut hidden) = (0, 0, 0);
            for y in 0..160 {
                for x in 0..200 {
                    let (Some(ray), Some(z)) = (rays.centre(x, y), light.z.0.get(x, y)) else {
                        continue;
                    };
                    if !z.is_finite() {
                        continue;
                    }
                    let point = ray * (f64::from(*z) / ray.z);
                    let from_beam = point - place;
                    let in_beam = rotation.transpose() * from_beam;
                    let at = in_beam.truncate() / in_beam.z;
                    let found = f64::from(*lit.get(x, y).unwrap());
                    let on_plate = *z < 1.5;
                    let crossing = place + from_beam * (1.2 / from_beam.z);
                    let distance = if on_plate { 9.0 } else { (crossing.x + 0.05).abs() };
                    if distance < 0.14 {
                        hidden += 1;
                        assert_eq!(found, 0.0);
                    } else if distance > 0.16 && at.length() < 0.58 {
                        bright += 1;
                        let albedo = if on_plate { 0.8 } else { 0.3 };
                        let cosine = from_beam.z / from_beam.length();
                        let expected = 2.0 * albedo * cosine / from_beam.length_squared();
                        assert!(
                            (found / expected - 1.0).abs() < 1e-4,
                            "{x} {y}: {found} {expected}"
                        );
                    } else if at.length() > 0.63 {
                        dark += 1;
                        assert_eq!(found, 0.0);
                    }
                }
            }
            assert!(
                bright > 2000 && dark > 1000 && hidden > 500,
                "{bright} {dark} {hidden}"
            );
        }
    }
}
