#!/usr/bin/env bash
# A folder of src/ includes only from itself and from the folders below it in the architecture: those that stand
# before it in this list; src/main.cpp includes from any. Usage: tools/check_layers.sh [SRC_DIR]
set -euo pipefail
layers='base geometry syntax machine execute dialect toolpath motion report cli'
src=${1:-$(cd "$(dirname "$0")/.." && pwd)/src}

for folder in "$src"/*/; do
  name=$(basename "$folder")
  case " $layers " in
    *" $name "*) ;;
    *) echo "layers: src/$name is not in the list of tools/check_layers.sh" >&2; exit 1 ;;
  esac
done

find "$src" \( -name '*.hpp' -o -name '*.cpp' \) -print0 | sort -z |
  xargs -0 -r awk -v layers="$layers" -v src="$src" '
    BEGIN {
      n = split(layers, list, " ")
      for (i = 1; i <= n; ++i) rank[list[i]] = i
    }
    FNR == 1 {
      file = FILENAME
      sub("^" src "/", "", file)
      split(file, parts, "/")
      own = parts[1]
      if (!(own in rank)) rank[own] = n + 1  # src/main.cpp stands above all folders
    }
    /^[ \t]*#[ \t]*include[ \t]*"/ {
      header = $0
      sub(/^[^"]*"/, "", header)
      sub(/".*/, "", header)
      split(header, parts, "/")
      if (!(parts[1] in rank)) {
        printf "layers: src/%s:%d includes \"%s\", which does not begin with a folder of src/\n", file, FNR, header
        bad = 1
      } else if (rank[parts[1]] > rank[own]) {
        printf "layers: src/%s:%d includes \"%s\": %s stands above %s\n", file, FNR, header, parts[1], own
        bad = 1
      }
    }
    END { exit bad }' >&2
