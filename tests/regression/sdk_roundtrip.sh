#!/usr/bin/env bash
# What a user does with an installation: makes a plugin of their own, builds it out of tree, tests
# it, and runs its scene. Usage: sdk_roundtrip.sh PREFIX KIND NAME
set -euo pipefail
prefix=$1 kind=$2 name=$3

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
unset MATPOINT_PLUGIN_PATH LD_LIBRARY_PATH
# In a place of its own, so that nothing can lean on the folder it was installed to.
cp -a "$prefix" "$work/sdk"
export PATH="$work/sdk/bin:$PATH"

fail() { echo "sdk_roundtrip: $*" >&2; exit 1; }
# expect STATUS TEXT COMMAND...: the command ends with the status and says the text.
expect() {
    local status=$1 text=$2 got=0 said
    shift 2
    said=$("$@" 2>&1) || got=$?
    [[ $got == "$status" ]] || fail "\`$*\` ended with $got, not $status: $said"
    [[ $said == *"$text"* ]] || fail "\`$*\` did not say \"$text\": $said"
}

expect 2 "did you mean \"material\"" matpoint new_plugin matrial "$name"
expect 2 "snake_case" matpoint new_plugin "$kind" NotSnake
expect 2 "usage" matpoint new_plugin "$kind"
expect 0 "$name" matpoint new_plugin "$kind" "$name"
expect 2 "exists already" matpoint new_plugin "$kind" "$name"
cd "$name"

# The scene needs the plugin.
expect 2 "$name" matpoint validate "$name.json"

# What is said about the plugin's target holds for its builds for each instruction set.
cat >>CMakeLists.txt <<end
target_sources($name PRIVATE afterwards.cpp)
target_compile_definitions($name PRIVATE SAID_AFTERWARDS)
end
printf '#ifndef SAID_AFTERWARDS\n#error\n#endif\n' >afterwards.cpp
sets=()
if [[ $kind == material ]]; then sets=(-DMATPOINT_INSTRUCTION_SETS=all); fi
expect 1 "was not built for \"x86-64-v9\"" cmake -S . -B refused -DMATPOINT_INSTRUCTION_SETS=x86-64-v9
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release "${sets[@]}"
cmake --build build
ctest --test-dir build --output-on-failure --no-tests=error

# Found by its folder, or named by the scene.
MATPOINT_PLUGIN_PATH=build/plugins expect 0 "" matpoint validate "$name.json"
MATPOINT_PLUGIN_PATH=build/plugins expect 0 "" matpoint run "$name.json" --output by_folder --quiet
MATPOINT_PLUGIN_PATH=build/plugins expect 0 "$name" matpoint describe "$name"
sed "s|\"matpoint\": 1,|&\n  \"plugins\": [\"build/plugins/$name.so\"],|" "$name.json" > by_file.json
expect 0 "" matpoint run by_file.json --output by_file --quiet
for run in by_folder by_file; do
    grep -q "\"$name\"" <(sed -n '/"loaded_plugins"/,/]/p' $run/summary.json) || fail "$run/summary.json does not list $name"
done

# The plugin is built for this machine alone, which the library says; or for each instruction set that Matpoint was built for, of which
# the machine's best is opened.
set=$(matpoint --version | sed 's/.*(\(.*\))/\1/')
if [[ $kind != material ]]; then
    [[ $(find build/plugins -name '*.so') == "build/plugins/$name.so" ]] || fail "more than one build: $(find build/plugins -name '*.so')"
    if [[ $set == x86-64-v* ]]; then
        readelf --notes "build/plugins/$name.so" | grep -q "ISA needed: .*$set" || fail "build/plugins/$name.so is not for $set"
    fi
fi
builds=() best=
if [[ $kind == material ]]; then
    for kernel in "$work"/sdk/lib/glibc-hwcaps/*/; do
        if [[ -d $kernel ]]; then builds+=("$(basename "$kernel")/"); fi
    done
    if [[ -d $work/sdk/lib/glibc-hwcaps/$set ]]; then best=$set/; fi
fi
for folder in "${builds[@]}" ""; do
    [[ -f build/plugins/$folder$name.so ]] || fail "build/plugins/$folder$name.so was not built"
done
expect_opened() {  # FOLDER: the plugin comes from there, and from nowhere else
    local opened
    opened=$(LD_DEBUG=files matpoint validate "$name.json" 2>&1 | grep -o "/[^ ]*/$name\.so" | sort --unique)
    [[ $opened == "$1/$best$name.so" ]] || fail "opened $opened, not $1/$best$name.so"
}
MATPOINT_PLUGIN_PATH=build/plugins expect_opened "$(realpath build)/plugins"

# Installed beside the plugins that came with the SDK, it needs neither.
cmake --install build --prefix "$work/sdk"
expect 0 "" matpoint validate "$name.json"
expect_opened "$(realpath "$work/sdk")/lib/matpoint/plugins"
expect 2 "already" matpoint new_plugin "$kind" "$name" --output again
