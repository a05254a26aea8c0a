# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# Common part of the examples: builds the program if necessary and sets
# $overroll, $name and the output folder $out. All pictures have one style.
set -eu
cd "$(dirname "$0")/../.."
name=$(basename "$0")
out=${EXAMPLES:-build/examples}
overroll=${OVERROLL:-build/overroll}
[ -x "$overroll" ] || make -s -j"$(nproc 2>/dev/null || echo 2)" "$overroll"
mkdir -p "$out"

# Runs the study of this name and writes its table.
run_study() {
    "$overroll" sweep "tools/examples/$name.ini" -o "$out/$name"
    "$overroll" sweep "tools/examples/$name.ini" -o "$out/$name" \
        --collect "$out/$name.csv" -q
}

# column NAME: prints the number of the column NAME (without unit) in the table
# of the study or in the history of the run.
column() {
    found=$(head -n 1 "$out/$name.csv" | tr ',' '\n' | sed 's/ \[.*\]$//' |
        grep -nxF "$1") || {
        echo "$name: no column '$1' in $out/$name.csv" >&2
        return 1
    }
    echo "${found%%:*}"
}

# picture WxH: draws a picture from gnuplot commands on standard input.
picture() {
    {
        cat <<END
set terminal pngcairo size ${1%x*},${1#*x} font 'sans,13' linewidth 1.6
set output '$out/$name.png'
set datafile separator ','
set linetype 1 linecolor rgb '#0b5fa5'
set linetype 2 linecolor rgb '#c8501e'
set linetype 3 linecolor rgb '#2f8f4e'
set linetype 4 linecolor rgb '#7a4fa3'
set linetype 5 linecolor rgb '#a8860b'
set linetype 6 linecolor rgb '#444444'
set grid linecolor rgb '#dddddd' linetype 1 linewidth 0.6
set border linecolor rgb '#666666' linewidth 0.8
set tics nomirror
set encoding utf8
set lmargin 11
set key noautotitle samplen 2 tmargin center horizontal
END
        cat
    } | LC_ALL=C.UTF-8 gnuplot # in C it warns of the degree sign
    echo "$out/$name.png"
}
