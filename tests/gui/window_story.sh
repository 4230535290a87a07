#!/usr/bin/env bash
# What a user does in a first half hour, in the real window: opens a model, runs, scrubs, adds and
# drags a seed, turns a slider, undoes, compares, takes pictures, saves, quits and comes back. What
# happened is read from the session file and from the pictures. Exit code 77 (skipped) where
# xvfb-run or xdotool are missing. With a second argument, screenshots are kept in that folder.
set -u
source "$(dirname "${BASH_SOURCE[0]}")/window_support.sh"
if [ "$1" != --inside ]; then
  export STORY_SHOTS=${2:-}
  on_own_display "$0" 1280x800 "$1"
fi
program=$2 folder=$3
session=$folder/story.chartflood

# A screenshot of the whole display, where wanted and possible.
shot() {
  [ -z "$STORY_SHOTS" ] || { mkdir -p "$STORY_SHOTS"; import -window root "$STORY_SHOTS/$1.png"; }
}
# Saves over the session file and waits until it is written.
save() {
  rm -f "$session"
  keys ctrl s
  await test -s "$session" || fail "the session was not saved: $1"
}
value() { sed -n "s/^ *\"$1\": \(.*[^,]\),*$/\1/p" "$session" | head -1; }
labels() {
  "$program" "$session" --layout=square --export-labels="$folder/labels-$1.txt" || fail "no labels: $1"
}
seeds() { sed -n '/^ "seeds"/,/^ \]/p' "$session"; }
# The only picture file that was not there before.
picture() {
  local before after
  before=$(ls "$folder"/pictures/chartflood/*.png 2> /dev/null | wc -l)
  xdotool mousemove 2 400; sleep 0.5
  keys F12
  await eval "[ \$(ls '$folder'/pictures/chartflood/*.png | wc -l) -gt $before ]" || fail "no picture: $1"
  sleep 0.3
  cp "$(ls -t "$folder"/pictures/chartflood/*.png | head -1)" "$folder/$1.png"
}

"$program" --sample=rocket --triangles=3000 --layout=square --export-mesh="$folder/model.obj" \
  || fail "no model"

"$program" & pid=$!
shows scrubber || fail "no window"
shows first-steps || fail "no first-run card"
shot first-run
keys ctrl o
shows browser-name || fail "the file browser did not open"
xdotool type --delay 30 "$folder/model.obj"; sleep 0.3
keys Return
hides browser-name || fail "the file browser did not close"
await xdotool search --name "^model" || fail "the model was not opened"
sleep 1
keys Return # run to the end
sleep 2
shot running
shows uv || fail "it was not laid flat"
keys ctrl s
shows browser-name || fail "no question for a name"
keys ctrl a
xdotool type --delay 30 "$session"; sleep 0.3
shot save-as
keys Return
await test -s "$session" || fail "the session was not saved"
grep -q '"file": ".*model.obj"' "$session" || fail "another model is saved"
[ "$(value charts)" = 20 ] || fail "K is $(value charts)"

picture end
drag scrubber 90 50 40 50 || fail "no scrubber"
picture middle
shot scrubbed
cmp -s "$folder/end.png" "$folder/middle.png" && fail "scrubbing changes nothing"
keys End
picture again
cmp -s "$folder/end.png" "$folder/again.png" || fail "the end of the run does not come back"

keys g
click view 50 55 || fail "no view"
save "a seed more"
[ "$(value charts)" = 21 ] || fail "a click added no seed"
seeds > "$folder/seeds-1"
drag view 50 55 50 45
save "a seed moved"
seeds > "$folder/seeds-2"
cmp -s "$folder/seeds-1" "$folder/seeds-2" && fail "the seed was not dragged"
shot seeds
keys v

click tab/UV
drag sharp-angle 25 50 60 50 || fail "no slider"
save "T_a"
[ "$(value sharp-angle)" != 45.0 ] || fail "the slider did nothing"
keys ctrl z
save "undo"
[ "$(value sharp-angle)" = 45.0 ] || fail "undo left T_a at $(value sharp-angle)"
keys ctrl z
save "undo"
seeds | cmp -s - "$folder/seeds-1" || fail "undo did not put the seed back"
keys ctrl shift z
save "redo"
seeds | cmp -s - "$folder/seeds-2" || fail "redo did not move the seed again"

# Compare: what is stored on the left, the live charts on the right.
click menu/Compare && shows "menu\/store A" && click "menu/store A" || fail "nothing to store with"
shows "caption\/A" || fail "A is not shown"
shows "caption\/Live" || fail "the live side is not shown"
drag charts 60 50 30 50 || fail "no slider"
sleep 2
save "K"
[ "$(value charts)" != 21 ] || fail "the slider changed no K"
shot side-by-side
drag view/A 50 50 70 50
shot turned
click menu/Compare && shows menu/wipe && click menu/wipe || fail "no wipe"
shows wipe-line || fail "no line to drag"
drag wipe-line 50 20 400 20
shot wipe
click "use A" || fail "A cannot be used"
sleep 2
save "A again"
[ "$(value charts)" = 21 ] || fail "A does not come back"
seeds | cmp -s - "$folder/seeds-2" || fail "the seeds of A do not come back"
click menu/Compare && shows menu/clear-compare && click menu/clear-compare || fail "no way out"
hides wipe-line || fail "the comparison does not end"

# Pictures, and the way back to it all.
click tab/UV
picture before
save "the end"
keys ctrl q
wait $pid || fail "exit code $?"
labels before
rm "$folder/probe.json"  # of the window that was closed
export CHARTFLOOD_FRAME_LOG=$folder/passes
"$program" "$session" & pid=$!
shows scrubber || fail "the saved session does not open"
picture after
shot reopened
save "once more"
# A window that nobody touches stands still. It may take a while until what was said has faded.
passes() { wc -l < "$CHARTFLOOD_FRAME_LOG"; }
rests() { local before; before=$(passes); sleep 2; [ "$(passes)" = "$before" ]; }
xdotool mousemove 2 400
await rests || fail "the resting window goes on drawing"
labels after
cmp -s "$folder/labels-before.txt" "$folder/labels-after.txt" || fail "other charts after the break"
keys ctrl q
wait $pid || fail "exit code $?"
echo "passed"
