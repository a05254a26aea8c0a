#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# check: what it prints is itself a case that means the same.
. "$TOP/tests/support/cli.sh"

cat >a.ini <<'END'
[contact]
M = 30          # a comment
L = 7
radius = 10 mm
modulus = 226 GPa
[time]
end = 2
[feature scratch]
shape = dent
depth = 0.1 um
width = 0.5
start = -5
END
expect 0 "$OVERROLL" check a.ini
contains out '^# lambda +0\.0041'
contains out '^# central film \(Moes\) +H = 0\.'
contains out '^depth = 0.1 um$'
contains out '^scheme = auto +# default$'
cp out b.ini
mv out first
expect 0 "$OVERROLL" check b.ini
sed 's/ *# default//' first >first.plain
sed 's/ *# default//' out >second.plain
cmp first.plain second.plain || fail "$(diff first.plain second.plain)"

expect 0 "$OVERROLL" check a.ini --json
contains out '"H_cen_moes": 0\.'
contains out '"memory_bytes": '
contains out '"transient": true'

expect 0 "$OVERROLL" help
contains out '^  check '
expect 0 "$OVERROLL" check --help
contains out '^usage: overroll check'

# Text in JSON is escaped; bytes that are not UTF-8 are replaced.
printf '[contact]\nM = 20\nL = 10\n' >t.ini
printf '[output]\ntitle = a "\303\244 \\ \377"\n' >>t.ini
expect 0 "$OVERROLL" check t.ini --json
contains out '"text": "a \\"ä \\\\ \\ufffd\\""'
if command -v python3 >/dev/null; then
    python3 -c 'import json; json.load(open("out"))' || fail 'not JSON'
fi
