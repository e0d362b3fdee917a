"""A data set that is made while a network learns."""

import numpy as np

import oaktwin

recipe = oaktwin.Recipe("recipe.toml", seed=1)
for sample in recipe:
    depth, exact = sample["depth_sensor_distance"], sample["distance_to_image_plane"]
    assert depth.shape == exact.shape == (100, 160)
assert np.array_equal(recipe[-1]["rgb"], recipe[len(recipe) - 1]["rgb"])
