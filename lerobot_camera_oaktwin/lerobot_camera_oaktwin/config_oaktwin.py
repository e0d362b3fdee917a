from dataclasses import dataclass, field
from typing import Any

from lerobot.cameras import CameraConfig


@CameraConfig.register_subclass("oaktwin")
@dataclass(kw_only=True)
class OaktwinCameraConfig(CameraConfig):
    """An OAK in a scene.

    scene: the path of the scene: USD, glTF, OBJ, STL or PLY.
    model: the model, such as "OAK-D Lite".
    eye, target: the position of the device and the point that it faces, metres.
    fps: the rate of frames.
    width, height: the size of the images; by default the model's.
    use_depth: whether `read_depth` is needed.
    seed: the seed of the noise.
    sensor: other arguments of `oaktwin.DepthSensor`, such as {"preset": "robotics"}.
    """

    scene: str
    model: str = "OAK-D Lite"
    eye: list[float] = field(default_factory=lambda: [1.0, 0.0, 0.5])
    target: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    fps: int | None = 30
    use_depth: bool = True
    seed: int = 0
    sensor: dict[str, Any] = field(default_factory=dict)
