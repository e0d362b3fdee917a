"""OAK stereo matching of a rectified pair in plain NumPy: the steps that `oaktwin_depth::stereo_matching` documents.

Written from that documentation, for images of a few thousand pixels: whole cost volumes, one path after the other.
"""

from dataclasses import dataclass

import numpy as np

WINDOWS = {"AUTO": (5, 5), "KERNEL_5x5": (5, 5), "KERNEL_7x7": (7, 7), "KERNEL_7x9": (7, 9)}
MASKS = {(5, 5): 0xA82415, (7, 7): 0xAA02A8154055, (7, 9): 0x2AA00AA805540155}
# The offset of the previous pixel in columns and rows, by number of paths.
PATHS = {
    3: [(-1, 0), (1, 0), (0, -1)],
    4: [(-1, 0), (1, 0), (0, -1), (0, 1)],
    5: [(-1, 0), (1, 0), (0, -1), (-1, -1), (1, -1)],
    6: [(-1, 0), (1, 0), (0, -1), (-1, -1), (1, -1), (0, 1)],
    8: [(-1, 0), (1, 0), (0, -1), (-1, -1), (1, -1), (0, 1), (-1, 1), (1, 1)],
}


@dataclass
class Parameters:
    """The program's parameter names, with dots replaced by underscores."""

    subpixelFractionalBits: int = 5
    subpixelInterpolation: str = "LINES"
    extendedDisparity: bool = False
    disparityShift: int = 0
    leftRightCheck: bool = True
    leftRightCheckThreshold: int = 10
    confidenceThreshold: int = 55
    numInvalidateEdgePixels: int = 0
    kernelSize: str = "AUTO"
    kernelMask: int = 0
    enableMeanMode: bool = True
    censusTransform_threshold: int = 0
    noiseThresholdOffset: int = 0
    noiseThresholdScale: int = 0
    disparityWidth: str = "DISPARITY_96"
    enableCompanding: bool = False
    alpha: int = 0
    beta: int = 2
    linearEquationParameters_threshold: int = 127
    blockSize: int = 5
    blockRows: int = 0
    divisionFactor: int = 1
    platform: str = "RVC2"
    horizontalPenaltyCostP1: int = 250
    horizontalPenaltyCostP2: int = 500
    verticalPenaltyCostP1: int = 250
    verticalPenaltyCostP2: int = 500
    penaltyShift: int = 4
    p1Config_enableAdaptive: bool = True
    p1Config_defaultValue: int = 11
    p1Config_edgeValue: int = 10
    p1Config_smoothValue: int = 22
    p2Config_enableAdaptive: bool = True
    p2Config_defaultValue: int = 33
    p2Config_edgeValue: int = 22
    p2Config_smoothValue: int = 63
    edgeThreshold: int = 15
    smoothThreshold: int = 5
    occlusionConfidenceWeight: int = 20
    motionVectorConfidenceWeight: int = 4
    motionVectorConfidenceThreshold: int = 1
    flatnessConfidenceWeight: int = 8
    flatnessConfidenceThreshold: int = 2
    flatnessOverride: bool = False
    holeFilling_enable: bool = True
    holeFilling_highConfidenceThreshold: int = 210
    holeFilling_fillConfidenceThreshold: int = 200
    holeFilling_minValidDisparity: int = 1
    holeFilling_invalidateDisparities: bool = True
    adaptiveMedianFilter_enable: bool = True
    adaptiveMedianFilter_confidenceThreshold: int = 200
    paths: int = 4


def match(left: np.ndarray, right: np.ndarray, p: Parameters) -> tuple[np.ndarray, np.ndarray]:
    """Disparity in fixed point without the shift, and confidence."""
    bits = 10 if left.dtype == np.uint16 else 8
    left, right = (np.minimum(image.astype(np.int64), 2**bits - 1) for image in (left, right))
    found = one_pass(left, right, bits, left.shape[1], p, p.numInvalidateEdgePixels)
    if p.extendedDisparity and min(left.shape) > 1:
        half = one_pass(halve(left), halve(right), bits, left.shape[1], p, p.numInvalidateEdgePixels // 2)
        return merge(found, half, p)
    return found


def candidates(p: Parameters) -> np.ndarray:
    counts = {"DISPARITY_96": (48, 32, 16), "DISPARITY_64": (32, 16, 16)}[p.disparityWidth]
    if not p.enableCompanding:
        return p.disparityShift + np.arange(sum(counts))
    steps = np.repeat((1, 2, 4), counts)
    return p.disparityShift + np.concatenate(([0], np.cumsum(steps)[:-1]))


def census(image: np.ndarray, bits: int, mask: int, p: Parameters) -> np.ndarray:
    """Booleans, one for each pixel of the window that counts, first axis."""
    height, width = image.shape
    rows, columns = WINDOWS[p.kernelSize]
    padded = np.pad(image, ((rows // 2,) * 2, (columns // 2,) * 2), mode="edge")
    window = np.stack([padded[y : y + height, x : x + width] for y in range(rows) for x in range(columns)])
    middle = rows * columns // 2
    reference = window.sum(0) // (rows * columns) if p.enableMeanMode else image
    raised = (p.censusTransform_threshold + p.noiseThresholdOffset) << (bits - 8)
    reference = reference + raised + ((p.noiseThresholdScale * reference) >> 12)
    others = np.delete(window, middle, axis=0)
    last = len(others) - 1
    counted = [k for k in range(len(others)) if mask >> (last - k) & 1]
    return others[counted] > reference


def costs(left, right, bits, full_width, p):
    """Height, width, candidates."""
    mask = p.kernelMask or (MASKS[WINDOWS[p.kernelSize]] if full_width >= 1280 else 2**64 - 1)
    ours, theirs = census(left, bits, mask, p), census(right, bits, mask, p)
    height, width = left.shape
    most = min(p.alpha * 255 + p.beta * 8 * len(ours), 32 * p.linearEquationParameters_threshold)
    disparities = candidates(p)
    volume = np.full((height, width, len(disparities)), 3 * most // 128 * 16, np.int64)
    for k, d in enumerate(disparities):
        if d >= width:
            continue
        there = slice(0, width - d)
        ctc = (ours[:, :, d:] != theirs[:, :, there]).sum(0)
        ad = np.abs((left[:, d:] >> (bits - 8)) - (right[:, there] >> (bits - 8)))
        volume[:, d:, k] = np.minimum(p.alpha * ad + p.beta * (ctc << 3), 32 * p.linearEquationParameters_threshold)
    return block_means(volume, p.blockRows or p.blockSize, p.blockSize)


def block_means(volume, rows, columns):
    """An eighth of the mean over each pixel's block, rounded half up."""
    height, width, _ = volume.shape
    area = rows * columns
    padded = np.pad(volume, ((rows // 2,) * 2, (columns // 2,) * 2, (0, 0)), mode="edge")
    total = sum(padded[y : y + height, x : x + width] for y in range(rows) for x in range(columns))
    return (total + 4 * area) // (8 * area)


def penalties(grey, before, along, p):
    """P1 and P2 of one row's or pixel's path."""
    if p.platform == "RVC2":
        pair = (p.horizontalPenaltyCostP1, p.horizontalPenaltyCostP2)
        if not along:
            pair = (p.verticalPenaltyCostP1, p.verticalPenaltyCostP2)
        p1, p2 = (np.full(grey.shape, penalty >> p.penaltyShift) for penalty in pair)
        return np.minimum(p1, p2), p2
    difference = np.abs(grey - before)

    def adaptive(name):
        default, edge, smooth = (getattr(p, f"{name}Config_{kind}Value") for kind in ("default", "edge", "smooth"))
        if not getattr(p, f"{name}Config_enableAdaptive"):
            return np.full(grey.shape, default)
        return np.where(
            difference > p.edgeThreshold, edge, np.where(difference < p.smoothThreshold, smooth, default)
        )

    p1, p2 = adaptive("p1"), adaptive("p2")
    return np.minimum(p1, p2), p2


def step(cost, before, p1, p2):
    """The costs at pixels (rows of `cost`) that come from the pixels `before`."""
    worst = np.full((len(cost), 1), 10**9)
    least = before.min(1, keepdims=True)
    nearer = np.concatenate([worst, before[:, :-1]], 1) + p1[:, None]
    farther = np.concatenate([before[:, 1:], worst], 1) + p1[:, None]
    best = np.minimum(np.minimum(before, least + p2[:, None]), np.minimum(nearer, farther))
    return cost + best - least


def path(volume, grey, dx, dy, p):
    """The costs along one path; pixels outside the image cost nothing."""
    height, width, _ = volume.shape
    out = np.zeros_like(volume)
    if dy == 0:
        columns = range(width) if dx < 0 else range(width - 1, -1, -1)
        for x in columns:
            if not 0 <= x + dx < width:
                out[:, x] = volume[:, x]
                continue
            p1, p2 = penalties(grey[:, x], grey[:, x + dx], True, p)
            out[:, x] = step(volume[:, x], out[:, x + dx], p1, p2)
        return out
    rows = range(height) if dy < 0 else range(height - 1, -1, -1)
    for y in rows:
        out[y] = volume[y]
        if not 0 <= y + dy < height:
            continue
        here = slice(max(0, -dx), width - max(0, dx))
        there = slice(max(0, dx), width - max(0, -dx))
        p1, p2 = penalties(grey[y, here], grey[y + dy, there], False, p)
        out[y, here] = step(volume[y, here], out[y + dy, there], p1, p2)
    return out


def one_pass(left, right, bits, full_width, p, invalid_edge):
    volume = costs(left, right, bits, full_width, p)
    grey = left >> (bits - 8)
    sums = sum(path(volume, grey, dx, dy, p) for dx, dy in PATHS[p.paths]) // p.divisionFactor
    height, width, count = sums.shape
    disparities = candidates(p)
    best = sums.argmin(2)
    index = np.arange(count)
    others = np.where(np.abs(index - best[..., None]) > 1, sums, 10**9)
    first, second = sums.min(2), others.min(2)
    f32 = np.float32
    with np.errstate(all="ignore"):
        confidence = f32(255) * (second - first).astype(f32) / second.astype(f32)
    confidence = np.where(second > 0, confidence, 0).astype(np.uint8)

    fraction = fractions(sums, best, p)
    own = disparities[best]
    toward = np.clip(np.where(fraction < 0, best - 1, best + 1), 0, count - 1)
    spacing = np.maximum(np.abs(disparities[toward] - own), 1).astype(f32)
    exact = ((own - p.disparityShift).astype(f32) + fraction * spacing) * f32(1 << p.subpixelFractionalBits)
    fixed = np.maximum(exact + f32(0.5), 0).astype(np.int64)

    x = np.arange(width)[None, :]
    partner = x - own
    there = right_disparities(sums, disparities)[np.arange(height)[:, None], np.maximum(partner, 0)]
    apart = np.where((partner >= 0) & (there >= 0), np.abs(there - own), 10**6)
    kept = (partner >= 0) & (x >= invalid_edge)
    if p.leftRightCheck:
        kept &= apart <= p.leftRightCheckThreshold
    if p.platform == "RVC4":
        confidence = metrics(fixed, apart <= 1, confidence.astype(np.int64), p)
        if p.holeFilling_enable:
            fixed = fill_holes(fixed, confidence, superpixels(grey), p)
        if p.adaptiveMedianFilter_enable:
            fixed = adaptive_median(fixed, confidence, p)
    kept &= confidence >= p.confidenceThreshold
    return np.where(kept, fixed, 0), confidence.astype(np.uint8)


def around(image):
    """The 3×3 neighbours along the first axis, with the border replicated."""
    height, width = image.shape
    padded = np.pad(image, 1, mode="edge")
    return np.stack([padded[y : y + height, x : x + width] for y in range(3) for x in range(3)])


def metrics(fixed, seen, share, p):
    """The confidence of RVC4."""
    bits = p.subpixelFractionalBits
    apart = np.clip(around(fixed) - fixed, -(16 << bits), 16 << bits)
    variance = 9 * (apart**2).sum(0) - apart.sum(0) ** 2
    still = 255 - np.minimum((variance << p.motionVectorConfidenceThreshold) >> (2 * bits + 1), 255)
    steep = np.clip(8 * share - 255 * p.flatnessConfidenceThreshold, 0, 255)
    if p.flatnessOverride:
        return steep
    weighted = (
        p.occlusionConfidenceWeight * 255 * seen
        + p.motionVectorConfidenceWeight * still
        + p.flatnessConfidenceWeight * steep
    )
    return np.minimum(weighted >> 5, 255)


def superpixels(grey, side=8, rounds=2):
    """Each pixel's superpixel: the number of the cell that its centre began in."""
    height, width = grey.shape
    y, x = np.mgrid[0:height, 0:width]
    columns = -(-width // side)
    rows = -(-height // side)
    own = y // side * columns + x // side
    label = own
    for _ in range(rounds):
        count = np.bincount(label.ravel(), minlength=rows * columns)
        means = []
        for what in (x, y, grey):
            total = np.bincount(label.ravel(), what.ravel(), rows * columns).astype(np.int64)
            means.append((total + count // 2) // np.maximum(count, 1))
        least, best = np.full(grey.shape, 10**9), label
        for dy in (-1, 0, 1):
            for dx in (-1, 0, 1):
                row, column = y // side + dy, x // side + dx
                there = (row >= 0) & (row < rows) & (column >= 0) & (column < columns)
                cell = np.where(there, row * columns + column, 0)
                distance = (x - means[0][cell]) ** 2 + (y - means[1][cell]) ** 2 + (grey - means[2][cell]) ** 2
                better = there & (count[cell] > 0) & (distance < least)
                least, best = np.where(better, distance, least), np.where(better, cell, best)
        label = best
    return label


def fill_holes(fixed, confidence, label, p):
    sure = confidence > p.holeFilling_highConfidenceThreshold
    size = label.max() + 1
    count = np.bincount(label.ravel(), minlength=size)
    sures = np.bincount(label[sure], minlength=size)
    total = np.bincount(label[sure], fixed[sure], size).astype(np.int64)
    mean = (total + sures // 2) // np.maximum(sures, 1)
    enough = (sures > 0) & (sures << p.holeFilling_minValidDisparity >= count)
    filled = np.where(enough[label], mean[label], 0 if p.holeFilling_invalidateDisparities else fixed)
    return np.where(confidence < p.holeFilling_fillConfidenceThreshold, filled, fixed)


def adaptive_median(fixed, confidence, p):
    near = around(fixed)
    medians = np.median(np.where(near == 0, fixed, near), axis=0).astype(np.int64)
    return np.where(confidence < p.adaptiveMedianFilter_confidenceThreshold, medians, fixed)


def fractions(sums, best, p):
    count = sums.shape[2]

    def at(offset):
        return np.take_along_axis(sums, np.clip(best + offset, 0, count - 1)[..., None], 2)[..., 0].astype(np.float32)

    a, b, c, d, e = (at(offset) for offset in (-2, -1, 0, 1, 2))
    over, under = b - d, 2 * (b - 2 * c + d)
    if p.subpixelInterpolation == "LINES":
        under = 2 * np.maximum(b - c, d - c)
    elif p.subpixelInterpolation == "PARABOLA_5":
        bend = 10 * (2 * (a + e - c) - b - d)
        five = (best >= 2) & (best + 2 < count) & (bend > 0)
        over = np.where(five, 7 * (2 * (a - e) + (b - d)), over)
        under = np.where(five, bend, under)
    usable = (under > 0) & (best > 0) & (best < count - 1)
    place = (over / np.where(usable, under, 1)).astype(np.float32)
    return np.where(usable, np.clip(place, np.float32(-0.5), np.float32(0.5)), np.float32(0)).astype(np.float32)


def right_disparities(sums, disparities):
    """The disparities of the right image's pixels, −1 where there is none."""
    height, width, _ = sums.shape
    least = np.full((height, width), 10**9)
    out = np.full((height, width), -1)
    for k, d in enumerate(disparities):
        if d >= width:
            continue
        there = sums[:, d:, k]
        here = slice(0, width - d)
        better = there < least[:, here]
        out[:, here] = np.where(better, d, out[:, here])
        least[:, here] = np.minimum(least[:, here], there)
    return out


def halve(image):
    height, width = (side // 2 * 2 for side in image.shape)
    image = image[:height, :width]
    return (image[::2, ::2] + image[::2, 1::2] + image[1::2, ::2] + image[1::2, 1::2] + 2) >> 2


def merge(full, half, p):
    (disparity, confidence), (half_disparity, half_confidence) = full, half
    height, width = disparity.shape
    y = np.minimum(np.arange(height) // 2, len(half_disparity) - 1)[:, None]
    x = np.minimum(np.arange(width) // 2, half_disparity.shape[1] - 1)[None, :]
    near, sure = half_disparity[y, x], half_confidence[y, x]
    bits = p.subpixelFractionalBits
    doubled = 2 * near + (p.disparityShift << bits)
    beyond = (candidates(p)[-1] - p.disparityShift) << bits
    taken = (near > 0) & (doubled > beyond) & ((disparity == 0) | (sure > confidence))
    return np.where(taken, np.minimum(doubled, 65535), disparity), np.where(taken, sure, confidence)
