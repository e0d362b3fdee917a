"""Digital twins of Luxonis OAK depth cameras.

>>> import numpy as np, oaktwin
>>> device = oaktwin.Device("OAK4-D")
>>> sensor = oaktwin.DepthSensor(device, seed=7)
>>> measured = sensor(np.full((800, 1280), 2.0, np.float32))  # exact depth in, measured depth out

Depth is metres along the optical axis (float32) or whole millimetres (uint16). In exact depth what is not finite and above
0 is no surface; in measured depth 0 was not measured. A camera's frame is OpenCV's (x right, y down, z forward), a device's
body is x forward, y left, z up; matrices are 4x4, named target_from_source, for column vectors.

What cannot be raises `Error`, a ValueError, with the program's own text: where, what is wrong, what to do. Files that
cannot be read or written raise OSError. The interpreter is released while pixels are worked on, Ctrl-C is looked for
between images, and every object may be used from many threads. Builds of Python without the GIL are not supported.
"""

from . import filters
from ._accuracy import Accuracy, accuracy
from ._oaktwin import (
    Camera,
    DepthSensor,
    Device,
    Error,
    Filter,
    Finding,
    FindingWarning,
    Recording,
    Rectification,
    Scene,
    StereoMatcher,
    __version__,
    align,
    annotators,
    look_at,
    models,
)

__all__ = [
    "Accuracy",
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
    "accuracy",
    "align",
    "annotators",
    "filters",
    "look_at",
    "models",
]
