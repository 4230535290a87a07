#!/usr/bin/env bash
# The real window on a display of its own: finds widgets by the probe, clicks, types keys, takes a
# picture, quits. Exit code 77 (skipped) where xvfb-run or xdotool are missing.
set -u
source "$(dirname "${BASH_SOURCE[0]}")/window_support.sh"
[ "$1" = --inside ] || on_own_display "$0" 1280x800 "$1"
program=$2 folder=$3

"$program" --sample=sphere --triangles=2000 & pid=$!
shows scrubber || fail "no window"
shows tab/Charts || fail "no tabs"
click tab/Charts || fail "no tab"
shows chart/19 || fail "the first flood was not played"
click tab/Plots || fail "no tab"
shows plot/spread || fail "the tab did not open"
keys h
shows Keys || fail "the key H did nothing"
keys h
keys F12
await test -s "$folder/pictures/chartflood/sphere_charts_001.png" || fail "no picture"
kill -0 $pid || fail "the program ended early"
keys ctrl q
await test -s "$folder/config/chartflood/config.json" || fail "it did not quit"
wait $pid || fail "exit code $?"
echo "passed"
