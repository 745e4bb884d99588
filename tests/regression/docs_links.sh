#!/usr/bin/env bash
# docs_links.sh ROOT: relative links in the project's Markdown files lead somewhere, and README.md's table of
# verification has every folder.
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
for folder in configs/verification/*/; do
    if ! grep -q "^| \[$(basename "$folder")\](${folder}README.md) |" README.md; then
        echo "README.md: the table of verification lacks $folder"
        status=1
    fi
done
exit $status
