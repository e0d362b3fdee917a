"""The windows of Open3D and Rerun without a screen: what a program shows is counted."""

from __future__ import annotations

import importlib.abc
import importlib.util
import sys
from collections.abc import Callable
from typing import Any


class Viewers:
    """Replaces the viewers of Open3D and Rerun in programs that import them.

    frames: after so many updates of an Open3D window, it is closed; None for never.
    """

    def __init__(self, frames: int | None) -> None:
        self.frames = frames
        # How often each window was drawn, and each path of Rerun logged.
        self.counts: dict[str, int] = {}
        self._before: list[tuple[Any, str, Any]] = []
        self._finder = _Finder({"open3d": self._replace_open3d, "rerun": self._replace_rerun})

    def open(self) -> None:
        """Replaces the viewers, also of modules that are imported later."""
        self._finder.open()

    def close(self) -> None:
        """Puts the viewers back."""
        self._finder.close()
        while self._before:
            owner, name, value = self._before.pop()
            setattr(owner, name, value)

    def _set(self, owner: Any, name: str, value: Any) -> None:
        if hasattr(owner, name):
            self._before.append((owner, name, getattr(owner, name)))
            setattr(owner, name, value)

    def _count(self, name: str) -> int:
        self.counts[name] = self.counts.get(name, 0) + 1
        return self.counts[name]

    def _replace_open3d(self, module: Any) -> None:
        viewers = self

        class Window(_Window):
            def __init__(self) -> None:
                super().__init__(viewers)

        for name in ("Visualizer", "VisualizerWithKeyCallback", "VisualizerWithEditing", "VisualizerWithVertexSelection"):
            self._set(module.visualization, name, Window)
        self._set(module.visualization, "draw_geometries", lambda *_, **__: self._count("Open3D window 'draw_geometries'"))

    def _replace_rerun(self, module: Any) -> None:
        # Without a recording, Rerun's other functions have no effect.
        for name in ("init", "spawn", "connect_grpc", "serve_grpc", "serve_web_viewer", "save"):
            self._set(module, name, _nothing)
        self._set(module, "log", lambda path, *_, **__: self._count(f"Rerun path {path!r}"))

    def report(self) -> None:
        """Prints what was shown."""
        for name, count in self.counts.items():
            print(f"oaktwin: {name}: {count} updates", file=sys.stderr)


class _Window:
    """Open3D's Visualizer, whose settings have no effect."""

    def __init__(self, viewers: Viewers) -> None:
        self._viewers, self._name, self._updates = viewers, "Open3D window 'Open3D'", 0

    def create_window(self, window_name: str = "Open3D", *_: Any, **__: Any) -> bool:
        """Names the window."""
        self._name = f"Open3D window {window_name!r}"
        return True

    def update_geometry(self, *_: Any) -> bool:
        """Counts what is shown."""
        self._updates = self._viewers._count(self._name)
        return True

    add_geometry = update_geometry

    def poll_events(self) -> bool:
        """Whether the window is open."""
        return self._viewers.frames is None or self._updates < self._viewers.frames

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return _nothing


class _Settings:
    """Accepts every setting of a view."""

    def __getattr__(self, name: str) -> Any:
        return _nothing


def _nothing(*_: Any, **__: Any) -> Any:
    return _Settings()


class _Finder(importlib.abc.MetaPathFinder):
    """Calls a function with a module after its import.

    functions: by the names of modules.
    """

    def __init__(self, functions: dict[str, Callable[[Any], None]]) -> None:
        self._functions = functions
        self._is_searching = False

    def open(self) -> None:
        """Treats the modules that are imported already, and watches for the others."""
        for name, function in self._functions.items():
            if name in sys.modules:
                function(sys.modules[name])
        sys.meta_path.insert(0, self)

    def close(self) -> None:
        """Watches no longer."""
        sys.meta_path.remove(self)

    def find_spec(self, fullname: str, path: Any, target: Any = None) -> Any:
        """The place of a module, whose loader calls the function."""
        if fullname not in self._functions or self._is_searching:
            return None
        self._is_searching = True
        try:
            spec = importlib.util.find_spec(fullname)
        finally:
            self._is_searching = False
        if spec is None or spec.loader is None:
            return spec
        execute, function = spec.loader.exec_module, self._functions[fullname]

        def exec_module(module: Any) -> None:
            execute(module)
            function(module)

        spec.loader.exec_module = exec_module  # type: ignore[method-assign]
        return spec
