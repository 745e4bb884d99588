#!/usr/bin/env bash
# What a hostile user types: told within seconds, with nothing written, never a crash or an endless run.
source "$(dirname "$0")/expect.bash"

head -c 2000000 /dev/zero | tr '\0' '[' >deep.json
expect 2 run deep.json
says "$err" "deep.json:1:257: error: nested deeper"

expect 2 run block.json --threads 100000
says "$err" "--threads"
expect 2 run block.json --set /grid/cell_size=1e-12
says "$err" "/grid/cell_size: the grid has too many cells"
expect 2 run block.json --set /bodies/block/particles_per_cell=[1e9,1e9]
says "$err" "/bodies/block/particles_per_cell/0"
expect 2 run block.json --set '/bodies/block/velocity=["1/(x-x)",0]'
says "$err" "/bodies/block/velocity/0: the formula \"1/(x-x)\" is infinite at t = 0 s, x = 0.03125 m"
sed -e 's/"dimension": 2/"dimension": 3/' -e 's/\[0, 0\]/[0,0,0]/g' -e 's/\[1, 1\]/[1,1,1]/' -e 's/\[1, 0.5\]/[1,1,1]/' \
    -e 's/\[0, -10\]/[0,-10,0]/' -e 's/0\.125/0.001/' block.json >many.json
expect 3 run many.json
says "$err" 'not enough memory for body "block": about 8e+09 particles'
expect 2 run block.json --set /space/precision=single --set /materials/rubber/density=1e-50
says "$err" "/bodies/block: its particles get masses of"
[[ ! -e out ]] || fail "something was written"

# What particles have lived through can't be made up by a restart with other outputs.
expect 0 run block.json --set '/outputs=[]' --set '/checkpoint={"every_steps":10}' --quiet
expect 2 restart out/block/checkpoints/checkpoint_00000040.h5 --output again --set '/outputs=[{"type":"csv","fields":"displacement"}]'
says "$err" "run it from the start"
[[ ! -e again ]] || fail "something was written"
