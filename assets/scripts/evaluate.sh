#!/usr/bin/env bash
# The paper's evaluation (section 4: figures 5 and 6, tables 1 and 2) on any meshes.
#   assets/scripts/evaluate.sh FOLDER MESH..
# For every mesh FOLDER gets, with the paper's parameters (-paper) and with ours (-ours): the three
# methods side by side as charts and as checkerboards (figure 6), their figures as text and JSON
# (tables 1 and 2); and once the Gauss area of vertices, edges and triangles (figure 5).
set -euo pipefail
if [ $# -lt 2 ]; then
  echo "usage: $0 FOLDER MESH.." >&2
  exit 2
fi
program=$(dirname "$0")/../../build/release/chartflood
if [ ! -x "$program" ]; then
  echo "$program is not there: build the program first (./run.sh does)." >&2
  exit 1
fi
folder=$1
shift
mkdir -p "$folder"
methods=mcgim,vsa,t-flooding
for mesh in "$@"; do
  name=$(basename "${mesh%.*}")
  echo "== $name"
  for element in vertex edge face; do
    "$program" "$mesh" --steps=1 --color-by="gauss-$element" --seed-marks=off \
      --output="$folder/$name-gauss-$element.png"
  done
  for set in paper ours; do
    options=(--charts=20 --compare=$methods --resolution=1920,900)
    if [ $set = paper ]; then options+=(--preset=paper); fi
    "$program" "$mesh" "${options[@]}" --report="$folder/$name-$set.json" \
      --output="$folder/$name-$set-charts.png" | tee "$folder/$name-$set.txt"
    "$program" "$mesh" "${options[@]}" --unwrap=circle --color-by=checkerboard \
      --output="$folder/$name-$set-checkerboard.png" >/dev/null
  done
done
