#!/usr/bin/env bash
# Streams that are closed or full, files that can't grow, and a terminal that goes away.
source "$(dirname "$0")/expect.bash"

value() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))[sys.argv[2]])' "$@"; }
expect 0 run block.json --quiet --output whole

# Without standard streams no file of results takes their place.
"$matpoint" run block.json --output closed <&- >&- 2>&- || fail "status $? without standard streams"
cmp whole/height.csv closed/height.csv
"$matpoint" run block.json --output full >/dev/full 2>err.txt && fail "a full standard output is not told"
says "$(<err.txt)" "standard output can't be written"
[[ $(value full/summary.json status) == completed ]] || fail "a full standard output ends the run"

# Files that may not grow: like a full disk, for tables, files and checkpoints.
limited() {
    local status=0
    (ulimit -f "$1" && shift && exec "$matpoint" "$@") >stdout.txt 2>stderr.txt || status=$?
    out=$(<stdout.txt) err=$(<stderr.txt)
    ((status == 1)) || fail "matpoint ${*:2}: status $status with files of $1 kB"$'\n'"$out$err"
}
limited 8 run block.json --set /time/end=1e6 --output table --quiet
says "$err" "height.csv: File too large"
[[ -z $(tail -c 1 table/height.csv) ]] || fail "half a row is left"
[[ $(value table/summary.json status) == interrupted ]] || fail "status after a file that is too large"
limited 8 run block.json --set /time/end=1 --set '/outputs=[{"type": "csv", "every_steps": 1}]' --output background --quiet \
    --set '/bodies/block/particles_per_cell=25'
says "$err" "particles_block_000000.csv: File too large"
limited 8 run block.json --set '/outputs=[]' --set '/checkpoint={"every_steps": 1, "keep": 2}' --output saved --quiet
says "$err" "can't write checkpoint"
says "$err" "File too large"
[[ -z $(find saved -name '*.tmp') ]] || fail "half a checkpoint is left"
cat >study.json <<'END'
{ "scene": "block.json", "set": { "/outputs": [ { "type": "csv", "every_steps": 1 } ], "/bodies/block/particles_per_cell": 25 }, "keep_outputs": true,
  "vary": { "/time/end": [0.01, 0.02] }, "accuracy": { "summary": "/conservation/energy_drift" } }
END
limited 8 study study.json --output studied
says "$(<studied/study.csv)" "particles_block_000000.csv: File too large"

# SIGHUP saves as SIGTERM does, however often it comes; nohup keeps the run alive.
set -m
start() {
    "$@" run block.json --set /time/end=1e6 --output hung --quiet >nohup.txt 2>stderr.txt &
    run=$!
    for _ in {1..600}; do
        if [[ -s hung/height.csv && $(wc -l <hung/height.csv) -gt 2 ]]; then return; fi
        sleep 0.05
    done
    fail "no run: $(<stderr.txt)"
}
start "$matpoint"
kill -HUP $run
kill -HUP $run 2>/dev/null || true
status=0
wait $run || status=$?
((status == 1)) || fail "status $status after SIGHUP"
says "$(<stderr.txt)" "matpoint restart hung/checkpoints/"
[[ $(value hung/summary.json status) == interrupted ]] || fail "status in summary.json after SIGHUP"
rm -rf hung
start nohup "$matpoint"
kill -HUP $run
sleep 0.3
kill -0 $run || fail "nohup: SIGHUP ended the run"
kill -TERM $run
wait $run || [[ $? == 1 ]] || fail "status after SIGTERM"
