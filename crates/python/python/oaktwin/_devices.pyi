from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Literal, final

import numpy.typing as npt

from ._cameras import Camera, Rectification
from ._findings import Finding
from ._types import (
    _CalibrationHandler,
    _Float64,
    _Group,
    _ImuFrame,
    _Inertial,
    _Intrinsics,
    _Isaac,
    _Json,
    _Lens,
    _Model,
    _Mount,
    _Offsets,
    _Part,
    _Platform,
    _Preset,
    _Robot,
    _Sensor,
    _Target,
    _Up,
)

__all__ = ["Device", "models", "parameters", "presets", "simulate_imu"]

@final
class Device:
    """A digital twin of a depth camera: the nominal device of a model, or one unit by its calibration.

    model: the name, such as "OAK4-D"; case, spaces, hyphens and underscores are ignored. See `models()`.
    lens: "pinhole" (default), or "fisheye" for the left and right cameras of the wide models.
    imu_frame: the source of the axes of the inertial unit, about which sources disagree: "driver" (default, RTAB-Map's) or "board-file" (the
        vendor's). A calibration with inertial extrinsics has its own.
    catalog: a folder of TOML files with additional devices and sensors. Unpickling reads it again.

    Frames: a camera's is OpenCV's (x right, y down, z forward); the body's is x forward, y left, z up, with the origin midway
    between the left and right optical centres. Metres.

    Raises oaktwin.Error for an unknown model, with the nearest names, or a lens that the model does not have.
    """
    def __new__(
        cls,
        model: _Model | str,
        *,
        lens: _Lens = "pinhole",
        imu_frame: _ImuFrame = "driver",
        catalog: str | PathLike[str] | None = None,
    ) -> Device: ...
    def population(self, count: int, *, seed: int = 0) -> list[Device]:
        """Returns units of the model with realistic variation: their cameras are drawn around the nominal values with the spread of
        factory calibrations.

        count: the number of units, 1 to 10000.
        seed: the seed of the population; a unit depends on the model, the seed and its number.

        A unit has a calibration, which `oaktwin population` also writes. Its findings state the source of the spread. Raises
        oaktwin.Error for the device of a calibration.
        """
    def __reduce__(self) -> tuple[object, ...]: ...
    @staticmethod
    def from_calibration(
        calibration: str | PathLike[str] | bytes | bytearray | Mapping[str, object] | _CalibrationHandler,
        model: _Model | str | None = None,
        *,
        pair: tuple[str, str] | None = None,
        platform: _Platform | None = None,
        force: bool = False,
        lens: _Lens = "pinhole",
        imu_frame: _ImuFrame = "driver",
        catalog: str | PathLike[str] | None = None,
    ) -> Device:
        """Creates the twin of one unit from its DepthAI calibration (JSON).

        calibration: the path of the file; its text, as a string or bytes; its content as a dictionary; or a `CalibrationHandler` of
            DepthAI.
        model: the model of the unit; by default the product name in the calibration. A calibration of no model is a rig, such as two cameras on
            an FFC board, whose cameras are known from it alone: `StereoMatcher` matches their images.
        pair: the sockets of the left and the right camera of a rig, such as ("CAM_B", "CAM_C"); by default those that the calibration names.
        platform: the processor of a rig, "rvc2" (default) or "rvc4".
        force: whether to ignore calibration errors, which become findings.
        lens: see `Device`; a calibrated camera always has its own lens.
        imu_frame: see `Device`; a finding says if the calibration has its own.
        catalog: see `Device`.

        Warnings about the file are in `findings`. Raises FileNotFoundError and other OSErrors for files that cannot be read,
        oaktwin.Error for an invalid calibration or one of another model.
        """
    @property
    def name(self) -> str:
        """The name of the model."""
    @property
    def origin(self) -> str:
        """"nominal", or the calibration file's name."""
    @property
    def findings(self) -> list[Finding]:
        """The findings about the calibration, or about a model that stands in for another."""
    @property
    def cameras(self) -> dict[str, Camera]:
        """The cameras by role: "rgb", "left", "right", "tof"."""
    def depth_camera(self, sensor: _Sensor | str | None = None) -> Camera:
        """Returns the camera of a depth sensor's images: a pinhole with the depth sensor's clipping range. For a calibrated
        stereo pair, it is the device's rectified left camera, as in `StereoMatcher`: rotated, and on RVC2 with the right camera's K.

        sensor: "stereo", "tof" or a prim; by default "tof" if the device has it.
        """
    @property
    def depth_sensors(self) -> dict[str, _Json]:
        """The parameters of the depth sensors by kind ("stereo", "tof"; further stereo pairs by prim), with the catalog's names, which
        include units.
        """
    def extrinsics(self, source: _Part, target: _Part) -> _Float64:
        """(4, 4) float64, target_from_source: takes points in the frame of one part to the frame of another, metres.

        source, target: a camera's role ("rgb", "left", "right", "tof"), "imu" or "body".

        Raises oaktwin.Error for a part that the device does not have.
        """
    def rectification(
        self, *, intrinsics: _Intrinsics | None = None
    ) -> Rectification:
        """The rectification of the stereo pair at the size of its images, as cv2.stereoRectify computes it.

        intrinsics: the intrinsics of the rectified images: "right-camera" (RVC2), "left-camera" (RVC4 and DepthAI's host), "zero-disparity"
            (OpenCV's default) or "free-disparity" (OpenCV without CALIB_ZERO_DISPARITY); by default those of the device's processor, and
            OpenCV's for devices of other makers.

        Raises oaktwin.Error for a device without a stereo pair, or cameras that cannot be rectified.
        """
    def write_usd(
        self,
        path: str | PathLike[str],
        *,
        isaac: _Isaac = "5.1",
        target: _Target = "isaac",
        aperture_offsets: _Offsets = "openusd",
        extended_disparity: bool = False,
        legacy_distortion: bool = False,
        rigid_body: bool = False,
        body: bool = True,
        over: str | PathLike[str] | None = None,
        scene_limit: float = 1.0,
    ) -> None:
        """Writes the USD asset for Isaac Sim and Omniverse.

        path: the file: .usd or .usda for text, .usdz for a package.
        isaac: the version of Isaac Sim, "5.1" or "6".
        target: "isaac", or "ovrtx" (experimental).
        aperture_offsets: the representation of a calibrated principal point: "openusd", "document" or "zero".
        extended_disparity: whether the depth sensor uses the extended mode.
        legacy_distortion: whether to write the old distortion attributes too.
        rigid_body: whether to add mass and a collider.
        body: whether to add the visible body.
        over: an existing asset of the model: the file is then a layer of overrides on it, which refers to it by a relative path.
        scene_limit: a factor on the limits on the prims, references and instances of `over`; by default 1.

        Warns with oaktwin.FindingWarning. Raises oaktwin.Error for an option that the model does not support or an unknown
        extension, OSError for files that cannot be written; incomplete files are removed.
        """
    def export(
        self,
        folder: str | PathLike[str],
        format: _Robot,
        *,
        name: str = "oak",
        parent: str | None = None,
        mount: _Mount = "cameras",
        xyz: Sequence[float] | None = None,
        rpy: Sequence[float] | None = None,
    ) -> list[Path]:
        """Writes a description for robots and simulators, and returns the paths of its files.

        folder: the folder for the files, which is created.
        format: "urdf", "sdf", "drake", "mjcf", "webots" or "blender".
        name: the name of the device, the prefix of its frames.
        parent: the robot's link that carries the device.
        mount: the point of the device that xyz places: "cameras" (midway between the left and the right optical centre), or the centre of
            the housing's face "front", "back", "bottom" or "top".
        xyz: the position of that point in the parent's frame in metres; by default its origin.
        rpy: roll, pitch and yaw of the device in the parent's frame in radians; by default 0.

        Warns with oaktwin.FindingWarning about what the format cannot represent. Raises oaktwin.Error for an unknown format or an invalid
        name, OSError for files that cannot be written.
        """
    def to_ros(self) -> dict[str, str]:
        """Returns ROS's camera_info YAML: a mapping from file names to texts, one per camera.

        Warns with oaktwin.FindingWarning about information that the format cannot represent.
        """
    def to_opencv(self) -> dict[str, str]:
        """Returns OpenCV's FileStorage YAML: a mapping from file names to texts, one per camera and "stereo.yml"."""
    def to_kalibr(self) -> dict[str, str]:
        """Returns Kalibr's camchain, and imu.yaml of the inertial sensor: a mapping from file names to texts.

        Warns with oaktwin.FindingWarning about information that the format cannot represent.
        """
    def to_depthai(self) -> dict[str, str]:
        """Returns DepthAI's calibration JSON: a mapping from a file name to its text; for a nominal device, the ideal unit's."""
    def _repr_html_(self) -> str: ...
    def report(self) -> _Json:
        """Everything known about the device, each number with its source: what `oaktwin show --json` prints."""

def models(
    *,
    maker: str | None = None,
    depth: Literal["stereo", "tof", "none"] | None = None,
    catalog: str | PathLike[str] | None = None,
) -> list[str]:
    """Returns the names of all models for `Device`.

    maker: only this manufacturer's, such as "Luxonis" or "Intel".
    depth: only those with this kind of depth sensor: "stereo", "tof" or "none".
    catalog: a folder with more models, see `Device`.

    Raises oaktwin.Error for an unknown maker or kind, and for an invalid file, FileNotFoundError for a folder that does not exist.
    """

def parameters(
    group: _Group, *, platform: _Platform = "rvc2"
) -> list[_Json]:
    """The parameters of an engine, an imager or the filters, as dictionaries.

    group: "stereo-noise", "stereo-matching", "time-of-flight", "single-view", "imager", "color-imager" or "filters".
    platform: "rvc2" or "rvc4", whose defaults are returned.

    Each dictionary has "name", "table", "type", "default" (a value of that type), "unit", "min", "max", "platform" (if the
    parameter has an effect on one platform only), "source" and "description", and "values" if "type" is "enum".
    """

def presets(platform: Literal["rvc2", "rvc4", "tof"] = "rvc2") -> list[_Preset]:
    """The names of DepthAI's presets for a platform, in DepthAI's order, as `preset` accepts them.

    platform: "rvc2", "rvc4" or "tof" (time of flight).
    """

def _device(
    model: str | None,
    choices: tuple[str, str, tuple[str, str] | None, str | None],
    catalog: str | PathLike[str] | None,
    calibration: tuple[str, str, bool] | None,
) -> Device: ...

def simulate_imu(
    device: Device,
    times: npt.ArrayLike,
    poses: npt.ArrayLike,
    *,
    rate: float | None = None,
    part: str | None = None,
    seed: int | None = 0,
    up: _Up = "z",
) -> _Inertial:
    """Simulates the inertial sensor of a device along a trajectory, as `oaktwin render --imu` does.

    times: (N,) the times of the poses in seconds, increasing; at least two.
    poses: (N, 4, 4) world_from_body: the poses of the device's body, metres; a `CameraPose` is rejected.
    rate: the samples per second; by default 400, or the part's maximum if lower.
    part: the inertial part, such as "BMI270"; by default the device's.
    seed: the noise seed; None for one of fresh entropy.
    up: the vertical axis of the world, "z" or "y".

    Returns a mapping: "timestamp" (M,) int64 nanoseconds, "angular_velocity" (M, 3) float64 rad/s and "linear_acceleration"
    (M, 3) float64 m/s², which is +9.81 upwards at rest; both in the frame of the sensor, `device.extrinsics("imu", "body")`;
    and "seed".

    Warns with oaktwin.FindingWarning. Raises oaktwin.Error for invalid input, and for a device without an inertial sensor.
    """
