"""The parameters of the node, without rclpy: the options of oaktwin.DepthSensor with ROS's types.

"" and -1 mean that an option is not set, because parameters of ROS have one type and no None.
"""

from __future__ import annotations

from typing import Any

# A test compares the names with oaktwin.DepthSensor's, whose `parameters` may also be the path of a file, `params` here.
OPTIONS: dict[str, Any] = {
    "engine": "",
    "preset": "",
    # A list of texts; ROS gives an empty list no type.
    "filters": [""],
    "params": "",
    # NAME=VALUE.
    "parameters": [""],
    "extended_disparity": False,
    "isaac": "",
    "seed": 0,
    "device_seed": -1,
    "drift": "",
}


def arguments(values: dict[str, Any]) -> dict[str, Any]:
    """The keyword arguments of oaktwin.DepthSensor for the values of parameters."""
    found: dict[str, Any] = {}
    for name, default in OPTIONS.items():
        value = values.get(name, default)
        if name == "params":
            continue
        if name == "parameters":
            texts = [text for text in value if text]
            wrong = [text for text in texts if "=" not in text]
            if wrong:
                raise ValueError(f"parameters: invalid assignment '{wrong[0]}'; write NAME=VALUE, as in noiseSigma=0.2")
            file = values.get("params", "")
            if file and texts:
                raise ValueError("params: is given beside parameters; write all parameters into the file")
            found[name] = file or dict(text.split("=", 1) for text in texts)
        elif isinstance(default, list):
            found[name] = [text for text in value if text]
        elif name == "device_seed":
            found[name] = None if value < 0 else value
        elif default == "":
            found[name] = value or None
        else:
            found[name] = value
    return found
