#!/usr/bin/env bash
# Kernel and plugins for the machine's best instruction set are used, for a lower one if the machine has no better, and the
# results agree: to the bit where the processor can multiply and add in one operation, to rounding where it can't.
source "$(dirname "$0")/expect.bash"

built=(x86-64-v2)
for set in x86-64-v3 x86-64-v4; do
    if [[ -d $(dirname "$matpoint")/../lib/glibc-hwcaps/$set ]]; then built+=("$set"); fi
done
if ((${#built[@]} == 1)); then
    echo "skipped: built for one instruction set, or installed elsewhere"
    exit 77
fi
machine_has=$(/lib64/ld-linux-x86-64.so.2 --help)
# What the dynamic linker is told to believe that the processor lacks.
declare -A lacks=([x86-64-v2]=-AVX2,-AVX512F [x86-64-v3]=-AVX512F [x86-64-v4]=)

plugins='/outputs=[{ "type": "csv", "every": "25 ms", "fields": ["velocity", "stress"] }]'
had=()
for set in "${built[@]}"; do
    if [[ $machine_has != *"$set (supported"* ]]; then
        echo "not tried: this machine has no $set"
        continue
    fi
    export GLIBC_TUNABLES=glibc.cpu.hwcaps=${lacks[$set]}
    expect 0 --version
    says "$out" "($set)"
    for shape in linear gimp bspline; do
        for precision in double single; do
            expect 0 run block.json --set "$plugins" --set "/shape_function/type=\"$shape\"" \
                --set "/space/precision=\"$precision\"" --quiet --output "$set/$shape/$precision"
            grep -q "\"instruction_set\": \"$set\"" "$set/$shape/$precision/summary.json" || fail "summary.json does not say $set"
        done
        # The plugin's build that is opened: the one for this set, and for no other.
        LD_DEBUG=files "$matpoint" validate block.json --set "/shape_function/type=\"$shape\"" 2>&1 |
            grep -o "/plugins/[^ ]*$shape\.so" | sort --unique >opened.txt
        folder=/plugins/$set
        if [[ $set == "${built[0]}" ]]; then folder=/plugins; fi
        [[ $(<opened.txt) == "$folder/$shape.so" ]] || fail "$set opened $(<opened.txt)"
    done
    had+=("$set")
done
unset GLIBC_TUNABLES

for shape in linear gimp bspline; do
    for precision in double single; do
        for table in x86-64-v2/"$shape"/"$precision"/particles_block_*.csv; do
            other=${table#*/}
            if [[ ${had[*]} == *v3* ]]; then
                tolerance=1e-9
                if [[ $precision == single ]]; then tolerance=1e-3; fi
                "$here/same_table.py" "$table" "x86-64-v3/$other" $tolerance
            fi
            if [[ ${had[*]} == *v4* ]]; then cmp "x86-64-v3/$other" "x86-64-v4/$other"; fi
        done
    done
done
echo "agree: ${had[*]}"
