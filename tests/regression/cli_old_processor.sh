#!/usr/bin/env bash
# On a processor without AVX, emulated, what is built for the lowest instruction set is used, and nothing that it lacks.
source "$(dirname "$0")/expect.bash"

if [[ $(uname -m) != x86_64 ]] || ! command -v qemu-x86_64 >/dev/null; then
    echo "skipped: no qemu-x86_64 (Debian: qemu-user)"
    exit 77
fi
if [[ $("$matpoint" --version) != *v2* && ! -d $(dirname "$matpoint")/../lib/glibc-hwcaps/x86-64-v3 ]]; then
    echo "skipped: not built for x86-64-v2"
    exit 77
fi
nehalem=(qemu-x86_64 -cpu Nehalem "$matpoint")
[[ $("${nehalem[@]}" --version) == *"(x86-64-v2)" ]] || fail "$("${nehalem[@]}" --version)"
for shape in linear gimp bspline; do
    "${nehalem[@]}" run block.json --set "/shape_function/type=\"$shape\"" --set /time/end=0.01 --threads 1 --quiet \
        --output "$shape"
    grep -q '"status": "completed"' "$shape/summary.json" || fail "$(<"$shape/summary.json")"
done
