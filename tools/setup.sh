# shellcheck shell=bash
# Shared by run, test, lint, bench/run.sh and fuzz/run.sh (sourced, not run): what must be installed, and how a build
# tree is configured and built. Progress goes to standard error; full output to build/*.log, shown when a step fails.

kerf_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$kerf_root" || exit 2
mkdir -p build

# The versions kerf is developed with: Debian 12 package and its upstream version.
kerf_versions='
g++                  12.2
clang                14.0
libclang-rt-14-dev   14.0
clang-format         14.0
clang-tidy           14.0
cmake                3.25
ninja-build          1.11
libfmt-dev           9.1
libcli11-dev         2.1
libtomlplusplus-dev  3.3
nlohmann-json3-dev   3.11
libexpected-dev      1.0
libgtest-dev         1.12
googletest           1.12
libbenchmark-dev     1.7
time                 1.9
'
kerf_packages_run='g++ cmake ninja-build libfmt-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libexpected-dev'
kerf_packages_test="$kerf_packages_run clang libclang-rt-14-dev clang-format libgtest-dev googletest"
# shellcheck disable=SC2034 # used by the scripts that source this one
kerf_packages_lint="$kerf_packages_test clang-tidy"
# shellcheck disable=SC2034
kerf_packages_bench="$kerf_packages_run libbenchmark-dev time"

kerf_say() { printf 'kerf: %s\n' "$*" >&2; }

# kerf_step TEXT LOG COMMAND...: one quiet step; on failure the end of its log and the exit status of the command.
kerf_step() {
  local text=$1 log=$2 status=0
  shift 2
  kerf_say "$text"
  "$@" >"$log" 2>&1 </dev/null || status=$?
  if [ "$status" -ne 0 ]; then
    tail -n 80 "$log" >&2
    kerf_say "failed: $text (status $status, all of it in ${log#"$kerf_root"/})"
  fi
  return "$status"
}

# kerf_installed PACKAGES...: one line "name version" for each installed one.
kerf_installed() {
  dpkg-query -W -f '${Package} ${Version} ${db:Status-Status}\n' "$@" 2>/dev/null |
    awk '$3 == "installed" { print $1, $2 }'
}

kerf_apt_install() {
  export DEBIAN_FRONTEND=noninteractive
  apt-get install -y --no-install-recommends "$@" ||
    { apt-get update && apt-get install -y --no-install-recommends "$@"; }
}

# Without dpkg nothing can be installed for the user: the tools must be there, CMake looks for the libraries.
kerf_need_tools() {
  local tool missing=''
  for tool in g++ cmake ninja; do
    command -v "$tool" >/dev/null || missing="$missing $tool"
  done
  [ -z "$missing" ] && return 0
  kerf_say "needs${missing}, and the development files of fmt, CLI11, toml++, nlohmann-json and tl-expected"
  exit 2
}

# kerf_require PACKAGES...: installs what is missing. Sets kerf_have: what is installed, with versions.
kerf_require() {
  local package missing=''
  if ! command -v dpkg-query >/dev/null; then
    kerf_need_tools
    kerf_have='no dpkg'
    return 0
  fi
  kerf_have=$(kerf_installed "$@")
  for package in "$@"; do
    case $'\n'$kerf_have in
      *$'\n'"$package "*) ;;
      *) missing="$missing $package" ;;
    esac
  done
  [ -z "$missing" ] && return 0
  if [ "$(id -u)" -ne 0 ]; then
    kerf_say "these packages are missing; install them and start again:"
    printf '  sudo apt-get update && sudo apt-get install -y --no-install-recommends%s\n' "$missing" >&2
    exit 2
  fi
  # shellcheck disable=SC2086 # a list of words
  kerf_step "installing:$missing" build/install.log kerf_apt_install $missing || exit 2
  kerf_have=$(kerf_installed "$@")
}

# Warns of versions that differ from those in the table: the build may still work, nobody has tried it.
kerf_warn_versions() {
  local package version wanted
  while read -r package version; do
    wanted=$(awk -v name="$package" '$1 == name { print $2 }' <<<"$kerf_versions")
    case ${version#*:} in
      "$wanted" | "$wanted".* | "$wanted"[+-]*) ;;
      *) [ -z "$wanted" ] || kerf_say "$package is $version; kerf is developed with $wanted" ;;
    esac
  done <<<"$kerf_have"
}

# kerf_build PRESET [TARGET...]: configures when something that was installed has changed, then builds.
kerf_build() {
  local preset=$1 dir=build/$1 targets=()
  shift
  [ $# -eq 0 ] || targets=(--target "$@")
  local stamp=$dir/.installed
  local key
  key="$kerf_root"$'\n'"$kerf_have"
  if [ ! -f "$dir/build.ninja" ] || [ ! -f "$stamp" ] || [ "$(<"$stamp")" != "$key" ]; then
    kerf_warn_versions
    kerf_step "configuring $preset" "build/$preset-configure.log" cmake --fresh --preset "$preset" || return 1
    kerf_step "building $preset (once; this takes some minutes)" "build/$preset-build.log" \
      cmake --build "$dir" -j "$(nproc)" "${targets[@]}" || return 1
    printf '%s\n' "$key" >"$stamp"
    return 0
  fi
  # Nothing to do is the usual case and stays silent; a rebuild after a change says so once it takes time.
  local timer status=0
  # The sleep outlives the kill and must not keep the caller's pipes open.
  { sleep 1 </dev/null >/dev/null 2>&1 && kerf_say "building $preset"; } &
  timer=$!
  cmake --build "$dir" -j "$(nproc)" "${targets[@]}" >"build/$preset-build.log" 2>&1 </dev/null || status=$?
  kill "$timer" 2>/dev/null
  wait "$timer" 2>/dev/null
  if [ "$status" -ne 0 ]; then
    tail -n 80 "build/$preset-build.log" >&2
    kerf_say "failed: building $preset (all of it in build/$preset-build.log)"
  fi
  return "$status"
}

# Every file of the project, build trees aside; works without git too.
kerf_files() {
  find . \( -name .git -o -name build -o -name 'build-*' -o -name .cache \) -prune -o -type f -print
}
