#!/usr/bin/env bash
# A scene that the machine has no memory for is told of before it takes any: how much, for which body.
source "$(dirname "$0")/expect.bash"

# 1e12 particles in all, half of them in the disk.
cat >large.json <<'END'
{ "matpoint": 1, "space": { "dimension": 2 }, "grid": { "type": "uniform", "min": [0, 0], "max": [100, 100], "cell_size": 0.01 },
  "shape_function": { "type": "gimp" }, "integrator": { "type": "usl" }, "time": { "end": 1 },
  "materials": { "m": { "type": "linear_elastic", "density": 1, "youngs_modulus": 1 } },
  "bodies": { "small": { "material": "m", "particles_per_cell": 1, "geometry": { "type": "box", "min": [0, 0], "max": [1, 1] } },
              "large": { "material": "m", "particles_per_cell": 10000, "geometry": { "type": "box", "min": [0, 1], "max": [100, 100] } } } }
END
for verb in validate run; do
    expect 3 $verb large.json
    says "$err" 'not enough memory for body "large": about 9.9e+11 particles of'
    says "$err" "TB, beside "
done
[[ ! -e out ]] || fail "something was written"

# What may be had counts, not what the machine has. A disk fills pi / 4 of its box.
(
    ulimit -v 4000000
    disk='/bodies={"disk": {"material": "m", "particles_per_cell": PER_CELL, "geometry": {"type": "sphere", "center": [50, 50], "radius": 50}}}'
    expect 3 validate large.json --set "${disk/PER_CELL/1}"
    [[ $err =~ 'body "disk": about 7.8'[0-9]*'e+07 particles' ]] || fail "$err"
    says "$err" "and there are 4.1 GB"
    expect 3 validate large.json --set /grid/cell_size=0.1 --set "${disk/PER_CELL/100}"
    expect 0 validate large.json --set "${disk/PER_CELL/1}" --set /grid/cell_size=0.1
)
