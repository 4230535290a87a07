# shellcheck shell=bash
# shellcheck disable=SC2154  # root is set by the script that reads this one
# Shared by run.sh and test.sh: installs missing Debian packages and configures the release build.
# Expects $root, the folder of the checkout. Says nothing when there is nothing to do.

# The packages of the list that are marked with one of the given words.
listed_packages() {
  local kinds=" $* " name kind _
  while read -r name kind _; do
    case "$name" in '' | '#'*) continue ;; esac
    case "$kinds" in *" $kind "*) printf '%s\n' "$name" ;; esac
  done < "$root/apt-packages.txt"
}

# Installs those of the listed packages that are missing. Needs no network when none is.
install_packages() {
  local wanted=() missing=()
  if ! command -v dpkg-query > /dev/null; then
    echo "This is no Debian: install what apt-packages.txt names with your own package manager." >&2
    return 0
  fi
  mapfile -t wanted < <(listed_packages "$@" | sort -u)
  # The query fails when a package is unknown, and then still lists the others.
  mapfile -t missing < <(comm -23 <(printf '%s\n' "${wanted[@]}") <({
    dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${wanted[@]}" 2> /dev/null || true
  } | sed -n 's/^installed //p' | sort -u))
  [ ${#missing[@]} -eq 0 ] && return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo > /dev/null; then
      echo "Packages are missing and sudo is not there. As root, run: apt-get install ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing Debian packages: ${missing[*]}" >&2
  "${as_root[@]}" apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# Configures build/release unless it is already (or the tests are asked for and were left out).
configure_release() {
  local tests=$1 cache="$root/build/release/CMakeCache.txt"
  if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    # The checkout was moved or copied: what CMake remembers belongs to another place.
    rm -rf "$cache" "$root/build/release/CMakeFiles" "$root/build/release/build.ninja"
  fi
  if [ -f "$root/build/release/build.ninja" ]; then
    [ "$tests" = OFF ] && return 0
    grep -qx 'CHARTFLOOD_TESTS:BOOL=ON' "$cache" && return 0
  fi
  # Most of a first build is reading the same headers again: several files at once take less than half
  # the time. Who works on the sources configures without it and rebuilds single files.
  (cd "$root" && cmake --preset release -DCHARTFLOOD_TESTS="$tests" \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8 > /dev/null)
}

# One compiler a core, and no more than one for each 1.5 GB of memory.
build_jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemTotal:/ { print int($2 / 1500000) }' /proc/meminfo)
  [ "$memory" -lt 1 ] && memory=1
  echo $((cores < memory ? cores : memory))
}

# Builds the given targets (all when none is given); ninja's output goes to standard error.
build_release() {
  local target targets=()
  for target in "$@"; do targets+=(--target "$target"); done
  (cd "$root" && cmake --build --preset release --parallel "$(build_jobs)" "${targets[@]}") \
    | sed '/^ninja: no work to do\.$/d' >&2
}
