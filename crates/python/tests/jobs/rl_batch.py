"""Depth of many environments: units of their own, and episodes that end one by one."""

import numpy as np

import oaktwin

device = oaktwin.Device("OAK4-D")
sensor = oaktwin.DepthSensor(device, hfov_deg=77, filters=["temporal"], seed=5)
depth = np.random.default_rng(0).uniform(1, 4, (64, 1, 1)) * np.ones((64, 60, 106))
exact = depth.astype(np.float32)
environments = sensor.batch(64, device_seeds=range(64))

measured = environments(exact)
for step in range(1, 4):
    environments.reset(np.arange(64) % 2 == step % 2, episode=step)
    measured = environments(exact)
assert measured.shape == exact.shape and np.median(np.abs(measured - exact)) < 0.2
assert len({float(np.median(image / one)) for image, one in zip(measured, exact)}) > 60
