from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Literal, TypedDict, TypeVar, final, overload

import numpy as np
import numpy.typing as npt

__all__ = [
    "Camera",
    "DepthSensor",
    "Device",
    "Error",
    "Filter",
    "Finding",
    "FindingWarning",
    "Recording",
    "Rectification",
    "Scene",
    "StereoMatcher",
    "__version__",
    "_camera",
    "_device",
    "_read_from",
    "accuracy",
    "align",
    "look_at",
    "main",
    "models",
]

__version__: Final[str]

_Role = Literal["rgb", "left", "right", "tof"]
_Sensor = Literal["stereo", "tof"]
_Part = Literal["rgb", "left", "right", "tof", "imu", "body"]
_Engine = Literal["stereo-noise", "time-of-flight", "single-view"]
_Isaac = Literal["5.1", "6"]
_Lens = Literal["pinhole", "fisheye"]
_Fill = Literal["footprint", "nearest"]
_Float64 = npt.NDArray[np.float64]
_Out = TypeVar("_Out")
_Image = TypeVar("_Image", np.float32, np.uint16, np.uint8)
_Depth = TypeVar("_Depth", np.float32, np.uint16)

_Grey = npt.NDArray[np.uint8] | npt.NDArray[np.uint16]

class _Matched(TypedDict):
    depth: npt.NDArray[np.float32]
    disparity: npt.NDArray[np.float32]
    confidence: npt.NDArray[np.uint8]
    rectified_left: _Grey
    rectified_right: _Grey
    findings: list[Finding]

class _Pair(TypedDict):
    left: _Grey
    right: _Grey
    rectified_left: _Grey
    rectified_right: _Grey
    z: npt.NDArray[np.float32]

class Error(ValueError): ...
class FindingWarning(UserWarning): ...

@final
class Finding:
    @property
    def code(self) -> str: ...
    @property
    def level(self) -> Literal["note", "warning", "error"]: ...
    @property
    def place(self) -> str: ...
    @property
    def message(self) -> str: ...
    @property
    def remedy(self) -> str: ...

@final
class Camera:
    def __new__(
        cls,
        size: tuple[int, int],
        *,
        K: npt.ArrayLike | None = None,
        hfov_deg: float | None = None,
        distortion: Sequence[float] | _Float64 | None = None,
        lens: Literal["pinhole", "opencv", "fisheye"] | None = None,
        body_from_camera: npt.ArrayLike | None = None,
        near: float = 0.01,
        far: float = 1e7,
        name: str = "camera",
    ) -> Camera: ...
    @property
    def name(self) -> str: ...
    @property
    def K(self) -> _Float64: ...
    @property
    def lens(self) -> str: ...
    @property
    def distortion(self) -> _Float64: ...
    @property
    def size(self) -> tuple[int, int]: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def hfov_deg(self) -> float: ...
    @property
    def vfov_deg(self) -> float: ...
    @property
    def clip(self) -> tuple[float, float]: ...
    @property
    def body_from_camera(self) -> _Float64: ...
    def resized(self, width: int, height: int, *, keep_aspect_ratio: bool = True) -> Camera: ...
    def cropped(self, x: float, y: float, width: int, height: int) -> Camera: ...
    def __reduce__(self) -> tuple[Any, ...]: ...

@final
class Rectification:
    def __new__(
        cls,
        left: Camera,
        right: Camera,
        *,
        intrinsics: Literal["zero-disparity", "free-disparity", "left-camera"] = "zero-disparity",
    ) -> Rectification: ...
    def __getnewargs_ex__(self) -> tuple[tuple[Camera, Camera], dict[str, Any]]: ...
    @property
    def R1(self) -> _Float64: ...
    @property
    def R2(self) -> _Float64: ...
    @property
    def P1(self) -> _Float64: ...
    @property
    def P2(self) -> _Float64: ...
    @property
    def Q(self) -> _Float64: ...
    @property
    def baseline(self) -> float: ...
    def maps(self, camera: Literal["left", "right"]) -> npt.NDArray[np.float32]: ...

@final
class Device:
    def __new__(
        cls, model: str, *, lens: _Lens = "pinhole", catalog: str | PathLike[str] | None = None
    ) -> Device: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    @staticmethod
    def from_calibration(
        path: str | PathLike[str],
        model: str | None = None,
        *,
        force: bool = False,
        lens: _Lens = "pinhole",
        catalog: str | PathLike[str] | None = None,
    ) -> Device: ...
    @property
    def name(self) -> str: ...
    @property
    def origin(self) -> str: ...
    @property
    def findings(self) -> list[Finding]: ...
    @property
    def cameras(self) -> dict[str, Camera]: ...
    def depth_camera(self, sensor: _Sensor | None = None) -> Camera: ...
    @property
    def depth_sensors(self) -> dict[str, dict[str, Any]]: ...
    def extrinsics(self, source: _Part, target: _Part) -> _Float64: ...
    def rectification(
        self, *, intrinsics: Literal["zero-disparity", "free-disparity", "left-camera"] = "zero-disparity"
    ) -> Rectification: ...
    def write_usd(
        self,
        path: str | PathLike[str],
        *,
        isaac: _Isaac = "5.1",
        target: Literal["isaac", "ovrtx"] = "isaac",
        aperture_offsets: Literal["usd", "document", "zero"] = "usd",
        extended_disparity: bool = False,
        legacy_distortion: bool = False,
        rigid_body: bool = False,
        body: bool = True,
        over: str | PathLike[str] | None = None,
    ) -> None: ...
    def to_ros(self) -> dict[str, str]: ...
    def to_opencv(self) -> dict[str, str]: ...
    def to_kalibr(self) -> dict[str, str]: ...
    def to_depthai(self) -> dict[str, str]: ...
    def report(self) -> dict[str, Any]: ...

@final
class DepthSensor:
    def __new__(
        cls,
        device: Device,
        *,
        sensor: _Sensor | None = None,
        engine: _Engine | None = None,
        preset: str | None = None,
        filters: Sequence[str] = (),
        parameters: Mapping[str, object] | None = None,
        seed: int = 0,
        device_seed: int | None = None,
        extended_disparity: bool = False,
        isaac: _Isaac = "5.1",
        fx: float | None = None,
        hfov_deg: float | None = None,
        camera: Camera | None = None,
        name: str | None = None,
    ) -> DepthSensor: ...
    @overload
    def __call__(
        self, depth: npt.NDArray[_Depth], rgb: object | None = None, *, frame: int = 0, out: None = None
    ) -> npt.NDArray[_Depth]: ...
    @overload
    def __call__(
        self, depth: object, rgb: object | None = None, *, frame: int = 0, out: None = None
    ) -> npt.NDArray[Any]: ...
    @overload
    def __call__(self, depth: object, rgb: object | None = None, *, frame: int = 0, out: _Out) -> _Out: ...
    def __getnewargs_ex__(self) -> tuple[tuple[Device], dict[str, Any]]: ...
    def annotate(
        self, depth: object, rgb: object | None = None, *, annotators: Sequence[str], frame: int = 0
    ) -> dict[str, npt.NDArray[Any]]: ...
    def reset(self) -> None: ...
    @overload
    def align(
        self,
        depth: npt.NDArray[_Depth],
        to: _Role = "rgb",
        *,
        size: tuple[int, int] | None = None,
        fill: _Fill = "footprint",
        out: None = None,
    ) -> npt.NDArray[_Depth]: ...
    @overload
    def align(
        self,
        depth: object,
        to: _Role = "rgb",
        *,
        size: tuple[int, int] | None = None,
        fill: _Fill = "footprint",
        out: None = None,
    ) -> npt.NDArray[Any]: ...
    @overload
    def align(
        self,
        depth: object,
        to: _Role = "rgb",
        *,
        size: tuple[int, int] | None = None,
        fill: _Fill = "footprint",
        out: _Out,
    ) -> _Out: ...
    @property
    def engine(self) -> _Engine: ...
    @property
    def parameters(self) -> dict[str, str]: ...
    @property
    def filters(self) -> list[str]: ...
    @property
    def findings(self) -> list[Finding]: ...

@final
class Filter:
    def __new__(cls, *filters: str) -> Filter: ...
    @overload
    def __call__(
        self, image: npt.NDArray[_Image], rgb: object | None = None, *, out: None = None
    ) -> npt.NDArray[_Image]: ...
    @overload
    def __call__(self, image: object, rgb: object | None = None, *, out: None = None) -> npt.NDArray[Any]: ...
    @overload
    def __call__(self, image: object, rgb: object | None = None, *, out: _Out) -> _Out: ...
    def __getnewargs__(self) -> tuple[str, ...]: ...
    def reset(self) -> None: ...

@final
class Scene:
    @staticmethod
    def open(
        path: str | PathLike[str],
        *,
        time: float | None = None,
        subdivide: int = 0,
        up: Literal["y", "z"] | None = None,
        scale: float | None = None,
    ) -> Scene: ...
    @staticmethod
    def from_triangles(
        vertices: object, faces: object, *, up: Literal["y", "z"] = "z", label: str | None = None
    ) -> Scene: ...
    def render(
        self,
        camera: Camera,
        world_from_camera: npt.ArrayLike,
        *,
        annotators: Sequence[str] | None = None,
        backend: Literal["auto", "raster", "ray"] = "auto",
        smooth_edges: bool = True,
    ) -> dict[str, Any]: ...
    def render_pair(
        self,
        device: Device,
        world_from_body: npt.ArrayLike,
        *,
        size: tuple[int, int] | None = None,
        projector: float = 0.0,
        ambient: float = 1.0,
        imager: Mapping[str, object] | None = None,
        seed: int = 0,
        device_seed: int | None = None,
        frame: int = 0,
    ) -> _Pair: ...
    def __reduce__(self) -> tuple[Any, ...]: ...
    @property
    def cameras(self) -> dict[str, tuple[Camera, _Float64]]: ...
    @property
    def findings(self) -> list[Finding]: ...
    @property
    def up(self) -> Literal["y", "z"]: ...
    @property
    def triangle_count(self) -> int: ...
    @property
    def bounds(self) -> list[list[float]] | None: ...

@final
class StereoMatcher:
    def __new__(
        cls,
        device: Device | None = None,
        *,
        raw: bool | None = None,
        rectify: Literal["auto", "homography", "mesh", "full"] | None = None,
        fx: float | None = None,
        hfov_deg: float | None = None,
        baseline: float | None = None,
        platform: Literal["rvc2", "rvc4"] | None = None,
        preset: str | None = None,
        filters: Sequence[str] = (),
        parameters: Mapping[str, object] | None = None,
        extended_disparity: bool = False,
    ) -> StereoMatcher: ...
    def __call__(self, left: object, right: object) -> _Matched: ...
    def __getnewargs_ex__(self) -> tuple[tuple[Device | None], dict[str, Any]]: ...
    def reset(self) -> None: ...
    @property
    def camera(self) -> Camera: ...
    @property
    def baseline(self) -> float: ...
    @property
    def rectify(self) -> Literal["homography", "mesh", "full"] | None: ...
    @property
    def parameters(self) -> dict[str, str]: ...
    @property
    def filters(self) -> list[str]: ...
    @property
    def findings(self) -> list[Finding]: ...

@final
class Recording:
    def __new__(cls, path: str | PathLike[str], *, up: Literal["y", "z"] = "z") -> Recording: ...
    def log(
        self,
        camera: Camera,
        world_from_camera: npt.ArrayLike,
        *,
        time: float | None = None,
        frame: int = 0,
        depth: object | None = None,
        measured: object | None = None,
        rgb: object | None = None,
        points: bool = True,
        name: str | None = None,
    ) -> None: ...
    def close(self) -> None: ...
    @property
    def path(self) -> Path: ...
    def __enter__(self) -> Recording: ...
    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, traceback: TracebackType | None, /
    ) -> None: ...

def annotators() -> dict[str, str]: ...
def models(*, catalog: str | PathLike[str] | None = None) -> list[str]: ...
def look_at(
    eye: Sequence[float] | _Float64,
    target: Sequence[float] | _Float64,
    up: Sequence[float] | _Float64 = (0.0, 0.0, 1.0),
    *,
    frame: Literal["camera", "body"] = "camera",
) -> _Float64: ...
@overload
def align(
    depth: npt.NDArray[_Depth],
    source: Camera,
    target: Camera,
    *,
    target_from_source: npt.ArrayLike | None = None,
    fill: _Fill = "footprint",
    out: None = None,
) -> npt.NDArray[_Depth]: ...
@overload
def align(
    depth: object,
    source: Camera,
    target: Camera,
    *,
    target_from_source: npt.ArrayLike | None = None,
    fill: _Fill = "footprint",
    out: None = None,
) -> npt.NDArray[Any]: ...
@overload
def align(
    depth: object,
    source: Camera,
    target: Camera,
    *,
    target_from_source: npt.ArrayLike | None = None,
    fill: _Fill = "footprint",
    out: _Out,
) -> _Out: ...
def accuracy(
    device: Device,
    *,
    sensor: str | None = None,
    distances: Sequence[float] | str | None = None,
    devices: int | None = None,
    captures: int = ...,
    region: float = ...,
    engine: str | None = None,
    preset: str | None = None,
    filters: Sequence[str] = ...,
    parameters: Mapping[str, object] | None = None,
    seed: int = 0,
    device_seed: int | None = None,
    extended_disparity: bool = False,
    isaac: str = "5.1",
    measured: str | PathLike[str] | None = None,
    measured_from: float = 0.0,
    focal_px: float | None = None,
    width_px: int | None = None,
) -> dict[str, Any]: ...
def main(arguments: Sequence[str]) -> int: ...
def _camera(
    name: str,
    size: tuple[int, int],
    k: Sequence[Sequence[float]],
    lens: str,
    coefficients: Sequence[float],
    clip: tuple[float, float],
    body_from_camera: Sequence[Sequence[float]],
) -> Camera: ...
def _device(
    model: str,
    lens: str,
    catalog: str | PathLike[str] | None,
    calibration: tuple[str, str, bool] | None,
) -> Device: ...
def _read_from(depth: object) -> int: ...
