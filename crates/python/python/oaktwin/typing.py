"""Types for annotations: the options of sensors and of pairs as mappings, and the names of choices.

```python
from oaktwin.typing import SensorOptions

options: SensorOptions = {"engine": "stereo-noise", "filters": ["median"]}
```
A type checker knows the keys and their values; when the program runs, they are dictionaries and strings.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._types import (
        _Engine as Engine,
        _Model as Model,
        _PairOptions as PairOptions,
        _Platform as Platform,
        _Preset as Preset,
        _Role as Role,
        _SceneAnnotator as SceneAnnotator,
        _SensorAnnotator as SensorAnnotator,
        _SensorOptions as SensorOptions,
    )
else:
    PairOptions = SensorOptions = dict
    Engine = Model = Platform = Preset = Role = SceneAnnotator = SensorAnnotator = str

__all__ = ["Engine", "Model", "PairOptions", "Platform", "Preset", "Role", "SceneAnnotator", "SensorAnnotator", "SensorOptions"]
