#!/usr/bin/env bash
# A plugin or a resource of the machine is missing: status 3.
source "$(dirname "$0")/expect.bash"

sed '$s/}/,"plugins":["none.so"]}/' block.json >names_plugin.json
expect 3 run names_plugin.json
says "$err" "none.so"
expect 3 validate block.json names_plugin.json
says "$out" "block.json: ok"

touch file
expect 3 run block.json --output file/out
says "$err" "file"

export MATPOINT_PLUGIN_PATH=$PWD/no_such_folder
expect 3 run block.json
says "$err" "no_such_folder"

# A broken plugin is told of, and hides no other.
mkdir plugins
echo "not a library" >plugins/broken.so
echo '{"plugin":"broken","version":"1","abi":1,"components":[{"kind":"material","type":"broken","doc":""}]}' \
    >plugins/broken.plugin.json
export MATPOINT_PLUGIN_PATH=$PWD/plugins
expect 3 list
says "$err" "broken"
says "$out" "neo_hookean"
expect 3 describe neo_hookean
says "$out" "youngs_modulus"
expect 0 validate block.json
