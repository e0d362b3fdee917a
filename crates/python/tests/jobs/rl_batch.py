"""Depth of many environments: units of their own, and episodes that end one by one."""

import numpy as np

import oaktwin

device = oaktwin.Device("OAK4-D")
sensor = oaktwin.DepthSensor(device, hfov_deg=77, filters=["temporal"], seed=5)
depth = np.random.default_rng(0).uniform(1, 4, (64, 1, 1)) * np.ones((64, 60, 106))
batch = depth.astype(np.float32)
units = np.arange(64)

for step in range(3):
    measured = sensor(batch, device_seed=units)
    sensor.reset(np.flatnonzero(units % 2 == step % 2))
assert measured.shape == batch.shape and np.median(np.abs(measured - batch)) < 0.2
assert len({float(np.median(image / exact)) for image, exact in zip(measured, batch)}) > 60
