"""Shots: what the depth sensor of a device measures of a scene."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._html import table
from ._plot import new_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._cameras import Camera
    from ._findings import Finding
    from ._poses import CameraPose

    _Codes = np.ndarray[Any, np.dtype[np.uint8]]
    _Layers = dict[str, Any]
else:
    _Codes, _Layers = np.ndarray, dict


class Reasons(_Codes):
    """Why pixels have no depth: (H, W) uint8, 0 where a depth was measured.

    legend: the meaning of the codes, a dictionary from code to name.
    """

    legend: dict[int, str]

    def __array_finalize__(self, source: Any) -> None:
        self.legend = getattr(source, "legend", {})

    def __reduce__(self) -> tuple[Any, ...]:
        reduced: Any = super().__reduce__()
        make, arguments, state = reduced
        return _with_legend, (make, arguments, state, self.legend)


def _with_legend(make: Any, arguments: Any, state: Any, legend: dict[int, str]) -> Reasons:
    reasons: Reasons = make(*arguments)
    reasons.__setstate__(state)
    reasons.legend = legend
    return reasons


class Shot(_Layers):
    """What a camera made of a scene, from `DepthSensor.shoot` or `Rig.shoot`: a dictionary of arrays by the names of Replicator's annotators,
    such as `shot["distance_to_image_plane"]`, with shorter names for the same arrays.

    layers: the arrays by name.
    camera: the Camera that depth, reasons and confidence are images of.
    image_camera: the Camera that rgb and exact depth are images of. Both are the same, unless the engine matches pairs and rectifies
        them, a filter decimates, or the engine is "single-view".
    world_from_camera: the pose of `camera`, (4, 4), metres; its axes are OpenCV's.
    frame, seed: the number of the frame and the seed, which give the same noise again.
    findings: the problems of the scene and the images.
    """

    def __init__(
        self,
        layers: dict[str, Any],
        *,
        camera: Camera,
        image_camera: Camera,
        world_from_camera: CameraPose,
        frame: int,
        seed: int,
        findings: list[Finding],
    ) -> None:
        super().__init__(layers)
        self.camera = camera
        self.image_camera = image_camera
        self.world_from_camera = world_from_camera
        self.frame = frame
        self.seed = seed
        self.findings = findings

    def _layer(self, name: str, attribute: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"shot: has no {attribute}, which its engine does not make; it has {', '.join(self)}") from None

    @property
    def depth(self) -> npt.NDArray[np.float32]:
        """The measured depth, "depth_sensor_distance": (H, W) float32 metres along the optical axis, 0 where invalid."""
        depth: npt.NDArray[np.float32] = self._layer("depth_sensor_distance", "depth")
        return depth

    @property
    def exact_depth(self) -> npt.NDArray[np.float32]:
        """The ground truth, "distance_to_image_plane": (H, W) float32 metres along the optical axis, inf for a miss."""
        depth: npt.NDArray[np.float32] = self._layer("distance_to_image_plane", "exact depth")
        return depth

    @property
    def rgb(self) -> npt.NDArray[np.uint8]:
        """The colour image, "rgb": (H, W, 4) uint8 sRGB, with coverage as its fourth channel."""
        rgb: npt.NDArray[np.uint8] = self._layer("rgb", "rgb")
        return rgb

    @property
    def confidence(self) -> npt.NDArray[np.uint16]:
        """The confidence, "depth_sensor_confidence": (H, W) uint16, higher is better. Some engines have none."""
        confidence: npt.NDArray[np.uint16] = self._layer("depth_sensor_confidence", "confidence")
        return confidence

    @property
    def reasons(self) -> Reasons:
        """Why pixels have no depth, "depth_sensor_reason": (H, W) uint8, 0 where a depth was measured, with the meaning of the codes in
        its `legend`. Some engines have none."""
        reasons: Reasons = self._layer("depth_sensor_reason", "reasons").view(Reasons)
        reasons.legend = self["depth_sensor_reason_names"]
        return reasons

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plots the measured depth and returns the axes; invalid pixels are blank.

        ax: the Matplotlib axes; by default a new figure's.

        Raises ImportError without Matplotlib: `pip install oaktwin[plot]`.
        """
        ax = new_axes() if ax is None else ax
        depth = np.where(self.depth > 0, self.depth, np.nan)
        near, far = np.nanpercentile(depth, (1, 99)) if np.isfinite(depth).any() else (0.0, 1.0)
        drawn = ax.imshow(depth, cmap="turbo", vmin=near, vmax=far, interpolation="nearest")
        ax.figure.colorbar(drawn, ax=ax, label="m")
        ax.set_title(f"frame {self.frame}, {np.mean(self.depth > 0):.1%} of the pixels measured")
        return ax

    def __repr__(self) -> str:
        width, height = self.camera.size
        return f"<oaktwin.Shot {width}x{height}, {self._summary()}: {', '.join(self)}>"

    def _summary(self) -> str:
        if "depth_sensor_distance" not in self:
            return f"frame {self.frame}"
        return f"frame {self.frame}, {np.mean(self.depth > 0):.1%} measured"

    def _repr_html_(self) -> str:
        rows = [(name, str(one.dtype), str(one.shape)) for name, one in self.items() if isinstance(one, np.ndarray)]
        return table(("array", "dtype", "shape"), rows, self._summary())
