#!/usr/bin/env bash
# Mistakes in scenes: all are told, with file, line, pointer and the nearest name; nothing is written.
source "$(dirname "$0")/expect.bash"

sed -e 's/"title"/"titel"/' -e 's/"poissons_ratio": 0.3/"poissons_ratio": 0.7/' block.json >wrong.json
expect 2 run wrong.json
says "$err" "wrong.json:3:"
says "$err" "/titel"
says "$err" 'did you mean "title"?'
says "$err" "wrong.json:9:"
says "$err" "/materials/rubber/poissons_ratio"

expect 2 run missing.json
says "$err" "missing.json"
expect 2 run block.json --set /time/ende=1
says "$err" "/time/ende"
expect 2 run block.json --set /tiem/end=1
says "$err" 'did you mean "/time"?'
expect 2 run block.json --set time=1
says "$err" "/json/pointer=VALUE"

# Several files: the mistakes of all.
sed 's/"gravity"/"gravitiy"/' block.json >other.json
expect 2 validate wrong.json block.json other.json
says "$err" "wrong.json:3:"
says "$err" 'did you mean "gravity"?'
says "$out" "block.json: ok"

# A scene's checks are looked at before it runs.
sed '$s/}/,"checks":[{"probe":"height","formla":"0","relative":1}]}/' block.json >checks.json
expect 2 run checks.json
says "$err" "/checks/0/formla"

expect 2 restart missing.h5
says "$err" "missing.h5"
expect 2 restart block.json
[[ ! -e out ]] || fail "something was written"
