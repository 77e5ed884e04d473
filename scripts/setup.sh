# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Functions shared by the scripts and .ci/run, which source this file with the repository as working directory.
# All progress goes to standard error: standard output belongs to the results.

say() { printf '== %s\n' "$*" >&2; }

# fail MESSAGE...: prints one line a message and exits.
fail() {
  printf '%s\n' "$@" >&2
  exit 1
}

# install_build_packages: installs the packages needed to build shapegauge and its tests.
install_build_packages() { install_listed_packages scripts/packages.txt; }

# install_listed_packages FILE PACKAGE...: installs the packages that a file lists, one per line, and those named.
install_listed_packages() {
  local packages
  mapfile -t packages < <(grep -Ev '^(#|$)' "$1")
  install_packages "${packages[@]}" "${@:2}"
}

# missing_packages PACKAGE...: prints the Debian packages that are not installed, one a line.
missing_packages() {
  local package
  for package in "$@"; do
    dpkg-query --show --showformat='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || echo "$package"
  done
}

# install_packages PACKAGE...: installs missing Debian packages without asking.
install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "not a Debian system: the counterparts of these packages must be installed (docs/install.md): $*"
    return
  fi
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  [[ ${#missing[@]} -gt 0 ]] || return 0
  if [[ $EUID -ne 0 ]]; then
    command -v sudo >/dev/null ||
      fail "Packages are missing, and installing them takes root or sudo. As root, run:" \
        "  apt-get update && apt-get install --no-install-recommends ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  "${as_root[@]}" apt-get --quiet --option DPkg::Lock::Timeout=300 update >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet --yes --no-install-recommends \
    --option DPkg::Lock::Timeout=300 --option Dpkg::Use-Pty=0 install "${missing[@]}" </dev/null >&2
}

# build_jobs: prints the number of parallel compilers, with 2 GB each (a source that includes CGAL takes up to 1.3 GB).
build_jobs() {
  local cores memory limit
  cores=$(nproc)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1024) }' /proc/meminfo)
  # In a container the limit of the control group counts too.
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || echo max)
  [[ $limit == max || $((limit / 1048576)) -ge $memory ]] || memory=$((limit / 1048576))
  local jobs=$((memory / 2048))
  [[ $jobs -le $cores ]] || jobs=$cores
  [[ $jobs -ge 1 ]] || jobs=1
  echo "$jobs"
}

# build PRESET FOLDER TARGET...: configures if necessary, and builds the targets.
build() {
  local preset=$1 folder=$2
  shift 2
  if [[ ! -f $folder/build.ninja ]]; then
    say "configuring $folder"
    cmake --preset "$preset" >&2
  fi
  local jobs
  jobs=$(build_jobs)
  say "building in $folder, $jobs at a time"
  cmake --build "$folder" --parallel "$jobs" --target "$@" >&2
}
