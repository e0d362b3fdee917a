use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::{Instance, Mesh, Scene};

use super::Random;
use crate::shapes::icosphere;

/// The contents of a random scene: around the origin and a few metres wide, unless stated otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Boxes in rows in one mesh, rotated, scaled and mirrored.
    Boxes,
    /// Spheres with shared vertices in one mesh.
    Spheres,
    /// Triangles of all sizes in random places.
    Soup,
    /// Triangles a thousand times longer than wide.
    Needles,
    /// Triangles far larger than the scene, inside and around it.
    Huge,
    /// Triangles smaller than a pixel.
    Tiny,
    /// Triangles around the origin that extend behind a camera there.
    AroundTheOrigin,
    /// Overlapping coplanar triangles, duplicates, and neighbours with tiny gaps.
    Coplanar,
    /// A mixture with triangles without area: points, lines, repeated vertices.
    Degenerate,
    /// Boxes a hundred kilometres from the origin, placed by their instance's transform.
    FarAway,
    /// A closed room with a fine floor: no pixel misses.
    Room,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 11] = [
        Self::Boxes,
        Self::Spheres,
        Self::Soup,
        Self::Needles,
        Self::Huge,
        Self::Tiny,
        Self::AroundTheOrigin,
        Self::Coplanar,
        Self::Degenerate,
        Self::FarAway,
        Self::Room,
    ];

    /// Returns the centre of the scene.
    #[must_use]
    pub fn centre(self) -> DVec3 {
        match self {
            Self::FarAway => DVec3::new(1e5, -7e4, 3e3),
            _ => DVec3::ZERO,
        }
    }
}

/// Creates a scene of up to several hundred triangles.
#[must_use]
pub fn scene(kind: Kind, random: &mut Random) -> Scene {
    let mut builder = Builder::default();
    match kind {
        Kind::Boxes | Kind::FarAway => {
            let mesh = builder.mesh(cuboid());
            for _ in 0..12 {
                let mirror = if random.below(2) == 0 { 1.0 } else { -1.0 };
                let stretch = DVec3::new(
                    mirror * random.magnitude(0.05, 1.0),
                    random.magnitude(0.05, 1.0),
                    random.magnitude(0.05, 1.0),
                );
                let matrix = random.rotation() * DMat3::from_diagonal(stretch);
                builder.place(mesh, matrix, kind.centre() + 2.5 * random.in_cube());
            }
        }
        Kind::Spheres => {
            let mesh = builder.mesh(icosphere(2, |_| 1.0));
            for _ in 0..3 {
                let matrix = random.rotation() * random.magnitude(0.2, 1.0);
                builder.place(mesh, matrix, 2.0 * random.in_cube());
            }
        }
        Kind::Soup => builder.soup(200, random, |random| {
            let size = random.magnitude(1e-3, 3.0);
            let middle = 3.0 * random.in_cube();
            [0; 3].map(|_| middle + size * random.in_cube())
        }),
        Kind::Needles => builder.soup(200, random, |random| {
            let (middle, along) = (3.0 * random.in_cube(), random.direction());
            let length = random.magnitude(0.1, 10.0);
            let thin = 1e-3 * length * random.direction();
            [middle - length * along, middle + length * along, middle + thin]
        }),
        Kind::Huge => builder.soup(30, random, |random| {
            let size = random.magnitude(1e2, 1e6);
            let middle = random.magnitude(0.5, 30.0) * random.direction();
            let plane = random.rotation();
            [0.3, 2.4, 4.5].map(|angle| {
                let angle: f64 = angle + random.range(0.0, 1.2);
                middle + plane * DVec3::new(size * angle.cos(), size * angle.sin(), 0.0)
            })
        }),
        Kind::Tiny => builder.soup(1500, random, |random| {
            let size = random.magnitude(1e-5, 2e-2);
            let middle = 2.0 * random.in_cube();
            [0; 3].map(|_| middle + size * random.in_cube())
        }),
        Kind::AroundTheOrigin => builder.soup(25, random, |random| {
            let middle = random.magnitude(0.02, 3.0) * random.direction();
            let size = random.magnitude(0.5, 20.0);
            [0; 3].map(|_| middle + size * random.in_cube())
        }),
        Kind::Coplanar => coplanar(&mut builder, random),
        Kind::Degenerate => degenerate(&mut builder, random),
        Kind::Room => {
            let mesh = builder.mesh(cuboid());
            builder.place(mesh, DMat3::from_diagonal(DVec3::new(4.0, 5.0, 3.0)), DVec3::ZERO);
            let floor = crate::shapes::heightfield([12, 12], [8.0, 10.0], |x, y| {
                -2.5 + 0.3 * crate::shapes::hills(x, y)
            });
            let floor = builder.mesh(floor);
            builder.place(floor, DMat3::IDENTITY, DVec3::ZERO);
        }
    }
    builder.scene
}

#[derive(Default)]
struct Builder {
    scene: Scene,
}

impl Builder {
    #[expect(clippy::cast_possible_truncation, reason = "few meshes")]
    fn mesh(&mut self, mesh: Mesh) -> u32 {
        self.scene.meshes.push(mesh);
        self.scene.meshes.len() as u32 - 1
    }

    fn place(&mut self, mesh: u32, matrix: DMat3, translation: DVec3) {
        let number = self.scene.instances.len();
        self.scene.instances.push(Instance {
            mesh,
            path: format!("/Scene/Thing_{number}"),
            world_from_mesh: DAffine3::from_mat3_translation(matrix, translation),
            labels: Vec::new(),
            material_offset: 0,
        });
    }

    /// Adds triangles without shared vertices, in the world frame.
    fn soup(&mut self, count: u32, random: &mut Random, mut triangle: impl FnMut(&mut Random) -> [DVec3; 3]) {
        let mut mesh = Mesh::default();
        for i in 0..count {
            mesh.positions.extend(triangle(random).map(single));
            mesh.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
        }
        let mesh = self.mesh(mesh);
        self.place(mesh, DMat3::IDENTITY, DVec3::ZERO);
    }
}

fn coplanar(builder: &mut Builder, random: &mut Random) {
    let mut planes = Vec::new();
    for _ in 0..6 {
        planes.push((random.rotation(), 2.0 * random.in_cube()));
    }
    builder.soup(48, random, |random| {
        let (turned, middle) = planes[random.below(6) as usize];
        let lift = [0.0, 0.0, 1e-4][random.below(3) as usize];
        [0; 3].map(|_| {
            let p = random.in_cube();
            middle + turned * DVec3::new(p.x, p.y, lift)
        })
    });
    // Again, in another order.
    let mut again = builder.scene.meshes[0].clone();
    again.triangles.reverse();
    let again = builder.mesh(again);
    builder.place(again, DMat3::IDENTITY, DVec3::ZERO);
}

fn degenerate(builder: &mut Builder, random: &mut Random) {
    builder.soup(150, random, |random| {
        let [a, b, c] = [0; 3].map(|_| 2.0 * random.in_cube());
        match random.below(5) {
            0 => [a; 3],
            1 => [a, a, b],
            2 => [a, b, a.lerp(b, 0.5)],
            3 => [DVec3::ZERO, b, c],
            _ => [a, a.lerp(b, 0.3), a.lerp(c, 0.3)],
        }
    });
    let mesh = &mut builder.scene.meshes[0];
    mesh.triangles.extend([[0, 0, 0], [1, 4, 1], [7, 7, 2]]);
}

/// A box with a half edge of 1 and shared corners.
fn cuboid() -> Mesh {
    let corner = |i: u32| [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -1.0 } else { 1.0 });
    let quads = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    Mesh {
        positions: (0..8).map(corner).collect(),
        triangles: quads
            .into_iter()
            .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect(),
        ..Mesh::default()
    }
}

#[expect(clippy::cast_possible_truncation, reason = "positions are float32")]
fn single(p: DVec3) -> [f32; 3] {
    p.to_array().map(|x| x as f32)
}
