#!/usr/bin/env bash
# same_results.sh MATPOINT OTHER: builds for two kinds of processor agree to rounding, in particles, energies and momentum.
other=$(realpath "$2")
source "$(dirname "$0")/expect.bash"

tables='/outputs=[{ "type": "csv", "every": "25 ms", "fields": ["velocity", "stress"] }]'
for shape in linear gimp bspline; do
    arguments=(run block.json --set "$tables" --set "/shape_function/type=\"$shape\"" --quiet --output)
    expect 0 "${arguments[@]}" "$shape/one"
    "$other" "${arguments[@]}" "$shape/other"
    for table in "$shape"/one/*.csv; do
        "$here/same_table.py" "$table" "$shape/other/${table##*/}" 1e-9
    done
    python3 - "$shape"/{one,other}/summary.json <<'END'
import json, math, sys
one, other = (json.load(open(file)) for file in sys.argv[1:])
assert one["instruction_set"] != other["instruction_set"], "twice the same build"
one, other = one["final"], other["final"]
for energy in ("kinetic_energy", "strain_energy", "external_work"):
    assert math.isclose(one[energy], other[energy], rel_tol=1e-9), (energy, one[energy], other[energy])
assert math.dist(one["momentum"], other["momentum"]) <= 1e-9 * math.hypot(*one["momentum"]), (one["momentum"], other["momentum"])
END
done
