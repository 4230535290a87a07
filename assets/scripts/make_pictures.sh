#!/usr/bin/env bash
# Makes the pictures of README.md anew, with the program that run.sh builds.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
program=$root/build/release/chartflood
pictures=$root/assets/pictures
mkdir -p "$pictures"

# One picture of the sample rocket: its name, then the options that make it.
picture() {
  local name=$1
  shift
  "$program" --sample=rocket --resolution=420,640 --supersampling=4 --background=transparent \
    --scalar-bar=off --output="$pictures/$name.png" "$@"
}

# Model and texture side by side.
"$program" --sample=rocket --resolution=1280,640 --supersampling=2 --scalar-bar=off \
  --seed-marks=off --view=both --color-by=checkerboard --output="$pictures/rocket-texture.png"

picture rocket-gauss --color-by=gauss --seams=off --seed-marks=off
picture rocket-flood --color-by=charts --steps=16000
picture rocket-charts --color-by=charts --seed-marks=off
