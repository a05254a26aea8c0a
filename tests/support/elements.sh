# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# Random gears, cams and bearings, those of tests/reference/elements_truth.h
# (90 % of the cams' events), marched at level 6 from first to last touch:
# march_elements EVERY takes each EVERY-th.  All of them also with heat and
# Eyring's oil, then rough on both sides too at a lambda ratio of 2 and more,
# gears and bearings with conserved oil; some are stopped and resumed.
elements() {
    cat <<'END'
gear 7 30 101 4709 94.9 0 20 0.074 centre 461.626
gear 4.13 21 33 3278 46.9 10.8 25 0.393 centre 114.333
gear 2.1 35 -143 189 11.8 0 20 0.352 shift_2 0.02
gear 3.28 40 -124 1252 26 19.8 20 0.265 shift_2 -0.009
gear 7.98 24 76 5975 96.4 0 20 0.303 centre 398.368
gear 3.8 34 47 2380 51.2 24.9 20 0.085 centre 169.457
gear 3.78 28 -143 531 48.3 0 20 0.135 shift_2 -0.038
gear 2.33 30 -120 873 14.4 22.6 20 0.396 shift_2 -0.1
gear 7.99 34 72 216 119.5 0 25 0.257 shift_2 0.251
gear 2.81 22 78 2041 16.1 23.5 20 0.083 centre 152.934
gear 5.36 27 -99 851 71.4 0 20 0.347 shift_2 -0.063
gear 7.36 20 -84 1572 91.2 24.4 25 0.079 shift_2 0.09
cam 4567 flat 8.54 71.6 0 79.5 39.07 368 373 29.289 160 11.8 135.99
cam 4567 roller 3.45 74.1 12.5 56.6 38.41 2659 195 48.535 101 9 128.88 8.84 0
cam cycloidal flat 8.28 80.5 0 87.7 32.35 1765 312 31.65 128 14.2 151.38
cam cycloidal roller 6.61 71.8 0 88.5 17.82 2796 381 29.5 184 12.4 144 6.86 0.02
cam 345 flat 6.11 81.4 0 78.1 26.05 3154 264 36.636 80 13.2 143.55
cam 345 roller 8.28 68.5 12.5 87.2 20.25 731 273 45.826 56 8.8 151.38 11.88 0
cam cycloidal flat 3.45 56.1 12.5 56.5 32.72 2126 258 41.661 53 9.6 112.59
cam harmonic roller 4.14 81.9 0 63.3 18.52 450 370 27.859 144 15.9 131 10.84 0
cam 345 flat 4.2 71.6 0 80 33.88 2012 163 19.058 167 14.5 136.44
cam 345 roller 5.36 82.7 0 58.1 38.32 2612 195 28.141 144 18.9 126.72 8.26 0.02
bearing 34.2 12 31.4 274060 3719 405 0 inner 141.8
bearing 11.5 16 11.6 18010 4070 0 57 pitch 72.7
bearing 21.2 13 26 80930 2637 0 34 inner 92.5
bearing 6.4 16 7.8 12455 2491 0 -3 pitch 40.5
bearing 32.7 20 47.8 389380 5178 129 30 inner 269
bearing 11.7 28 17.1 30434 5477 0 47 pitch 153
bearing 19.2 20 26.6 144855 4615 0 -5 inner 157.5
bearing 17 25 25.9 179060 5426 0 56 pitch 163.1
END
}

# The section of a line, in mm, degrees, rpm, N, N/mm, g and um.
section() {
    echo "$1" | awk '
    function put(key, value, unit) { print key " = " value unit }
    $1 == "gear" {
        print "[gear]"
        put("module", $2, " mm"); put("teeth_1", $3); put("teeth_2", $4)
        put("speed", $5, " rpm"); put("face", $6, " mm")
        put("helix_angle", $7, " deg"); put("pressure_angle", $8, " deg")
        put("shift_1", $9); put($10, $11, $10 == "centre" ? " mm" : "")
    }
    $1 == "cam" {
        print "[cam]"
        put("law", $2); put("follower", $3); put("lift", $4, " mm")
        put("rise", $5, " deg"); put("dwell", $6, " deg")
        put("fall", $7, " deg"); put("base_radius", $8, " mm")
        put("speed", $9, " rpm"); put("preload", $10, " N")
        put("spring", $11, " N/mm"); put("mass", $12, " g")
        put("face", $13, " mm"); put("to", $14, " deg")
        if (NF > 14) { put("roller_radius", $15, " mm"); put("slip", $16) }
    }
    $1 == "bearing" {
        print "[roller_bearing]\npasses = zone"
        put("roller", $2, " mm"); put("rollers", $3); put("length", $4, " mm")
        put("load", $5, " N"); put("speed_inner", $6, " rpm")
        put("speed_outer", $7, " rpm"); put("clearance", $8, " um")
        put($9, $10, " mm")
    }'
}

# write_case FILE KIND LINE: the case of one line.
write_case() {
    {
        section "$3"
        printf '[contact]\nmodulus = 226 GPa\n'
        [ "$2" != gear ] || echo 'hertz_pressure = 0.9 GPa'
        printf '[lubricant]\nviscosity = 15 mPa.s\nalpha = 16 1/GPa\n'
        printf '[domain]\nlevel = 6\n'
        [ "$2" != cam ] || printf '[time]\nstep = adaptive\n'
        [ "$2" != bearing ] ||
            printf '[time]\nend = 8\n[cavitation]\nmodel = conserving\n'
    } >"$1"
}

# marched WHAT FILE OPTION...: to its end, no step marked.
marched() {
    what=$1 file=$2
    shift 2
    expect 0 "$OVERROLL" run "$file" --json -q "$@"
    grep -q '"steps_marked": 0,' out || fail "$what: steps are marked"
    case $what in bearing*) ;; *)
        ! grep -q '"power_loss_W": null' out ||
            fail "$what did not go its whole way" ;;
    esac
    ran=$((ran + 1))
}

# Of two surfaces, in um: 2.5 of both together are the smallest film of a run.
roughness() {
    sed -n 's/^ *"H_min_overall_m": \(.*\),/\1/p' "$1" | awk '
        { printf "%.4g", 1e6 * $1 / 2.5 / sqrt(2) }'
}

# What is summed up of a run, but for what depends on the clock and its name.
told() {
    grep -vE '"seconds"|output"|"snapshots"' "$1"
}

# rough_case FILE KIND RQ: that of one.ini between rough surfaces with heat.
rough_case() {
    {
        cat one.ini
        [ "$2" != gear ] || printf '[cavitation]\nmodel = conserving\n'
        for k in 1 2; do
            printf '[feature %d]\nsurface = %d\nshape = roughness\n' $k $k
            printf 'Rq = %s um\nlength = 20\nshortest = 0.4\n' "$3"
            printf 'seed = %d\nstart = 16\ngrow = 1\n' $k
        done
    } >"$1"
}

# interrupted WHAT FILE OPTION...: stopped on the way and resumed, the same
# to the last digit as whole.json.
interrupted() {
    what=$1 file=$2
    shift 2
    code=0
    rm -f cut.h5 # of another run, which this one may not come to replace
    timeout -s TERM 0.3 "$OVERROLL" run "$file" -q --force -o cut.h5 "$@" \
        >out 2>err </dev/null || code=$?
    [ $code -eq 0 ] || [ $code -eq 124 ] || [ $code -eq 143 ] ||
        fail "$what, stopped: $code, $(cat err)"
    [ $code -ne 0 ] && [ -e cut.h5 ] || return 0
    expect 0 "$OVERROLL" resume cut.h5 -q --json
    told whole.json >a
    told out >b
    cmp -s a b || fail "$what: resumed, another run"
    resumed=$((${resumed:-0} + 1))
}

march_elements() {
    elements >elements.list
    number=0 ran=0 every=$1
    while read -r line; do
        kind=${line%% *}
        number=$((number + 1))
        [ $(((number - 1) % every)) -eq 0 ] || continue
        write_case one.ini "$kind" "$line"
        marched "$kind $number" one.ini -o one.h5 --force
        [ "$kind" != gear ] || marched "gear $number, conserved oil" one.ini \
            --set cavitation.model=conserving
        set -- --set lubricant.rheology=eyring \
            --set lubricant.eyring_stress=5MPa --set heat.model=lobatto \
            --set heat.temperature=90degC
        # On level 6 (M = 0.77, D = 0.1 b) its temperatures do not converge
        # with the logarithmic mean between nodes.
        [ $number -ne 17 ] || set -- "$@" --set domain.level=7
        marched "$kind $number, heat" one.ini --force -o one.h5 "$@"
        rough_case rough.ini "$kind" "$(roughness out)"
        marched "$kind $number, all" rough.ini --force -o rough.h5 "$@"
        cp out whole.json
        lambda=$(sed -n 's/^ *"lambda_ratio": \(.*\),/\1/p' whole.json)
        awk -v lambda="$lambda" 'BEGIN { exit !(lambda >= 2) }' ||
            fail "$kind $number: lambda ratio $lambda"
        interrupted "$kind $number" rough.ini "$@"
    done <elements.list
    echo "$ran runs, ${resumed:-0} stopped and resumed"
}
