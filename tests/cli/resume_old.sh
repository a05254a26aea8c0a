#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A file that version 0.1.0 stopped goes on as it began: second order,
# upstream2, whatever the defaults of today.  0.1.0 itself ended with the film
# below; a step is solved to a tolerance, on this level some 1e-5 of H.
. "$TOP/tests/support/cli.sh"

for part in h5 h5.restart; do
    gzip -dc "$TOP/tests/cli/stopped/0.1.0.$part.gz" >"old.$part" || exit 1
done
expect 0 "$OVERROLL" resume old.h5 --set time.end=1 --json
contains out '"order": 2'
contains out '"scheme": "upstream2"'
H=$(sed -n 's/^  "H_cen": \([0-9.e-]*\).*/\1/p' out)
awk -v a="$H" 'BEGIN { d = a/0.0769017516 - 1; exit !(d*d < 1e-8) }' ||
    fail "H_cen = $H, by 0.1.0 0.0769017516"

# Another order or scheme is another run, said and refused.
for part in h5 h5.restart; do
    gzip -dc "$TOP/tests/cli/stopped/0.1.0.$part.gz" >"old.$part" || exit 1
done
expect 2 "$OVERROLL" resume old.h5 --set time.end=1 --set domain.order=4
contains err "'domain.order' was '2' and is now '4'"
