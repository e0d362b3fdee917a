"""The node Script, whose Python runs in a thread of the host."""

from __future__ import annotations

import inspect
import sys
from os import PathLike
from pathlib import Path
from typing import Any

import depthai as dai

from ._node import Closed, VirtualNode


class Ports(dict[str, Any]):
    """Inputs or outputs, each made when it is first named."""

    def __init__(self, make: Any) -> None:
        super().__init__()
        self._make = make

    def __missing__(self, name: str) -> Any:
        self[name] = self._make(name)
        return self[name]


class _Node:
    """What a script calls `node`."""

    def __init__(self, script: Script) -> None:
        self._script = script
        self.inputs, self.outputs = script.inputs, script.outputs
        # DepthAI's own, which measure where a node spends its time.
        self.mainLoop = script.mainLoop
        self.inputBlockEvent, self.outputBlockEvent, self.blockEvent = script.inputBlockEvent, script.outputBlockEvent, script.blockEvent

    @property
    def io(self) -> dict[str, Any]:
        """All inputs and outputs by name."""
        return {**self.outputs, **self.inputs}

    def _log(self, text: Any) -> None:
        print(f"Script({self._script.id}): {text}", file=sys.stderr)

    trace = debug = info = warn = error = critical = _log


class Script(VirtualNode):
    """DepthAI's Script. The names of DepthAI's messages are its globals, as on the device."""

    Properties = getattr(dai.node.Script, "Properties", None)

    def __init__(self) -> None:
        super().__init__()
        self.inputs = Ports(lambda name: self.createInput(name=name, blocking=True, queueSize=8))
        self.outputs = Ports(lambda name: self.createOutput(name=name))
        self._text, self._name = "", "<script>"

    def setScript(self, script: str, name: str = "<script>") -> None:
        """The text of the script."""
        # DepthAI removes the indentation that all lines share, too.
        self._text, self._name = inspect.cleandoc(script), name or "<script>"

    def setScriptPath(self, path: str | PathLike[str], name: str = "") -> None:
        """The file of the script."""
        self.setScript(Path(path).read_text(encoding="utf-8"), name or str(path))

    def getScriptName(self) -> str:
        """The name of the script in messages."""
        return self._name

    def setProcessor(self, processor: dai.ProcessorType) -> None:
        """Has no effect: the script runs on the host."""

    def work(self) -> None:
        """Runs the script; it is ended at its next line after the pipeline has stopped."""
        names = {name: getattr(dai, name) for name in dir(dai) if not name.startswith("_")}

        def watch(*_: Any) -> Any:
            if not self.runs():
                raise Closed("the pipeline has stopped")
            return watch

        sys.settrace(watch)
        try:
            exec(compile(self._text, self._name, "exec"), {**names, "node": _Node(self), "__name__": "__main__"})
        finally:
            sys.settrace(None)
