"""The base of all nodes that stand in for nodes of the device."""

from __future__ import annotations

import threading
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import depthai as dai

from .._findings import Error

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ._twin import Twin

_creating = threading.local()
IMAGES = [dai.Node.DatatypeHierarchy(dai.DatatypeEnum.ImgFrame, False)]
Closed: Any = dai.MessageQueue.QueueException


@contextmanager
def creating_for(twin: Twin) -> Iterator[None]:
    """Nodes that are created in this context belong to a virtual device."""
    before = getattr(_creating, "twin", None)
    _creating.twin = twin
    try:
        yield
    finally:
        _creating.twin = before


class VirtualNode(dai.node.ThreadedHostNode):
    """A node that runs on the host. An exception in `work` stops the pipeline and is reported, and does not end the process."""

    def __init__(self) -> None:
        super().__init__()
        twin = getattr(_creating, "twin", None)
        if twin is None:
            raise Error(f"{type(self).__name__}: it is created outside a pipeline; use pipeline.create(dai.node.{type(self).__name__})")
        self.twin: Twin = twin
        # Whether its work is done, before the pipeline has stopped.
        self.has_ended = False
        # The names of the outputs whose messages a program reads.
        self.queued_outputs: set[str] = set()

    def is_wanted(self, output: dai.Node.Output) -> bool:
        """Whether anything receives the messages of an output of this node."""
        name = output.getName()
        links = self.getParentPipeline().getConnections()
        return name in self.queued_outputs or any(one.outputId == self.id and one.outputName == name for one in links)

    def image_input(self, name: str, *, blocking: bool = True, size: int = 4) -> Any:
        """An input for images, like the device node's."""
        return self.createInput(name=name, blocking=blocking or self.twin.clock.fast, queueSize=size, types=IMAGES)

    def message_input(self, name: str, kind: dai.DatatypeEnum) -> Any:
        """An input for configurations, which are read without waiting."""
        return self.createInput(name=name, blocking=False, queueSize=4, types=[dai.Node.DatatypeHierarchy(kind, False)])

    def image_output(self, name: str) -> dai.Node.Output:
        """An output of images."""
        return self.createOutput(name=name, possibleDatatypes=IMAGES)

    def message_output(self, name: str, kind: dai.DatatypeEnum) -> dai.Node.Output:
        """An output of messages of another kind."""
        return self.createOutput(name=name, possibleDatatypes=[dai.Node.DatatypeHierarchy(kind, False)])

    def ignore(self, *_: Any, **__: Any) -> None:
        """Accepts a setting of the hardware that has no meaning here, such as the number of buffers."""

    def runs(self) -> bool:
        """Whether the pipeline runs and no node has failed."""
        return bool(self.isRunning()) and not self.twin.errors

    def run(self) -> None:
        """Runs `work`, and reports what it raises."""
        try:
            self.work()
            self.has_ended = True
        except Closed:
            pass
        except BaseException as error:
            if self.isRunning():
                self.twin.fail(error, type(self).__name__)

    def work(self) -> None:
        """What the node does until the pipeline stops."""
        raise NotImplementedError
