"""A simulated Luxonis OAK as a camera of LeRobot, which finds it by the name of this package: the type "oaktwin"."""

from .config_oaktwin import OaktwinCameraConfig
from .oaktwin import OaktwinCamera

__all__ = ["OaktwinCamera", "OaktwinCameraConfig"]
