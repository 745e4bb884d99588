#!/usr/bin/env bash
# `matpoint study`: the files it writes, variants that break down, are refused or crash, going on after Ctrl-C, mistakes.
source "$(dirname "$0")/expect.bash"

# query FILE EXPRESSION: of the JSON in FILE, which is called s, with its variants in v.
query() { python3 -c 'import json, sys; s = json.load(open(sys.argv[1])); v = s["variants"]; print(eval(sys.argv[2]))' "$@"; }
# What does not change from run to run.
rows() { query "$1/study.json" '[{k: r[k] for k in ("name", "status", "error", "value", "order", "particle_steps", "folder")} for r in v]'; }

cat >study.json <<'END'
{ "title": "Steps of a block", "scene": "block.json", "set": { "/time/end": 0.02 },
  "variants": { "usl": { "/integrator/type": "usl" }, "usf": { "/integrator/type": "usf" } },
  "vary": { "/time/step": { "from": 1e-3, "to": 2.5e-4, "factor": 0.5 } },
  "accuracy": { "summary": "/conservation/energy_drift", "label": "energy drift" }, "cost": { "summary": "/steps" }, "target": 1,
  "plots": [ { "name": "drift", "x": "step", "lines": "variant", "slopes": [1] } ] }
END
expect 0 study study.json --output first
says "$out" "usf, step=0.00025"
says "$out" "cheapest with an error of at most 1: us"
[[ -f first/study.csv && -f first/study.html && -f first/drift.svg ]] || fail "files are missing"
[[ $(query first/study.json '[r["steps"] for r in v]') == "[20, 40, 80, 20, 40, 80]" ]] || fail "steps: $(rows first)"
[[ $(query first/study.json 's["best"]["cost"]') == 20.0 ]] || fail "the cheapest is not the best"
[[ $(wc -l <first/study.csv) == 7 && $(head -n 1 first/study.csv) == number,name,* ]] || fail "study.csv"

# The front by definition.
python3 - <<'END'
import json
rows = json.load(open("first/study.json"))["variants"]
for r in rows:
    beaten = any(o["cost"] <= r["cost"] and o["error"] <= r["error"] and (o["cost"], o["error"]) != (r["cost"], r["error"]) for o in rows)
    assert r["front"] == (not beaten), r
END

# What is kept is small. The best scene runs from anywhere, to the same error, and writes the original's outputs.
mapfile -t kept < <(find first/runs -type f -printf '%f\n' | sort -u)
[[ ${kept[*]} == "log.txt summary.json variant.json" ]] || fail "kept: ${kept[*]}"
mkdir elsewhere
cp first/best.json elsewhere/
expect 0 run elsewhere/best.json --quiet --output best
[[ -f best/height.csv ]] || fail "best.json has no outputs"
python3 - <<'END'
import json
best, summary = json.load(open("first/study.json"))["best"], json.load(open("best/summary.json"))
assert best["error"] == abs(summary["conservation"]["energy_drift"]), best
END

# A second call measures nothing. One with more values measures those.
touch -d '1 minute ago' first/runs/*/summary.json
touch mark
expect 0 study study.json --output first --quiet
[[ -z $out$err && -z $(find first/runs -name summary.json -newer mark) ]] || fail "measured again"
sed 's/2.5e-4/1.25e-4/' study.json >more.json
expect 0 study more.json --output first --quiet
[[ $(find first/runs -name summary.json -newer mark | wc -l) == 2 ]] || fail "measured again, or not enough"
expect 0 study study.json --output first --quiet --again
[[ $(find first/runs -name summary.json -newer mark | wc -l) == 8 ]] || fail "not measured again"

# Breaking down, and being refused by the scene's rules because of what else a variant has, is a row each.
cat >rows.json <<'END'
{ "scene": "block.json", "set": { "/time/end": 0.02 }, "timing": "quiet", "keep_outputs": true,
  "vary": { "/time/step": [1e-3, 0.1], "/integrator/type": ["usl", "usf"],
            "/transfer": [{ "type": "flip" }, { "type": "flip", "gradient_enhanced": true }] },
  "accuracy": { "summary": "/conservation/energy_drift" }, "target": 1e-9 }
END
expect 0 study rows.json
says "$out" "one run at a time"
says "$out" "no variant meets the target"
[[ $(query out/rows/study.json '[r["status"] for r in v]') == "['completed', 'completed', 'completed', 'refused', 'broke_down', 'broke_down', 'broke_down', 'refused']" ]] || fail "$(rows out/rows)"
says "$(query out/rows/study.json 'v[3]["reason"]')" "/transfer/gradient_enhanced"
[[ ! -e out/rows/best.json && -n $(find out/rows/runs -name height.csv) ]] || fail "best.json or outputs"

# A probe measures too, against what is exact; where there is nothing to measure is a row.
cat >probe.json <<'END'
{ "scene": "block.json", "vary": { "/time/end": [0.01, 0.05] }, "target": 1,
  "accuracy": { "measure": { "statistic": "first_time_below", "probe": "height", "level": 0.249 }, "exact": 0.02 } }
END
expect 0 study probe.json --quiet
[[ $(query out/probe/study.json '[r["status"] for r in v]') == "['broke_down', 'completed']" ]] || fail "$(rows out/probe)"
says "$(query out/probe/study.json 'v[0]["reason"]')" "0.249 is never passed"
expect 0 run out/probe/best.json --quiet --output probed
python3 - <<'END'
import csv, json
row = json.load(open("out/probe/study.json"))["variants"][1]
first = next(float(r["time"]) for r in csv.DictReader(open("probed/height.csv")) if float(list(r.values())[1]) < 0.249)
assert row["value"] == first > 0 and row["error"] == abs(first - 0.02) / 0.02, (row, first)
END
touch mark
expect 0 study probe.json --quiet
[[ -z $(find out/probe/runs -name height.csv -newer mark) ]] || fail "measured again"
sed 's/"height"/"hight"/' probe.json >no_probe.json
expect 2 study no_probe.json
says "$err" '/accuracy/measure/probe: the scene has no probe "hight"'
sed 's/"measure"/"summary": "\/steps", "measure"/' probe.json >both.json
expect 2 study both.json
says "$err" "one of both"

# A type that is varied does not stumble over parameters of the one before.
cat >types.json <<'END'
{ "scene": "block.json", "set": { "/time/end": 0.02, "/shape_function": { "type": "gimp", "domain": "uniform" } },
  "vary": { "/shape_function/type": ["linear", "gimp", "bspline"] }, "accuracy": { "summary": "/conservation/energy_drift" } }
END
expect 0 study types.json --quiet
[[ $(query out/types/study.json '[r["status"] for r in v]') == "['completed', 'completed', 'completed']" ]] || fail "$(rows out/types)"
[[ $(query out/types/study.json 'json.load(open("out/types/" + v[1]["folder"] + "/variant.json"))["shape_function"]["domain"]') == uniform ]] \
    || fail "gimp lost its domain"

# A value that is refused whatever the others are is a mistake of the study: nothing is run.
sed -i 's/"bspline"/"bsplien"/' types.json
expect 2 study types.json --output none
says "$err" "types.json:2:"
says "$err" 'did you mean "bspline"?'
sed 's,"/integrator/type": \["usl"\, "usf"\],"/materials/rubber/poissons_ratio": [0.3\, 0.7],' rows.json >ratio.json
expect 2 study ratio.json --output none
says "$err" "ratio.json:2:"
says "$err" "expected a number > -1 and < 0.5, got 0.7"
[[ ! -e none ]] || fail "something was run"

# A crash is a row too. Job control, because a shell without it starts background jobs deaf to Ctrl-C.
set -m
cat >crash.json <<'END'
{ "scene": "block.json", "vary": { "/time/end": [0.02, 1e6] }, "accuracy": { "summary": "/conservation/energy_drift" } }
END
"$matpoint" study crash.json --quiet &
study=$!
for _ in {1..600}; do
    if pgrep -P $study -f 'end=1000000' >/dev/null; then break; fi
    sleep 0.05
done
sleep 0.2
pkill -KILL -P $study -f 'end=1000000'
wait $study || fail "a child's crash ends the study"
[[ $(query out/crash/study.json '[r["status"] for r in v]') == "['completed', 'crashed']" ]] || fail "$(rows out/crash)"
says "$(query out/crash/study.json 'v[1]["reason"]')" "signal 9"

# Ctrl-C in the middle; then on to the same rows, without measuring twice.
sed -e 's/0.02/0.5/' -e 's/2.5e-4/1.25e-4/' study.json >long.json
"$matpoint" study long.json --output "$folder/stopped" --jobs 1 2>stderr.txt &
study=$!
for _ in {1..600}; do
    if (($(find stopped/runs -name summary.json 2>/dev/null | wc -l) >= 2)); then break; fi
    sleep 0.02
done
kill -INT $study
status=0
wait $study || status=$?
((status == 1)) || fail "status $status after Ctrl-C"
says "$(<stderr.txt)" "goes on from here"
[[ ! -e stopped/study.json ]] || fail "a study that was interrupted wrote its table"
! pgrep -f "$folder/stopped" >/dev/null || fail "a child runs on"
touch -d '1 minute ago' stopped/runs/*/summary.json
touch mark
done_before=$(find stopped/runs -name summary.json ! -newer mark | wc -l)
((done_before >= 2 && done_before < 8)) || fail "$done_before variants were measured before Ctrl-C"
expect 0 study long.json --output stopped --quiet
[[ $(find stopped/runs -name summary.json -newer mark | wc -l) == $((8 - done_before)) ]] || fail "measured twice"
expect 0 study long.json --output whole --quiet
[[ $(rows stopped) == "$(rows whole)" ]] || fail "rows differ:"$'\n'"$(rows stopped)"$'\n'"$(rows whole)"

# Mistakes are located in the study, and nothing is run.
cat >wrong.json <<'END'
{ "scene": "block.json",
  "set": { "/tmie/end": 1 },
  "vary": { "/time/step": [1e-3] },
  "accuracy": { "summary": "/conservation/energy_drift" } }
END
expect 2 study wrong.json
says "$err" "wrong.json:2:"
says "$err" 'did you mean "/time"?'
sed -i -e 's/tmie/time/' -e 's,/time/step,/time/max_stesp,' wrong.json
expect 2 study wrong.json
says "$err" "wrong.json:3:"
says "$err" 'did you mean "max_steps"?'
[[ ! -e out/wrong ]] || fail "something was run"
sed -i -e 's,/time/max_stesp,/time/step,' -e 's,energy_drift,enregy_drift,' wrong.json
expect 2 study wrong.json
says "$err" "wrong.json:4:"
says "$err" 'did you mean "/conservation/energy_drift"?'
sed -i 's,/conservation/enregy_drift,/error/linf,' wrong.json
expect 2 study wrong.json
says "$err" "exact_solution"
expect 2 study study.json --jobs 0
says "$err" "--jobs"
expect 2 study missing.json

# Nothing completed.
sed 's/1e-3, 0.1/0.1, 0.2/' rows.json >broken.json
expect 1 study broken.json
says "$err" "no variant completed"

# Variants that come to the same scene are run once.
cat >same.json <<'END'
{ "scene": "block.json", "vary": { "/time/end": [0.02, "20 ms"] }, "accuracy": { "summary": "/conservation/energy_drift" } }
END
expect 0 study same.json --jobs 2
[[ $(find out/same/runs -name summary.json | wc -l) == 1 ]] || fail "run twice"
[[ $(query out/same/study.json 'v[0]["cpu_seconds"] == v[1]["cpu_seconds"]') == True ]] || fail "$(rows out/same)"
