#!/bin/sh
# SPDX-License-Identifier: MIT
# The version, help and facts; and the manual's session with `scarp sample`.
. ./common.sh

version=$(sed -n 's/^#define SCARP_VERSION_[A-Z]* //p' "$source_dir/include/scarp.h" |
    tr '\n' . | sed 's/\.$//')
[ "$(scarp --version)" = "scarp $version" ] || fail "--version prints $(scarp --version)"
scarp info >"$notes/info"
grep -q '^scalar  *yes' "$notes/info" || fail "info: $(cat "$notes/info")"
[ "$(grep -c ' yes$' "$notes/info")" -eq 1 ] || fail "not one set is active: $(cat "$notes/info")"
for command in terrain sample info; do
    scarp help $command >"$notes/one"
    scarp $command --help >"$notes/other"
    same "$notes/one" "$notes/other"
    grep -q "^usage: scarp $command" "$notes/one" || fail "help $command: $(cat "$notes/one")"
done

# shellcheck disable=SC2016 # the dollar is the prompt
sed -n '/^\$ printf .*scarp sample/,/^```$/{p;/^```$/q;}' "$source_dir/src/cli/README.md" >"$notes/session"
command=$(sed -n '1s/^\$ //p' "$notes/session")
sed '1d;$d' "$notes/session" >"$notes/expected"
[ "$(wc -l <"$notes/expected")" -ge 3 ] || fail "src/cli/README.md has no session with scarp sample"
eval "$command" >"$notes/printed"
diff "$notes/expected" "$notes/printed" || fail "$command prints (>) not what the manual says (<)"

# From a file to a file, as from standard input to standard output
printf '1.5 2.25 3\n-4 0.5 6\n' >points.txt
scarp sample --dims 3 --input points.txt --output values.txt
scarp sample --dims 3 --input-format text --output-format text <points.txt | cmp - values.txt ||
    fail "files and streams get different results"
[ "$(wc -l <values.txt)" -eq 2 ] || fail "2 points have $(wc -l <values.txt) results"
printf '1 2\n1 x\n' >bad.txt
refused 2 'bad.txt' sample --input bad.txt --output never.txt
