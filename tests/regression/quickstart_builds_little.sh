#!/usr/bin/env bash
# What apps/quickstart configures builds for one instruction set and precision, each plugin once, and most of the kernel's files in groups.
# Usage: quickstart_builds_little.sh SOURCE
set -euo pipefail
source=$1
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT
fail() { echo "quickstart_builds_little: $*" >&2; exit 1; }

read -ra options < <(sed -n 's/^cmake --preset release \(.*\) --log-level.*/\1/p' "$source/apps/quickstart")
cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${options[@]}" --log-level=WARNING >/dev/null
ninja -C "$build" -t commands all | grep -- ' -c ' >"$build/compilations"
count() { grep --count --extended-regexp -- "$1" "$build/compilations" || true; }

sets=$(grep -o -- '-march=[^ ]*' "$build/compilations" | sort --unique | wc -l)
((sets <= 1)) || fail "builds for $sets instruction sets"
for plugin in "$source"/plugins/*/*/; do
    (($(count "/$(basename "$(dirname "$plugin")")/$(basename "$plugin")/CMakeFiles/.*\.o ") >= 1)) || fail "does not build $plugin"
done
(($(count '-DMATPOINT_WITHOUT_SINGLE') == $(wc -l <"$build/compilations"))) || fail "builds single precision"
linear=$(count '/linear\.cpp$')
((linear == 1)) || fail "compiles linear.cpp $linear times"
groups=$(count 'matpoint_common\.dir') files=$(find "$source/framework/src" -name '*.cpp' | wc -l)
((3 * groups < files)) || fail "compiles the kernel's $files files as $groups, which are too many"
