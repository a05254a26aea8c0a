#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# `make html`: README, manual, gallery, validation and the paper as one site
# whose links lead somewhere, and which a browser shows whole on a wide and a
# narrow screen.
. "$TOP/tests/support/cli.sh"
need mandoc
need python3

mkdir build build/examples
cp "$BUILD/overroll-case.5" build
cp "$TOP/tools/pictures/gear.png" build/examples/ground.png
export OVERROLL PYTHONDONTWRITEBYTECODE=1
expect 0 python3 "$TOP/tools/site/run" --no-examples --fast build
for page in index manual overroll.1 overroll-case.5 overroll-theory.7 gallery \
    validation proofs accuracy speed paper changelog contributing; do
    [ -s build/html/$page.html ] || fail "no page $page"
done
contains build/html/index.html 'Venner'
contains build/html/gallery.html '<img src="[^"]*ground.png"'
contains build/html/overroll-case.5.html \
    '<b><a href="#eyring_stress">eyring_stress</a></b>'
for example in $(cd "$TOP/tools/examples" && ls); do
    case $example in *.*) continue ;; esac
    contains build/html/gallery.html "id=\"$example\""
done

# What leads nowhere is found out
cp -r build/html broken
echo '<a href="gone.html">x</a><a href="index.html#gone">x</a>' \
    >>broken/paper.html
expect 1 python3 "$TOP/tools/site/links.py" broken
[ "$(wc -l <out)" -eq 2 ] || fail "$(cat out)"

command -v chromedriver >/dev/null || exit 0
expect 0 python3 - "$TOP/tests/pictures" "$PWD/build/html" <<'END'
import glob
import sys

sys.path.insert(0, sys.argv[1])
from browser import Browser

for width in 1300, 500:
    browser = Browser(width, 900)
    try:
        for page in sorted(glob.glob(sys.argv[2] + "/*.html")):
            browser.open("file://" + page)
            wide, room, lost = browser.run(
                "return [document.scrollingElement.scrollWidth, innerWidth, "
                "[...document.images].filter(i => !(i.complete && "
                "i.naturalWidth)).length]")
            assert wide <= room, (page, width, wide)
            assert lost == 0, (page, "pictures")
            assert not browser.log(), (page, browser.log())
        # From the front page to a key, by its links
        browser.open("file://" + sys.argv[2] + "/index.html")
        for where in 'nav a[href="manual.html"]', \
                'a[href$="#Index_of_keys"]', 'a[href="#eyring_stress"]':
            browser.run("document.querySelector(arguments[0]).click()", where)
            browser.wait("return document.readyState == 'complete'")
        top = browser.run("return document.getElementById("
                          "'eyring_stress').getBoundingClientRect().top")
        assert -1 < top < 900, top  # pages scroll by whole pixels
    finally:
        browser.close()
END
