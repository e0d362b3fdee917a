"""Digital twins of Luxonis OAK depth cameras.

>>> import numpy as np, oaktwin
>>> device = oaktwin.Device("OAK4-D")
>>> sensor = oaktwin.DepthSensor(device, seed=7)
>>> measured = sensor(np.full((800, 1280), 2.0, np.float32))  # ground-truth depth in, measured depth out

Depth is metres along the optical axis (float32) or integer millimetres (uint16). In ground-truth depth, values that are not
finite and above 0 mean that there is no surface; in measured depth, 0 is invalid. A camera's frame is OpenCV's (x right, y
down, z forward), a device's body frame is x forward, y left, z up; matrices are 4x4, named target_from_source, for column
vectors.

Invalid input raises `Error`, a ValueError, with the same text as the program: the place, the problem, the remedy. Files that
cannot be read or written raise OSError. The interpreter is released while images are processed, Ctrl-C is handled between
images, and all objects are thread-safe. Builds of Python without the GIL are not supported.
"""

from . import filters
from ._accuracy import Accuracy, accuracy
from ._batches import SensorBatch
from ._cameras import Camera, Rectification, look_at
from ._coverage import Coverage, coverage
from ._datasets import Recipe, Sample, generate
from ._devices import Device, models, parameters, presets, simulate_imu
from ._findings import Error, Finding, FindingWarning
from ._fit import Fit, fit
from ._images import Filter, align
from ._oaktwin import __version__, fit_latency, set_memory_limit
from ._poses import BodyPose, CameraPose
from ._rigs import Rig
from ._scenes import Mesh, Recording, Scene, annotators
from ._sensors import DepthSensor, StereoMatcher
from ._shots import Shot
from ._stream import Observation, Stream
from ._worlds import Worlds

__all__ = [
    "Accuracy",
    "BodyPose",
    "Camera",
    "CameraPose",
    "Coverage",
    "DepthSensor",
    "Device",
    "Error",
    "Filter",
    "Finding",
    "FindingWarning",
    "Fit",
    "Mesh",
    "Observation",
    "Recipe",
    "Recording",
    "Rectification",
    "Rig",
    "Sample",
    "Scene",
    "SensorBatch",
    "Shot",
    "StereoMatcher",
    "Stream",
    "Worlds",
    "__version__",
    "accuracy",
    "align",
    "annotators",
    "coverage",
    "filters",
    "fit",
    "fit_latency",
    "generate",
    "look_at",
    "models",
    "parameters",
    "presets",
    "set_memory_limit",
    "simulate_imu",
]
