#!/usr/bin/env bash
# make_reference.sh MATPOINT [FILE]: writes reference.md, all components there are, from what they say of themselves.
set -euo pipefail
matpoint=$(realpath "$1")
file=${2:-$(dirname "$0")/reference.md}
unset MATPOINT_PLUGIN_PATH
entry='^  ([$a-z0-9_]+) '

{
    echo "# Components"
    echo
    echo "Written by [make_reference.sh](make_reference.sh) from \`matpoint list\` and \`matpoint describe\`. Sections are the"
    echo "kinds of component, headings the names that a scene gives as \`\"type\"\`; the first has the scene's own keys."
    echo "What a formula is made of: [formulas](formulas.md)."
    "$matpoint" list | while IFS= read -r line; do
        if [[ $line =~ ^([a-z_]+):\ (.*)$ ]]; then
            kind=${BASH_REMATCH[1]}
            printf '\n## %s\n%s.\n' "$kind" "${BASH_REMATCH[2]}"
        elif [[ $line =~ $entry ]]; then
            printf '\n### %s\n```text\n' "${BASH_REMATCH[1]}"
            "$matpoint" describe "$kind/${BASH_REMATCH[1]}" </dev/null
            printf '```\n'
        else
            printf '\nNone yet.\n'
        fi
    done
} >"$file"
