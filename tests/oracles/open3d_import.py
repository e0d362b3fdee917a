"""Open3D, also where the system has no libusb, which its library wants for cameras that nobody uses here."""

import ctypes
from functools import cache
from types import ModuleType


@cache
def open3d() -> ModuleType:
    """The package; an ImportError says what is missing."""
    import libusb_package

    # Loaded first, it is the libusb that Open3D's library finds.
    ctypes.CDLL(str(libusb_package.get_library_path()), mode=ctypes.RTLD_GLOBAL)
    import open3d

    return open3d
