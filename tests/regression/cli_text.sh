#!/usr/bin/env bash
# Names that are not UTF-8: used where they can be, told where they can't.
export LC_ALL=C  # bytes that are no characters
source "$(dirname "$0")/expect.bash"

value() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))[sys.argv[2]])' "$@"; }
latin=$(printf 'caf\xe9')

# A scene's and a folder's name: the title shows what can be shown.
grep -v '"title"' block.json >"$latin.json"
expect 0 validate "$latin.json"
expect 0 run "$latin.json" --quiet
[[ $(value "out/$latin/summary.json" title) == $(printf 'caf\xef\xbf\xbd') ]] || fail "title"
expect 0 run "out/$latin/resolved.json" --quiet --output again
cmp again/height.csv "out/$latin/height.csv"
expect 1 run "$latin.json" --quiet --output "$latin" --set /time/step=0.1
[[ $(value "$latin/summary.json" status) == broke_down ]] || fail "a reason with a path that is not UTF-8"
checkpoints=("$latin"/checkpoints/*.h5)
expect 0 restart "${checkpoints[0]}" --quiet --output restarted --set /time/step=0.001
cat >"$latin.study.json" <<END
{ "scene": "block.json", "vary": { "/time/end": [0.01, 0.02], "/time/step": [1e-3, 0.1] },
  "accuracy": { "summary": "/conservation/energy_drift" } }
END
expect 0 study "$latin.study.json" --quiet
[[ -f out/$latin.study/study.json ]] || fail "no study"

# What can't be written into results is told before anything runs.
expect 2 run block.json --output other --set "/title=$latin"
says "$err" "--set /title: error: /title:"
says "$err" "is not UTF-8"
expect 2 run block.json --output other --set "/bodies/$latin={\"material\": \"rubber\", \"geometry\": {\"type\": \"box\", \"min\": [0, 0.5], \"max\": [1, 1]}}"
says "$err" "is not UTF-8"
mkdir "$latin.folder"
sed 's/{ "type": "box", "min": \[0, 0\], "max": \[1, 0.5\] }/{ "type": "points", "file": "points.csv" }/' block.json >"$latin.folder/scene.json"
printf 'x,y,volume\n0.5,0.5,0.1\n' >"$latin.folder/points.csv"
for verb in run validate; do
    expect 2 $verb "$latin.folder/scene.json"
    says "$err" "/bodies/block/geometry/file"
    says "$err" "is not UTF-8"
done
sed "s/Elastic block/$latin/" block.json >title.json
expect 2 run title.json --output other
says "$err" "title.json:3:"
says "$err" "save the file as UTF-8"
[[ ! -e other ]] || fail "something was written"
