#!/usr/bin/env bash
# Measures kerf and prints Markdown tables: the micro benchmarks, then whole processes on a finishing program of a
# million blocks, beside LinuxCNC's stand-alone interpreter (rs274 -g) when it is installed. Medians of the repetitions.
#   bench/run.sh [--with-linuxcnc] [--blocks N] [--repetitions N] [--no-micro]
# --with-linuxcnc installs the Debian package linuxcnc-uspace for the comparison.
set -uo pipefail
# shellcheck source=tools/setup.sh
. "$(dirname "${BASH_SOURCE[0]}")/../tools/setup.sh"

blocks=1000000
repetitions=5
micro=1
packages=$kerf_packages_bench
while [ $# -gt 0 ]; do
  case $1 in
    --with-linuxcnc) packages="$packages linuxcnc-uspace" ;;
    --blocks) blocks=$2; shift ;;
    --repetitions) repetitions=$2; shift ;;
    --no-micro) micro=0 ;;
    *) kerf_say "unknown option $1"; exit 2 ;;
  esac
  shift
done
# shellcheck disable=SC2086 # a list of words
kerf_require $packages
# shellcheck disable=SC2086 # the build does not depend on LinuxCNC
kerf_require $kerf_packages_bench
kerf_build bench || exit 1
kerf=build/bench/kerf
work=build/bench-work
mkdir -p "$work"

kerf_step "writing a program of $blocks blocks" build/bench-input.log bash -c "
  set -e
  awk -v blocks=$blocks -f bench/three_axes.awk > $work/three_axes.nc
  g++ -std=c++20 -O2 tools/make_finishing.cpp -o $work/make_finishing
  $work/make_finishing $blocks > $work/finishing.nc
  $work/make_finishing 20000 > $work/small.nc
  mkdir -p $work/store
  awk -v folder=$work/store -f bench/melsec_store.awk
  mkdir -p $work/contour
  awk -v folder=$work/contour -f bench/melsec_contour.awk" || exit 1
printf '%%\n#101=0\nWHILE [#101 LT 10000000] DO1\n#101=#101+1\nEND1\nM02\n%%\n' >"$work/loop.gcd"
# The same lines for the OMRON controller: other words around them.
sed -e '/^%$/d' -e 's/^M02$/M30/' "$work/three_axes.nc" >"$work/omron.nc"
printf 'L0=0\nwhile(L0<10000000) L0=L0+1\nM30\n' >"$work/loop.nc"
# rs274 wants to know the tool and has no eight-digit program number.
printf 'T7 P7 Z+48.0 D+4.0 ;ball nose\n' >"$work/tool.tbl"
sed -e 's/^O00000104$/(O104)/' "$work/finishing.nc" >"$work/finishing.ngc"

# once COMMAND...: seconds and peak memory in MiB of one run.
once() {
  local report=$work/time.txt
  if ! /usr/bin/time -f '%e %M' -o "$report" "$@" >/dev/null 2>"$work/stderr.txt"; then
    tail -n 20 "$work/stderr.txt" >&2
    kerf_say "failed: $*"
    return 1
  fi
  awk 'END { printf "%.3f %.1f\n", $1, $2 / 1024 }' "$report"
}

# measure NAME COMMAND...: prints a row and remembers the median time in $median.
measure() {
  local name=$1 i rows=''
  shift
  for ((i = 0; i < repetitions; ++i)); do
    rows+=$(once "$@")$'\n' || exit 1
  done
  median=$(sort -n <<<"$rows" | awk 'NF == 2 { t[++n] = $1 } END { print n % 2 ? t[(n + 1) / 2] : (t[n / 2] + t[n / 2 + 1]) / 2 }')
  awk -v name="$name" -v median="$median" -v base="${base-}" -v lines="$lines" '
    NF == 2 {
      if (min == "" || $1 < min) min = $1
      if ($1 > max) max = $1
      if ($2 > memory) memory = $2
    }
    END {
      if (median == 0) median = 0.005  # below the step of the clock
      ratio = base == "" ? "1.0" : sprintf("%.1f", median / (base == 0 ? 0.005 : base))
      printf "| `%s` | %.2f | %.2f to %.2f | %.2f | %.0f | %s |\n", name, median, min, max,
             lines / median / 1e6, memory, ratio
    }' <<<"$rows"
}

printf '\nMachine: %s, %s cores. Compiler: %s.\n' \
  "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)" "$(nproc)" "$(g++ --version | head -n 1)"

if [ "$micro" -eq 1 ] && [ -x build/bench/bench/kerf_bench ]; then
  kerf_say "micro benchmarks, $repetitions repetitions"
  build/bench/bench/kerf_bench --benchmark_repetitions="$repetitions" --benchmark_report_aggregates_only=true \
    --benchmark_format=csv >"$work/micro.csv" 2>"$work/micro.log" ||
    { tail -n 20 "$work/micro.log" >&2; exit 1; }
  printf '\n| micro benchmark | median time | items/s |\n| --- | ---: | ---: |\n'
  awk -F, '
    $1 ~ /_median"?$/ {
      gsub(/"/, "", $1)
      sub(/_median$/, "", $1)
      printf "| %s | %.4g %s | %s |\n", $1, $4, $5, $7 == "" ? "" : sprintf("%.3g", $7)
    }' "$work/micro.csv"
fi

# heading TITLE BLOCKS BYTES
heading() {
  lines=$2
  base=''
  kerf_say "$1, $lines blocks, $repetitions repetitions each"
  printf '\n%s: %s blocks, %s MB; whole process from start to end, %s repetitions.\n\n' \
    "$1" "$lines" "$(awk -v b="$3" 'BEGIN { printf "%.1f", b / 1e6 }')" "$repetitions"
  printf '| command | median s | range s | million blocks/s | peak MiB | time / `kerf path` |\n'
  printf '| --- | ---: | ---: | ---: | ---: | ---: |\n'
}

# table TITLE FILE.nc [FILE.ngc]: the commands on one program, beside rs274 on its own copy of it.
table() {
  heading "$1" "$(wc -l <"$2")" "$(wc -c <"$2")"
  measure 'kerf path --quiet' "$kerf" path --quiet "$2"
  base=$median
  measure 'kerf check' "$kerf" check "$2"
  measure 'kerf path --json' "$kerf" path --json "$2"
  measure 'kerf run' "$kerf" run "$2"
  measure 'kerf run --report' "$kerf" run --report "$work/report.html" "$2"
  if [ -n "${3-}" ] && command -v rs274 >/dev/null; then
    # What it writes is thrown away as the others' output is; -g leaves the motion queue out.
    measure 'rs274 -g (LinuxCNC)' rs274 -g -t "$work/tool.tbl" "$3"
  fi
}

command -v rs274 >/dev/null ||
  kerf_say 'LinuxCNC is not installed: bench/run.sh --with-linuxcnc compares with it'
table 'Three axes, four decimals' "$work/three_axes.nc" "$work/three_axes.nc"
table 'A finishing program' "$work/finishing.nc" "$work/finishing.ngc"
table 'A short finishing program' "$work/small.nc"

variables='--set melsec.system.common_system_points=100 --set melsec.system.common_system_start_device=D2000'
heading 'MELSEC: four subprograms, called thirteen times' 988110 "$(cat "$work"/store/*.gcd | wc -c)"
# shellcheck disable=SC2086 # a list of words
measure 'kerf path --quiet' "$kerf" path --quiet $variables "$work/store/O001.gcd"
base=$median
# shellcheck disable=SC2086 # a list of words
measure 'kerf run' "$kerf" run $variables "$work/store/O001.gcd"

heading 'MELSEC: a contour, plain and with tool radius compensation' 988110 "$(cat "$work"/contour/O00[2-6].gcd | wc -c)"
base=
# shellcheck disable=SC2086 # a list of words
measure 'kerf path --quiet, G40' "$kerf" path --quiet $variables --set tools.1.radius=5 "$work/contour/O006.gcd"
base=$median
# shellcheck disable=SC2086 # a list of words
measure 'kerf path --quiet, G42' "$kerf" path --quiet $variables --set tools.1.radius=5 "$work/contour/O007.gcd"

heading 'MELSEC: a loop of ten million turns, three statements each' 30000000 "$(wc -c <"$work/loop.gcd")"
base=
# shellcheck disable=SC2086 # a list of words
measure 'kerf path --quiet' "$kerf" path --quiet $variables "$work/loop.gcd"

heading 'OMRON: three axes, four decimals' "$(wc -l <"$work/omron.nc")" "$(wc -c <"$work/omron.nc")"
base=
measure 'kerf path --quiet' "$kerf" path --quiet --dialect omron "$work/omron.nc"
base=$median
measure 'kerf run' "$kerf" run --dialect omron "$work/omron.nc"

heading 'OMRON: a loop of ten million additions' 20000000 "$(wc -c <"$work/loop.nc")"
base=
measure 'kerf path --quiet' "$kerf" path --quiet --dialect omron "$work/loop.nc"
