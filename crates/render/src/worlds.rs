//! Many worlds that share their geometry, for the environments of a simulator.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use oaktwin_camera::math::DAffine3;
use oaktwin_scene::Scene;
use rayon::ThreadPoolBuilder;

use crate::{Backend, Renderer, View};

/// Worlds with the same meshes, in which some instances have other poses.
///
/// A world is the poses of the instances that have moved: meshes exist once for each thread, however many worlds there are. Each thread
/// renders whole worlds, because the images of environments are small.
#[derive(Debug)]
pub struct Worlds {
    /// A scene for each thread, which stands as in the world that was rendered last.
    renderers: Vec<Mutex<Renderer>>,
    count: usize,
    /// The instances that have been moved in any world.
    moved: Vec<usize>,
    /// Their `world_from_mesh`, world by world.
    poses: Vec<DAffine3>,
}

impl Worlds {
    /// Makes a number of worlds, in all of which the scene stands as it is.
    #[must_use]
    pub fn new(scene: &Scene, count: usize) -> Self {
        let threads = rayon::current_num_threads().clamp(1, count.max(1));
        Self {
            renderers: (0..threads)
                .map(|_| Mutex::new(Renderer::new(scene.clone())))
                .collect(),
            count,
            moved: Vec::new(),
            poses: Vec::new(),
        }
    }

    /// Returns the number of worlds.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Sets `world_from_mesh` of instances in some worlds: `poses` has those of all instances in the first of these worlds, then in the
    /// second, and so on. Worlds, instances and poses out of range are ignored.
    pub fn set_poses(&mut self, worlds: &[usize], instances: &[usize], poses: &[DAffine3]) {
        let places = self.places(instances);
        let width = self.moved.len();
        for (world, own) in worlds.iter().zip(poses.chunks_exact(instances.len().max(1))) {
            let Some(row) = self.poses.get_mut(world * width..(world + 1) * width) else {
                continue;
            };
            for (place, pose) in places.iter().zip(own) {
                row[*place] = *pose;
            }
        }
    }

    /// Returns the pose of an instance in a world: `world_from_mesh`.
    #[must_use]
    pub fn pose(&self, world: usize, instance: usize) -> Option<DAffine3> {
        let place = self.moved.iter().position(|one| *one == instance);
        match place {
            Some(place) => self.poses.get(world * self.moved.len() + place).copied(),
            None => self.first(instance),
        }
    }

    /// Returns the places of instances among the ones that have moved, to which it adds them.
    fn places(&mut self, instances: &[usize]) -> Vec<usize> {
        let width = self.moved.len();
        let mut places = Vec::with_capacity(instances.len());
        for instance in instances {
            let known = self.moved.iter().position(|one| one == instance);
            places.push(known.unwrap_or(self.moved.len()));
            if known.is_none() {
                self.moved.push(*instance);
            }
        }
        let new = &self.moved[width..];
        if !new.is_empty() {
            let firsts: Vec<DAffine3> = new
                .iter()
                .map(|one| self.first(*one).unwrap_or_default())
                .collect();
            let mut poses = Vec::with_capacity(self.count * self.moved.len());
            for world in 0..self.count {
                poses.extend_from_slice(&self.poses[world * width..(world + 1) * width]);
                poses.extend_from_slice(&firsts);
            }
            self.poses = poses;
        }
        places
    }

    /// The pose of an instance that no world has moved.
    fn first(&self, instance: usize) -> Option<DAffine3> {
        let renderer = self
            .renderers
            .first()?
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        renderer
            .scene()
            .instances
            .get(instance)
            .map(|instance| instance.world_from_mesh)
    }

    /// Renders the z-depth of some worlds, metres, `+inf` for a miss: the images of the views, one after another, into `out`. Each image has
    /// the bytes of [`Renderer::depth`] with the same backend. Worlds without room in `out` or without a view are left out, and all that
    /// are left once `stop` says so.
    pub fn depth(
        &self,
        worlds: &[usize],
        views: &[View],
        backend: Backend,
        out: &mut [f32],
        stop: &(dyn Fn() -> bool + Sync),
    ) {
        let pixels = |view: &View| {
            let size = view.camera.intrinsics.size;
            size.width as usize * size.height as usize
        };
        let Some(length) = views.first().map(pixels).filter(|length| *length > 0) else {
            return;
        };
        let images: Vec<Mutex<&mut [f32]>> = out.chunks_exact_mut(length).map(Mutex::new).collect();
        let jobs = worlds.len().min(views.len()).min(images.len());
        let next = AtomicUsize::new(0);
        let work = |renderer: &Mutex<Renderer>| {
            let mut renderer = renderer.lock().unwrap_or_else(PoisonError::into_inner);
            loop {
                let job = next.fetch_add(1, Ordering::Relaxed);
                if job >= jobs || stop() {
                    return;
                }
                self.put(&mut renderer, worlds[job]);
                let depth = renderer.depth(&views[job], backend);
                let mut image = images[job].lock().unwrap_or_else(PoisonError::into_inner);
                if image.len() == depth.0.pixels().len() {
                    image.copy_from_slice(depth.0.pixels());
                }
            }
        };
        std::thread::scope(|scope| {
            for renderer in &self.renderers {
                let work = &work;
                // One thread: a world is rendered by the thread that takes it. The pool is made for each call, because a forked
                // process inherits no threads.
                scope.spawn(move || match ThreadPoolBuilder::new().num_threads(1).build() {
                    Ok(pool) => pool.install(|| work(renderer)),
                    Err(_) => work(renderer),
                });
            }
        });
    }

    /// Makes the scene of a worker stand as in a world.
    fn put(&self, renderer: &mut Renderer, world: usize) {
        let width = self.moved.len();
        if let Some(own) = self
            .poses
            .get(world * width..(world + 1) * width)
            .filter(|own| !own.is_empty())
        {
            renderer.set_poses(self.moved.iter().copied().zip(own.iter().copied()));
        }
    }
}

#[cfg(test)]
mod tests {
    use oaktwin_camera::math::DVec3;

    use super::*;
    use crate::fixture;

    fn scene() -> Scene {
        let mut scene = Scene::default();
        for z in [2.0, 3.0, 5.0] {
            fixture::placed(
                &mut scene,
                "/Part",
                fixture::rectangle([-1.0, 1.0], [-0.5, 0.5], z),
            );
        }
        scene
    }

    #[test]
    fn worlds_are_scenes_of_their_own() {
        let scene = scene();
        let mut worlds = Worlds::new(&scene, 3);
        let moved = |x: f64| DAffine3::from_translation(DVec3::new(x, 0.1, 0.0));
        worlds.set_poses(
            &[0, 2],
            &[1, 0],
            &[moved(0.2), moved(-0.4), moved(0.7), moved(1.5)],
        );
        worlds.set_poses(&[1], &[2], &[moved(-0.9)]);
        let expected = [
            vec![(1, moved(0.2)), (0, moved(-0.4))],
            vec![(2, moved(-0.9))],
            vec![(1, moved(0.7)), (0, moved(1.5))],
        ];
        let view = fixture::view();
        let size = view.camera.intrinsics.size;
        let length = size.width as usize * size.height as usize;
        for backend in [Backend::Raster, Backend::Ray] {
            let order = [2, 0, 1, 2];
            let mut out = vec![0.0; 4 * length];
            worlds.depth(&order, &[view; 4], backend, &mut out, &|| false);
            for (image, world) in out.chunks(length).zip(order) {
                let mut alone = Renderer::new(scene.clone());
                alone.set_poses(expected[world].clone());
                assert!(
                    alone.depth(&view, backend).0.pixels() == image,
                    "{backend} {world}"
                );
            }
        }
        assert_eq!(worlds.pose(0, 1), Some(moved(0.2)));
        assert_eq!(worlds.pose(1, 1), Some(DAffine3::IDENTITY));
        assert_eq!(worlds.pose(0, 9), None);
    }

    #[test]
    fn what_is_out_of_range_is_left_out() {
        let mut worlds = Worlds::new(&scene(), 2);
        worlds.set_poses(&[7], &[0], &[DAffine3::IDENTITY]);
        worlds.set_poses(&[0], &[], &[]);
        let view = fixture::view();
        let mut out = vec![-1.0; 10];
        worlds.depth(&[0, 1], &[view; 2], Backend::Auto, &mut out, &|| false);
        worlds.depth(&[], &[], Backend::Auto, &mut out, &|| false);
        assert!(out.iter().all(|z| *z == -1.0));
        let none = Worlds::new(&Scene::default(), 0);
        assert_eq!(none.count(), 0);
    }
}
