use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_simd::Lanes;

use super::pattern::Spot;
use crate::ray::Vector;

/// A light other than a dome.
#[derive(Clone, Debug)]
pub(super) struct Lamp {
    pub(super) shape: LampShape,
    /// The number among the scene's lamps.
    pub(super) number: usize,
    /// Linear radiance; for a distant light, the irradiance of a surface that faces it.
    pub(super) radiance: Vec3,
}

/// A lamp's shape in the world, metres.
#[derive(Clone, Copy, Debug)]
pub(super) enum LampShape {
    /// A disk infinitely far away.
    Distant {
        /// Unit vector.
        towards: DVec3,
        /// Half axes of the disk, one metre away.
        u: DVec3,
        v: DVec3,
    },
    Sphere {
        centre: DVec3,
        radius: f64,
        /// Unit vector.
        up: DVec3,
    },
    /// A rectangle or an ellipse, shining to one side.
    Area {
        centre: DVec3,
        /// Half axes.
        u: DVec3,
        v: DVec3,
        /// Unit vector to the side that shines.
        normal: DVec3,
        round: bool,
    },
}

impl LampShape {
    /// Creates a distant light in the direction `towards`, a unit vector, with a diameter of `angle` radians.
    pub(super) fn distant(towards: DVec3, angle: f64) -> Self {
        let (u, v) = towards.any_orthonormal_pair();
        let half = (angle.clamp(0.0, 3.0) / 2.0).tan();
        Self::Distant {
            towards,
            u: u * half,
            v: v * half,
        }
    }

    /// Returns the emitting area in m²; `None` for distant lights.
    pub(super) fn surface(&self) -> Option<f64> {
        use std::f64::consts::PI;
        Some(match self {
            Self::Distant { .. } => return None,
            Self::Sphere { radius, .. } => 4.0 * PI * radius * radius,
            Self::Area { u, v, round, .. } => u.cross(*v).length() * if *round { PI } else { 4.0 },
        })
    }

    /// Returns the vector from a point to a spot on the lamp, and whether the lamp is at a finite distance.
    pub(super) fn towards(&self, point: DVec3, spot: Spot) -> (DVec3, bool) {
        let Spot { square, disk: [a, b] } = spot;
        match self {
            Self::Distant { towards, u, v } => (*towards + *u * a + *v * b, false),
            Self::Sphere { centre, radius, up } => {
                let way = *centre - point;
                let [u, v] = across(way.normalize_or(*up), *up);
                // Ends at the surface of the sphere, which may have its own mesh.
                let near = (way.length() - radius).max(0.0) / way.length().max(f64::MIN_POSITIVE);
                ((way + (u * a + v * b) * *radius) * near, true)
            }
            Self::Area {
                centre, u, v, round, ..
            } => {
                let [a, b] = if *round { [a, b] } else { square };
                (*centre + *u * a + *v * b - point, true)
            }
        }
    }
}

/// Returns two axes across a direction, which turn with it from those across `up` and jump only where it points down, so that nearby
/// points see the same spots of a lamp at the same places.
fn across(direction: DVec3, up: DVec3) -> [DVec3; 2] {
    let sum = up + direction;
    let scale = 1.0 / (1.0 + up.dot(direction)).max(f64::MIN_POSITIVE);
    <[DVec3; 2]>::from(up.any_orthonormal_pair()).map(|axis| axis - sum * (direction.dot(axis) * scale))
}

/// The tangent of the angular radius below which the penumbrae of a lamp are narrow.
const SMALL: f64 = 0.02;

/// The tangent of the angular radius below which a lamp is a point.
const POINT: f64 = 2e-4;

/// How large a lamp looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Size {
    Point,
    Small,
    Large,
}

impl Lamp {
    /// Returns how large the lamp looks from a point.
    pub(super) fn size_from(&self, point: DVec3) -> Size {
        let (size, d2) = match self.shape {
            LampShape::Distant { u, .. } => (u.length(), 1.0),
            LampShape::Sphere { centre, radius, .. } => (radius, (centre - point).length_squared()),
            LampShape::Area { centre, u, v, .. } => {
                (u.length().max(v.length()), (centre - point).length_squared())
            }
        };
        let is_below = |tangent: f64| size * size < tangent * tangent * d2;
        match (is_below(POINT), is_below(SMALL)) {
            (true, _) => Size::Point,
            (false, true) => Size::Small,
            (false, false) => Size::Large,
        }
    }

    /// Whether points near this one see the same spots of the lamp at nearly the same places.
    pub(super) fn has_steady_spots_from(&self, point: DVec3) -> bool {
        match self.shape {
            LampShape::Sphere { centre, up, .. } => (centre - point).normalize_or(up).dot(up) > -0.8,
            LampShape::Distant { .. } | LampShape::Area { .. } => true,
        }
    }

    /// Returns the irradiance of a surface that faces the lamp, without shadows.
    #[expect(clippy::cast_possible_truncation, reason = "light is float32")]
    pub(super) fn irradiance_at(&self, point: DVec3) -> Vec3 {
        let share = match self.shape {
            LampShape::Distant { .. } => 1.0,
            LampShape::Sphere { centre, radius, .. } => {
                let r2 = radius * radius;
                std::f64::consts::PI * r2 / (centre - point).length_squared().max(r2)
            }
            LampShape::Area { centre, normal, .. } => {
                let way = point - centre;
                let (d2, area) = (way.length_squared(), self.shape.surface().unwrap_or(0.0));
                let cosine = (way.dot(normal) / d2.sqrt().max(f64::MIN_POSITIVE)).max(0.0);
                // The irradiance saturates close to a large lamp, which then fills a hemisphere.
                area * cosine / d2.max(area / std::f64::consts::PI)
            }
        };
        self.radiance * share as f32
    }

    /// Returns the lamp relative to the eye of a view.
    #[expect(clippy::cast_possible_truncation, reason = "shading is float32")]
    pub(super) fn seen_from(&self, eye: DVec3) -> Emitter {
        let area = self.shape.surface().unwrap_or(0.0) as f32;
        match self.shape {
            LampShape::Distant { towards, u, .. } => Emitter::Distant {
                towards: towards.as_vec3(),
                spread: u.length() as f32,
                irradiance: self.radiance,
            },
            LampShape::Sphere { centre, radius, .. } => Emitter::Sphere {
                centre: (centre - eye).as_vec3(),
                radius: radius as f32,
                radiance: self.radiance,
            },
            LampShape::Area {
                centre, u, v, normal, ..
            } => {
                // The centres of a rectangle's quarters, which suit a disk too.
                let (u, v) = ((u * 0.5).as_vec3(), (v * 0.5).as_vec3());
                let centre = (centre - eye).as_vec3();
                Emitter::Area {
                    points: [centre + u + v, centre + u - v, centre - u + v, centre - u - v],
                    normal: normal.as_vec3(),
                    area,
                    radiance: self.radiance,
                }
            }
        }
    }
}

/// A lamp in single precision, relative to the eye, in world axes.
#[derive(Clone, Debug)]
pub(super) enum Emitter {
    Distant {
        towards: Vec3,
        spread: f32,
        irradiance: Vec3,
    },
    Sphere {
        centre: Vec3,
        radius: f32,
        radiance: Vec3,
    },
    Area {
        points: [Vec3; 4],
        normal: Vec3,
        area: f32,
        radiance: Vec3,
    },
}

/// What the light of lamps falls on: eight points.
pub(super) trait Receiver<L: Lanes> {
    /// Receives light from the unit vector `towards`, with an irradiance of `share` times `radiance` on a surface that faces it,
    /// from a lamp of angular radius `width` (its tangent).
    fn receive(&mut self, towards: Vector<L>, share: L, radiance: Vec3, width: L);
}

impl Emitter {
    /// Sends the light of each sample of the lamp to points.
    #[inline(always)]
    pub(super) fn shine<L: Lanes>(&self, point: Vector<L>, on: &mut impl Receiver<L>) {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let min_length = L::splat(f32::MIN_POSITIVE);
        match self {
            Self::Distant {
                towards,
                spread,
                irradiance,
            } => on.receive(
                Vector::splat(towards.to_array()),
                one,
                *irradiance,
                L::splat(*spread),
            ),
            Self::Sphere {
                centre,
                radius,
                radiance,
            } => {
                let way = Vector::splat(centre.to_array()) - point;
                let r2 = radius * radius;
                let d2 = way.dot(way);
                let share = L::splat(std::f32::consts::PI * r2) / d2.max(L::splat(r2)).max(min_length);
                let distance = d2.sqrt().max(min_length);
                on.receive(
                    way * (one / distance),
                    share,
                    *radiance,
                    L::splat(*radius) / distance.max(L::splat(*radius)),
                );
            }
            Self::Area {
                points,
                normal,
                area,
                radiance,
            } => {
                let quarter = area / 4.0;
                let back = Vector::splat((-*normal).to_array());
                for place in points {
                    let way = Vector::splat(place.to_array()) - point;
                    let d2 = way.dot(way).max(min_length);
                    let towards = way * (one / d2.sqrt());
                    let cosine = towards.dot(back).max(zero);
                    let nearest = L::splat(quarter / std::f32::consts::PI);
                    let share = L::splat(quarter) * cosine / d2.max(nearest);
                    let width = (L::splat(quarter) / d2).sqrt().min(one);
                    on.receive(towards, share, *radiance, width);
                }
            }
        }
    }
}
