#!/usr/bin/env bash
# How smoothly the real window answers with a model: plays a flood, scrubs, drags sliders, drags a
# seed, turns the model, rests. Prints for each phase how many passes the loop made and what a pass
# and its parts took (median, 95th per cent, longest; milliseconds), then the processor time at rest.
# Usage: window_frames.sh PROGRAM MODEL [WxH]
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
source "$here/../gui/window_support.sh"
if [ "$1" != --inside ]; then
  export FRAMES_MODEL=$2 FRAMES_SIZE=${3:-1280x800}
  on_own_display "$0" "$FRAMES_SIZE" "$1"
fi
program=$2 folder=$3
export CHARTFLOOD_FRAME_LOG=$folder/frames

since=1
mark() { since=$(($(wc -l < "$folder/frames") + 1)); }
# Median, 95th per cent and longest of a column of the passes since the mark.
figures() { # column
  tail -n "+$since" "$folder/frames" | cut -d ' ' -f "$1" | sort -g | awk '{ v[NR] = 1000 * $1 } END {
    printf "%6.1f %6.1f %6.1f", v[int((NR + 1) / 2)], v[int(NR * 0.95 + 0.999)], v[NR] }'
}
report() { # phase
  sleep 0.3
  printf '%-14s %6s  %s   state %s   panels %s   present %s   picture %s\n' "$1" \
    "$(tail -n "+$since" "$folder/frames" | wc -l)" "$(figures 1)" "$(figures 2)" "$(figures 3)" \
    "$(figures 4)" "$(figures 5)"
}
# Moves the pressed pointer to and fro over a widget for some seconds.
stir() { # widget x1 y1 x2 y2 seconds
  local i=0 t at until
  at=$(place "$1" "$2" "$3") || fail "there is no $1"
  xdotool mousemove $at; sleep 0.3; xdotool mousedown 1; sleep 0.1
  until=$(($(date +%s%N) + $6 * 1000000000))
  while [ "$(date +%s%N)" -lt "$until" ]; do
    i=$(((i + 1) % 40)); t=$((i < 20 ? i * 5 : (40 - i) * 5))
    at=$(place "$1" $(($2 + ($4 - $2) * t / 100)) $(($3 + ($5 - $3) * t / 100)))
    [ -z "$at" ] || xdotool mousemove $at
    sleep 0.03
  done
  xdotool mouseup 1
}
"$program" "$FRAMES_MODEL" & pid=$!
shows scrubber || fail "no window"
await xdotool search --name "^$(basename "${FRAMES_MODEL%.*}")" || fail "the model was not opened"
sleep 2
[ -z "$(rectangle first-steps)" ] || keys Escape
mark; keys space; sleep 8; report "flood plays"
keys Return; sleep 3; settle
mark; stir scrubber 95 50 10 50 6; report "scrub"
keys End; settle
for row in speed-power sharp-angle charts; do
  [ -n "$(rectangle $row)" ] || { echo "$row: not in sight"; continue; }
  mark; stir $row 40 50 60 50 6; report "slider $row"
  settle; keys ctrl z; settle
done
keys g; click view 50 55; settle
mark; stir view 50 55 40 45 6; report "seed"
settle; keys v
mark; stir view 40 40 60 60 6; report "turn"
settle
# How long Esc takes to end a run, from the key until a pass was drawn without progress.
for delay in 0.05 0.3 0.6 1 1.5 2 3; do
  drag charts 50 50 60 50; settle
  keys Return; shows progress || continue
  sleep $delay
  grep -q '"progress"' "$folder/probe.json" || { echo "the run was over after $delay s"; continue; }
  start=$(date +%s%N); xdotool key Escape
  for i in $(seq 2000); do grep -q '"progress"' "$folder/probe.json" || break; sleep 0.005; done
  echo "Esc $delay s into a run: $((($(date +%s%N) - start) / 1000000)) ms"
  settle; keys ctrl z; settle
done
settle
before=$(ticks); sleep 10; after=$(ticks)
echo "at rest: $((after - before)) of 1000 hundredths of a second"
kill $pid
