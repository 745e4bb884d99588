#!/usr/bin/env bash
# new_plugin refuses names that its project could not be built or found with.
source "$(dirname "$0")/expect.bash"

refuses() {  # KIND NAME TEXT
    expect 2 new_plugin "$1" "$2"
    says "$err" "\"$2\" can't be the name of a plugin"
    says "$err" "$3"
    [[ ! -e $2 ]] || fail "$2 was written"
}
refuses output schema "would be called Schema, which the SDK uses"
refuses load registry "would be called Registry"
refuses material space "would be called Space"
refuses material real "would be called Real"
refuses material point_cloud "would be called PointCloud"
refuses shape_function spline "would be called Spline"
refuses output test "CMake"
refuses geometry matpoint "the SDK"
refuses load time "describe time"
refuses geometry bodies "describe bodies"
refuses material neo_hookean "exists already"
# Installed, it would take the place of the load.
refuses output gravity "gravity.so"
expect 2 new_plugin output NotSnake
says "$err" "snake_case"

for name in double table my_schema; do expect 0 new_plugin output "$name"; done
[[ -f my_schema/my_schema.cpp ]] || fail "no project"
