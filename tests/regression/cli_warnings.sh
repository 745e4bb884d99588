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

# A body that is driven as a whole is not stopped by a tool; one that is driven in part may be.
ceiling='/contacts=[{"type":"rigid_tool","name":"ceiling","geometry":{"type":"half_space","point":[0,0.6],"normal":[0,-1]}}]'
driven() { expect 0 validate block.json --set "$ceiling" --set "/boundary_conditions=[{\"type\":\"velocity\",\"on\":$1,\"velocity\":[0,1]}]"; }
driven '{"body":"block"}'
says "$err" "warning: /contacts/0: boundary conditions prescribe how all of block moves: the tool can't stop it"
driven '{"body":"block","within":{"type":"box","min":[0,0],"max":[1,0.2]}}'
[[ $err != *"can't stop"* ]] || fail "a warning although only a part is driven: $err"

# Levels by a transfer that loses slopes at their borders.
levels='/grid={"type":"multilevel","min":[0,0],"max":[1,1],"cell_size":0.125,"levels":[{"within":{"type":"box","min":[0.25,0],"max":[0.5,0.5]}}]}'
expect 0 run block.json --set "$levels" --output levels
says "$err" "take \"affine_flip\""
says "$(<levels/summary.json)" '"cells_over_uniform"'
expect 0 validate block.json --set "$levels" --set '/transfer/type=affine_flip'
[[ $err != *affine_flip* ]] || fail "a warning although slopes are kept: $err"
says "$out" "level 1: 32 cells"
expect 0 validate block.json --set "$levels" --set '/bodies/block/artificial_viscosity={"linear":0.2,"quadratic":2}'
says "$err" "takes the size of the coarsest cells"
