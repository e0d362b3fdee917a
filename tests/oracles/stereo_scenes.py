"""Rendered stereo pairs with known disparity, for comparing matchers."""

import numpy as np


def noise(random, height, width, blur=1.0):
    """A texture with detail of all sizes from a few pixels up, 0 to 255."""
    out = np.zeros((height, width))
    size = max(blur, 1e-3)
    while size < min(height, width) / 2:
        rows, columns = int(np.ceil(height / size)) + 2, int(np.ceil(width / size)) + 2
        grid = random.standard_normal((rows, columns))
        out += bilinear(grid, np.arange(height)[:, None] / size, np.arange(width)[None, :] / size)
        size *= 3
    low, high = np.percentile(out, [2, 98])
    return np.clip((out - low) / max(high - low, 1e-9), 0, 1) * 200 + 25


def bilinear(grid, y, x):
    y, x = np.broadcast_arrays(y, x)
    y0 = np.clip(np.floor(y).astype(int), 0, grid.shape[0] - 2)
    x0 = np.clip(np.floor(x).astype(int), 0, grid.shape[1] - 2)
    v, u = y - y0, x - x0
    return (
        (grid[y0, x0] * (1 - u) + grid[y0, x0 + 1] * u) * (1 - v)
        + (grid[y0 + 1, x0] * (1 - u) + grid[y0 + 1, x0 + 1] * u) * v
    )


def pair(random, height, width, layers, blur=1.0, sigma=0.0, samples=4):
    """Left, right (uint8), the left image's disparity, and where the right image sees the same.

    A layer is `(inside, plane)`: `inside(x, y)` says what of the left image it covers, `plane` gives a, b, c of its
    disparity a + b·x + c·y. Layers come one before the other; each has its own texture.
    """
    reach = 2 * width
    textures = [noise(random, height, 2 * reach, blur) for _ in layers]

    def disparity(plane, x, y):
        a, b, c = plane
        return a + b * x + c * y

    def see(is_right, x, y):
        grey, deepest, which = np.zeros(x.shape), np.full(x.shape, -np.inf), np.full(x.shape, -1)
        for number, ((inside, plane), texture) in enumerate(zip(layers, textures)):
            a, b, c = plane
            # x_right = x − a − b·x − c·y
            source = (x + a + c * y) / (1 - b) if is_right else x
            d = disparity(plane, source, y)
            nearer = inside(source, y) & (d > deepest)
            grey = np.where(nearer, bilinear(texture, y, source + reach / 2), grey)
            deepest = np.where(nearer, d, deepest)
            which = np.where(nearer, number, which)
        return grey, deepest, which

    y, x = np.mgrid[0:height, 0:width].astype(float)

    def image(is_right):
        total = np.zeros((height, width))
        for k in range(samples):
            total += see(is_right, x + (k + 0.5) / samples - 0.5, y)[0]
        total = total / samples + sigma * random.standard_normal(total.shape)
        return np.clip(np.round(total), 0, 255).astype(np.uint8)

    _, truth, which = see(False, x, y)
    there = x - truth
    _, _, seen = see(True, there, y)
    return image(False), image(True), truth, (seen == which) & (there >= 0)


def everywhere(x, y):
    return np.full(x.shape, True)


def box(left, top, right, bottom):
    return lambda x, y: (x >= left) & (x < right) & (y >= top) & (y < bottom)


def surest(found, confidence, where, share):
    """Removes the least confident pixels, so that at most this fraction of `where` has a value; equally confident
    ones are all removed."""
    kept = where & (found > 0)
    levels = np.bincount(confidence[kept], minlength=256)[::-1].cumsum()
    # The most levels from the top that are not more than that.
    count = np.searchsorted(levels, share * where.sum(), side="right")
    return np.where(confidence > 255 - count, found, 0)
