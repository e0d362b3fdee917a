from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from types import TracebackType
from typing import Any, final

import numpy as np
import numpy.typing as npt

from ._cameras import Camera
from ._devices import Device
from ._findings import Finding
from ._types import _Annotator, _Array, _Backend, _Float64, _Pair, _Up

__all__ = ["Mesh", "Recording", "Scene", "annotators", "generate"]

@final
class Mesh:
    """A triangle mesh with a material, for `Scene.from_meshes`.

    vertices: (V, 3) numbers, metres in the mesh's own frame.
    faces: (F, 3) integers: the vertices of each triangle, counter-clockwise seen from outside. Depth contains both sides.
    color: the sRGB colour, (3,) for the whole mesh or (V, 3) for each vertex: uint8, or floats from 0 to 1. By default grey.
    normals: (V, 3), for smooth shading; by default triangles are flat.
    uvs: (V, 2) texture coordinates, (0, 0) at the lower left of the image.
    texture: an image (H, W, 3 or 4) uint8 sRGB, or the path of one; requires uvs and is multiplied by the colour.
    metallic, roughness: from 0 to 1.
    emissive: the emitted light, linear, (3,) or one number.

    Raises oaktwin.Error for invalid shapes, vertices that are not finite, and vertex indices that are out of range.
    """
    def __new__(
        cls,
        vertices: object,
        faces: object,
        *,
        color: npt.ArrayLike | None = None,
        normals: npt.ArrayLike | None = None,
        uvs: npt.ArrayLike | None = None,
        texture: npt.NDArray[np.uint8] | str | PathLike[str] | None = None,
        metallic: float = 0.0,
        roughness: float = 0.5,
        emissive: npt.ArrayLike | None = None,
    ) -> Mesh: ...
    def __getnewargs_ex__(self) -> tuple[tuple[npt.NDArray[np.float32], npt.NDArray[np.uint32]], dict[str, Any]]: ...

@final
class Scene:
    """A scene to render on the CPU: `Scene.open(path)`, `Scene.from_meshes({name: mesh})` or
    `Scene.from_triangles(vertices, faces)`.

    The world keeps the file's axes; its unit is the metre, whatever the file's unit is. `set_pose` moves parts between renders.
    Thread-safe. Unpickling opens the file again; meshes are stored in the pickle, and poses in both cases.
    """
    @staticmethod
    def open(
        path: str | PathLike[str],
        *,
        time: float | None = None,
        subdivide: int = 0,
        up: _Up | None = None,
        scale: float | None = None,
        scene_limit: float = 1.0,
        allow_outside: bool = False,
    ) -> Scene:
        """staticmethod(function) -> method

        Convert a function to be a static method.

        A static method does not receive an implicit first argument.
        To declare a static method, use this idiom:

             class C:
                 @staticmethod
                 def f(arg1, arg2, argN):
                     ...

        It can be called either on the class (e.g. C.f()) or on an instance
        (e.g. C().f()). Both the class and the instance are ignored, and
        neither is passed implicitly as the first argument to the method.

        Static methods in Python are similar to those found in Java or C++.
        For a more advanced concept, see the classmethod builtin.
        """
    @staticmethod
    def from_triangles(
        vertices: _Array, faces: _Array, *, up: _Up = "z", label: str | None = None
    ) -> Scene:
        """staticmethod(function) -> method

        Convert a function to be a static method.

        A static method does not receive an implicit first argument.
        To declare a static method, use this idiom:

             class C:
                 @staticmethod
                 def f(arg1, arg2, argN):
                     ...

        It can be called either on the class (e.g. C.f()) or on an instance
        (e.g. C().f()). Both the class and the instance are ignored, and
        neither is passed implicitly as the first argument to the method.

        Static methods in Python are similar to those found in Java or C++.
        For a more advanced concept, see the classmethod builtin.
        """
    @staticmethod
    def from_meshes(
        meshes: Mapping[str, Mesh],
        *,
        poses: Mapping[str, npt.ArrayLike] | None = None,
        labels: Mapping[str, str] | None = None,
        up: _Up = "z",
    ) -> Scene:
        """staticmethod(function) -> method

        Convert a function to be a static method.

        A static method does not receive an implicit first argument.
        To declare a static method, use this idiom:

             class C:
                 @staticmethod
                 def f(arg1, arg2, argN):
                     ...

        It can be called either on the class (e.g. C.f()) or on an instance
        (e.g. C().f()). Both the class and the instance are ignored, and
        neither is passed implicitly as the first argument to the method.

        Static methods in Python are similar to those found in Java or C++.
        For a more advanced concept, see the classmethod builtin.
        """
    def set_pose(self, name: str, world_from_part: npt.ArrayLike) -> None:
        """Moves a part. Only what depends on its pose is computed again.

        name: its name, or its prim path; that of a mesh in a file, see `poses`.
        world_from_part: (4, 4), the new pose, metres; without scale: a scale in the file stays.

        Renders that other threads have started finish with the old pose. Raises oaktwin.Error for unknown names and invalid poses.
        """
    def set_poses(self, poses: Mapping[str, npt.ArrayLike]) -> None:
        """Moves several parts: a mapping from names to poses, as in `set_pose`. If one is invalid, none is moved."""
    @property
    def poses(self) -> dict[str, _Float64]:
        """The poses of all parts, a dictionary from prim path to (4, 4) float64 world_from_part, metres."""
    def save_usd(self, path: str | PathLike[str]) -> None:
        """Writes the scene as a USD file, with its present poses, materials, lights and semantic labels.

        path: the file to write, *.usda or *.usd. Images of textures are written to a folder beside it, NAME_textures.

        Raises oaktwin.Error for another extension, and OSError if a file cannot be written.
        """
    def render(
        self,
        camera: Camera,
        world_from_camera: npt.ArrayLike,
        *,
        annotators: Sequence[_Annotator] | None = None,
        backend: _Backend = "auto",
        smooth_edges: bool = True,
    ) -> dict[str, Any]:
        """Renders the ground truth of a camera.

        camera: a device's camera (`device.cameras["left"]`, `device.depth_camera()`) or any other `Camera`.
        world_from_camera: the camera's pose: (4, 4), or (N, 4, 4) for a batch; its axes are OpenCV's (x right, y down, z
            forward), metres. See `look_at`.
        annotators: names of Replicator's annotators, by default "distance_to_image_plane"; see `annotators()`.
        backend: "auto" (default), "raster" or "ray"; depths agree within 3 ulp of float32 up to 75° of incidence.
        smooth_edges: whether outlines in colour images are antialiased.

        Returns a dictionary by annotator. Images are (H, W) or (H, W, C) for one pose, (N, H, W) or (N, H, W, C) for a batch:
        distances float32 metres, inf for a miss; "rgb" uint8 with coverage as its fourth channel; "normals" float32 in the
        world frame, 0 for a miss; segmentations uint32, 0 for the background, with the meaning of the ids in
        "instance_id_segmentation_prim_paths" and "semantic_segmentation_labels". Bounding boxes (structured, with Replicator's
        fields) and "pointcloud" ((P, 3) float32 in the world, metres) are an array for one pose, a list of arrays for a batch.

        Raises oaktwin.Error for invalid poses, unknown annotators, and images that do not fit in memory.
        """
    def render_pair(
        self,
        device: Device,
        world_from_body: npt.ArrayLike,
        *,
        size: Sequence[int] | None = None,
        projector: float = 0.0,
        ambient: float = 1.0,
        imager: Mapping[str, object] | None = None,
        seed: int | None = None,
        device_seed: int | None = None,
        frame: int | None = None,
    ) -> _Pair:
        """Renders the images of a device's stereo pair, raw and rectified as on the device, for a `StereoMatcher`.

        device: the device with the stereo pair.
        world_from_body: the pose of its body, (4, 4), metres; x forward, y left, z up. See `look_at` with frame="body".
        size: (width, height) of the images in px, resized by DepthAI's rule; by default the cameras' own.
        projector: the intensity of a Pro's infrared dot projector, from 0 (default, off) to 1.
        ambient: the scale of the scene's lights; 0 is darkness.
        imager: a mapping of image sensor parameters by name: {"bits": 10, "noise": False, ...}.
        seed: the noise seed.
        device_seed: the seed of the unit's calibration error, which displaces the right camera from its assumed pose; None
            (default) for no error.
        frame: the frame number in the sequence, which determines the noise together with the seed.

        Returns a dictionary: "left", "right", "rectified_left", "rectified_right", (H, W) uint8, or uint16 with 10 bits; the
        rectified images are 0 outside the camera's image; "z", the ground truth in the rectified left camera, (H, W) float32
        metres along its optical axis, inf for a miss.

        Issues an oaktwin.FindingWarning for missing or unsupported contents. Raises oaktwin.Error for a device without a stereo
        pair or without the requested projector, an invalid pose, values out of range, and images that do not fit in memory.
        """
    def __reduce__(self) -> tuple[Any, ...]: ...
    def __setstate__(self, poses: Mapping[str, npt.ArrayLike]) -> None: ...
    @property
    def cameras(self) -> dict[str, tuple[Camera, _Float64]]:
        """The cameras in the file that `oaktwin render` renders: those of render products with a depth sensor, otherwise all. A
        dictionary from the prim's path to (camera, world_from_camera), the latter (4, 4) float64 metres with OpenCV's axes:
        `scene.render(*scene.cameras["/World/Camera"])`.

        A camera that cannot be rendered is skipped and listed in `findings`; raises oaktwin.Error if none can be rendered.
        """
    @property
    def findings(self) -> list[Finding]:
        """Warnings about missing and unsupported contents of the file."""
    @property
    def up(self) -> _Up:
        """The up axis of the world, "y" or "z"."""
    @property
    def triangle_count(self) -> int:
        """The number of rendered triangles, counting those of every instance."""
    @property
    def bounds(self) -> _Float64 | None:
        """The minimum and maximum corner of the bounding box, (2, 3) metres in the world; None if the scene is empty."""

@final
class Recording:
    """A recording of moving cameras: `with oaktwin.Recording("path.mcap") as recording: recording.log(...)`.

    An .mcap contains ROS 2 messages: for each camera NAME the topics /NAME/rgb, /NAME/depth, /NAME/measured (sensor_msgs/Image:
    rgb8, 32FC1 metres or 16UC1 millimetres), /NAME/camera_info, /NAME/depth_points or /NAME/measured_points
    (sensor_msgs/PointCloud2), and its pose on /tf and /tf_static: world, NAME (x forward, y left, z up),
    NAME_optical_frame (x right, y down, z forward), which is the frame of images and clouds. Invalid depth is NaN (0 in
    millimetres); ground-truth depth without a surface is inf (REP-117, REP-118). The same calls give the same bytes.

    An .rrd is for Rerun; it requires a package built with the feature `rerun`.

    path: the file, .mcap or .rrd. It is created when the recording is closed, and not at all if the `with` block ends in
        an exception or the object is dropped.
    up: the up axis of the world, "z" (default) or "y"; .mcap does not store it.

    Raises oaktwin.Error for another extension, OSError if the file cannot be written. Thread-safe.
    """
    def __new__(cls, path: str | PathLike[str], *, up: _Up = "z") -> Recording: ...
    def log(
        self,
        camera: Camera,
        world_from_camera: npt.ArrayLike,
        *,
        time: float | None = None,
        frame: int | None = None,
        depth: _Array | None = None,
        measured: _Array | None = None,
        measured_camera: Camera | None = None,
        rgb: _Array | None = None,
        points: bool = True,
        name: str | None = None,
    ) -> None:
        """Records the images of a camera at a pose.

        camera: the camera of the images; all calls with the same name must use the same camera.
        world_from_camera: the camera's pose, (4, 4), with OpenCV's axes, metres.
        time: the time in seconds, from 0 to 2^31; by default frame / 30.
        frame: the frame number, used if time is None.
        depth: ground-truth depth, (H, W) float32 metres or uint16 millimetres.
        measured: the depth sensor's output, in the same format.
        measured_camera: the camera of the depth sensor's output, `DepthSensor.camera`, if it is not the camera itself: a
            filter decimates, or the engine is "single-view". Its topic is /NAME/measured_camera_info.
        rgb: the colour image, (H, W, 3) or (H, W, 4) uint8, sRGB.
        points: whether to record a point cloud, too: of measured depth, or otherwise of ground-truth depth.
        name: the name of the camera; by default its own. Characters other than letters, digits and _ are replaced by _.

        Raises oaktwin.Error for images whose size differs from the camera's, a different camera with the same name, an invalid
        time, or a closed recording; OSError if the file cannot be written.
        """
    def close(self) -> None:
        """Completes the file. Does nothing if the recording is closed.

        Raises OSError if the file cannot be written.
        """
    @property
    def path(self) -> Path:
        """The path of the file."""
    def __enter__(self) -> Recording: ...
    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None, /
    ) -> None: ...

def annotators() -> dict[str, str]:
    """The annotators of scenes and depth sensors: a dictionary from name to description.

    `Scene.render` takes all but "camera_params" and those whose names begin with "depth_sensor_", which
    `DepthSensor.annotate` takes.
    """

def generate(
    recipe: str | PathLike[str],
    output: str | PathLike[str],
    *,
    frames: tuple[int, int] | None = None,
    resume: bool = False,
    formats: Sequence[str] | None = None,
    seed: int | None = None,
    workers: int | None = None,
    only_frames: bool = False,
) -> dict[str, int]:
    """Generates a data set of random scenes from a recipe, as `oaktwin generate` does.

    recipe: the TOML file.
    output: the folder of the data set.
    frames: the first frame and the frame after the last one, such as (0, 100); by default all frames of the recipe.
    resume: whether an existing data set is completed or extended.
    formats: the names of formats instead of the recipe's, such as ["bop", "coco"].
    seed: the seed instead of the recipe's.
    workers: the number of frames that are made at the same time; by default that of the processors, if there is enough memory.
    only_frames: whether files that span frames are left to another call with resume=True. Several processes, also on several
        machines with a common folder, can make different frames of one data set in this way.

    Returns a mapping: "frames", the number of frames that were made, "skipped", those that were complete already, "missing", those of
    the recipe that are not there, "files" and "bytes".

    Warns with oaktwin.FindingWarning. Raises oaktwin.Error for an invalid recipe or an impossible placement; what is complete
    remains and can be resumed, also after Ctrl-C.
    """
