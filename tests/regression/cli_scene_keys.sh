#!/usr/bin/env bash
# describe and list tell of the keys that a scene has beside its components; rules and uses name parameters.
source "$(dirname "$0")/expect.bash"

expect 0 list scene
keys=$(awk 'NR > 1 { print $1 }' <<<"$out")
for key in space time bodies accuracy checkpoint health plugins checks; do
    grep -qx "$key" <<<"$keys" || fail "list scene lacks $key: $keys"
done
# All of them, and nothing that chooses a component.
for key in $keys; do
    expect 0 describe "$key"
    says "$out" "$key (key of a scene)"
done
expect 0 describe time
says "$out" "max_steps: a whole number >= 1; optional"
says "$out" "refused (cfl): give \`step\` or \`cfl\`, not both"
expect 0 describe scene/checkpoint
says "$out" "keep: a whole number >= 1; default 2"
expect 0 describe bodies --json
python3 -c 'import json, sys; names = [p["name"] for p in json.load(sys.stdin)["parameters"]]; assert "velocity" in names' <<<"$out"
expect 0 describe scene
says "$out" "shape_function: a shape_function: an object with \"type\"; default"
expect 0 describe materials
says "$out" "neo_hookean"
expect 2 describe tiem
says "$err" 'did you mean "time"?'

expect 0 describe uniform
says "$out" "refused (cell_size): max - min must be"

# What goes with each quantity of a probe is a table.
expect 0 describe probe
says "$out" "What goes with each quantity"
grep -Eq "^  reaction +- +- +possible +- +- +needed +- *$" <<<"$out" || fail "no row of reaction: $out"
(($(grep -c refused <<<"$out") < 10)) || fail "rules of the table are told again: $out"
