#!/usr/bin/env bash
# How long everything takes on growing meshes, from the file to the picture, and how much memory.
#   assets/scripts/speed_table.sh PROGRAM [MODEL..] > table.md
# PROGRAM is the built chartflood, a MODEL a mesh file or sample:NAME/TRIANGLES; without models the torus
# from 20 thousand to ten million triangles. Needs GNU time. Run it on a machine with nothing else to do.
# Each model is run RUNS times (3) in each way; the table has the medians:
#   literal   charts alone, with borders by moves: from the file to one number a face
#   fast      the same with --search=fast
#   picture   the defaults: seam cuts, cuts to disks, unwrap, packing, and a picture of 1280 x 960
set -euo pipefail
if [ $# -lt 1 ]; then
  echo "usage: $0 PROGRAM [MODEL..]" >&2
  exit 2
fi
program=$1
shift
[ -x "$program" ] || { echo "$program is no program: build it first (./run.sh does)." >&2; exit 1; }
[ -x /usr/bin/time ] || { echo "GNU time is not there: install the package time." >&2; exit 1; }
models=("$@")
if [ ${#models[@]} = 0 ]; then
  models=(sample:torus/20000 sample:torus/150000 sample:torus/1000000 sample:torus/10000000)
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# One run of the program; a line of figures goes to the file `rows`: seconds, kilobytes, triangles, then
# milliseconds of the stages as far as a report tells them.
once() {
  : >"$folder/report.json"
  /usr/bin/time -o "$folder/time" -f '%e %M' "$program" "$@"
  awk -v figures="$(<"$folder/time")" '
    function value(line) { sub(/.*: */, "", line); sub(/[, ]*$/, "", line); return line }
    /"triangles":/ && !triangles { triangles = value($0) }
    match($0, /"(read|gauss_area|flood_graph|segment|cut|unwrap|pack)": *[0-9]/) {
      split($0, word, "\""); time[word[2]] = value($0) }
    END { printf "%s %d", figures, triangles
      n = split("read gauss_area flood_graph segment cut unwrap pack", stage, " ")
      for (i = 1; i <= n; ++i) printf " %d", time[stage[i]]
      print "" }' "$folder/report.json" >>"$folder/rows"
}

# The median of each column of `rows`.
medians() {
  awk '{ for (c = 1; c <= NF; ++c) v[c, NR] = $c + 0 }
    END {
      for (c = 1; c <= NF; ++c) {
        for (i = 1; i <= NR; ++i) for (j = i + 1; j <= NR; ++j)
          if (v[c, j] < v[c, i]) { t = v[c, i]; v[c, i] = v[c, j]; v[c, j] = t }
        printf "%s ", v[c, int((NR + 1) / 2)]
      }
    }' "$folder/rows"
}

echo "Seconds of the whole, microseconds and bytes a triangle; of the picture also milliseconds of its stages."
echo
echo "| model | triangles | literal, s | µs | bytes | fast, s | µs | bytes | picture, s | µs | bytes | read | Gauss areas | graph | segment | cut | unwrap | pack | draw and write |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
for model in "${models[@]}"; do
  source=("$model") name=$(basename "${model%.*}")
  if [[ $model == sample:* ]]; then
    name=${model#sample:}
    source=(--sample="${name%/*}" --triangles="${name#*/}")
    name=${name%/*}
  fi
  row=
  for way in picture literal fast; do
    rm -f "$folder/rows"
    for ((i = 0; i < ${RUNS:-3}; ++i)); do
      case $way in
        picture) once "${source[@]}" --verbose=error --output="$folder/picture.png" --report="$folder/report.json" ;;
        *)
          once "${source[@]}" --verbose=error --refine=moves --search=$way \
            --export-labels="$folder/labels.txt" ;;
      esac
    done
    row="$row $(medians)"
  done
  awk -v name="$name" '{
    stages = ""
    rest = 1000 * $1
    for (i = 4; i <= 10; ++i) { stages = stages sprintf(" %d |", $i); rest -= $i }
    t = $3
    printf "| %s | %d | %.2f | %.2f | %d | %.2f | %.2f | %d | %.2f | %.2f | %d |%s %d |\n", name, t,
      $11, 1e6 * $11 / t, 1024 * $12 / t, $21, 1e6 * $21 / t, 1024 * $22 / t,
      $1, 1e6 * $1 / t, 1024 * $2 / t, stages, rest }' <<<"$row"
done
