#!/usr/bin/env bash
# Builds chartflood and starts it with the given arguments. Without a display it segments and draws
# the same file into a picture instead.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
source "$root/assets/scripts/setup.sh"

install_packages run build
configure_release OFF
build_release chartflood

program=$root/build/release/chartflood

# True when an argument already asks for something that needs no window.
needs_no_window() {
  local argument
  for argument in "$@"; do
    case "$argument" in
      --) return 1 ;;
      --output* | --report* | --export-* | --info | --help | -h | --version | --list-*) return 0 ;;
    esac
  done
  return 1
}

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || needs_no_window "$@"; then
  exec "$program" "$@"
fi
picture=$root/build/chartflood.png
echo "There is no display, so no window can open: segmenting and drawing into a picture." >&2
"$program" --output="$picture" "$@"
echo "$picture"
