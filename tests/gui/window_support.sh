# Drives the real window by the rectangles that it writes to a file; sourced by the scripts beside it.
# Expects: $program, $folder. Exit code 77 (skipped) where a tool is missing.

# Runs the calling script again, inside a display of its own, in a home of its own.
on_own_display() { # script size program
  local tool
  for tool in xvfb-run xdotool; do
    command -v "$tool" > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
  done
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  unset WAYLAND_DISPLAY
  export HOME=$folder XDG_CONFIG_HOME=$folder/config XDG_STATE_HOME=$folder/state
  export XDG_PICTURES_DIR=$folder/pictures CHARTFLOOD_PROBE_FILE=$folder/probe.json
  xvfb-run -a -s "-screen 0 $2x24" "$1" --inside "$3" "$folder"
  exit
}

fail() { echo "failed: $1"; kill "$pid" 2> /dev/null; exit 1; }

# Repeats a command until it works, 40 seconds at most.
await() {
  local i
  for i in $(seq 400); do "$@" > /dev/null 2>&1 && return 0; sleep 0.1; done
  return 1
}

# Left, top, right, bottom of a widget.
rectangle() { sed -n "s/^  \"${1//\//\\/}\": \[\(.*\)\],*$/\1/p" "$folder/probe.json" | tr -d ,; }

# Pixel of a widget at shares of its width and height, in per cent.
place() { # widget x y
  set -- $(rectangle "$1") "$2" "$3"
  [ $# = 6 ] || return 1
  echo $(($1 + ($3 - $1) * $5 / 100)) $(($2 + ($4 - $2) * $6 / 100))
}

click() { # widget [x y]
  local at
  at=$(place "$1" "${2:-50}" "${3:-50}") || return 1
  xdotool mousemove $at; sleep 0.3
  xdotool mousedown 1; sleep 0.3; xdotool mouseup 1; sleep 0.3
}

# Presses at one place of a widget, moves to another in ten steps, lets go.
drag() { # widget x1 y1 x2 y2
  local i at
  at=$(place "$1" "$2" "$3") || return 1
  xdotool mousemove $at; sleep 0.3; xdotool mousedown 1; sleep 0.2
  for i in 1 2 3 4 5 6 7 8 9 10; do
    at=$(place "$1" $(($2 + ($4 - $2) * i / 10)) $(($3 + ($5 - $3) * i / 10)))
    xdotool mousemove $at; sleep 0.05
  done
  sleep 0.3; xdotool mouseup 1; sleep 0.3
}

# Each key stays down for a while, as under a finger: what comes and goes between two frames of a
# slow display is missed.
keys() { # [modifier..] key
  local i
  for ((i = 1; i <= $#; ++i)); do xdotool keydown "${!i}"; sleep 0.15; done
  for ((i = $#; i > 0; --i)); do xdotool keyup "${!i}"; sleep 0.1; done
  sleep 0.2
}

shows() { await grep -q "\"$1\"" "$folder/probe.json"; }
hides() { local i; for i in $(seq 400); do grep -q "\"$1\"" "$folder/probe.json" || return 0; sleep 0.1; done; return 1; }

# Hundredths of a second of processor time that the program has taken.
ticks() { awk '{ print $14 + $15 }' "/proc/$pid/stat"; }
# Waits until the program has been quiet for a second, a minute at most.
settle() {
  local before after i
  for i in $(seq 60); do
    before=$(ticks); sleep 1; after=$(ticks)
    [ $((after - before)) -le 2 ] && return
  done
}
