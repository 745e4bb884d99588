#!/usr/bin/env bash
# A plugin's mistake is told in a sentence, once. Usage: sdk_mistakes.sh COMPILER OPTION...
set -euo pipefail
source=$(dirname "$0")/sdk_mistakes.cpp
said=$("$@" -fsyntax-only "$source" 2>&1) && { echo "sdk_mistakes: it compiles" >&2; exit 1; }

fail() { echo "sdk_mistakes: $*"$'\n'"$said" >&2; exit 1; }
while IFS= read -r sentence; do
    times=$(grep -cF "static assertion failed: $sentence" <<<"$said") || true
    ((times == 1)) || fail "told $times times: $sentence"
done <<'end'
a pointwise material has a function `template <class Point> auto squared_wave_speed
a pointwise material has a function `template <class Point> auto update
a component describes its parameters
a component derives, publicly, from the interface of the kind
a component is made from its parameters
a component overrides every function that its interface declares
a shape's kernel says how many nodes a particle reaches
a condition on a Pack has a truth for each particle
end
# The functions that are missing are named.
grep -qF 'matpoint::Output::write' <<<"$said" || fail "write is not named"
lines=$(wc -l <<<"$said")
((lines <= 8 * 16)) || fail "$lines lines for eight mistakes"
