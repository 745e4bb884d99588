#!/usr/bin/env bash
# list, describe and schema.
source "$(dirname "$0")/expect.bash"

is_json() { python3 -m json.tool >/dev/null <<<"$1" || fail "not JSON: $1"; }

expect 0 list
says "$out" "neo_hookean"
says "$out" "shape_function"
expect 0 list material
says "$out" "neo_hookean"
[[ $out != *shape_function* ]] || fail "list material lists other kinds"
expect 0 list --json
is_json "$out"
expect 2 list materials
says "$err" 'did you mean "material"?'

expect 0 describe neo_hookean
says "$out" "poissons_ratio"
expect 0 describe material/neo_hookean --json
is_json "$out"
expect 0 describe material
says "$out" "neo_hookean"
expect 2 describe neo_hokean
says "$err" 'did you mean "neo_hookean"?'

expect 0 schema
is_json "$out"
says "$out" "neo_hookean"
