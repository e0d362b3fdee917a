from collections.abc import Mapping, Sequence
from typing import Literal, final, overload

import numpy as np
import numpy.typing as npt

from ._batches import SensorBatch
from ._cameras import Camera
from ._devices import Device
from ._findings import Finding
from ._scenes import Scene
from ._shots import Shot
from ._types import (
    _AlignedZ,
    _Annotated,
    _Array,
    _Callable,
    _Depth,
    _Drift,
    _Engine,
    _Fill,
    _Isaac,
    _Items,
    _Json,
    _Matched,
    _Measured,
    _Out,
    _Parameters,
    _Platform,
    _Preset,
    _Rectify,
    _Role,
    _Seeds,
    _Sensor,
    _SensorAnnotator,
)

__all__ = ["DepthSensor", "StereoMatcher"]

def _drift(sensor: DepthSensor, width: int, height: int) -> list[float] | None: ...

@final
class DepthSensor:
    """The depth sensor of a device: converts exact depth to the depth that the device would measure.

    device: the device.
    sensor: its depth sensor, "stereo", "tof" or a prim; by default time of flight if the device has it.
    fx: the focal length of the images at their width, px; or hfov_deg: their horizontal field of view, degrees. Their
        principal point is then in the centre. By default, images have the model's field of view, whatever their size.
    camera: the Camera of the images, with their size. Its focal length and principal point are used by time of flight,
        points and aligned depth. fx and hfov_deg must agree with it. Images are rectified: a lens with distortion
        causes a finding.
    name: the name of the camera, which distinguishes its noise from other cameras'; by default the sensor's
        prim.
    engine: the error model: "stereo-noise" (an OAK's stereo; the default for stereo), "time-of-flight" (the default for
        time of flight), "single-view" (Isaac Sim's DepthSensorDistance), "stereo-matching", which matches pairs of images
        in `shoot`, `accuracy` and `coverage`, or an engine of one's own: a callable with the parameters `left` and `right`
        (the rectified pair) or `depth`; see the manual.
    preset: the name of a DepthAI preset of the platform: "default", "face", "robotics", ...: sets the mode and the filters.
    filters: the filters as text, in order, such as "spatial:alpha=0.5,delta=20"; they replace the preset's filters.
    parameters: the parameters of the engine, which override all other settings: a mapping by name, as listed by
        `oaktwin.parameters(engine)`, a `Fit`, or the path of a TOML file that `Fit.save` or `oaktwin fit` has written.
    extended_disparity: whether to search disparities up to 190 px instead of 95, for closer objects.
    isaac: the Isaac Sim version that determines the defaults of "single-view", "5.1" or "6".
    seed: the noise seed: equal seeds, names, frames and items give equal noise. None draws one of fresh entropy.
    device_seed: the seed of the unit's calibration error; None disables it.
    drift: the change of the stereo pair since its calibration, such as {"yaw": 0.3, "baseline": 50}: rotations of the right
        camera in mrad (yaw, pitch, roll), the growth of the baseline in µm, of the focal length in ppm, or the warming in K
        (temperature). "stereo-noise" computes the resulting depth errors and lost pixels.

    Raises oaktwin.Error for an unknown or invalid engine, preset, filter or parameter, with the nearest names, and for
    a camera whose field of view contradicts fx or hfov_deg.

    A call, `sensor(depth, rgb=None, *, frame=None, seed=None, device_seed=None, out=None)`, returns the measurement of exact depth:

    depth: one image (H, W), or a batch (N, H, W) of simultaneous images, such as the environments of a simulator, each
        with its own noise; with or without a last dimension of 1. Floating-point metres along the optical axis (float32 is read without
        a copy), or uint16 millimetres. Masked pixels are invalid. Values that are not finite or
        not above 0 are invalid. NumPy arrays, or objects with the buffer protocol, DLPack or NumPy's array interface in
        CPU memory; C-contiguous arrays are read without a copy.
    rgb: the colour images of the same camera, uint8 sRGB, (H, W, 3 or 4) or (N, H, W, 3 or 4), used for the texture in
        the confidence and for the brightness in filters. Three channels are copied.
    frame: the number of the frame in the sequence. Noise differs between frames and is reproducible for each. By default,
        the calls of a sensor without `frame` are numbered from 0 on; copies and pickles continue the numbering.
    seed, device_seed: for a batch, a sequence of N seeds. Item i is measured like the image of a DepthSensor with `seed[i]`,
        or by the unit with `device_seed[i]`. By default all items have the sensor's seeds, and their index distinguishes their
        noise.
    out: the output array: C-contiguous, with the shape of the result, float32 for metres or uint16 for millimetres, not
        overlapping the depth.

    Returns `out`, or a new NumPy array in the unit of the input: metres or millimetres, 0 where invalid. It has the
    shape of the input; smaller if a filter decimates.

    A temporal filter remembers the (H, W) images of earlier calls, and of batches the images of each item, until the image size
    changes; see `reset()`.

    Raises TypeError for an object that is not an array or has another dtype, oaktwin.Error for an invalid shape and for
    a size that differs from the camera's.

    Thread-safe; calls of one sensor with a temporal filter run one after another. Copies and pickles have the settings,
    the device's calibration and the number of the next frame, but not the state of temporal filters.
    """
    def __new__(
        cls,
        device: Device,
        *,
        sensor: _Sensor | str | None = None,
        fx: float | None = None,
        hfov_deg: float | None = None,
        camera: Camera | None = None,
        name: str | None = None,
        # Generated by `cargo xtask schema`: options of DepthSensor.
        engine: _Engine | _Callable | None = None,
        preset: _Preset | None = None,
        filters: Sequence[str] = (),
        parameters: _Parameters | None = None,
        extended_disparity: bool = False,
        isaac: _Isaac | None = None,
        seed: int | None = 0,
        device_seed: int | None = None,
        drift: _Drift | None = None,
        # End of the generated part.
    ) -> DepthSensor: ...
    @overload
    def __call__(
        self,
        depth: npt.NDArray[_Depth],
        rgb: _Array | None = None,
        *,
        frame: int | None = None,
        seed: _Seeds | None = None,
        device_seed: _Seeds | None = None,
        out: None = None,
    ) -> npt.NDArray[_Depth]:
        """Measures a depth image or a batch; see the class."""
    @overload
    def __call__(
        self,
        depth: _Array,
        rgb: _Array | None = None,
        *,
        frame: int | None = None,
        seed: _Seeds | None = None,
        device_seed: _Seeds | None = None,
        out: None = None,
    ) -> _Measured: ...
    @overload
    def __call__(
        self,
        depth: _Array,
        rgb: _Array | None = None,
        *,
        frame: int | None = None,
        seed: _Seeds | None = None,
        device_seed: _Seeds | None = None,
        out: _Out,
    ) -> _Out: ...
    def __getnewargs_ex__(self) -> tuple[tuple[Device], dict[str, object]]: ...
    def __getstate__(self) -> int: ...
    def __setstate__(self, next_frame: int) -> None: ...
    def annotate(
        self, depth: _Array, rgb: _Array | None = None, *, annotators: Sequence[_SensorAnnotator], frame: int | None = None
    ) -> _Annotated:
        """The outputs of Isaac Sim's depth sensor annotators for one image, from one measurement.

        depth: exact depth (H, W), as in a call.
        rgb: the colour image, (H, W, 3 or 4) uint8, as in a call; required for the colours and the imager.
        annotators: the names of Isaac Sim's depth sensor annotators, such as "depth_sensor_distance"; see
            `annotators()`.
        frame: as in a call.

        Returns a dictionary by name. "depth_sensor_distance": (H, W) float32 metres, 0 where invalid, as returned by a
        call. Positions: (H, W, 4) float32 metres in the camera's frame with USD's axes (x right, y up, z backward),
        then 1. Colours: (H, W, 4) uint8. Positions and colours are 0 where invalid. The imager: (H, W) float32, 0 to 1.
        The visualization: (H, W, 4) uint8. Only "single-view" supports the imager and the visualization. "depth_sensor_confidence":
        (H, W) uint16, higher is better. "depth_sensor_reason": (H, W) uint8, 0 where a depth was measured, with the meaning of the
        codes in "depth_sensor_reason_names".

        Raises oaktwin.Error for unknown names, for outputs that the engine does not support, and for a missing colour
        image.
        """
    def shoot(
        self,
        scene: Scene,
        world_from_body: npt.ArrayLike,
        *,
        size: Sequence[int] | None = None,
        projector: float = 0.0,
        ambient: float = 1.0,
        imager: Mapping[str, object] | None = None,
        frame: int | None = None,
    ) -> Shot:
        """Renders a scene with the device at a pose, and measures it: exact depth and colours for engines that measure depth, the device's
        stereo pair for engines that match pairs.

        scene: the scene.
        world_from_body: the pose of the device's body, (4, 4), metres; x forward, y left, z up. See `Scene.look_at` with a device; a
            `CameraPose` is rejected.
        size: (width, height) of the images in px, resized by DepthAI's rule; by default the sensor's own.
        projector: the intensity of a Pro's infrared dot projector, from 0 (default, off) to 1.
        ambient: the scale of the scene's lights; 0 is darkness.
        imager: a mapping of image sensor parameters by name, as in `Scene.render_pair`, for engines that match pairs.
        frame: as in a call.

        Returns a `Shot`, which has its images as attributes and, as a dictionary, by Replicator's names. A temporal filter remembers the
        shots of one size and light.

        Issues an oaktwin.FindingWarning for missing or unsupported contents. Raises oaktwin.Error for an invalid pose, a sensor with
        fx, hfov_deg or camera, which has images of its own, and images that do not fit in memory.
        """
    def batch(
        self,
        count: int,
        *,
        seeds: _Seeds | None = None,
        device_seeds: _Seeds | None = None,
        parameters: Mapping[str, object] | None = None,
        drift: Mapping[str, object] | None = None,
        units: Sequence[Device] | None = None,
    ) -> SensorBatch:
        """The sensors of `count` simultaneous images, such as the environments of a simulator, each with its own unit, parameters and episodes.

        count: the number of items.
        seeds, device_seeds: a seed for each item, as in a call.
        parameters: parameters of the engine that differ between items, by name, such as `{"jitter": array}`: an array with a value for each
            item, or one value for all. They override the parameters of the sensor.
        drift: the same for the change of the stereo pair, such as `{"yaw": array}`.
        units: a `Device` for each item, such as `device.population(count)`: units of one model with their calibrations.

        Returns a `SensorBatch`, which has this sensor's settings, and numbers frames from 0 on.

        Raises oaktwin.Error for sequences of another length, and for values that the sensor would reject, with the number of the item.
        """
    def reset(self, items: _Items | None = None, *, seed: int | None = None) -> None:

        """Starts a new sequence: temporal filters forget earlier images. The numbering of frames continues, so that no noise repeats.

        items: the numbers of the items of batches that start a new sequence, or a mask; the others, and the (H, W) images, go on.
        seed: the new noise seed, with which frames are numbered from 0 on. Equal seeds give equal noise: give each worker process
            its own.
        """
    @property
    def seed(self) -> int:

        """The noise seed; of a sensor with `seed=None`, the one that was drawn."""
    @overload
    def align(
        self,
        depth: npt.NDArray[_Depth],
        to: _Role = "rgb",
        *,
        size: Sequence[int] | None = None,
        z: _AlignedZ | None = None,
        fill: _Fill = "footprint",
        out: None = None,
    ) -> npt.NDArray[_Depth]:
        """Reprojects measured depth to another camera of the device; the nearest measurement in each pixel wins.

        depth: the output of this sensor, (H, W) or (N, H, W), float32 metres or uint16 millimetres.
        to: the camera: "rgb", "left", "right", "tof".
        size: the (width, height) of its image, resized by DepthAI's rule; by default the camera's own.
        z: "geometric": along that camera's axis; "measured": as this sensor measured it; by default as on the device, which
            is "measured" for stereo on RVC2 and otherwise "geometric", where the device's is unknown.
        fill: "footprint" (default) fills all pixels that a sample covers, "nearest" only the one that it falls into.
        out: as in a call.

        Returns metres (or millimetres), 0 where invalid.

        Raises oaktwin.Error for a camera that the device does not have, TypeError for an object that is not an array or
        has another dtype.
        """
    @overload
    def align(
        self,
        depth: _Array,
        to: _Role = "rgb",
        *,
        size: Sequence[int] | None = None,
        z: _AlignedZ | None = None,
        fill: _Fill = "footprint",
        out: None = None,
    ) -> _Measured: ...
    @overload
    def align(
        self,
        depth: _Array,
        to: _Role = "rgb",
        *,
        size: Sequence[int] | None = None,
        z: _AlignedZ | None = None,
        fill: _Fill = "footprint",
        out: _Out,
    ) -> _Out: ...
    @property
    def camera(self) -> Camera:
        """The Camera that the outputs are images of, for the most recent image size: the images' camera, made smaller by a
        filter that decimates, with its pose on the device. Isaac Sim's sensor ("single-view") shows what its left imager
        sees, which is to the left of the images' camera by the baseline.
        """
    @property
    def engine(self) -> str:
        """The name of the engine: "stereo-noise", "stereo-matching", "time-of-flight", "single-view", or the name of an engine written in Python."""
    @property
    def parameters(self) -> dict[str, bool | int | float | str]:
        """The engine's parameters by name, with values of their types, for the most recent image size; none of an engine written in Python."""
    @property
    def filters(self) -> list[str]:
        """The filters, in the format of `filters=`."""
    def latency(self, connection: Literal["usb", "poe"] | None = None) -> _Json | None:
        """The time from the middle of an exposure until its depth is at the host, with its stages and their sources; see `Stream`. None
        where no source states it. connection: "usb" or "poe"; by default the device's.
        """
    @property
    def findings(self) -> list[Finding]:
        """Findings about the settings, for the most recent image size, and about the images measured so far: "depth-unit" (metres
        that look like millimetres, or the reverse), "nothing-measured" (an image all of whose pixels were lost),
        "field-of-view-unit" (degrees that look like radians). Those about images are also shown once as an
        oaktwin.FindingWarning.
        """

@final
class StereoMatcher:
    """The stereo matcher of an OAK: a left and a right image in, depth out. Equivalent to `oaktwin stereo` for files.

    device: the device that took the images, or None for another maker's rectified pair, with fx (or hfov_deg) and baseline.
    sensor: the depth sensor whose pair took the images, by prim, such as "Camera_pseudo_depth_50mm" of the OAK-D LR; by default
        the device's first pair.
    raw: whether the images are unrectified and have to be rectified first, as on the device; by default True for a
        calibrated device and for a fisheye lens.
    rectify: the rectification method for raw images: "homography" (ignores lens distortion), "mesh" (a position every 16
        pixels), "full" (a position for every pixel), "auto" (homography up to a field of view of 85 degrees, mesh above);
        by default the device's.
    fx: the focal length of the rectified images, px.
    hfov_deg: alternatively their horizontal field of view, degrees.
    baseline: the distance between the cameras, metres.
    platform: the platform that determines defaults and presets, "rvc2" or "rvc4"; by default the device's, otherwise "rvc2".
    engine: a callable that matches the rectified pairs instead, as for `DepthSensor`; by default "stereo-matching".
    preset: the name of a DepthAI preset of the platform: "default", "face", "robotics", ...: sets the mode and the filters.
    filters: the filters as text, in order, such as "spatial:alpha=0.5,delta=20"; they replace the preset's filters.
    parameters: the parameters of the engine, which override all other settings: a mapping by name, as listed by
        `oaktwin.parameters(engine)`, a `Fit`, or the path of a TOML file that `Fit.save` or `oaktwin fit` has written.
    extended_disparity: whether to search disparities up to 190 px instead of 95, for closer objects.

    Raises oaktwin.Error for a device without a stereo pair or without calibrated extrinsics of the pair, and for an unknown
    or invalid preset, filter or parameter, with the nearest names.

    A call, `matcher(left, right)`, matches a pair, or a batch of pairs of the same size:

    left, right: (H, W) or (N, H, W) uint8, or uint16 with 10 bits (0 to 1023), or colours (H, W, 3 or 4) or (N, H, W, 3 or 4)
        uint8, which are converted to luma. NumPy arrays, or objects with the buffer protocol, DLPack or NumPy's array
        interface in CPU memory.

    Returns a dictionary. "depth": (H, W) float32 metres along the optical axis of the rectified left camera, 0 where invalid.
    "disparity": (H, W) float32 px of the images, 0 where invalid. "confidence": (H, W) uint8, 255 is the highest. These three
    are images of `camera`, and smaller than the images if a filter decimates. "rectified_left" and "rectified_right": the matched images. "findings": the problems of the images, a list of
    Finding: "pair-swapped", "vertical-offset", "no-texture", "saturated", "range-beyond-image", "same-image", "unrelated".
    For a batch, each array has a leading dimension N, and a finding's place begins with the index of its pair; the pairs are
    matched in parallel.

    Raises TypeError for an object that is not an array or has another dtype, oaktwin.Error for an invalid shape and for
    images of different sizes or dtypes.

    A temporal filter remembers the pairs of earlier calls, and of batches the pairs of each item, until the image size changes;
    see `reset()`. Thread-safe; calls of one matcher run one after another. Copies and pickles have the settings and the device's
    calibration, but not the state of temporal filters.
    """
    def __new__(
        cls,
        device: Device | None = None,
        *,
        sensor: str | None = None,
        raw: bool | None = None,
        rectify: _Rectify | None = None,
        fx: float | None = None,
        hfov_deg: float | None = None,
        baseline: float | None = None,
        platform: _Platform | None = None,
        engine: _Callable | None = None,
        # Generated by `cargo xtask schema`: options of StereoMatcher.
        preset: _Preset | None = None,
        filters: Sequence[str] = (),
        parameters: _Parameters | None = None,
        extended_disparity: bool = False,
        # End of the generated part.
    ) -> StereoMatcher: ...
    def __call__(self, left: _Array, right: _Array) -> _Matched:
        """Matches a pair or a batch of pairs; see the class."""
    def __getnewargs_ex__(self) -> tuple[tuple[Device | None], dict[str, object]]: ...
    def reset(self, items: _Items | None = None) -> None:
        """Starts a new sequence: temporal filters forget earlier pairs.

        items: the numbers of the items of batches that start a new sequence, or a mask; the others, and the (H, W) pairs, go on.
        """
    @property
    def camera(self) -> Camera:
        """The camera that depth, disparity and confidence are images of, for the most recent image size; initially for the
        device's own size, or 1280 x 800 without a device. It is the rectified left camera, whose image is made smaller by a
        filter that decimates.
        """
    @property
    def baseline(self) -> float:
        """The distance between the cameras, metres."""
    @property
    def rectify(self) -> Literal["homography", "mesh", "full"] | None:
        """The rectification method, "homography", "mesh" or "full"; None if the images are rectified already."""
    @property
    def parameters(self) -> dict[str, bool | int | float | str]:
        """The matcher's parameters by name, with values of their types, for the most recent image size."""
    @property
    def filters(self) -> list[str]:
        """The filters, in the format of `filters=`."""
    @property
    def findings(self) -> list[Finding]:
        """Findings about the settings. Findings about images are returned by the call."""
