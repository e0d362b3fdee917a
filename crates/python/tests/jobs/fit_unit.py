"""The errors of a unit, fitted to its images of a wall, in another sensor."""

import numpy as np

import oaktwin

device = oaktwin.Device("OAK4-D")
unit = oaktwin.DepthSensor(device, parameters={"bias": 0.2})
texture = np.random.default_rng(0).integers(0, 256, (400, 640, 3)).astype(np.uint8)
images = {z: np.stack([unit(np.full((400, 640), z, np.float32), texture) for _ in range(3)]) for z in (0.8, 1.2, 2.0, 3.0)}
fit = oaktwin.fit(device, images)
twin = oaktwin.DepthSensor(device, parameters=fit)
assert abs(fit.parameters["bias"] - 0.2) < 0.05 and np.isclose(float(twin.parameters["bias"]), fit.parameters["bias"], rtol=1e-3)
