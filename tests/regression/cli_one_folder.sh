#!/usr/bin/env bash
# A folder of results is one process's at a time. What somebody takes away under a run is told, and the state is saved.
source "$(dirname "$0")/expect.bash"

value() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))[sys.argv[2]])' "$@"; }
# begin FOLDER ARGUMENT...: a long run in the background, $run, that has begun to write.
begin() {
    local into=$1
    shift
    "$matpoint" run block.json --set /time/end=1e6 --output "$into" --quiet "$@" 2>"$into.txt" &
    run=$!
    for _ in {1..600}; do
        if [[ -s $into/height.csv && $(wc -l <"$into/height.csv") -gt 2 ]]; then return; fi
        sleep 0.05
    done
    fail "no run in $into: $(<"$into.txt")"
}
# ends FOLDER PART...: the run in the background ends by itself with status 1, and says these.
ends() {
    local into=$1 status=0 part
    shift
    wait "$run" || status=$?
    ((status == 1)) || fail "status $status: $(<"$into.txt")"
    for part in "$@"; do says "$(<"$into.txt")" "$part"; done
}

expect 0 run block.json --quiet --output whole --set '/checkpoint={"every": 0.02, "keep": 1}'
checkpoints=(whole/checkpoints/*.h5)
cat >study.json <<'END'
{ "scene": "block.json", "vary": { "/time/end": [0.01, 0.02] }, "accuracy": { "summary": "/conservation/energy_drift" } }
END
cat >limits.json <<'END'
{ "scene": "block.json", "set": { "/time/end": 0.02 }, "search": { "pointer": "/time/step", "from": 1e-4, "to": 1e-2, "digits": 1 },
  "stable": { "summary": "/final/kinetic_energy", "below": 1e6 } }
END

# Whoever comes second writes nothing.
begin mine
for second in "run block.json --set /title=second" "restart ${checkpoints[0]}" "study study.json" "limits limits.json"; do
    # shellcheck disable=SC2086
    expect 3 $second --output mine
    says "$err" "process $run writes its results into mine"
done
[[ $(ls -A mine) == $'height.csv\nresolved.json' ]] || fail "written by the second: $(ls -A mine)"
[[ $(value mine/resolved.json title) != second ]] || fail "overwritten by the second"
# A run that was killed leaves no lock.
kill -KILL "$run"
wait "$run" 2>/dev/null || true
expect 0 run block.json --quiet --output mine
cmp mine/height.csv whole/height.csv
[[ $(ls -A mine) == $'height.csv\nresolved.json\nsummary.json' ]] || fail "left over: $(ls -A mine)"

# The same for a study.
sed 's/0.01, 0.02/1e6, 2e6/' study.json >long.json
"$matpoint" study long.json --output studied --quiet 2>long.txt &
study=$!
for _ in {1..600}; do
    if [[ -d studied/runs ]]; then break; fi
    sleep 0.05
done
expect 3 study study.json --output studied
says "$err" "process $study writes its results into studied"
kill -TERM $study
wait $study || [[ $? == 1 ]] || fail "status of a study after SIGTERM: $(<long.txt)"
expect 0 study study.json --output studied --quiet

# A table that was removed, or that somebody else writes to.
begin removed
rm removed/height.csv
ends removed "height.csv: No such file or directory" "The state is saved in"
[[ $(value removed/summary.json status) == interrupted && ! -e removed/height.csv ]] || fail "after a table was removed"
begin changed
echo "1,2" >>changed/height.csv
ends changed "height.csv: somebody else changed it" "The state is saved in"

# The folder goes: it is made anew for the state. Or it becomes another one: what is there is left alone.
begin gone
mv gone taken
ends gone "gone" "The state is saved in"
[[ $(value gone/summary.json status) == interrupted ]] || fail "summary of a run whose folder was removed"
checkpoints=(gone/checkpoints/*.h5)
expect 0 restart "${checkpoints[0]}" --quiet --set "/time/end=$(python3 -c "print(1.01 * $(value gone/summary.json time))")"
mkdir one other
ln -s one link
begin link
ln -s other next
mv -T next link
ends link "link is not the one any more" "could not be saved"
[[ -z $(ls -A other) ]] || fail "written into another folder: $(ls -A other)"

# The folder is removed while nothing is due: that is told at the end.
"$matpoint" run block.json --quiet --output idle --set /time/end=1e6 --set /outputs=[] --set /time/max_steps=200000 2>idle.txt &
run=$!
for _ in {1..600}; do
    if [[ -s idle/resolved.json ]]; then break; fi
    sleep 0.02
done
mv idle taken_too
ends idle "the folder idle was removed during the run" "The state is saved in"
