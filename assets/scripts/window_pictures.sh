#!/usr/bin/env bash
# Takes pictures of the real window in its sizes, themes and tabs, with the program that run.sh
# builds: every one into FOLDER, to be looked at, or without it the few of the README into
# assets/pictures. Needs xvfb, xdotool and imagemagick. PROGRAM in the
# environment names another program. Usage: window_pictures.sh [FOLDER [MODEL]]
set -u
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
source "$root/tests/gui/window_support.sh"

# The display of the size, the window's scale in it, the theme, and where the pictures go.
if [ "${1:-}" != --inside ]; then
  program=${PROGRAM:-$root/build/release/chartflood}
  export PICTURES_FOLDER=${1:-} PICTURES_MODEL=${2:-} PICTURES_SCALE PICTURES_THEME PICTURES_SIZE
  if [ -z "$PICTURES_FOLDER" ]; then
    PICTURES_SIZE=1280x800 PICTURES_SCALE=1 PICTURES_THEME=dark
    (on_own_display "$0" "$PICTURES_SIZE" "$program")
    exit
  fi
  mkdir -p "$PICTURES_FOLDER"
  PICTURES_FOLDER=$(cd "$PICTURES_FOLDER" && pwd -P)
  for size in "1024x640 1" "1280x800 1" "2560x1440 2"; do
    for theme in dark light high-contrast; do
      read -r PICTURES_SIZE PICTURES_SCALE <<< "$size"
      PICTURES_THEME=$theme
      (on_own_display "$0" "$PICTURES_SIZE" "$program")
    done
  done
  exit
fi
program=$2 folder=$3

shot() { # name
  if [ "$1" = flood ]; then sleep 0.7; else settle; fi # software drivers draw for a while
  if [ -n "$PICTURES_FOLDER" ]; then
    import -window root "$PICTURES_FOLDER/$PICTURES_SIZE-$PICTURES_THEME-$1.png"
  else
    case "$1" in # those that the README shows
      uv | compare) import -window root "$root/assets/pictures/window-$1.png" ;;
    esac
  fi
}
# Runs a line as the search for actions takes it.
line() {
  keys ctrl p
  xdotool type --delay 15 "$1"; sleep 0.4
  keys Return; sleep 0.4
}

mkdir -p "$XDG_CONFIG_HOME/chartflood" "$XDG_STATE_HOME/chartflood"
width=${PICTURES_SIZE%x*} height=${PICTURES_SIZE#*x}
cat > "$XDG_CONFIG_HOME/chartflood/config.json" <<< \
  "{\"theme\": \"$PICTURES_THEME\", \"ui-scale\": $PICTURES_SCALE, \"first-steps\": false}"
cat > "$XDG_STATE_HOME/chartflood/state.json" <<< \
  "{\"window-width\": $width, \"window-height\": $height}"
model=${PICTURES_MODEL:---sample=rocket}
"$program" "$model" & pid=$!
shows scrubber || fail "no window"
sleep 3
[ -z "$(rectangle first-steps)" ] || keys Escape
keys space; sleep 2.5; keys space
shot flood
keys Return
[ -n "$(rectangle tab/UV)" ] || keys u
shows uv || fail "it was not laid flat"
sleep 4
for tab in UV Charts sphere Plots; do
  [ -n "$(rectangle "tab/$tab")" ] || continue
  click "tab/$tab"
  xdotool mousemove $(place view 50 50)
  shot "${tab,,}"
done
click tab/UV
keys shift F12; shot dialog; keys Escape
line "compare-methods"; sleep 2; hides progress; shot compare
kill $pid
