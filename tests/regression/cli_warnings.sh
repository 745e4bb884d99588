#!/usr/bin/env bash
# What a scene may not mean is told at once, with its place, by every verb that reads it, and kept with the results.
source "$(dirname "$0")/expect.bash"

second='{"material":"rubber","geometry":{"type":"box","min":[0.25,0.25],"max":[0.5,0.75]}}'
overlap=(--set "/bodies/second=$second")
place="/bodies/second/geometry: overlaps with body"
expect 0 validate block.json "${overlap[@]}"
says "$err" "warning: $place"
expect 0 run block.json "${overlap[@]}" --set '/checkpoint={"every_steps":40}' --output out
says "$err" "warning: $place"
says "$(<out/summary.json)" "$place"
expect 0 restart out/checkpoints/*.h5
says "$err" "warning: $place"

expect 0 run block.json "${overlap[@]}" --set '/bodies/second/overlaps=block' --output meant
[[ $err != *overlaps* ]] || fail "a warning although it is meant: $err"
[[ $(<meant/summary.json) != *overlaps* ]] || fail "summary.json keeps a warning although it is meant"

# Mistakes and warnings together; nothing is written.
expect 2 run block.json "${overlap[@]}" --set '/boundary_conditions=[{"type":"fixed","on":{"type":"box","min":[5,5],"max":[6,6]}}]' --output wrong
says "$err" "error: /boundary_conditions/0/on: there is no node"
says "$err" "warning: $place"
[[ ! -e wrong ]] || fail "something was written"
