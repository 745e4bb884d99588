#!/usr/bin/env bash
# `matpoint limits` on a case that can be worked out by hand, on ranges without a limit, and going on.
source "$(dirname "$0")/expect.bash"

query() { python3 -c 'import json, sys; v = json.load(open(sys.argv[1]))["variants"]; print(eval(sys.argv[2]))' "$@"; }

# A bar with wave speed 1 and cell size 1, two particles a cell at 1/4 and 3/4, linear shape functions, usf. Of a wave with
# u = sin^2(k/2), an acceleration of the nodes comes back from the particles 1 - 3u/4 times as large, so w^2 = 4 u (1 - 3u/4).
# That is largest for u = 2/3, w = 2/sqrt(3), and the limit is 2/w = sqrt(3) = 1.7320.
cat >bar.json <<'END'
{ "matpoint": 1, "space": { "dimension": 1 }, "grid": { "type": "uniform", "min": [0], "max": [40], "cell_size": 1 },
  "shape_function": { "type": "linear" }, "transfer": { "type": "flip" }, "integrator": { "type": "usf" },
  "time": { "end": 2000, "step": 0.1 }, "health": { "unstable_step": "ignore", "energy_gain": 1e9 },
  "materials": { "unit": { "type": "linear_elastic", "density": 1, "youngs_modulus": 1 } },
  "bodies": { "bar": { "material": "unit", "velocity": ["x < 13 ? 1e-9 : 0"], "geometry": { "type": "box", "min": [0], "max": [40] } } },
  "boundary_conditions": [ { "type": "fixed", "on": ["x_min", "x_max"] } ] }
END
cat >limits.json <<'END'
{ "scene": "bar.json",
  "vary": { "/materials/unit/youngs_modulus": [1, 4] },
  "search": { "pointer": "/time/step", "from": 0.5, "to": 4, "digits": 3 }, "stable": { "summary": "/final/kinetic_energy", "below": 1e-12 } }
END
expect 0 limits limits.json
says "$out" "youngs_modulus=4"
[[ $(query out/limits/limits.json '[(r["limit"], r["unstable"]) for r in v]') == "[(1.73, 1.74), (0.866, 0.867)]" ]] \
    || fail "limits: $out"
[[ -f out/limits/limits.html && $(wc -l <out/limits/limits.csv) == 3 ]] || fail "files are missing"

# A second call runs nothing; one with fewer digits finds its values on the way.
touch -d '1 minute ago' out/limits/runs/*/summary.json
touch mark
expect 0 limits limits.json --quiet
[[ -z $out$err && -z $(find out/limits/runs -name summary.json -newer mark) ]] || fail "run again"

# Ranges without a limit, and a search from the other end.
sed 's/"to": 4/"to": 0.8/' limits.json >low.json
expect 0 limits low.json
says "$out" "stable at the end of the range"
[[ $(query out/low/limits.json '[r["status"] for r in v]') == "['stable_everywhere', 'stable_everywhere']" ]] || fail "$out"
sed 's/0.5, "to": 4/2.1, "to": 4/' limits.json >high.json
expect 1 limits high.json
says "$out" "unstable everywhere"
sed -e 's,/time/step,/materials/unit/density,' -e 's,"/materials/unit/youngs_modulus": \[1\, 4\],"/time/step": [1],' \
    -e 's/0.5, "to": 4, "digits": 3/0.1\, "to": 10\, "digits": 2\, "largest": false/' limits.json >density.json
expect 0 limits density.json
[[ $(query out/density/limits.json '(v[0]["limit"], v[0]["unstable"])') == "(0.34, 0.33)" ]] || fail "smallest density 1/3: $out"

# A range that leaves what the parameter takes, at either end or between, is a mistake: nothing is run.
sed 's,/time/step,/materials/unit/poissons_ratio,; s/"from": 0.5/"from": 0.1/; s/"to": 4/"to": 0.7/' limits.json >outside.json
expect 2 limits outside.json --output none
says "$err" "outside.json:3:"
says "$err" "/search/to: /materials/unit/poissons_ratio: expected a number > -1 and < 0.5, got 0.7"
sed 's,/time/step,/materials/unit/poissons_ratio,; s/"from": 0.5/"from": -3/; s/"to": 4/"to": 0.3/' limits.json >outside.json
expect 2 limits outside.json --output none
says "$err" "/search/from: /materials/unit/poissons_ratio"
sed 's,/time/step,/time/max_steps,; s/"from": 0.5/"from": 1/; s/"to": 4/"to": 5/' limits.json >outside.json
expect 2 limits outside.json --output none
says "$err" "/search: /time/max_steps: expected a whole number"
[[ ! -e none ]] || fail "something was run"

# A variant that the range does not suit is a row.
sed 's,"/materials/unit/youngs_modulus": \[1\, 4\],"/integrator/type": ["usf"\, "usl"]\, "/transfer": [{"type": "flip"}\, {"type": "flip"\, "gradient_enhanced": true}],; s/"digits": 3/"digits": 1/' \
    limits.json >suits.json
expect 0 limits suits.json
[[ $(query out/suits/limits.json '[r["status"] == "refused" for r in v]') == "[False, True, False, False]" ]] || fail "$out"
[[ $(query out/suits/limits.json 'v[1]["trials"]') == "[]" ]] || fail "a variant that is refused was run"

# Mistakes.
sed 's/"below"/"belwo"/' limits.json >wrong.json
expect 2 limits wrong.json
says "$err" 'did you mean "below"?'
sed 's,/time/step,/tiem/step,' limits.json >wrong.json
expect 2 limits wrong.json
says "$err" 'did you mean "/time"?'
sed 's,/final/kinetic,/finl/kinetic,' limits.json >wrong.json
expect 2 limits wrong.json
says "$err" 'did you mean "/final/kinetic_energy"?'
