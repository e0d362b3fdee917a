"""Data sets from recipes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any

from ._oaktwin import Recipe

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._cameras import Camera
    from ._poses import CameraPose
    from ._types import _Callable, _Engine, _Progress

    _Layers = dict[str, Any]
else:
    _Layers = dict

__all__ = ["Recipe", "Sample", "generate"]


class Sample(_Layers):
    """A frame of a data set in memory, `recipe[number]`: a dictionary of arrays by the names of Replicator's annotators, such as
    `sample["distance_to_image_plane"]`, those that the formats of the recipe have. With several cameras, the names begin with the camera's:
    `sample["Camera_left/rgb"]`. The values equal those in the files, to the byte.

    layers: the arrays by name.
    frame: the number of the frame.
    cameras: the Cameras by name; the only one is "camera".
    world_from_camera: their poses, (4, 4), metres; the axes are OpenCV's.
    measured_cameras: the Cameras that measured depth is an image of.
    objects: a dictionary for each object, with "path", "name", "label" and "world_from_object", (4, 4), if a format of the recipe has poses.

    `Recipe` is a data set as PyTorch expects it: `torch.utils.data.DataLoader(recipe, num_workers=4)`.
    """

    def __init__(
        self,
        layers: dict[str, Any],
        frame: int,
        cameras: dict[str, Camera],
        world_from_camera: dict[str, CameraPose],
        measured_cameras: dict[str, Camera],
        objects: list[dict[str, str | npt.NDArray[np.float64]]],
    ) -> None:
        super().__init__(layers)
        self.frame = frame
        self.cameras = cameras
        self.world_from_camera = world_from_camera
        self.measured_cameras = measured_cameras
        self.objects = objects

    def __repr__(self) -> str:
        return f"<oaktwin.Sample {self.frame}: {', '.join(self)}>"


def generate(
    recipe: str | PathLike[str] | Mapping[str, object],
    output: str | PathLike[str],
    *,
    frames: range | tuple[int, int] | None = None,
    resume: bool = False,
    verify: bool = False,
    formats: Sequence[str] | None = None,
    seed: int | None = None,
    save_scenes: bool = False,
    catalog: str | PathLike[str] | None = None,
    engine: _Engine | _Callable | None = None,
    workers: int | None = None,
    only_frames: bool = False,
    ray: bool | str = False,
    progress: _Progress = False,
) -> dict[str, int]:
    """Generates a data set of random scenes from a recipe, as `oaktwin generate` does.

    recipe: the TOML file, or its contents as a mapping, whose paths are relative to the working directory.
    output: the folder of the data set.
    frames: the frames, such as range(0, 100), or the first one and the one after the last: (0, 100); by default all of the recipe.
    resume: whether an existing data set is completed or extended.
    verify: whether the contents of finished files are compared, not only their lengths, and changed frames are made again; with resume.
    formats: the names of formats instead of the recipe's, such as ["bop", "coco"].
    seed: the seed instead of the recipe's.
    save_scenes: whether each arrangement is also written as a USD scene, scenes/NUMBER.usda.
    catalog: a folder of TOML files with additional devices and sensors.
    engine: an engine instead of the recipe's: its name, or a callable as for `DepthSensor`.
    workers: the number of frames to make at once; by default one per processor, or fewer if memory is short.
    only_frames: whether files that span frames are left to another call with resume=True. Several processes, also on several
        machines with a common folder, can make different frames of one data set in this way.
    ray: whether Ray distributes the frames: True for the cluster that this process is connected to, the one at RAY_ADDRESS or this
        machine; or the address of a cluster, such as "auto", "host:6379" or "ray://host:10001". All machines need this version of
        oaktwin, and the recipe, its files and the folder under the same paths. The bytes are the same as without Ray.
    progress: whether a progress bar is shown on standard error; or a callable that gets the numbers of frames that are done and in total.

    Returns a mapping: "frames", the number of frames that were made, "skipped", those that were complete before, "missing", frames of
    the recipe that are not there, "files" and "bytes".

    Warns with oaktwin.FindingWarning. Raises oaktwin.Error for an invalid recipe or an impossible placement, and ImportError without
    Ray: `pip install oaktwin[ray]`; what is complete remains and can be resumed, also after Ctrl-C.
    """
    opened = Recipe(recipe, formats=formats, seed=seed, save_scenes=save_scenes, catalog=catalog, engine=engine)
    return opened.generate(
        output, frames=frames, resume=resume, verify=verify, workers=workers, only_frames=only_frames, ray=ray, progress=progress
    )
