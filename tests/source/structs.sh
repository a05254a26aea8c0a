#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every struct of the public headers begins with its size, so that a binding
# made before a field was added survives it, and crosses the border by a pointer
# alone; or it is one of the small ones that stay as they are, listed in
# tools/CONTRIBUTING.md.
set -u
list=$TOP/tools/CONTRIBUTING.md
fixed=$(sed -n '/^\*\*Structs without a size/,/^$/p' "$list" |
    grep -o 'ovr_[a-z_]*' | sort -u)
[ -n "$fixed" ] || { echo "no list in $list"; exit 1; }

# Without comments, and without the inline functions, which know their sizes.
# shellcheck disable=SC2086
echo '#include <overroll/overroll.h>' |
    $CC -E -P -I"$TOP/include" -x c - | tr '\n' ' ' >text
awk -v fixed="$fixed" '
BEGIN { count = split(fixed, name, "\n"); for (k in name) listed[name[k]] = 1 }
{
    gsub(/static inline[^{}]*\{[^{}]*\}/, " ")
    rest = $0
    while (match(rest, /typedef struct ovr_[a-z_]* \{[^}]*/)) {
        one = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        split(one, word, " ")
        if (one ~ /\{ *size_t size;/) sized[word[3]] = 1
        else plain[word[3]] = 1
    }
    for (s in plain)
        if (!(s in listed))
            print s " has no size, nor is it among those that stay as they are"
    for (s in listed)
        if (!(s in plain))
            print s " is listed as a struct without a size: there is none"
    for (s in sized) {
        total++
        rest = $0
        while (match(rest, "[^a-z_]" s "[^a-z_]+[a-z]*")) {
            use = substr(rest, RSTART + 1, RLENGTH - 1)
            if (use ~ /^ovr_observation extreme/) # of a whole run
                use = "*"
            before = substr(rest, RSTART - 6, 7)
            rest = substr(rest, RSTART + length(s) + 1)
            if (use !~ /^[a-z_]* *(\*|const)/ && before !~ /(struct|}) ?$/)
                print s " crosses the border by value"
        }
    }
    if (total < 40)
        print "only " total " structs with a size were found"
}' text | sort -u >wrong
cat wrong
[ ! -s wrong ] && [ -s text ]
