//! What mirrors and transparent surfaces do with a ray: reflect a share of its light, let another pass, and scatter the rest.

use glam::Vec3;
use oaktwin_scene::{DEFAULT_INDEX, Material};

/// The metalness, or the reflectance at normal incidence, from which on a surface is a mirror.
const MIRROR: f32 = 0.5;
/// The roughness up to which mirrors reflect rays. Rougher ones reflect the mean of their surroundings, as all other surfaces do.
const MAX_ROUGHNESS_OF_MIRRORS: f32 = 0.4;
/// The same for surfaces that are not mirrors, such as glass and polished lacquer.
const MAX_ROUGHNESS: f32 = 0.15;

/// The optical properties of a material that reflects rays or lets them pass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Optic {
    index: f64,
    specular: Option<Vec3>,
    metallic: f32,
    roughness: f32,
    transmits: f32,
    tint: Option<Vec3>,
    refracts: bool,
    is_polished: bool,
}

/// What a surface is to a ray that passes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wall {
    /// A sheet with two sides, such as a pane of glass, whose thickness is not modelled.
    Sheet,
    /// One side of a solid that does not bend light.
    Side,
    /// The surface of a solid that bends light, from outside.
    Entry,
    /// The same from inside.
    Exit,
}

/// How a ray meets a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    /// The cosine of the angle to the normal.
    pub(super) cosine: f64,
    /// The base colour of the place.
    pub(super) color: Vec3,
    /// The opacity of the place, from 0 to 1.
    pub(super) opacity: f32,
    /// The factor of the material's transmission at the place, from 0 to 1.
    pub(super) clarity: f32,
    pub(super) wall: Wall,
}

/// The shares of light on its way back along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Balance {
    pub(super) reflected: Vec3,
    pub(super) transmitted: Vec3,
    pub(super) own: OwnLightFactors,
}

/// The factors of the light that a surface sends itself; see [`OwnLight`](super::reflect::OwnLight).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OwnLightFactors {
    pub(super) scattered: f32,
    pub(super) glossy: f32,
    pub(super) around: f32,
    pub(super) emitted: f32,
}

impl OwnLightFactors {
    pub(super) const ALL: Self = Self {
        scattered: 1.0,
        glossy: 1.0,
        around: 1.0,
        emitted: 1.0,
    };
}

impl Optic {
    /// Returns the properties of a material; `None` if no ray needs to be followed beyond its surface.
    pub(super) fn new(material: &Material) -> Option<Self> {
        let share = |value: f32| {
            if value.is_finite() {
                value.clamp(0.0, 1.0)
            } else {
                0.0
            }
        };
        let (metallic, roughness) = (share(material.metallic), share(material.roughness));
        let specular = material.specular.map(|color| Vec3::from(color.map(share)));
        let transmission = material
            .transmission
            .filter(|transmission| transmission.share > 0.0);
        let is_mirror = metallic >= MIRROR || specular.is_some_and(|color| color.max_element() >= MIRROR);
        let limit = if is_mirror {
            MAX_ROUGHNESS_OF_MIRRORS
        } else {
            MAX_ROUGHNESS
        };
        let is_polished = roughness <= limit;
        let is_partial = material.opacity.is_some_and(|opacity| opacity.is_partial());
        if !(is_polished || is_partial || transmission.is_some()) {
            return None;
        }
        let index = if material.index.is_finite() {
            material.index.max(1.0)
        } else {
            DEFAULT_INDEX
        };
        Some(Self {
            index: f64::from(index),
            specular,
            metallic,
            roughness,
            transmits: transmission.map_or(0.0, |transmission| share(transmission.share)),
            tint: transmission
                .and_then(|transmission| transmission.tint)
                .map(|tint| Vec3::from(tint.map(share))),
            refracts: transmission.is_some_and(|transmission| transmission.refracts) && index > 1.0,
            is_polished,
        })
    }

    pub(super) const fn index(&self) -> f64 {
        self.index
    }

    pub(super) const fn roughness(&self) -> f32 {
        self.roughness
    }

    /// Whether closed meshes bend light.
    pub(super) const fn refracts(&self) -> bool {
        self.refracts
    }

    /// Whether any light passes where the opacity is 1.
    pub(super) fn transmits(&self) -> bool {
        self.transmits > 0.0
    }

    /// Returns what becomes of light. The shares of no channel add up to more than 1.
    #[expect(clippy::cast_possible_truncation, reason = "light is float32")]
    pub(super) fn balance(&self, meeting: &Meeting) -> Balance {
        let Meeting {
            cosine,
            color,
            opacity,
            clarity,
            wall,
        } = *meeting;
        let share = self.transmits * clarity;
        let transmits = share * opacity + (1.0 - opacity);
        let passes = transmits * (1.0 - self.metallic);
        let reflected = if self.is_polished {
            let dielectric = match wall {
                Wall::Sheet if transmits > 0.0 => {
                    let once = fresnel(cosine, self.index);
                    // The sum over the reflections between both sides.
                    2.0 * once / (1.0 + once)
                }
                Wall::Exit => fresnel(cosine, 1.0 / self.index),
                Wall::Sheet | Wall::Side | Wall::Entry => fresnel(cosine, self.index),
            };
            let dielectric = Vec3::splat(dielectric as f32);
            let grazing = {
                let from = (1.0 - cosine.clamp(0.0, 1.0)) as f32;
                let squared = from * from;
                squared * squared * from
            };
            let schlick = |straight: Vec3| straight + (Vec3::ONE - straight) * grazing;
            match self.specular {
                Some(specular) => schlick(specular),
                None => dielectric * (1.0 - self.metallic) + schlick(color.min(Vec3::ONE)) * self.metallic,
            }
        } else {
            Vec3::ZERO
        };
        let rest = Vec3::ONE - reflected;
        let tint = self.tint.unwrap_or(color).min(Vec3::ONE);
        let clear = Vec3::splat(1.0 - opacity) + tint * (opacity * share);
        let is_bare = if self.is_polished {
            1.0
        } else {
            opacity * (1.0 - share)
        };
        Balance {
            reflected,
            transmitted: rest * clear * (1.0 - self.metallic),
            own: OwnLightFactors {
                scattered: rest.min_element() * (1.0 - passes),
                glossy: is_bare,
                around: if self.is_polished { 0.0 } else { is_bare },
                emitted: opacity,
            },
        }
    }
}

/// Returns the reflectance of a smooth surface for unpolarized light, by Fresnel's equations: `cosine` is that of the angle to the
/// normal, and `index` is that of the other side, relative to the side of the ray.
pub(super) fn fresnel(cosine: f64, index: f64) -> f64 {
    let cosine = cosine.clamp(0.0, 1.0);
    let below = 1.0 - (1.0 - cosine * cosine) / (index * index);
    if below <= 0.0 {
        return 1.0;
    }
    let inside = below.sqrt();
    let across = (cosine - index * inside) / (cosine + index * inside);
    let along = (index * cosine - inside) / (index * cosine + inside);
    0.5 * (across * across + along * along)
}

#[cfg(test)]
mod tests {
    use oaktwin_scene::{Opacity, Transmission};

    use super::*;

    fn meeting(cosine: f64, wall: Wall) -> Meeting {
        Meeting {
            cosine,
            color: Vec3::new(1.0, 0.5, 0.2),
            opacity: 1.0,
            clarity: 1.0,
            wall,
        }
    }

    #[test]
    fn reflectances_are_those_of_the_closed_forms() {
        // At normal incidence ((n - 1) / (n + 1))², at grazing incidence 1.
        for index in [1.0, 1.33, 1.5, 2.4] {
            let straight: f64 = (index - 1.0) / (index + 1.0);
            assert!((fresnel(1.0, index) - straight * straight).abs() < 1e-12);
            assert!((fresnel(1.0, 1.0 / index) - straight * straight).abs() < 1e-12);
            assert!(index == 1.0 || fresnel(1e-9, index) > 0.999_999);
        }
        // At Brewster's angle only one polarization is reflected: half of ((n² - 1) / (n² + 1))².
        let brewster = 1.5_f64.atan().cos();
        let across: f64 = (2.25 - 1.0) / (2.25 + 1.0);
        assert!((fresnel(brewster, 1.5) - across * across / 2.0).abs() < 1e-12);
        // Beyond the critical angle all light is reflected.
        let critical = (1.0 / 1.5_f64).asin();
        assert!(fresnel((critical - 1e-3).cos(), 1.0 / 1.5) < 1.0);
        assert_eq!(fresnel((critical + 1e-3).cos(), 1.0 / 1.5), 1.0);
        // The same reflectance from both sides of a surface.
        let outside = 50_f64.to_radians();
        let inside = (outside.sin() / 1.5).asin();
        assert!((fresnel(outside.cos(), 1.5) - fresnel(inside.cos(), 1.0 / 1.5)).abs() < 1e-12);
    }

    #[test]
    fn shares_never_add_up_to_more_than_one() {
        for metallic in [0.0, 0.4, 1.0] {
            for roughness in [0.0, 0.3, 0.9] {
                for share in [0.0, 0.3, 1.0] {
                    for opacity in [0.05, 0.5, 1.0] {
                        let material = Material {
                            metallic,
                            roughness,
                            transmission: Some(Transmission {
                                share,
                                mask: None,
                                tint: None,
                                refracts: true,
                            }),
                            opacity: Opacity::new(opacity, None, 0.0),
                            ..Material::default()
                        };
                        let Some(optic) = Optic::new(&material) else {
                            continue;
                        };
                        for cosine in [0.0, 0.1, 0.7, 1.0] {
                            for wall in [Wall::Sheet, Wall::Side, Wall::Entry, Wall::Exit] {
                                let meeting = Meeting {
                                    opacity,
                                    color: Vec3::new(1.0, 0.5, 0.0),
                                    ..meeting(cosine, wall)
                                };
                                let balance = optic.balance(&meeting);
                                let diffuse = meeting.color * (1.0 - metallic) * balance.own.scattered;
                                let sum = balance.reflected + balance.transmitted + diffuse;
                                assert!(sum.max_element() < 1.0 + 1e-6, "{material:?} {meeting:?}: {sum}");
                                assert!(sum.min_element() >= 0.0);
                            }
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn a_pane_reflects_like_the_sum_over_its_two_sides() {
        let glass = Material {
            roughness: 0.0,
            transmission: Some(Transmission {
                share: 1.0,
                mask: None,
                tint: Some([1.0; 3]),
                refracts: false,
            }),
            ..Material::default()
        };
        let optic = Optic::new(&glass).unwrap();
        let balance = optic.balance(&meeting(1.0, Wall::Sheet));
        // 0.04 + 0.96² · 0.04 · (1 + 0.04² + …) = 2 · 0.04 / 1.04.
        assert!((balance.reflected.x - 0.08 / 1.04).abs() < 1e-6);
        assert!((balance.transmitted.x - 0.96 / 1.04).abs() < 1e-6);
        assert_eq!(balance.own.scattered, 0.0);
    }

    #[test]
    fn ordinary_materials_need_no_rays() {
        let with = |metallic, roughness| {
            Optic::new(&Material {
                metallic,
                roughness,
                ..Material::default()
            })
        };
        assert!(Optic::new(&Material::default()).is_none());
        assert!(with(1.0, 0.5).is_none() && with(0.0, 0.2).is_none());
        assert!(with(1.0, 0.3).is_some() && with(0.0, 0.05).is_some());
    }
}
