//! Embree as an engine: `rtcIntersect1`, and packets of 8 and 16 over blocks of 4 × 2 and 4 × 4 pixels.

use std::path::Path;

use oaktwin_scene::Mesh;
use oaktwin_testkit::embree::{EmbreeScene, Packet};
use rayon::prelude::*;

use crate::engine::Engine;
use crate::protocol::ViewJson;

/// The rows of a work item and the columns of a packet.
const BAND: usize = 4;

pub(crate) struct Embree {
    scene: EmbreeScene,
    rays: Rays,
}

/// The rays of a view in float32, bit-identical for all engines.
struct Rays {
    width: usize,
    height: usize,
    origin: [f32; 3],
    rotation: [[f32; 3]; 3],
    columns: Vec<f32>,
    rows: Vec<f32>,
    near: f32,
}

impl Embree {
    pub(crate) fn build(library: &Path, mesh: Mesh, view: &ViewJson, threads: usize) -> Result<Self, String> {
        Ok(Self {
            scene: EmbreeScene::build(library, mesh.positions, mesh.triangles, threads)?,
            rays: Rays::new(view),
        })
    }

    fn packets<const N: usize>(&self, cast: impl Fn(&Packet<N>) -> [f32; N] + Sync) -> Vec<f32> {
        let width = self.rays.width;
        let mut depth = vec![0f32; width * self.rays.height];
        let columns = BAND.min(N);
        depth
            .par_chunks_mut(BAND * width)
            .enumerate()
            .for_each(|(band, pixels)| {
                let rows = pixels.len() / width;
                for y0 in (0..rows).step_by((N / BAND).max(1)) {
                    for x0 in (0..width).step_by(columns) {
                        // Lanes outside the image are clamped to its border.
                        let place = |lane: usize| {
                            (
                                (x0 + lane % columns).min(width - 1),
                                (y0 + lane / columns).min(rows - 1),
                            )
                        };
                        let rays: [_; N] = std::array::from_fn(|lane| {
                            let (x, y) = place(lane);
                            self.rays.direction(x, band * BAND + y)
                        });
                        let directions = std::array::from_fn(|axis| rays.map(|ray| ray[axis]));
                        let packet = Packet {
                            origin: self.rays.origin,
                            directions,
                            near: self.rays.near,
                        };
                        for (lane, t) in cast(&packet).into_iter().enumerate() {
                            let (x, y) = place(lane);
                            pixels[y * width + x] = t;
                        }
                    }
                }
            });
        depth
    }
}

impl Engine for Embree {
    fn modes(&self) -> Vec<String> {
        ["1", "8", "16"].map(str::to_owned).into()
    }

    fn frame(&self, mode: &str) -> Vec<f32> {
        match mode {
            "8" => self.packets(|packet| self.scene.intersect8(packet)),
            "16" => self.packets(|packet| self.scene.intersect16(packet)),
            _ => self.packets(|packet| self.scene.intersect1(packet)),
        }
    }
}

impl Rays {
    #[expect(clippy::cast_possible_truncation, reason = "Embree's rays are float32")]
    fn new(view: &ViewJson) -> Self {
        let along = |count: u32| {
            (0..count)
                .map(|i| ((f64::from(i) + 0.5 - f64::from(count) / 2.0) / view.focal) as f32)
                .collect()
        };
        Self {
            width: view.width as usize,
            height: view.height as usize,
            origin: view.translation.map(|x| x as f32),
            rotation: view.rotation.map(|row| row.map(|x| x as f32)),
            columns: along(view.width),
            rows: along(view.height),
            near: view.near as f32,
        }
    }

    /// The order of the operations is the same as in `bench_render.py`.
    fn direction(&self, x: usize, y: usize) -> [f32; 3] {
        let (x, y) = (self.columns[x], self.rows[y]);
        self.rotation.map(|[a, b, c]| a * x + (b * y + c))
    }
}
