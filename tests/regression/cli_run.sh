#!/usr/bin/env bash
# A run's files, what validate predicts, and restarting: after Ctrl-C a run goes on to the same result.
source "$(dirname "$0")/expect.bash"

value() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))[sys.argv[2]])' "$@"; }

expect 0 run block.json
[[ $(value out/block/summary.json status) == completed ]] || fail "status"
[[ -f out/block/resolved.json && -f out/block/height.csv ]] || fail "files are missing"
[[ $out =~ "results in out/block; "([0-9.e-]+)" s in all" ]] || fail "not told where results are: $out"
(($(python3 -c "print(int(${BASH_REMATCH[1]} >= $(value out/block/summary.json wall_seconds)))"))) || fail "shorter than its steps: $out"
expect 0 run block.json --quiet --output quiet
[[ -z $out$err ]] || fail "not quiet: $out$err"
cmp out/block/height.csv quiet/height.csv

expect 0 validate block.json
says "$out" ", $(value quiet/summary.json steps) steps"
says "$out" "$(value quiet/summary.json particles) particles of $(value quiet/summary.json bytes_per_particle) bytes"

# The resolved scene runs again to the same result.
expect 0 run quiet/resolved.json --quiet --output again
cmp quiet/height.csv again/height.csv

# Job control, because a shell without it starts background jobs deaf to Ctrl-C.
set -m
"$matpoint" run block.json --set /time/end=1e6 --output stopped --quiet 2>stderr.txt &
for _ in {1..600}; do
    if [[ -s stopped/resolved.json ]]; then break; fi
    sleep 0.1
done
sleep 0.5
kill -INT $!
status=0
wait $! || status=$?
((status == 1)) || fail "status $status after Ctrl-C: $(<stderr.txt)"
[[ $(value stopped/summary.json status) == interrupted ]] || fail "status in summary.json after Ctrl-C"

end=$(python3 -c "print(1.1 * $(value stopped/summary.json time))")
checkpoints=(stopped/checkpoints/*.h5)
expect 0 restart "${checkpoints[-1]}" --set "/time/end=$end"
says "$out" "results in stopped; "
[[ $(value stopped/summary.json status) == completed ]] || fail "status after restart"
expect 0 run block.json --set "/time/end=$end" --output whole --quiet
cmp stopped/height.csv whole/height.csv

# A run that breaks down says why, and ends with status 1.
expect 1 run block.json --set /time/step=0.1 --output broken --quiet
[[ $(value broken/summary.json status) == broke_down ]] || fail "status of a run that breaks down"
[[ -n $err ]] || fail "a run broke down without a word"
