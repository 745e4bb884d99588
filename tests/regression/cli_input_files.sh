#!/usr/bin/env bash
# What is no file, or has no end, is refused at once wherever a file is read.
source "$(dirname "$0")/expect.bash"

# Each call must end within a second; the limit is wide, for slow machines.
quick() {
    local wanted=$1 status=0
    shift
    timeout 20 "$matpoint" "$@" >stdout.txt 2>stderr.txt || status=$?
    out=$(<stdout.txt) err=$(<stderr.txt)
    ((status == wanted)) || fail "matpoint $*: status $status, expected $wanted"$'\n'"$out"$'\n'"$err"
}

mkdir folder
mkfifo pipe
truncate -s 1T huge
ln -s loop loop
declare -A says=([pipe]="is a pipe" [/dev/zero]="is a device" [folder]="is a folder" [huge]="bytes" [loop]="symbolic link" [none]="no such file")

geometry() {
    printf '%s' "{ \"type\": \"$1\", \"file\": \"$2\" }"
}
solid='{ "matpoint": 1, "space": { "dimension": 3 }, "grid": { "type": "uniform", "min": [0,0,0], "max": [1,1,1], "cell_size": 0.25 },
  "shape_function": { "type": "linear" }, "integrator": { "type": "usl" }, "time": { "end": 1 },
  "materials": { "m": { "type": "linear_elastic", "density": 1, "youngs_modulus": 1 } },
  "bodies": { "b": { "material": "m", "geometry": { "type": "box", "min": [0,0,0], "max": [1,1,1] } } } }'
echo "$solid" >solid.json
echo '{ "scene": "block.json", "cases": { "gold": { "checks": [ { "gold": "GOLD", "probe": "height", "absolute": 1 } ] } } }' >gold.json

for file in pipe /dev/zero folder huge loop none; do
    for verb in run validate study limits test; do
        if [[ $verb == test && $file == folder ]]; then continue; fi
        quick 2 $verb $file
        says "$err" "${says[$file]}"
    done
    quick 2 restart $file
    if [[ $file == huge ]]; then says "$err" "not a checkpoint"; else says "$err" "${says[$file]}"; fi
    for type in stl points; do
        quick 2 run solid.json --set "/bodies/b/geometry=$(geometry $type $file)"
        if [[ $file == huge ]]; then says "$err" huge; else says "$err" "${says[$file]}"; fi
    done
    sed "s,GOLD,$file," gold.json >gold.test.json
    quick 1 test gold.test.json
    if [[ $file == none ]]; then says "$out" "no gold file"; else says "$out" "${says[$file]}"; fi
done
# A table that begins well, and a checkpoint.
printf 'x,y,z,volume\n0.5,0.5,0.5,1\n' >points.csv
truncate -s 1T points.csv
quick 2 run solid.json --set "/bodies/b/geometry=$(geometry points points.csv)"
says "$err" "points.csv:3: longer than any row"
expect 0 run block.json --quiet --output saved --set '/checkpoint={"every": 0.02, "keep": 1}'
checkpoints=(saved/checkpoints/*.h5)
truncate -s 1T "${checkpoints[0]}"
quick 2 restart "${checkpoints[0]}"
says "$err" "is damaged"

# Plugins.
mkdir plugins
mkfifo plugins/a.plugin.json
MATPOINT_PLUGIN_PATH=$PWD/plugins quick 3 run block.json
says "$err" "a.plugin.json"
says "$err" "is a pipe"

# Standard input that is a file is one.
quick 0 validate /dev/stdin <block.json
[[ ! -e out ]] || fail "something was written"
