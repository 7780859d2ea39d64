#!/usr/bin/env bash
# Text that must not be in the tree: absolute paths of somebody's machine, notes to do later, switched-off tests,
# conflict marks. Usage: tools/check_tree.sh
set -euo pipefail
# shellcheck source=tools/setup.sh
. "$(dirname "$0")/setup.sh"

status=0
# forbid WHAT PATTERN: the patterns are written so that this file does not match itself.
forbid() {
  local hits
  hits=$(kerf_files | grep -v -e '^\./fuzz/corpus/' -e '^\./LICENSE$' | tr '\n' '\0' |
    xargs -0 grep -nIE "$2" /dev/null || true)
  [ -z "$hits" ] && return 0
  printf '%s\n%s\n' "tree: $1:" "$hits" >&2
  status=1
}

forbid 'an absolute path of one machine' '(^|[^A-Za-z0-9_.$}{*-])/(wor[k]|hom[e]|roo[t]|tm[p]|User[s])/'
forbid 'a note to do later' '\b(TOD[O]|FIXM[E]|XX[X])\b'
forbid 'a switched-off test' '(GTEST_SKI[P]|DISABLE[D]_[A-Z])'
forbid 'a conflict mark' '^(<{7}|>{7}|\|{7})( |$)'
exit "$status"
