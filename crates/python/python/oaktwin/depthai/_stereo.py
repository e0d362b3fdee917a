"""The node StereoDepth: matches the images of the stereo pair, or adds a device's errors to exact depth."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import depthai as dai
import numpy as np
import numpy.typing as npt

from .._cameras import Camera as Lens
from .._findings import Error
from .._images import align
from .._sensors import DepthSensor, StereoMatcher
from ._camera import Camera, corner, cover_size, cut
from ._frames import camera_of, depth_frame, grey_frame, grey_of, transformation
from ._library import warn_once
from ._node import VirtualNode, creating_for
from ._stereo_config import Config, Preset, apply_preset, depth_scale, disparity_scale, filters_of, parameters_of

if TYPE_CHECKING:
    from typing_extensions import Self

Socket = dai.CameraBoardSocket
Align = Config.AlgorithmControl.DepthAlign
# The name of the camera of the images to which depth is aligned.
_ALIGNED = "StereoDepth.inputAlignTo"
Metres = npt.NDArray[np.float32]
_RealStereo = dai.node.StereoDepth


@dataclass
class Measured:
    """What an engine returns for one pair; images of `camera` except for the rectified ones."""

    depth: Metres
    disparity: Metres
    confidence: npt.NDArray[np.uint8]
    camera: Lens
    # Depth in metres times disparity in pixels of the matched images.
    focal_baseline: float
    rectified: tuple[Any, Any] | None


class StereoDepth(VirtualNode):
    """DepthAI's StereoDepth."""

    PresetMode = _RealStereo.PresetMode
    Properties = _RealStereo.Properties

    def __init__(self) -> None:
        super().__init__()
        if self.twin.stereo_sockets is None:
            raise Error(f"StereoDepth: {self.twin.device.name} has no stereo pair; choose a model with one, such as OAK-D Pro")
        self.left, self.right = self.image_input("left"), self.image_input("right")
        self.inputAlignTo = self.image_input("inputAlignTo", blocking=False, size=1)
        self.inputConfig = self.message_input("inputConfig", dai.DatatypeEnum.StereoDepthConfig)
        self.depth, self.disparity = self.image_output("depth"), self.image_output("disparity")
        self.confidenceMap = self.image_output("confidenceMap")
        self.syncedLeft, self.syncedRight = self.image_output("syncedLeft"), self.image_output("syncedRight")
        self.rectifiedLeft, self.rectifiedRight = self.image_output("rectifiedLeft"), self.image_output("rectifiedRight")
        self.outConfig = self.message_output("outConfig", dai.DatatypeEnum.StereoDepthConfig)
        self.debugDispLrCheckIt1, self.debugDispLrCheckIt2 = self.image_output("debugDispLrCheckIt1"), self.image_output("debugDispLrCheckIt2")
        self.debugDispCostDump = self.image_output("debugDispCostDump")
        self.initialConfig = Config()
        self._align_to: dai.CameraBoardSocket | None = None
        self._size: tuple[int, int] | None = None
        self._keeps_aspect = True
        self._rectifies = True
        self._rectify: Any = None
        self._aligned: dai.ImgFrame | None = None
        # The calibration that the engine has.
        self._device = self.twin.described

    def build(self, *arguments: Any, **named: Any) -> Self:
        """Links the outputs of two cameras, or creates the cameras."""
        if isinstance(arguments[0] if arguments else None, bool) or "autoCreateCameras" in named:
            forms = ("autoCreateCameras", "presetMode", "size", "fps")
            return self._build_cameras(**{**dict(zip(forms, arguments)), **named})
        names = ("left", "right", "presetMode")
        given = {**dict(zip(names, arguments)), **named}
        given["left"].link(self.left)
        given["right"].link(self.right)
        self.setDefaultProfilePreset(given.get("presetMode", Preset.DEFAULT))
        return self

    def _build_cameras(
        self,
        autoCreateCameras: bool,
        presetMode: dai.node.StereoDepth.PresetMode = Preset.DEFAULT,
        size: tuple[int, int] = (640, 400),
        fps: float | None = None,
    ) -> Self:
        if not autoCreateCameras:
            return self
        pipeline = self.getParentPipeline()
        sockets = self.twin.stereo_sockets or ()
        for socket, port in zip(sockets, (self.left, self.right)):
            with creating_for(self.twin):
                camera = pipeline.create(Camera)
            self._cameras = [*getattr(self, "_cameras", []), camera.build(socket)]
            camera.requestOutput(size, fps=fps).link(port)
        self.setDefaultProfilePreset(presetMode)
        return self

    # Settings.
    def setDefaultProfilePreset(self, presetMode: dai.node.StereoDepth.PresetMode) -> None:
        """Sets the mode and the filters of a preset of the device's platform."""
        apply_preset(self.initialConfig, presetMode, self.twin)

    def setLeftRightCheck(self, enable: bool) -> None:
        """Whether disparities are checked against those of the right image."""
        self.initialConfig.setLeftRightCheck(enable)

    def setSubpixel(self, enable: bool) -> None:
        """Whether disparities have fractions."""
        self.initialConfig.setSubpixel(enable)

    def setSubpixelFractionalBits(self, subpixelFractionalBits: int) -> None:
        """The bits of the fractions, 3 to 5."""
        self.initialConfig.setSubpixelFractionalBits(subpixelFractionalBits)

    def setExtendedDisparity(self, enable: bool) -> None:
        """Whether closer objects are measured, too."""
        self.initialConfig.setExtendedDisparity(enable)

    def setDepthAlign(self, to: Any) -> None:
        """The camera of the depth image: a socket, or one of the rectified cameras."""
        if isinstance(to, Socket):
            self.twin.camera(to)
            self._align_to = to
        else:
            self._align_to = None
            self.initialConfig.setDepthAlign(to)

    def setOutputSize(self, width: int, height: int) -> None:
        """The size of the depth image, px."""
        if width <= 0 or height <= 0:
            raise RuntimeError(f"StereoDepth: the output size {width}x{height} has no pixels")
        self._size = (width, height)

    def setOutputKeepAspectRatio(self, keep: bool) -> None:
        """Whether a depth image of another shape is cropped instead of stretched."""
        self._keeps_aspect = keep

    def setRectification(self, enable: bool) -> None:
        """Whether images are rectified before they are matched."""
        self._rectifies = enable

    def useHomographyRectification(self, enable: bool) -> None:
        """Whether rectification ignores the distortion of the lenses."""
        self._rectify = "homography" if enable else "mesh"

    def enableDistortionCorrection(self, enable: bool) -> None:
        """Whether rectification corrects the distortion of the lenses."""
        self.useHomographyRectification(not enable)

    def _unsupported(self, *_: Any, **__: Any) -> None:
        raise Error("StereoDepth: meshes, scaling, baselines and focal lengths of a program's own are not simulated; leave them out")

    loadMeshData = loadMeshFiles = setAlphaScaling = setBaseline = setFocalLength = _unsupported

    def _ignored(self, *_: Any, **__: Any) -> None:
        warn_once("StereoDepth: settings of the hardware and of the nominal translation have no effect")

    setNumFramesPool = setPostProcessingHardwareResources = setRuntimeModeSwitch = setInputResolution = VirtualNode.ignore
    setMeshStep = setRectifyEdgeFillColor = setFrameSync = VirtualNode.ignore
    setDepthAlignmentUseSpecTranslation = setDisparityToDepthUseSpecTranslation = _ignored
    setRectificationUseSpecTranslation = _ignored

    # Measuring.
    def work(self) -> None:
        """Measures pairs until the pipeline stops."""
        config = self.initialConfig
        engine = self._engine(config)
        wants_align = self.is_linked(self.inputAlignTo)
        checked: set[tuple[int, int]] = set()
        while self.runs():
            left, right = synchronized(self.left, self.right)
            size = left.getWidth(), left.getHeight()
            if self._device is not self.twin.described:
                engine = self._engine(config)
                checked.clear()
            if size not in checked:
                checked.add(size)
                self._check(left, "left")
                self._check(right, "right")
            while (message := self.inputConfig.tryGet()) is not None:
                config = message
                engine = self._engine(config)
            if wants_align:
                is_first = self._aligned is None or self.twin.clock.fast
                self._aligned = self.inputAlignTo.get() if is_first else self.inputAlignTo.tryGet() or self._aligned
            self._pass_on(left, right, config)
            if any(map(self.is_wanted, (self.depth, self.disparity, self.confidenceMap, self.rectifiedLeft, self.rectifiedRight))):
                self._send(engine.measure(left, right), left, right, config)

    def is_linked(self, port: dai.Node.Input) -> bool:
        """Whether an output is linked to an input of this node."""
        links = self.getParentPipeline().getConnections()
        return any(one.inputId == self.id and one.inputName == port.getName() for one in links)

    def _check(self, image: dai.ImgFrame, role: str) -> None:
        """Raises an error for an image that the calibration does not describe, whose depth would be wrong."""
        own = cut(self.twin.described.cameras[role], (image.getWidth(), image.getHeight()))
        described: Any = image.getTransformation()
        if not described.isValid():
            warn_once("StereoDepth: an image has no transformation; it is taken as one of the whole sensor")
        elif np.abs(np.asarray(described.getIntrinsicMatrix()) - own.K).max() > 1e-2:
            raise Error(
                f"StereoDepth: the {role} image of {own.width}x{own.height} is not the middle of the sensor's image; "
                "request outputs without undistortion, with the resize mode CROP"
            )

    def _engine(self, config: Config) -> Matching | FromDepth:
        self._device = self.twin.described
        if self.twin.settings.engine == "stereo-noise":
            return FromDepth(self, config)
        return Matching(self, config)

    def _pass_on(self, left: dai.ImgFrame, right: dai.ImgFrame, config: Config) -> None:
        self.syncedLeft.send(left)
        self.syncedRight.send(right)
        if self.is_wanted(self.outConfig):
            self.outConfig.send(config)

    def _send(self, measured: Measured, left: dai.ImgFrame, right: dai.ImgFrame, config: Config) -> None:
        target = self._target(measured.camera)
        z: Any = "geometric" if self.twin.is_rvc4 else "measured"

        def placed(image: Metres) -> Metres:
            return image if target is None else align(image, measured.camera, target, z=z)

        camera = target or measured.camera
        if self.is_wanted(self.depth):
            values = np.round(placed(measured.depth) * depth_scale(config))
            self._deliver(self.depth, depth_frame(np.clip(values, 0, 65535).astype(np.uint16)), camera, left)
        if self.is_wanted(self.disparity):
            values = np.round(self._placed_disparity(measured, target, z) * disparity_scale(config))
            is_fine = config.algorithmControl.enableSubpixel or config.getMaxDisparity() > 255
            frame = depth_frame(values.astype(np.uint16)) if is_fine else grey_frame(np.clip(values, 0, 255).astype(np.uint8), dai.ImgFrame.Type.RAW8)
            self._deliver(self.disparity, frame, camera, left)
        if self.is_wanted(self.confidenceMap):
            self._deliver(self.confidenceMap, grey_frame(measured.confidence, dai.ImgFrame.Type.RAW8), measured.camera, left)
        if measured.rectified is not None:
            size = left.getWidth(), left.getHeight()
            for output, image, one in zip((self.rectifiedLeft, self.rectifiedRight), measured.rectified, self.rectified_cameras(size)):
                if self.is_wanted(output):
                    self._deliver(output, grey_frame(image), one, left if output is self.rectifiedLeft else right)

    def _placed_disparity(self, measured: Measured, target: Lens | None, z: Any) -> Metres:
        if target is None:
            return measured.disparity
        # A disparity is a depth in another unit: its image is aligned as the depth is.
        depth = align(measured.depth, measured.camera, target, z=z)
        return _disparity(depth, measured.focal_baseline)

    def _deliver(self, output: dai.Node.Output, frame: dai.ImgFrame, camera: Lens, source: dai.ImgFrame) -> None:
        socket, origin = self.twin.origin
        frame.setSourceSize(camera.width, camera.height)
        aligned, number = self._aligned, int(Socket.CAM_B if self._align_to is None else self._align_to)
        if aligned is not None and camera.name == _ALIGNED and camera.size == (aligned.getWidth(), aligned.getHeight()):
            # Nodes compare it with that of the other image to the last digit.
            frame.setTransformation(aligned.getTransformation())
            number = aligned.getInstanceNum()
        else:
            frame.setTransformation(transformation(camera, origin, socket))
        frame.setSequenceNum(source.getSequenceNum())
        frame.setTimestamp(source.getTimestamp())
        frame.setTimestampDevice(source.getTimestampDevice())
        frame.setInstanceNum(number)
        frame.cam = source.cam
        output.send(frame)

    def _target(self, own: Lens) -> Lens | None:
        """The camera to which depth is aligned, or None for its own."""
        if self._aligned is not None:
            camera = camera_of(self._aligned, self.twin.origin[1], _ALIGNED)
        elif self._align_to is not None:
            camera = self.twin.camera(self._align_to)[1]
        else:
            where = self.initialConfig.algorithmControl.depthAlign
            moved = {Align.RECTIFIED_RIGHT: 1.0, Align.CENTER: 0.5}.get(where)
            if moved is None and self._size in (None, own.size):
                return None
            camera = own if moved is None else _shifted(own, moved * self.baseline)
        if self._size is not None and self._size != camera.size:
            camera = camera.resized(*self._size, rule="depthai", keep_aspect_ratio=self._keeps_aspect)
        return camera

    @property
    def needs_images(self) -> bool:
        """Whether it looks at the images that it receives, or passes them on."""
        outputs = self.syncedLeft, self.syncedRight, self.rectifiedLeft, self.rectifiedRight
        return self.twin.settings.engine != "stereo-noise" or any(map(self.is_wanted, outputs))

    @property
    def baseline(self) -> float:
        """The baseline of the rectified pair, metres."""
        return float(self.twin.described.rectification().baseline)

    def rectified_cameras(self, size: tuple[int, int]) -> tuple[Lens, Lens]:
        """The cameras of the rectified images."""
        left = cut(self.twin.described.depth_camera("stereo"), size)
        return left, _shifted(left, self.baseline)


def _shifted(camera: Lens, right_m: float) -> Lens:
    """A camera that is moved to the right in its own frame."""
    pose = np.asarray(camera.body_from_camera).copy()
    pose[:3, 3] += pose[:3, 0] * right_m
    return Lens(camera.size, K=camera.K, body_from_camera=pose, name=camera.name)


def _disparity(depth: Metres, focal_baseline: float) -> Metres:
    return np.where(depth > 0, focal_baseline / np.maximum(depth, 1e-6), 0).astype(np.float32)


def synchronized(left_input: Any, right_input: Any) -> tuple[dai.ImgFrame, dai.ImgFrame]:
    """The next images of two inputs that were taken at the same time; others are dropped."""
    left, right = left_input.get(), right_input.get()
    while (apart := (left.getTimestampDevice() - right.getTimestampDevice()).total_seconds()) and abs(apart) > 1e-3:
        if apart < 0:
            left = left_input.get()
        else:
            right = right_input.get()
    return left, right


class Matching:
    """Matches the images that the node receives."""

    def __init__(self, node: StereoDepth, config: Config) -> None:
        self.node = node
        raw = None if node._rectifies else False
        self.matcher = StereoMatcher(
            node.twin.described,
            raw=raw,
            rectify=node._rectify if raw is not False and node.twin.described.origin != "nominal" else None,
            parameters=parameters_of(config, node.twin.platform),
            filters=filters_of(config),
        )

    def measure(self, left: dai.ImgFrame, right: dai.ImgFrame) -> Measured:
        """Depth, disparity and confidence of a pair. Narrower images are matched as parts of the sensor's, without anything around them."""
        size = left.getWidth(), left.getHeight()
        whole = cover_size(self.node.twin.described.cameras["left"], size)
        found = self.matcher(_framed(grey_of(left), whole), _framed(grey_of(right), whole))
        for finding in found["findings"]:
            warn_once(f"StereoDepth: {finding}")
        rectified = _middle(found["rectified_left"], whole, size), _middle(found["rectified_right"], whole, size)
        values = self.matcher.parameters
        focal_baseline = float(values["focalLength"]) * float(values["baseline"]) * whole[0] / int(values["width"])
        depth, disparity, confidence = (_middle(found[name], whole, size) for name in ("depth", "disparity", "confidence"))
        camera = self.matcher.camera
        if whole != size:
            left_px, top_px = corner(camera.size, depth.shape[::-1])
            camera = camera.cropped(left_px, top_px, *depth.shape[::-1])
        return Measured(depth, disparity, confidence, camera, focal_baseline, rectified)


def _framed(image: Any, whole: tuple[int, int]) -> Any:
    """An image in the middle of one of the whole sensor, whose edges repeat."""
    size = image.shape[1], image.shape[0]
    if size == whole:
        return image
    left, top = corner(whole, size)
    return np.pad(image, ((top, whole[1] - size[1] - top), (left, whole[0] - size[0] - left)), mode="edge")


def _middle(image: Any, whole: tuple[int, int], size: tuple[int, int]) -> Any:
    """The middle of an image of the whole sensor, in the proportions of the images; filters may have made it smaller."""
    if whole == size:
        return image
    width, height = image.shape[1] * size[0] // whole[0], image.shape[0] * size[1] // whole[1]
    left, top = corner((image.shape[1], image.shape[0]), (width, height))
    return np.ascontiguousarray(image[top : top + height, left : left + width])


class FromDepth:
    """Adds the errors of the device to the exact depth at the time of the images."""

    def __init__(self, node: StereoDepth, config: Config) -> None:
        self.node, self.config = node, config
        self._sensors: dict[tuple[int, int], tuple[DepthSensor, Lens]] = {}
        self._rectifier = Matching(node, config) if node.is_wanted(node.rectifiedLeft) or node.is_wanted(node.rectifiedRight) else None

    def measure(self, left: dai.ImgFrame, right: dai.ImgFrame) -> Measured:
        """Depth, and the disparity and confidence that belong to it."""
        size = left.getWidth(), left.getHeight()
        if size not in self._sensors:
            self._sensors[size] = self._sensor(size)
        sensor, camera = self._sensors[size]
        exact = self.node.twin.shots.depth(left.getTimestampDevice().total_seconds(), camera)
        names: Any = ["depth_sensor_distance"]
        rgb = None
        if self.node.is_wanted(self.node.confidenceMap):
            # Confidence follows the texture.
            names.append("depth_sensor_confidence")
            rgb = np.ascontiguousarray(self.node.twin.shots.colour(left.getTimestampDevice().total_seconds(), camera))
        found = sensor.annotate(exact, rgb, annotators=names, frame=left.getSequenceNum())
        depth = found["depth_sensor_distance"]
        own = sensor.camera
        focal_baseline = float(camera.K[0, 0]) * self.node.baseline
        confidence = found["depth_sensor_confidence"] if len(names) > 1 else np.zeros(depth.shape, np.uint16)
        rectified = self._rectifier.measure(left, right).rectified if self._rectifier else None
        return Measured(depth, _disparity(depth, focal_baseline), np.clip(confidence, 0, 255).astype(np.uint8), own, focal_baseline, rectified)

    def _sensor(self, size: tuple[int, int]) -> tuple[DepthSensor, Lens]:
        twin = self.node.twin
        camera = cut(twin.device.depth_camera("stereo"), size)
        extended = bool(self.config.algorithmControl.enableExtended)
        sensor = DepthSensor(
            twin.device,
            sensor="stereo",
            camera=camera,
            engine="stereo-noise",
            filters=filters_of(self.config),
            extended_disparity=extended,
            seed=twin.settings.seed,
        )
        return sensor, camera
