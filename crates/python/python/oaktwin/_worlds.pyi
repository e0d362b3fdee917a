from collections.abc import Sequence
from typing import final

import numpy as np
import numpy.typing as npt

from ._cameras import Camera
from ._scenes import Scene
from ._types import _Array, _Backend, _Items

__all__ = ["Worlds"]

@final
class Worlds:
    """Many worlds with the geometry of one scene, in which parts have other poses: the environments of a simulator.

    scene: the scene. Its geometry and its present poses are copied; later changes of the scene have no effect.
    count: the number of worlds.

    Meshes exist once for each thread, however many worlds there are. Thread-safe.

    Raises oaktwin.Error for more worlds than fit in memory.
    """
    def __new__(cls, scene: Scene, count: int) -> Worlds: ...
    def set_poses(self, names: Sequence[str], poses: _Array, *, worlds: _Items | None = None) -> None:
        """Moves parts.

        names: the names or prim paths of P parts, as in `Scene.set_pose`.
        poses: (N, P, 4, 4) world_from_part, metres, for N worlds; or (P, 4, 4) for all of them.
        worlds: the numbers of the N worlds, or a mask; by default all.

        Raises oaktwin.Error for unknown names, with the nearest ones, other shapes, and matrices that are not poses. Nothing is moved then.
        """
    def render(
        self,
        camera: Camera,
        world_from_camera: _Array,
        *,
        worlds: _Items | None = None,
        backend: _Backend = "auto",
        out: npt.NDArray[np.float32] | None = None,
    ) -> npt.NDArray[np.float32]:
        """Renders the depth of a camera in each world.

        camera: the camera, as in `Scene.render`.
        world_from_camera: (N, 4, 4) poses of the camera, one for each of N worlds, or (4, 4) for all; the axes are OpenCV's, metres.
        worlds: the numbers of the N worlds, or a mask; by default all.
        backend: "auto" (default), "raster" or "ray", as in `Scene.render`.
        out: the output array: C-contiguous float32 (N, H, W).

        Returns `out`, or a new (N, H, W) array: float32 metres along the optical axis, inf for a miss. Each image has the bytes of
        `Scene.render` with the same backend.

        Raises oaktwin.Error for invalid poses, other numbers of poses than of worlds, and images that do not fit in memory.
        """
    def __len__(self) -> int: ...
