#!/usr/bin/env bash
# What a restart can change and what not: nothing that is asked for is ignored.
source "$(dirname "$0")/expect.bash"

value() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))[sys.argv[2]])' "$@"; }

expect 0 run block.json --quiet --output out --set '/checkpoint={"every_steps": 20}' \
    --set '/materials/stone={"type":"linear_elastic","density":2000,"youngs_modulus":1e6}'
checkpoint=out/checkpoints/checkpoint_00000040.h5
before=$(<out/resolved.json)

# Only the start of a run reads these.
refused() {
    expect 2 restart "$checkpoint" --set "$1"
    says "$err" "${2:-${1%%=*}}: only the start of a run reads it"
}
refused /materials/rubber/density=2000
says "$err" "it reads /materials/rubber/type, /materials/rubber/youngs_modulus, /materials/rubber/poissons_ratio"
refused /bodies/block/velocity='[1,0]'
says "$err" "it reads /bodies/block/material"
refused /bodies/block/particles_per_cell=9
refused /bodies/block/geometry/max='[1,0.6]' /bodies/block/geometry
refused /grid/cell_size=0.0625 /grid
says "$err" "/loads"
refused /space/precision=single /space
refused '/exact_solution={"type":"free_flight","body":"block","velocity":[0,0]}' /exact_solution
refused '/bodies/other={"material":"rubber","geometry":{"type":"box","min":[0,0.5],"max":[1,1]}}' /bodies/other/geometry
expect 2 restart "$checkpoint" --set /time/end=0.03
says "$err" "/time: the checkpoint is at step 40, t = 0.04 s already"
expect 2 restart "$checkpoint" --set /time/max_steps=30
says "$err" "/time: the checkpoint is at step 40"
[[ $(<out/resolved.json) == "$before" ]] || fail "a refused restart changed resolved.json"

# The same value again is no change; a material's other constants and a body's material are read.
expect 0 restart "$checkpoint" --quiet --output same --set /materials/rubber/density=1000 --set '/bodies/block/velocity=[0,"0 m/s"]'
expect 0 restart "$checkpoint" --quiet --output stiff --set /materials/rubber/youngs_modulus=4e6
expect 0 restart "$checkpoint" --quiet --output stone --set /bodies/block/material=stone
for output in stiff stone; do
    ! cmp -s same/height.csv $output/height.csv || fail "$output: the change did nothing"
done

# A step of another length goes on from the time reached.
expect 0 restart "$checkpoint" --quiet --output finer --set /time/step=1e-4
[[ $(value finer/summary.json steps) == 140 ]] || fail "$(value finer/summary.json steps) steps"
expect 0 restart "$checkpoint" --quiet --output parted --set /time/step=1e-4 --set '/checkpoint={"every_steps": 30, "keep": 9}'
expect 0 restart parted/checkpoints/checkpoint_00000090.h5 --quiet --output parted
cmp finer/height.csv parted/height.csv
