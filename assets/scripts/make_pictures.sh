#!/usr/bin/env bash
# Makes the pictures of README.md anew, with the program that run.sh builds; given a folder of meshes,
# also those of assets/docs/findings.md that show the printed method beside this program's defaults.
#   assets/scripts/make_pictures.sh [MESH-FOLDER]
# PROGRAM in the environment names another program.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
program=${PROGRAM:-$root/build/release/chartflood}
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

# Charts above, checkerboard below, figures under them: file of the mesh folder, name of the
# picture, then the options.
sheet() {
  local file=$1 name=$2
  shift 2
  "$program" "$meshes/$file" --compare=t-flooding --color-by=charts,checkerboard \
    --resolution=360,680 --supersampling=2 --background=white --seed-marks=off --scalar-bar=off \
    --verbose=error --output="$root/assets/docs/pictures/$name.png" "$@" >/dev/null
}

if [ $# -ge 1 ]; then
  meshes=$1
  for file in stanford-bunny.obj armadillo-80354.ply fandisk.obj casting.off; do
    [ -f "$meshes/$file" ] || { echo "$meshes has no $file." >&2; exit 1; }
    short=${file%%[-.]*}
    [ "$short" = stanford ] && short=bunny
    sheet "$file" "$short-paper" --preset=paper
    sheet "$file" "$short-defaults"
  done
fi
