#!/bin/sh
# Renders the rig's depth, as an OAK-D Pro reports it: render.sh OUT [SEED] writes OUT/depth_mm.png, 16-bit millimetres, 640x360.
# OAKTWIN names the program. See README.md for the settings and where they are from.
set -eu
out=${1:?usage: render.sh OUT [SEED]}
seed=${2:-0}
here=$(dirname "$0")
program=${OAKTWIN:-oaktwin}

# What the left and right cameras record at 400P, with the dots at half of their power.
"$program" render "$here/board.usda" --model OAK-D-Pro --look-at 0 0 0 1 0 0 --resolution 640x400 --engine stereo-matching \
    --pair --annotators rgb --projector 0.5 --ambient 8 --seed "$seed" -o "$out/pair"

# The depth of the pair, aligned to the colour camera.
"$program" stereo "$out/pair/rectified_left_0000.png" "$out/pair/rectified_right_0000.png" --model OAK-D-Pro \
    --param subpixel=false --param confidenceThresholdV2=255 --param leftRightCheck=true \
    --param paths=3 --param blockSize=5 --param blockRows=1 --param penaltyShift=2 \
    --align rgb --align-size 640x360 --png16 -o "$out/depth"

cp "$out/depth/rectified_depth_sensor_distance_aligned_rgb_millimetres_0000.png" "$out/depth_mm.png"
