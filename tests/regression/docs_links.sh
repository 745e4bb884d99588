#!/usr/bin/env bash
# docs_links.sh ROOT: relative links in the project's Markdown files lead somewhere.
set -euo pipefail
cd "$1"
status=0
while read -r file; do
    while read -r target; do
        target=${target%%#*}
        if [[ -n $target && $target != *://* && $target != mailto:* && ! -e $(dirname "$file")/$target ]]; then
            echo "$file: the link to $target leads nowhere"
            status=1
        fi
    done < <(grep -oP '\]\(\K[^) ]+' "$file" || true)
done < <(find . -name '*.md' -not -path './build*' -not -path './.git/*' -not -path './out/*')
exit $status
