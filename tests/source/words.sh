#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# English of comments, messages, manual pages and Markdown: the counts of
# violations (words.py) do not exceed words.baseline. For each kind of text, the
# check detects a violation that is inserted.
. "$TOP/tests/support/cli.sh"

need_python re
words="$TOP/tests/source/words.py"
"$PYTHON" "$words" --root "$TOP" || fail "see tools/STYLE.md"

mkdir -p tree/src/new tree/tools
cat >tree/src/new/new.c <<'END'
/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tells the load. */
int f(void) /* Serves the anew made load. */
{
    return puts("the smallest film"
                " of the run");
}
END
printf '.SH TEXT\nIt is to be written anew.\n' >tree/src/new/overroll-new.5
echo 'The largest pressure is zero.' >tree/tools/NEW.md
: >tree/README.md
: >tree/CHANGELOG.md
! "$PYTHON" "$words" --root tree --baseline none >out ||
    fail "nothing found: $(cat out)"
for line in 'src/new: head: tell-say: 1' 'src/new: head: vague-verb: 1' \
    'src/new: comment: vague-verb: 1' 'src/new: comment: archaic: 1' \
    'src/new: message: term: 1' 'src/new: man: archaic: 1' \
    'tools: md: term: 1'; do
    grep -q "^$line, allowed" out || fail "not found: $line: $(cat out)"
done
