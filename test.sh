#!/usr/bin/env bash
# Builds chartflood with its tests and runs all of them without a display. Arguments go to ctest:
# ./test.sh -L unit, ./test.sh -R Presets, ..
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
source "$root/assets/scripts/setup.sh"

install_packages run build test
configure_release ON
build_release

export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(build_jobs)}
exec env -u DISPLAY -u WAYLAND_DISPLAY \
  ctest --test-dir "$root/build/release" --output-on-failure "$@"
