#!/usr/bin/env bash
# What an artist does with the sliders, in the real window: opens a model, tweaks five of them and
# sees finished charts with their texture each time, takes all back, tries three seeds, saves a
# picture and makes it again. What the window settled on is held against a batch run. Exit code 77
# (skipped) where xvfb-run or xdotool are missing. With a second argument, screenshots are kept in
# that folder.
set -u
source "$(dirname "${BASH_SOURCE[0]}")/window_support.sh"
if [ "$1" != --inside ]; then
  export STORY_SHOTS=${2:-}
  on_own_display "$0" 1280x800 "$1"
fi
program=$2 folder=$3
session=$folder/explore.chartflood
model=$folder/model.obj
options="charts sharp-angle speed-power speed-epsilon offset-damping best-of"

shot() {
  [ -z "$STORY_SHOTS" ] || { mkdir -p "$STORY_SHOTS"; import -window root "$STORY_SHOTS/$1.png"; }
}
value() { sed -n "s/^ *\"$1\": \(.*[^,]\),*$/\1/p" "$session" | head -1; }
save() {
  rm -f "$session"
  keys ctrl s
  await test -s "$session" || fail "the session was not saved: $1"
}
# The charts of the session against those of a batch run with its values.
labels() { # name
  settle
  save "$1"
  local words="" option
  for option in $options; do words="$words --$option=$(value $option)"; done
  "$program" "$session" --layout=square --export-labels="$folder/$1.txt" || fail "no labels: $1"
  "$program" "$model" $words --layout=square --export-labels="$folder/batch.txt" || fail "no batch: $1"
  cmp -s "$folder/$1.txt" "$folder/batch.txt" || fail "$1: the window settled on other charts than a batch run"
}

"$program" --sample=bumps --triangles=4000 --layout=square --export-mesh="$model" || fail "no model"
"$program" "$model" & pid=$!
shows scrubber || fail "no window"
await xdotool search --name "^model" || fail "the model was not opened"
shows uv || fail "it was not finished and laid flat by itself"
keys Escape
settle
keys ctrl s
shows browser-name || fail "no question for a name"
keys ctrl a
xdotool type --delay 30 "$session"; sleep 0.3
keys Return
await test -s "$session" || fail "the session was not saved"
labels opened
shot opened

click section/Balance || fail "no section of the balance"
shows offset-damping || fail "no row for beta"
for row in charts sharp-angle speed-power speed-epsilon offset-damping; do
  before=$(value $row)
  drag $row 40 50 62 50 || fail "no slider $row"
  labels $row
  [ "$(value $row)" != "$before" ] || fail "the slider $row did nothing"
  shows uv || fail "$row: no texture"
  shot $row
done
cmp -s "$folder/opened.txt" "$folder/offset-damping.txt" && fail "five sliders changed no chart"
for i in 1 2 3 4 5; do keys ctrl z; done
labels undone
cmp -s "$folder/opened.txt" "$folder/undone.txt" || fail "undo did not bring the first charts back"
shot undone

keys ctrl p
sleep 0.5
xdotool type --delay 30 "best-of 3"; sleep 0.3
keys Return
labels best
[ "$(value best-of)" = 3 ] || fail "best of 3 was not taken"
shot best

xdotool mousemove 2 400; sleep 0.5
keys F12
await eval "ls '$folder'/pictures/chartflood/*.png" || fail "no picture"
sleep 0.5
picture=$(ls -t "$folder"/pictures/chartflood/*.png | head -1)
cp "$picture" "$folder/picture.png"
"$program" --like="$folder/picture.png" --output="$folder/again.png" "$model" || fail "the picture cannot be made again"
test -s "$folder/again.png" || fail "no second picture"
"$program" "$model" --like="$folder/picture.png" --layout=square --export-labels="$folder/like.txt" \
  --output="$folder/again.png" || fail "the picture holds no charts"
cmp -s "$folder/best.txt" "$folder/like.txt" || fail "the picture holds other charts"
keys ctrl s
sleep 0.5
keys ctrl q
wait $pid || fail "exit code $?"
echo "the story ends well"
