#!/usr/bin/env bash
# A second run into a folder: files of its outputs are its own, those of outputs that are gone are named.
source "$(dirname "$0")/expect.bash"

vtk='{"type":"vtk","name":"seen","every":"5 ms"}'
probe='{"type":"probe","name":"mass","quantity":"mass"}'
expect 0 run block.json --quiet --output out --set "/outputs=[$vtk,$probe]"
[[ -f out/seen_000010.vtp && -f out/mass.csv ]] || fail "the first run's files are missing"
echo mine >out/notes.csv

# A shorter run leaves no frame of the longer one.
expect 0 run block.json --quiet --output out --set "/outputs=[$vtk,$probe]" --set "/time/end=20 ms"
[[ -z $err ]] || fail "said: $err"
[[ $(echo out/*.vtp) == "out/seen_000000.vtp out/seen_000001.vtp out/seen_000002.vtp out/seen_000003.vtp out/seen_000004.vtp" ]] ||
    fail "frames: $(echo out/*.vtp)"

# What the scene no longer writes stays, and is named.
expect 0 run block.json --quiet --output out --set "/outputs=[$probe]"
says "$err" "out keeps files of an earlier run that this one does not write: seen.pvd, seen_000000.vtp, seen_000001.vtp, seen_000002.vtp, seen_000003.vtp and 1 more"
[[ -f out/seen_000004.vtp && $(<out/notes.csv) == mine ]] || fail "a file is gone"

# A restart drops the frames after its checkpoint, and keeps those before.
expect 0 run block.json --quiet --output cut --set "/outputs=[$vtk]" --set '/checkpoint={"every_steps": 10, "keep": 9}'
expect 0 restart cut/checkpoints/checkpoint_00000010.h5 --quiet --set "/time/end=15 ms"
[[ $(echo cut/*.vtp) == "cut/seen_000000.vtp cut/seen_000001.vtp cut/seen_000002.vtp cut/seen_000003.vtp" ]] ||
    fail "frames: $(echo cut/*.vtp)"

# Two outputs that would write one file.
csv='{"type":"csv","name":"mass"}'
expect 2 run block.json --set "/outputs=[$csv,{\"type\":\"probe\",\"name\":\"mass_times\",\"quantity\":\"mass\"}]"
says "$err" "/outputs/1/name: it would write mass_times.csv, as /outputs/0 does"
expect 2 run block.json --set "/outputs=[$probe,$probe]"
says "$err" "/outputs/1/name: it would write mass.csv, as /outputs/0 does"

# A probe's place far from the body.
expect 2 validate block.json --set '/outputs/0={"type":"probe","name":"tip","quantity":"particle","body":"block","field":"velocity","at":[0.5,3]}'
says "$err" "/outputs/0"
says "$err" "is far from body \"block\": the nearest particle, number"
