#!/usr/bin/env bash
# A disk that is full while a file is written in the background: told with status 1, the state saved, however the run ends.
source "$(dirname "$0")/expect.bash"

value() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))[sys.argv[2]])' "$@"; }
# full FOLDER FILE: the file in the folder can't be written.
full() {
    mkdir "$1"
    ln -s /dev/full "$1/$2.tmp"
}

example=$here/../../plugins/output/vtk/example.json
expect 0 run "$example" --quiet --output whole

# In the middle of a run: the next write tells.
full middle fall_000003.vtp
expect 1 run "$example" --quiet --output middle
says "$err" "fall_000003.vtp: No space left on device"
says "$err" "The state is saved in"
[[ $(value middle/summary.json status) == interrupted ]] || fail "status after a full disk"
[[ ! -e middle/fall_000003.vtp && ! -e middle/fall_000004.vtp ]] || fail "files after the one that failed"
checkpoints=(middle/checkpoints/*.h5)
expect 0 restart "${checkpoints[-1]}" --quiet
# What was due when the failure was told is missing, too: one table.
cmp whole/fall_disk_000010.csv middle/fall_disk_000009.csv

# The last file: the end of the run tells, and going on from the saved state writes it.
full end fall_000010.vtp
expect 1 run "$example" --quiet --output end
says "$err" "fall_000010.vtp: No space left on device"
[[ $(value end/summary.json status) == interrupted ]] || fail "status after a full disk at the end"
checkpoints=(end/checkpoints/*.h5)
expect 0 restart "${checkpoints[-1]}" --quiet
cmp whole/fall.pvd end/fall.pvd
cmp whole/fall_000010.vtp end/fall_000010.vtp

# A run that breaks down before the failure was told.
full broken particles_000000.vtp
expect 1 run block.json --set /time/step=0.1 --set '/outputs=[{"type": "vtk", "every_steps": 1000000}]' --output broken --quiet
[[ $(value broken/summary.json status) == broke_down ]] || fail "status of a run that breaks down"
says "$err" "particles_000000.vtp: No space left on device"

# A checkpoint waits for the files of its step: a run that is killed can go on from it without a gap.
"$matpoint" run block.json --output killed --quiet --set /time/end=1e6 --set '/checkpoint={"every_steps": 1, "keep": 3}' \
    --set '/outputs=[{"type": "vtk", "every_steps": 1}]' &
for _ in {1..600}; do
    if [[ -e killed/particles_000020.vtp ]]; then break; fi
    sleep 0.1
done
kill -KILL $!
wait $! 2>/dev/null || true
checkpoints=(killed/checkpoints/checkpoint_*.h5)
[[ ${checkpoints[-1]} =~ 0*([1-9][0-9]*)\.h5$ ]] || fail "no checkpoint"
printf -v last 'particles_%06d.vtp' "${BASH_REMATCH[1]}"
grep -q "$last" killed/particles.pvd || fail "$last is missing, but there is ${checkpoints[-1]}"
