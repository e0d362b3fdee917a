from collections.abc import Sequence
from typing import Any, Literal, final, overload

import numpy as np
import numpy.typing as npt

from ._poses import BodyPose, CameraPose, Mount
from ._types import _Float64, _Intrinsics, _LensModel

__all__ = ["Camera", "Rectification", "look_at"]

@final
class Camera:
    """A camera: intrinsics, lens, and its pose on a device.

    Its frame is OpenCV's: x right, y down, z forward; metres. Pixel coordinates are OpenCV's: the centre of the first
    pixel is (0, 0), so the centre of the image is ((width - 1) / 2, (height - 1) / 2).

    size, height: (width, height) of the image, px, or two numbers.
    K: camera matrix (3, 3), px; or give hfov_deg or vfov_deg.
    hfov_deg: horizontal field of view of an ideal centred camera, degrees between 0 and 180.
    vfov_deg: the vertical one instead, such as the `fovy` of MuJoCo.
    distortion: OpenCV's coefficients, up to 14 of the lens "opencv" (k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 tx ty), up to 4 of
        "fisheye"; none by default.
    lens: "pinhole", "opencv" or "fisheye"; by default "opencv" if distortion is given, otherwise "pinhole".
    body_from_camera: (4, 4), the camera's pose on its device; by default the identity.
    near, far: the clipping range, metres.
    name: the name in messages.

    Raises oaktwin.Error for an image without pixels, an invalid K or field of view, and too many coefficients.
    """
    def __new__(
        cls,
        size: Sequence[int] | int,
        height: int | None = None,
        *,
        K: npt.ArrayLike | None = None,
        hfov_deg: float | None = None,
        vfov_deg: float | None = None,
        distortion: Sequence[float] | _Float64 | None = None,
        lens: _LensModel | None = None,
        body_from_camera: npt.ArrayLike | None = None,
        near: float = 0.01,
        far: float = 1e7,
        name: str = "camera",
    ) -> Camera: ...
    @property
    def name(self) -> str:
        """The name in messages: the role on its device."""
    @property
    def K(self) -> _Float64:
        """Camera matrix (3, 3), px: [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]."""
    @property
    def lens(self) -> str:
        """The lens model: "pinhole", "opencv" or "fisheye"; "f-theta" for cameras of scenes."""
    @property
    def distortion(self) -> _Float64:
        """The lens coefficients in OpenCV's order: (14,) for "opencv", (4,) for "fisheye", (0,) for "pinhole"."""
    @property
    def size(self) -> tuple[int, int]:
        """(width, height) of the image, px."""
    @property
    def width(self) -> int:
        """The width of the image, px."""
    @property
    def height(self) -> int:
        """The height of the image, px."""
    @property
    def hfov_deg(self) -> float:
        """Horizontal field of view through the principal point, degrees: the lens's for a fisheye, otherwise
        the pinhole's.
        """
    @property
    def vfov_deg(self) -> float:
        """Vertical field of view, likewise."""
    @property
    def clip(self) -> tuple[float, float]:
        """The clipping range (near, far), metres."""
    @property
    def body_from_camera(self) -> Mount:
        """(4, 4): the transform from the camera's frame (x right, y down, z forward) to the device's body (x forward, y left, z up, its origin
        midway between left and right), metres.
        """
    def resized(
        self, width: int | Sequence[int], height: int | None = None, *, keep_aspect_ratio: bool = True, rule: Literal["center", "depthai"] = "center"
    ) -> Camera:
        """Returns the camera at another image size.

        width, height: px, or the pair (width, height).
        keep_aspect_ratio: whether to scale the image to cover the size and crop it; otherwise each axis is scaled separately.
        rule: "center" (default): a principal point in the centre stays there, as in simulators and for images resized by cv2.resize.
            "depthai": as DepthAI computes it, without regard to the half pixel between the border and the first pixel's centre.

        Raises oaktwin.Error for an image without pixels.
        """
    def project(
        self, points: npt.ArrayLike, world_from_camera: npt.ArrayLike | None = None
    ) -> tuple[_Float64, _Float64]:
        """Projects points to pixels, with the lens's distortion.

        points: (..., 3), metres, in the camera's frame, or in the world if world_from_camera is given.
        world_from_camera: (4, 4), the camera's pose.

        Returns (pixels, depth): (..., 2) float64 px, which may be outside the image, NaN behind the camera and outside the lens's
        field of view; and (...) float64 metres along the optical axis, negative behind the camera.

        Raises oaktwin.Error for other shapes.
        """
    def unproject(
        self, depth: object, world_from_camera: npt.ArrayLike | None = None
    ) -> npt.NDArray[np.float32]:
        """Converts depth images to points.

        depth: (H, W), or a batch (N, H, W), of this camera's size: float32 metres along the optical axis, or uint16 millimetres.
        world_from_camera: (4, 4), the camera's pose, or (N, 4, 4) for a batch; by default the points are in the camera's frame.

        Returns the point of each pixel, (..., H, W, 3) float32 metres; NaN where the depth is invalid.

        Raises oaktwin.Error for images of another size.
        """
    def rays(self) -> npt.NDArray[np.float32]:
        """Returns the unit direction in which each pixel's centre sees, (H, W, 3) float32 in the camera's frame; NaN outside the
        lens's field of view.
        """
    def undistortion_maps(self, target: Camera | None = None) -> npt.NDArray[np.float32]:
        """The position in this camera's image of each pixel of an undistorted image, (x, y) in px, (H, W, 2) float32, for
        `cv2.remap(image, maps, None, cv2.INTER_LINEAR)`.

        target: the camera of the undistorted image, a pinhole, whose size and K are used; by default this camera's.

        Positions may lie outside the image; they are NaN outside the lens's field of view. Raises oaktwin.Error for a target with
        distortion.
        """
    def cropped(self, x: float, y: float, width: int | Sequence[int], height: int | None = None) -> Camera:
        """Returns the camera of a part of the image: width x height pixels, or the pair of both, with the upper left corner (x, y).

        Raises oaktwin.Error for an image without pixels, and for a part that is not within the image.
        """
    @staticmethod
    def from_ros(info: object) -> Camera:

        """Returns the camera of ROS's calibration, a pinhole or with a lens.

        info: a sensor_msgs/CameraInfo, or a mapping with its fields: "width", "height", "distortion_model", "d" and "k".
        """
    def to_ros(self) -> dict[str, Any]:

        """The fields of a sensor_msgs/CameraInfo: `CameraInfo(**camera.to_ros())`.

        Raises oaktwin.Error for a lens that ROS does not have.
        """
    @staticmethod
    def from_isaac(cfg: object, *, size: Sequence[int] | None = None) -> Camera:
        """Returns the camera of a configuration of Isaac Lab: a CameraCfg, a TiledCameraCfg or a RayCasterCameraCfg, whose principal point is
        in the centre.

        cfg: the configuration, or a PinholeCameraCfg or PinholePatternCfg with `size`.
        size: (width, height) of the images; by default the configuration's.
        """
    @staticmethod
    def from_open3d(intrinsic: object) -> Camera:

        """Returns the camera of an intrinsic of Open3D, an open3d.camera.PinholeCameraIntrinsic."""
    def to_open3d(self) -> dict[str, Any]:

        """The arguments of Open3D's camera: `open3d.camera.PinholeCameraIntrinsic(**camera.to_open3d())`.

        Raises oaktwin.Error for a camera that is not a pinhole.
        """
    @staticmethod
    def from_mujoco(model: object, name: str | int, *, size: Sequence[int] | None = None) -> Camera:

        """Returns a camera of a MuJoCo model, version 3.6 or newer.

        model: the mujoco.MjModel.
        name: the name of the camera, or its number.
        size: (width, height) of its images, px; by default its resolution.

        MuJoCo's camera frame is OpenGL's: the pose of its camera is `CameraPose.of(matrix, "mujoco")`.
        """
    def to_mujoco(self) -> dict[str, Any]:

        """The intrinsics as arguments of MuJoCo's `MjSpec`: `body.add_camera(name="left", **camera.to_mujoco())`.

        Raises oaktwin.Error for a camera that is not a pinhole.
        """
    def _repr_html_(self) -> str: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __reduce__(self) -> tuple[object, ...]: ...

@final
class Rectification:
    """The rectification of a stereo pair: the matrices of cv2.stereoRectify, and the maps for cv2.remap.

    left, right: the cameras, with their poses on the device. `Device.rectification` returns a device's.
    intrinsics: the intrinsics of the rectified images: "zero-disparity" (default, OpenCV's default), "free-disparity" (OpenCV without
        CALIB_ZERO_DISPARITY), "left-camera" (DepthAI's host and RVC4), "right-camera" (RVC2).

    Raises oaktwin.Error if the cameras cannot be rectified.
    """
    def __new__(
        cls,
        left: Camera,
        right: Camera,
        *,
        intrinsics: _Intrinsics = "zero-disparity",
    ) -> Rectification: ...
    def __getnewargs_ex__(self) -> tuple[tuple[Camera, Camera], dict[str, object]]: ...
    @property
    def R1(self) -> _Float64:
        """The rotation from the left camera's frame to the rectified left frame, (3, 3)."""
    @property
    def R2(self) -> _Float64:
        """The rotation from the right camera's frame to the rectified right frame, (3, 3)."""
    @property
    def P1(self) -> _Float64:
        """The projection from the rectified left frame, metres, to pixels of the rectified left image, (3, 4)."""
    @property
    def P2(self) -> _Float64:
        """The projection from the rectified left frame, metres, to pixels of the rectified right image, (3, 4)."""
    @property
    def Q(self) -> _Float64:
        """The matrix from (x, y, disparity, 1) in pixels to homogeneous points in the rectified left frame, metres, (4, 4)."""
    @property
    def baseline(self) -> float:
        """The baseline in metres."""
    def maps(self, camera: Literal["left", "right"]) -> npt.NDArray[np.float32]:
        """The position in a camera's image of each pixel of its rectified image, (x, y) in px, (H, W, 2) float32, for
        `cv2.remap(image, maps, None, cv2.INTER_LINEAR)`.

        camera: "left" or "right".

        Positions may lie outside the image; they are NaN outside the lens's field of view. Raises oaktwin.Error for any other
        camera name.
        """

@overload
def look_at(
    eye: Sequence[float] | _Float64,
    target: Sequence[float] | _Float64,
    up: Sequence[float] | _Float64 = (0.0, 0.0, 1.0),
    *,
    frame: Literal["camera"] = "camera",
) -> CameraPose:
    """Returns the pose at a position in the world that faces a target: a (4, 4) float64 matrix, world_from_camera, metres.
    `Scene.look_at` knows the up axis of its world.

    eye: the position (3 values), metres in the world.
    target: the position to face (3 values), metres in the world.
    up: the direction in the world (3 values) that points up in the image; any length.
    frame: "camera" (default) for a camera's axes, OpenCV's (x right, y down, z forward), a `CameraPose`; "body" for a device's
        (x forward, y left, z up), a `BodyPose`. The pose of a device's camera is `look_at(..., frame="body") @ camera.body_from_camera`.

    Raises oaktwin.Error if eye and target are equal, or if the view direction is parallel to up.
    """

@overload
def look_at(
    eye: Sequence[float] | _Float64,
    target: Sequence[float] | _Float64,
    up: Sequence[float] | _Float64 = (0.0, 0.0, 1.0),
    *,
    frame: Literal["body"],
) -> BodyPose: ...
def _camera(
    name: str,
    size: tuple[int, int],
    k: Sequence[Sequence[float]],
    lens: str,
    coefficients: Sequence[float],
    clip: tuple[float, float],
    body_from_camera: Sequence[Sequence[float]],
) -> Camera: ...
