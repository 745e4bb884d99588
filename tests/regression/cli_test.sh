#!/usr/bin/env bash
# `matpoint test`: what passes, what fails and how, what is mistaken; choosing cases; gold files.
source "$(dirname "$0")/expect.bash"

mkdir suite
cp block.json suite/
cat >suite/block.test.json <<'END'
{ "scene": "block.json",
  "cases": {
    "falls": { "checks": [ { "probe": "height", "formula": "0.25", "relative": 0.1 } ] },
    "conserves": { "tags": ["quick"], "set": { "/time/end": 0.01 },
                   "checks": [ { "summary": "/conservation/mass_drift", "below": 1e-12 }, { "summary": "/steps", "equals": 10 } ] },
    "restart": { "checks": [ { "restart_equals_run": true } ] },
    "at_rest": { "set": { "/time/end": 0.001 },
                 "checks": [ { "particles": { "body": "block", "field": "displacement", "component": "y" },
                               "formula": "0", "norm": "linf", "below": 1e-3 } ] },
    "bad_body": { "set": { "/outputs/0/body": "blok" }, "expect_error": { "at": "/outputs/0/body", "matches": "did you mean \"block\"" } },
    "unstable": { "set": { "/time/step": 0.1 }, "expect_error": { "status": "broke_down", "matches": "step" } } } }
END
expect 0 test suite
says "$out" "6 of 6 cases passed"
expect 0 test suite --list
says "$out" "suite/block:conserves (quick)"
expect 0 test suite/block.test.json --filter 'falls$'
says "$out" "1 of 1 cases passed"
expect 0 test suite --tag quick
says "$out" "1 of 1 cases passed"
expect 0 test suite --exclude-tag quick --filter bad_body --output kept
says "$out" "1 of 1 cases passed"
expect 2 test suite --filter no_such_case

# A check that does not hold: what was measured, what was asked, where.
mkdir failing
cp block.json failing/
cat >failing/block.test.json <<'END'
{ "scene": "block.json",
  "cases": {
    "too_high": { "checks": [ { "summary": "/steps", "equals": 50 },
                              { "probe": "height", "formula": "0.5", "absolute": 0.01 } ] },
    "not_bad": { "expect_error": { "at": "/time" } } } }
END
expect 1 test failing
says "$out" "FAILED failing/block:too_high"
says "$out" "block.test.json:5:"
says "$out" "/cases/too_high/checks/1"
says "$out" "> 0.01"
says "$out" "expected 0.5"
says "$out" "FAILED failing/block:not_bad"
says "$out" "0 of 2 cases passed"

# Gold files are made when asked for.
mkdir gold
cp block.json gold/
echo '{ "scene": "block.json", "cases": { "same": { "checks": [ { "gold": "height.csv", "probe": "height", "relative": 1e-9 } ] } } }' \
    >gold/block.test.json
expect 1 test gold
says "$out" "--update-gold"
expect 0 test gold --update-gold
expect 0 test gold
sed -i '3s/$/1/' gold/height.csv
sed -i '4s/,/,9/' gold/height.csv
expect 1 test gold
says "$out" "row 3"

# Mistakes in case files: all, located.
mkdir mistaken
cp block.json mistaken/
echo '{ "scene": "block.json",
  "cases": { "a": { "cheks": [] },
             "b": { "checks": [ { "prob": "height" }, { "summary": "/steps" } ] } } }' >mistaken/block.test.json
expect 2 test mistaken
says "$err" "block.test.json:2:"
says "$err" 'did you mean "checks"?'
expect 2 test missing.json
says "$err" "missing.json"

# A scene's own checks are a case.
sed '$s/}/,"checks":[{"summary":"\/steps","equals":50}]}/' block.json >suite/with_checks.json
expect 0 test suite/with_checks.json
says "$out" "suite/with_checks:checks"
