"""What is measured of a picture of the rig in `examples/board_rig`: depth of a board before a wall, in millimetres, 0 where invalid."""

import cv2
import numpy as np

NAMES = ["fill", "board_fill", "left", "right", "wall_holes", "run_across", "run_down"]
# How far from the board the wall counts, so that its own holes are not those of the board's edges: rows and columns.
AROUND = (20, 30)


def statistics(depth):
    """The share of pixels with a value, on all of the picture and on the board; the widths in pixels of the bands without a value left and
    right of the board; the share of pixels without a value on the wall, and the mean lengths of their runs along rows and columns."""
    height, width = depth.shape
    is_valid = depth > 0
    between = between_board_and_wall(depth)
    left, right, top, bottom = board(is_valid & (depth < between))
    bands = []
    for start, step in ((left + 10, -1), (right - 10, 1)):
        bands.append(np.mean([band(depth[y], start, step, between) for y in range(top + 15, bottom - 15)]))
    is_far = np.ones_like(is_valid)
    rows, columns = AROUND
    is_far[max(0, top - rows) : bottom + rows, max(0, left - columns) : right + columns] = False
    holes = ~is_valid & is_far
    inside = is_valid[top + 10 : bottom - 10, left + 10 : right - 10]
    values = [is_valid.mean(), inside.mean(), *bands, holes.sum() / is_far.sum(), run(holes), run(holes.T)]
    return dict(zip(NAMES, map(float, values)))


def between_board_and_wall(depth):
    """The middle between the depths of both: of the picture's centre and of its right border."""
    centre, border = depth[100:260, 180:420], depth[:, 520:]
    return (np.median(centre[centre > 0]) + np.median(border[border > 0])) / 2


def board(is_near):
    """The left and right, top and bottom border of the largest connected area, but for a hundredth on each side."""
    cross = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]], np.uint8)
    # Without a border, so that closing erodes from the picture's border as elsewhere.
    closed = cv2.dilate(is_near.astype(np.uint8), cross, iterations=3, borderType=cv2.BORDER_CONSTANT, borderValue=0)
    closed = cv2.erode(closed, cross, iterations=3, borderType=cv2.BORDER_CONSTANT, borderValue=0)
    _, labels, sizes, _ = cv2.connectedComponentsWithStats(closed, connectivity=4)
    rows, columns = np.where(labels == 1 + np.argmax(sizes[1:, cv2.CC_STAT_AREA]))
    return [int(value) for value in (*np.percentile(columns, [1, 99]), *np.percentile(rows, [1, 99]))]


def band(row, start, step, between):
    """The length of the first run without a value, from a pixel on the board outwards."""
    at, end = start, 0 if step < 0 else len(row) - 1
    while at != end and 0 < row[at] < between:
        at += step
    first = at
    while at != end and row[at] == 0:
        at += step
    return abs(at - first)


def run(holes):
    """The mean length of the runs along rows; 0 without any."""
    padded = np.pad(holes.astype(np.int8), ((0, 0), (1, 1)))
    starts = (np.diff(padded, axis=1) == 1).sum()
    return holes.sum() / starts if starts else 0
