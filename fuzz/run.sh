#!/usr/bin/env bash
# Fuzzes every target for a number of seconds each, from the committed seeds. New inputs go to build/fuzz/<target>; an
# input that breaks something is left there as crash-*, and the exit status is 1.
#   fuzz/run.sh [SECONDS, default 60] [--built: do not build first]
set -uo pipefail
# shellcheck source=tools/setup.sh
. "$(dirname "${BASH_SOURCE[0]}")/../tools/setup.sh"
seconds=${1:-60}
if [ "${2-}" != --built ]; then
  # shellcheck disable=SC2086 # a list of words
  kerf_require $kerf_packages_test
  kerf_build asan || exit 1
fi

status=0
for source in fuzz/*_fuzz.cpp; do
  target=$(basename "$source" .cpp)
  for corpus in fuzz/corpus/*/; do
    dialect=$(basename "$corpus")
    found=build/fuzz/$target/$dialect
    mkdir -p "$found"
    KERF_FUZZ_DIALECT=$dialect ASAN_OPTIONS=allow_addr2line=1 kerf_step "fuzzing $target with the $dialect seeds for $seconds s" \
      "build/fuzz/$target-$dialect.log" \
      "build/asan/fuzz/kerf_$target" "$found" "$corpus" -dict="fuzz/$dialect.dict" -seed=1 -max_len=4096 \
      -timeout=10 -rss_limit_mb=2048 -artifact_prefix="$found/" -max_total_time="$seconds" || status=1
  done
done
exit "$status"
