#!/usr/bin/env bash
# The paper's evaluation (section 4: figures 5 and 6, tables 1 and 2) on any meshes, with the paper's
# parameters and with this program's.
#   assets/scripts/evaluate.sh PROGRAM MESH-FOLDER OUTPUT-FOLDER [NAME..]
# PROGRAM is the built chartflood, a NAME a file of the mesh folder or sample:NAME; without names the
# usual ones that the folder has. The output folder gets evaluation.md with all tables, pictures/ with
# figure 5 (Gauss area of corners, creases and triangles) and figure 6 (charts and checkerboards of the
# three methods), and data/ with every figure as JSON, text and one table of values (all.tsv). Every
# comparison runs with the generator seeds 1, 2 and 3, the page has the medians; pictures are of seed 1.
set -euo pipefail
if [ $# -lt 3 ]; then
  echo "usage: $0 PROGRAM MESH-FOLDER OUTPUT-FOLDER [NAME..]" >&2
  exit 2
fi
program=$1 meshes=$2 out=$3
shift 3
[ -x "$program" ] || { echo "$program is no program: build it first (./run.sh does)." >&2; exit 1; }
names=("$@")
if [ ${#names[@]} = 0 ]; then
  for name in happy-buddha-19976.ply sample:rocket igea-151558.ply homer.obj rocker-arm.obj \
    stanford-bunny.obj armadillo-80354.ply; do
    if [[ $name == sample:* || -f $meshes/$name ]]; then names+=("$name"); fi
  done
fi
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
mkdir -p "$out/pictures" "$out/data"
table=$out/data/all.tsv
: >"$table"

# Rows of the table of values from the text of one comparison: mesh, triangles, parameters, generator
# seed, borders (left or alike), then what the text says of each method.
rows() {
  awk -v mesh="$1" -v triangles="$2" -v set="$3" -v seed="$4" -v OFS='\t' '
    /^Charts as each/ { borders = "left" }
    /^The same borders/ { borders = "alike" }
    $1 ~ /^(mcgim|vsa|t-flooding)$/ {
      sub("%", "", $11)
      print mesh, triangles, set, seed, borders, $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12
    }' "$5"
}

# One comparison: short name of the mesh, name of the parameters, generator seed, then the options.
compare() {
  local base=$out/data/$1-$2-$3
  "$program" "${source[@]}" --charts=20 --compare=mcgim,vsa,t-flooding --rng-seed="$3" \
    --verbose=error --report="$base.json" "${@:4}" >"$base.txt"
  local triangles
  triangles=$(grep -o '"triangles": *[0-9]*' "$base.json" | head -1 | grep -o '[0-9]*$')
  rows "$1" "$triangles" "$2" "$3" "$base.txt" >>"$table"
}

for name in "${names[@]}"; do
  source=("$meshes/$name") paper=paper
  if [[ $name == sample:* ]]; then source=(--sample="${name#sample:}"); fi
  look=(--background=white --seed-marks=off --scalar-bar=off)
  if [[ $name == happy* ]]; then
    paper=paper-happy  # the paper's p = 3
    look+=(--up=+Z)
  fi
  short=$(basename "${name#sample:}")
  short=${short%.*}
  echo "$short" >&2
  for element in vertex edge face; do
    "$program" "${source[@]}" --steps=1 --color-by="gauss-$element" "${look[@]}" --seams=off \
      --resolution=270,330 --output="$out/pictures/$short-gauss-$element.png"
  done
  figure=("${look[@]}" --color-by=charts,checkerboard --resolution=780,740)
  for seed in 1 2 3; do
    paperPicture=() oursPicture=()
    if [ $seed = 1 ]; then
      paperPicture=("${figure[@]}" --output="$out/pictures/$short-paper.png")
      oursPicture=("${figure[@]}" --output="$out/pictures/$short-ours.png")
    fi
    compare "$short" paper $seed --preset=$paper "${paperPicture[@]}"
    compare "$short" ours $seed "${oursPicture[@]}"
    compare "$short" moves $seed --refine=moves
  done
done
awk -f "$here/evaluation_page.awk" "$table" | cat -s >"$out/evaluation.md"
echo "$out/evaluation.md" >&2
