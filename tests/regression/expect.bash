# For the tests of the command line; sourced. $1 is the executable. Each test works in a folder of its own.
set -euo pipefail
matpoint=$(realpath "$1")
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cp "$here/block.json" .

fail() {
    echo "FAILED: $*" >&2
    exit 1
}

# expect STATUS ARGUMENT...: what the command prints is then in $out and $err.
expect() {
    local wanted=$1 status=0
    shift
    "$matpoint" "$@" >stdout.txt 2>stderr.txt || status=$?
    out=$(<stdout.txt) err=$(<stderr.txt)
    ((status == wanted)) || fail "matpoint $*: status $status, expected $wanted"$'\n'"$out"$'\n'"$err"
}

# says TEXT PART: the text has the part.
says() {
    [[ $1 == *"$2"* ]] || fail "expected \"$2\" in:"$'\n'"$1"
}
