from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path
from types import TracebackType
from typing import SupportsIndex, final, overload

import numpy as np
import numpy.typing as npt

from ._cameras import Camera
from ._datasets import Sample
from ._devices import Device
from ._findings import Finding
from ._poses import BodyPose, CameraPose, Poses
from ._types import (
    _Array,
    _Backend,
    _Callable,
    _Drift,
    _Engine,
    _Float64,
    _Json,
    _Pair,
    _Progress,
    _Rendered,
    _SceneAnnotator,
    _Transparent,
    _Up,
)

__all__ = ["Mesh", "Recipe", "Recording", "Scene", "annotators"]

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
    def __getnewargs_ex__(self) -> tuple[tuple[npt.NDArray[np.float32], npt.NDArray[np.uint32]], dict[str, object]]: ...

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
        micro_texture: bool = False,
        infrared: Mapping[str, float] | None = None,
        mount: str | None = None,
    ) -> Scene:
        """Opens a USD stage (usd, usda, usdc, usdz) or a mesh file (gltf, glb, dae, obj, stl, ply).

        path: the file.
        time: the time code of a USD stage; by default the default values, or the first time samples. See `set_time`.
        subdivide: the subdivision level of a USD stage's meshes; 0 (default) renders the polygons.
        up: the up axis of a mesh file, "y" or "z"; by default its format's.
        scale: the metres per unit of a mesh file; by default 1.
        scene_limit: a factor on the limits on a USD stage's prims, references and instances; by default 1.
        allow_outside: whether a glTF file may name buffers and images outside its folder; for trusted files only.
        micro_texture: whether surfaces without a texture get the fine one of paint, wood or cloth, by which stereo cameras match them.
        infrared: the reflectance at 940 nm, 0 to 1, of materials by name and of surfaces by label; by default it follows from the colours.
        mount: the path of a USD stage's prim that carries a device; see `world_from_mount`.

        Missing and unsupported contents are listed in `findings`. Raises FileNotFoundError or another OSError if the file cannot
        be read, oaktwin.Error for an invalid file, or an option that does not apply to its format.
        """
    @staticmethod
    def from_triangles(
        vertices: _Array, faces: _Array, *, up: _Up = "z", label: str | None = None
    ) -> Scene:
        """Creates a scene of one mesh.

        vertices: (V, 3) numbers, metres in the world.
        faces: (F, 3) integers: the vertices of each triangle, counter-clockwise seen from outside. Depth contains both sides.
        up: the up axis of the world, "z" (default) or "y".
        label: the semantic class; by default none.

        Raises oaktwin.Error for invalid shapes, vertices that are not finite, and vertex indices that are out of range.
        """
    @staticmethod
    def from_meshes(
        meshes: Mapping[str, Mesh],
        *,
        poses: Mapping[str, npt.ArrayLike] | None = None,
        labels: Mapping[str, str] | None = None,
        up: _Up = "z",
    ) -> Scene:
        """Creates a scene of several meshes, which `set_pose` moves.

        meshes: a mapping from names to `Mesh`. Geometry that appears under several names is stored once.
        poses: a mapping from names to (4, 4) world_from_mesh, metres; by default the identity.
        labels: a mapping from names to semantic classes; by default none.
        up: the up axis of the world, "z" (default) or "y".

        The prim path of a name, in annotations and USD files, is /World/NAME; a name may have several elements: "arm/link_1".

        Raises oaktwin.Error for invalid names and poses, and for poses and labels of unknown names.
        """
    def set_pose(self, name: str, world_from_part: npt.ArrayLike) -> None:
        """Moves a part. Only what depends on its pose is computed again.

        name: its name or its prim path; for a mesh in a file, see `poses`.
        world_from_part: (4, 4), the new pose, metres; without scale: a scale in the file stays.

        Renders that other threads have started finish with the old pose. Raises oaktwin.Error for unknown names and invalid poses.
        """
    def set_poses(self, poses: Mapping[str, npt.ArrayLike]) -> None:
        """Moves several parts: a mapping from names to poses, as in `set_pose`. If one is invalid, none is moved."""
    def set_time(self, time: float | None) -> None:
        """Goes to another time code of an animated USD stage, or with None to its default values. The file is opened once for all times, and of a
        stage in which only transforms are animated, only these are read again: the poses of parts that are animated, and the cameras.
        Otherwise, the whole scene is made again, and poses that were set are lost.

        Issues an oaktwin.FindingWarning for contents that cannot be read. Raises oaktwin.Error for other scenes.
        """
    @property
    def version(self) -> int:
        """A number that changes whenever parts or the time do, by which programs find out whether an image is still true. It is not pickled."""
    @property
    def time(self) -> float | None:
        """The time code, if there is one."""
    @property
    def animation(self) -> tuple[float, float, float] | None:
        """The first and the last time code of an animated USD stage, and its time codes per second; None for other scenes. Without a range
        in the stage, the first is 0 and the last infinity.

        Raises oaktwin.Error if the stage cannot be read again.
        """
    @property
    def world_from_mount(self) -> npt.NDArray[np.float64] | None:
        """The pose at the present time of the prim that `open` was given as `mount`, (4, 4), metres; None without one. A device at a pose on the
        prim is at `scene.world_from_mount @ mount_from_body`.
        """
    @property
    def poses(self) -> Poses:
        """The poses of all parts, a dictionary from prim path to (4, 4) float64 world_from_part, metres. It finds parts by their names,
        too: `scene.poses["link"]` is `scene.poses["/World/link"]`.
        """
    def save_usd(self, path: str | PathLike[str]) -> None:
        """Writes the scene as a USD file, with its present poses, materials, lights and semantic labels.

        path: the file to write, *.usda or *.usd. Images of textures are written to a folder beside it, NAME_textures.

        Raises oaktwin.Error for another extension, and OSError if a file cannot be written.
        """
    @overload
    def look_at(
        self,
        eye: Sequence[float] | _Float64,
        target: Sequence[float] | _Float64,
        of: Camera | None = None,
    ) -> CameraPose:

        """Returns the pose at a position that faces a target, upright in the world of the scene: a (4, 4) float64 matrix, metres.

        eye, target: the position and the point to face (3 values each), metres in the world.
        of: what is placed: a `Camera` for a `CameraPose`, or a `Device` for the `BodyPose` of its body. By default, a camera.

        Raises oaktwin.Error if eye and target are equal, or one is above the other: `oaktwin.look_at` takes another up direction.
        """
    @overload
    def look_at(
        self,
        eye: Sequence[float] | _Float64,
        target: Sequence[float] | _Float64,
        of: Device,
    ) -> BodyPose: ...
    def render(
        self,
        camera: Camera,
        world_from_camera: npt.ArrayLike,
        *,
        annotators: Sequence[_SceneAnnotator] | None = None,
        backend: _Backend = "auto",
        smooth_edges: bool = True,
        transparent: _Transparent = "surface",
    ) -> _Rendered:
        """Renders the ground truth of a camera.

        camera: a device's camera (`device.cameras["left"]`, `device.depth_camera()`) or any other `Camera`.
        world_from_camera: the camera's pose: (4, 4), or (N, 4, 4) for a batch; its axes are OpenCV's (x right, y down, z
            forward), metres. See `look_at`.
        annotators: names of Replicator's annotators, by default "distance_to_image_plane"; see `annotators()`.
        backend: "auto" (default), "raster" or "ray"; depths agree within 3 ulp of float32 up to 75° of incidence.
        smooth_edges: whether outlines in colour images are antialiased.
        transparent: the ground truth of transparent surfaces: "surface" (default), or "through" for what lies behind the clear ones.

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
        sensor: str | None = None,
        size: Sequence[int] | None = None,
        projector: float = 0.0,
        ambient: float = 1.0,
        imager: Mapping[str, object] | None = None,
        seed: int | None = 0,
        device_seed: int | None = None,
        drift: _Drift | None = None,
        frame: int | None = None,
    ) -> _Pair:
        """Renders the images of a device's stereo pair, raw and rectified as on the device, for a `StereoMatcher`.

        device: the device with the stereo pair.
        world_from_body: the pose of its body, (4, 4), metres; x forward, y left, z up. See `look_at`; a `CameraPose` is rejected.
        sensor: the depth sensor with the pair, by prim, such as "Camera_pseudo_depth_50mm" of the OAK-D LR; by default the
            device's first pair.
        size: (width, height) of the images in px, resized by DepthAI's rule; by default the cameras' own.
        projector: the intensity of a Pro's infrared dot projector, from 0 (default, off) to 1.
        ambient: the scale of the scene's lights; 0 is darkness.
        imager: a mapping of image sensor parameters by name: {"bits": 10, "noise": False, ...}.
        seed: the noise seed; None for one of fresh entropy.
        device_seed: the seed of the unit's calibration error, which displaces the right camera from its assumed pose; None
            (default) for no error.
        drift: the change of the pair since the calibration to which its images are rectified, such as {"yaw": 0.3, "baseline": 50}; see
            `DepthSensor`.
        frame: the frame number in the sequence, which determines the noise together with the seed. By default, the calls of a scene
            without `frame` are numbered from 0 on; copies and pickles continue the numbering.

        Returns a dictionary: "left", "right", "rectified_left", "rectified_right", (H, W) uint8, or uint16 with 10 bits; the
        rectified images are 0 outside the camera's image; "z", the ground truth in the rectified left camera, (H, W) float32
        metres along its optical axis, inf for a miss; "camera", the rectified left camera; "baseline" of the rectified pair in metres;
        "frame" and "seed".

        Issues an oaktwin.FindingWarning for missing or unsupported contents. Raises oaktwin.Error for a device without a stereo
        pair or without the requested projector, an invalid pose, values out of range, and images that do not fit in memory.
        """
    def __reduce__(self) -> tuple[object, ...]: ...
    def __setstate__(self, state: tuple[dict[str, npt.ArrayLike], int]) -> None: ...
    @property
    def cameras(self) -> dict[str, tuple[Camera, CameraPose]]:
        """The cameras in the file that `oaktwin render` renders: the cameras of render products with a depth sensor, otherwise all. A
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
        """The number of rendered triangles, counting every instance."""
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

    path: the file, .mcap, which Rerun and Foxglove open, too. It is created when the recording is closed, and not at all if the `with` block ends in
        an exception or the object is dropped.

    Raises oaktwin.Error for another extension, OSError if the file cannot be written. Thread-safe.
    """
    def __new__(cls, path: str | PathLike[str]) -> Recording: ...
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

@final
class Recipe:
    """A recipe of a data set of random scenes, with its scenes and the list of its objects.

    source: the TOML file, or its contents as a mapping, whose paths are relative to the working directory.
    formats: the names of formats instead of the recipe's, such as ["bop", "coco"].
    seed: the seed instead of the recipe's.
    save_scenes: whether each arrangement is also written as a USD scene, scenes/NUMBER.usda.
    catalog: a folder of TOML files with additional devices and sensors.
    engine: an engine instead of the recipe's: its name, or a callable as for `DepthSensor`.

    A frame depends only on the recipe, the seed and its number: it has the same bytes on every machine, whichever frames are made
    before it. Unpickling reads the files again.

    Raises oaktwin.Error for an invalid recipe, with the line and the nearest name, FileNotFoundError or another OSError for a file that cannot be
    read.
    """
    def __new__(
        cls,
        source: str | PathLike[str] | Mapping[str, object],
        *,
        formats: Sequence[str] | None = None,
        seed: int | None = None,
        save_scenes: bool = False,
        catalog: str | PathLike[str] | None = None,
        engine: _Engine | _Callable | None = None,
    ) -> Recipe: ...
    def __getnewargs_ex__(self) -> tuple[tuple[object], dict[str, object]]: ...
    @property
    def frames(self) -> int:
        """The number of frames."""
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, index: SupportsIndex, /) -> Sample: ...
    @overload
    def __getitem__(self, index: slice, /) -> list[Sample]: ...
    def __iter__(self) -> Iterator[Sample]: ...
    def explain(self, frame: int) -> _Json:
        """Returns all random choices of a frame: the scene, the objects with their poses, the lights, the camera.

        Raises oaktwin.Error if an object or the camera has no place.
        """
    def preview(self, frames: int = 16, *, progress: _Progress = False) -> npt.NDArray[np.uint8]:
        """Returns a contact sheet of the first frames as an sRGB image (H, W, 3) of uint8: colour, exact depth and measured depth.

        frames: the number of frames, at least 1.
        progress: as in `generate`.
        """
    def generate(
        self,
        output: str | PathLike[str],
        *,
        frames: range | tuple[int, int] | None = None,
        resume: bool = False,
        verify: bool = False,
        workers: int | None = None,
        only_frames: bool = False,
        ray: bool | str = False,
        progress: _Progress = False,
    ) -> dict[str, int]:
        """Generates the data set, or a part of it, in a folder, as oaktwin.generate does.

        output: the folder of the data set.
        frames: the frames, such as range(0, 100), or the first one and the one after the last: (0, 100); by default all of the recipe.
        resume: whether an existing data set is completed or extended.
        verify: whether the contents of finished files are compared, not only their lengths, and changed frames are made again; with resume.
        workers: the number of frames to make at once; by default one per processor, or fewer if memory is short.
        only_frames: whether files that span frames are left to another call with resume=True. Several processes, also on several
            machines with a common folder, can make different frames of one data set in this way.
        ray: whether Ray distributes the frames: True, or the address of a cluster, such as "auto", "host:6379" or
            "ray://host:10001".
        progress: whether a progress bar is shown on standard error; or a callable that gets the numbers of frames that are done and in total.
            Not with Ray, which shows its own.
        """
