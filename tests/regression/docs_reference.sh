#!/usr/bin/env bash
# docs_reference.sh MATPOINT ROOT: the reference page is what its script writes.
set -euo pipefail
page=$(mktemp)
trap 'rm "$page"' EXIT
"$2/framework/docs/make_reference.sh" "$1" "$page"
diff "$2/framework/docs/reference.md" "$page" ||
    { echo "out of date: framework/docs/make_reference.sh $1" >&2; exit 1; }
