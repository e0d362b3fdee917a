"""Virtual OAK devices: programs for DepthAI v3 run without a camera.

>>> import depthai as dai, oaktwin.depthai
>>> with oaktwin.depthai.virtual_device("OAK4-D", scene="room.usd", look_at=(0, 0, 1.1, 1, 0, 1)):
...     with dai.Pipeline() as pipeline:
...         camera = pipeline.create(dai.node.Camera).build()
...         queue = camera.requestOutput((640, 400)).createOutputQueue()
...         pipeline.start()
...         image = queue.get().getCvFrame()

Within the context, `dai.Device`, `dai.Pipeline` and the nodes of the device see a scene through a twin. Queues, links, messages and
the nodes that DepthAI runs on the host are DepthAI's own.
"""

from ._library import TESTED, check_version

check_version()

from ._mujoco import from_mujoco  # noqa: E402
from ._recording import record  # noqa: E402
from ._virtual import VirtualDevice, virtual_device  # noqa: E402
from ._world import World  # noqa: E402

__all__ = ["TESTED", "VirtualDevice", "World", "from_mujoco", "record", "virtual_device"]
