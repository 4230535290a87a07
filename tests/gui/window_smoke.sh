#!/usr/bin/env bash
# The real window on a display of its own: finds widgets by the probe, clicks, types keys, takes a
# picture, quits. Exit code 77 (skipped) where xvfb-run or xdotool are missing.
set -u
if [ "$1" != --inside ]; then
  for tool in xvfb-run xdotool; do
    command -v "$tool" > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
  done
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  unset WAYLAND_DISPLAY
  export HOME=$folder XDG_CONFIG_HOME=$folder/config XDG_STATE_HOME=$folder/state
  export XDG_PICTURES_DIR=$folder/pictures CHARTFLOOD_PROBE_FILE=$folder/probe.json
  xvfb-run -a -s "-screen 0 1280x800x24" "$0" --inside "$1" "$folder"
  exit
fi

program=$2 folder=$3
fail() { echo "failed: $1"; kill "$pid" 2> /dev/null; exit 1; }
# Repeats a command until it works, 20 seconds at most.
await() {
  local i
  for i in $(seq 200); do "$@" > /dev/null 2>&1 && return 0; sleep 0.1; done
  return 1
}
# Left, top, right, bottom of a widget.
rectangle() { sed -n "s/^  \"$1\": \[\(.*\)\],*$/\1/p" "$folder/probe.json" | tr -d ,; }
click() {
  set -- $(rectangle "$1")
  [ $# = 4 ] || return 1
  xdotool mousemove $((($1 + $3) / 2)) $((($2 + $4) / 2)); sleep 0.3
  xdotool mousedown 1; sleep 0.3; xdotool mouseup 1; sleep 0.3
}
shows() { await grep -q "\"$1\"" "$folder/probe.json"; }

"$program" --sample=sphere --triangles=2000 & pid=$!
shows scrubber || fail "no window after 20 seconds"
shows tab/Charts || fail "no tab"  # side bars come one frame later
click "tab\/Charts" || fail "no tab"
shows chart/19 || fail "the first flood was not played"
click "tab\/Plots" || fail "no tab"
shows plot/spread || fail "the tab did not open"
xdotool key h
shows Keys || fail "the key H did nothing"
xdotool key h; sleep 0.5
xdotool key F12
await test -s "$folder/pictures/chartflood/sphere_charts_001.png" || fail "no picture"
kill -0 $pid || fail "the program ended early"
xdotool keydown ctrl; sleep 0.2; xdotool key q; sleep 0.2; xdotool keyup ctrl
await test -s "$folder/config/chartflood/config.json" || fail "it did not quit"
wait $pid || fail "exit code $?"
echo "passed"
