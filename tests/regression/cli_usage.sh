#!/usr/bin/env bash
# Help, version, and what is said about a command line that can't be understood.
source "$(dirname "$0")/expect.bash"

expect 0 --help
says "$out" "usage: matpoint VERB"
for verb in run restart validate list describe schema test study limits new_plugin; do
    says "$out" "$verb"
    "$matpoint" $verb --help >help.txt || fail "matpoint $verb --help"
    grep -qi usage help.txt || fail "matpoint $verb --help does not say how it is used"
done
expect 0 --version
[[ $out =~ ^matpoint\ [0-9]+\.[0-9]+\.[0-9]+\ \(.+\)$ ]] || fail "version: $out"

expect 2
says "$err" "usage: matpoint VERB"
expect 2 rum block.json
says "$err" 'unknown verb "rum"; did you mean "run"?'
expect 2 run block.json --outptu x
says "$err" 'did you mean "--output"?'
expect 2 run
says "$err" "too few arguments"
expect 2 run block.json block.json
says "$err" "too many arguments"
expect 2 run block.json --threads 0
says "$err" "--threads"
expect 2 run block.json --threads many
expect 2 test block.json --filter '('
says "$err" "regular expression"
[[ ! -e out ]] || fail "something was written"
