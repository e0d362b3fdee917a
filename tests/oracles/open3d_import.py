"""Imports Open3D, also on systems without libusb, which its library needs for cameras."""

import ctypes
from functools import cache
from types import ModuleType


@cache
def open3d() -> ModuleType:
    """Returns the package, or raises an ImportError that names what is missing."""
    try:
        import libusb_package
    except ImportError:
        # The system may have one.
        pass
    else:
        # Loaded first, so that Open3D's library finds this libusb.
        ctypes.CDLL(str(libusb_package.get_library_path()), mode=ctypes.RTLD_GLOBAL)
    import open3d

    return open3d
