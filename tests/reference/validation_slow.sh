#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The fast part of tools/validation: every number is within its band, and the
# page needs no other file. A film thickness with an error of 10 % is detected.
. "$TOP/tests/support/cli.sh"

if ! command -v python3 >/dev/null; then
    echo 'no python3'
    exit 77
fi
export OVERROLL PYTHONDONTWRITEBYTECODE=1
expect 0 "$TOP/tools/validation/run" --fast .
contains out '^[0-9]+ published numbers .* 0 not\.'
contains validation.md '^\| Martin, M = 0\.05.* \| 48\.952 \| 48\.9'
contains validation.md 'Murch and Wilson, L = 2.86, from memory: not counted'
contains validation.md 'S = -0\.5, .*, derived here: not counted \| 0\.848'
contains validation.html '<svg '
! grep -E '(src|href)=' validation.html || fail 'the page needs other files'
expect 0 python3 - "$TOP/tools/validation" <<'END'
import sys
sys.path.insert(0, sys.argv[1])
import checks
solve = checks.steady


def thicker(*arguments, **level):
    film = solve(*arguments, **level)
    return {**film, "H_min_located": 1.1 * film["H_min_located"]}


assert all(row.inside for row in checks.formulas(((50, 8),)).rows)
checks.steady = thicker
rows = checks.formulas(((50, 8),)).rows
off = [row.what for row in rows if not row.inside]
assert off == [row.what for row in rows if "minimum film" in row.what], off
assert off

wave = checks.film_wave
checks.film_wave = lambda k, s, E, Hc: wave(k, s, 1.1 * E, Hc)
rows = checks.sliding_waves(((20, 10, 0.3),), (0.5,), (0.3,), 8).rows
assert not any(row.inside for row in rows), rows  # ten per cent more flow

left = checks.small_waves.amplitude_left
checks.small_waves.amplitude_left = lambda c, length, angle, *more, **stride: \
    left(c, length, angle - 5, *more, **stride)
rows = checks.directions((), (), ((20, 10, 45, (0.5,), 0),), (), (), 5, 8).rows
assert rows and not any(row.inside for row in rows), rows  # at 40 degrees
END
expect 2 "$TOP/tools/validation/run" a b
