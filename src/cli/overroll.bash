# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Completion of overroll for bash.

# Options of a command; written by tools/update-manual.
_overroll_options() {
    case $1 in
    steady) echo '--estimate-error --set --M --L --level --scheme --smoother -q -v --json --help' ;;
    run) echo '-o --force --estimate-error --set --M --L --level --scheme --smoother -q -v --json --help' ;;
    resume) echo '--from-start --force --set --M --L --level --scheme --smoother -q -v --json --help' ;;
    check) echo '--set --M --L --level --scheme --smoother -q -v --json --help' ;;
    info) echo '-q -v --json --help' ;;
    sweep) echo '-j -o --list --task --collect --retry --redo -q -v --json --help' ;;
    stress) echo '--set --M --L --level --scheme --smoother -q -v --json --help' ;;
    export) echo '--snapshot --time --all --long --wide --at --field --units --format -o --force -q -v --json --help' ;;
    plot) echo '-o --kind --at --overlay --field --surface --depth --script --quantity --against --lines --log --hertzian --si -x --time --p-max --h-max --size --title --no-hertz --no-roughness --force -q -v --json --help' ;;
    frames) echo '-o --movie --rate --every --form --jobs --stress --depth --script --hertzian --si -x --time --p-max --h-max --size --title --no-hertz --no-roughness --force -q -v --json --help' ;;
    view) echo '-o --title --stress --force -q -v --json --help' ;;
    profile) echo '--unit-x --unit-z --spacing --column-x --column-z --line --from --to --level --degree --lambda-c --lambda-s --outliers --max-gap --max-missing --scale --offset --invert --reverse --case --convert --plot --force -q -v --json --help' ;;
    init) echo '--oil -o --force -q -v --json --help' ;;
    help) echo '--roff --bash -q -v --json --help' ;;
    esac # options
}

# Words of a key of the case; written by tools/update-manual.
_overroll_values() {
    case $1 in
    contact.M) echo '' ;;
    contact.L) echo '' ;;
    contact.lambda) echo '' ;;
    contact.alphabar) echo '' ;;
    contact.load) echo '' ;;
    contact.width) echo '' ;;
    contact.hertz_pressure) echo '' ;;
    contact.radius) echo '' ;;
    contact.modulus) echo '' ;;
    contact.viscosity) echo '' ;;
    contact.alpha) echo '' ;;
    contact.speed_1) echo '' ;;
    contact.speed_2) echo '' ;;
    contact.mean_speed) echo '' ;;
    contact.slide_to_roll) echo '' ;;
    contact.G) echo '' ;;
    contact.bearable_pressure) echo '' ;;
    lubricant.viscosity_law) echo 'roelands barus isoviscous doolittle yasutomi table' ;;
    lubricant.density_law) echo 'dowson-higginson incompressible tait table' ;;
    lubricant.viscosity) echo '' ;;
    lubricant.alpha) echo '' ;;
    lubricant.p0) echo '' ;;
    lubricant.z) echo 'auto' ;;
    lubricant.rheology) echo 'newtonian eyring carreau table' ;;
    lubricant.eyring_stress) echo '' ;;
    lubricant.eyring_number) echo '' ;;
    lubricant.carreau_stress) echo '' ;;
    lubricant.carreau_number) echo '' ;;
    lubricant.carreau_n) echo '' ;;
    lubricant.carreau_a) echo '' ;;
    lubricant.carreau_form) echo 'rate stress' ;;
    lubricant.rheology_file) echo '' ;;
    lubricant.limiting_shear) echo '' ;;
    lubricant.temperature) echo '' ;;
    lubricant.viscosity_40) echo '' ;;
    lubricant.viscosity_100) echo '' ;;
    lubricant.iso_vg) echo '' ;;
    lubricant.viscosity_index) echo '' ;;
    lubricant.density_15) echo '' ;;
    lubricant.viscosity_file) echo '' ;;
    lubricant.density_file) echo '' ;;
    lubricant.tait_K0) echo '' ;;
    lubricant.tait_K0_slope) echo '' ;;
    lubricant.doolittle_B) echo '' ;;
    lubricant.doolittle_R0) echo '' ;;
    lubricant.yasutomi_Tg0) echo '' ;;
    lubricant.yasutomi_A1) echo '' ;;
    lubricant.yasutomi_A2) echo '' ;;
    lubricant.yasutomi_b1) echo '' ;;
    lubricant.yasutomi_b2) echo '' ;;
    lubricant.yasutomi_C1) echo '' ;;
    lubricant.yasutomi_C2) echo '' ;;
    lubricant.glass_viscosity) echo '' ;;
    lubricant.S0) echo '' ;;
    lubricant.beta) echo '' ;;
    heat.model) echo 'none lobatto' ;;
    heat.points) echo '5 7' ;;
    heat.temperature) echo '' ;;
    heat.temperature_1) echo '' ;;
    heat.temperature_2) echo '' ;;
    heat.conductivity) echo '' ;;
    heat.heat_capacity) echo '' ;;
    heat.density) echo '' ;;
    heat.expansion) echo '' ;;
    heat.density_expansion) echo 'yes no' ;;
    domain.inlet) echo 'usual auto' ;;
    domain.outlet) echo 'auto' ;;
    domain.level) echo 'auto' ;;
    domain.accuracy) echo '' ;;
    domain.accuracy_of) echo 'H_cen H_min features' ;;
    domain.nodes) echo '' ;;
    domain.order) echo 'auto 2 4' ;;
    domain.refine) echo 'none spike' ;;
    domain.refine_level) echo '' ;;
    domain.refine_change) echo '' ;;
    solver.cycle) echo 'V W' ;;
    solver.sweeps_before) echo 'auto' ;;
    solver.sweeps_after) echo 'auto' ;;
    solver.coarsest_level) echo 'auto' ;;
    solver.stop) echo 'negligible truncation fixed' ;;
    solver.max_cycles) echo 'auto' ;;
    solver.tolerance) echo 'auto' ;;
    time.end) echo 'auto' ;;
    time.step) echo 'grid adaptive' ;;
    time.scheme) echo 'auto upstream1 upstream2 characteristic' ;;
    time.error) echo '' ;;
    time.until_steady) echo 'yes no' ;;
    load.history) echo 'constant ramp sine step table' ;;
    load.from) echo '' ;;
    load.to) echo '' ;;
    load.start) echo '' ;;
    load.duration) echo '' ;;
    load.amplitude) echo '' ;;
    load.period) echo '' ;;
    load.file) echo '' ;;
    load.time_unit) echo 'b/um s ms us' ;;
    speed.history) echo 'constant ramp sine step table' ;;
    speed.from) echo '' ;;
    speed.to) echo '' ;;
    speed.start) echo '' ;;
    speed.duration) echo '' ;;
    speed.amplitude) echo '' ;;
    speed.period) echo '' ;;
    speed.file) echo '' ;;
    speed.time_unit) echo 'b/um s ms us' ;;
    speed.mean) echo '' ;;
    sliding.history) echo 'constant ramp sine step table' ;;
    sliding.from) echo '' ;;
    sliding.to) echo '' ;;
    sliding.start) echo '' ;;
    sliding.duration) echo '' ;;
    sliding.amplitude) echo '' ;;
    sliding.period) echo '' ;;
    sliding.file) echo '' ;;
    sliding.time_unit) echo 'b/um s ms us' ;;
    radius.history) echo 'constant ramp sine step table' ;;
    radius.from) echo '' ;;
    radius.to) echo '' ;;
    radius.start) echo '' ;;
    radius.duration) echo '' ;;
    radius.amplitude) echo '' ;;
    radius.period) echo '' ;;
    radius.file) echo '' ;;
    radius.time_unit) echo 'b/um s ms us' ;;
    radius.curvature) echo 'auto rides imposed' ;;
    radius_1.history) echo 'constant ramp sine step table' ;;
    radius_1.from) echo '' ;;
    radius_1.to) echo '' ;;
    radius_1.start) echo '' ;;
    radius_1.duration) echo '' ;;
    radius_1.amplitude) echo '' ;;
    radius_1.period) echo '' ;;
    radius_1.file) echo '' ;;
    radius_1.time_unit) echo 'b/um s ms us' ;;
    cavitation.model) echo 'reynolds conserving' ;;
    supply.model) echo 'flooded film' ;;
    supply.thickness_1) echo '' ;;
    supply.thickness_2) echo '' ;;
    supply.profile_1) echo '' ;;
    supply.profile_2) echo '' ;;
    supply.waiting) echo 'endless' ;;
    supply.history) echo 'constant ramp sine step table' ;;
    supply.from) echo '' ;;
    supply.to) echo '' ;;
    supply.start) echo '' ;;
    supply.duration) echo '' ;;
    supply.amplitude) echo '' ;;
    supply.period) echo '' ;;
    supply.file) echo '' ;;
    supply.time_unit) echo 'b/um s ms us' ;;
    passes.number) echo '' ;;
    passes.split) echo '' ;;
    passes.loss) echo '' ;;
    passes.side_flow) echo '' ;;
    passes.replenish) echo '' ;;
    passes.spacing) echo '' ;;
    passes.recovery) echo '' ;;
    passes.again) echo 'both 1 2' ;;
    passes.loads) echo '' ;;
    feature.surface) echo '' ;;
    feature.shape) echo 'dent bump indent ridge step groove wave chirp texture profile roughness' ;;
    feature.start) echo 'inlet' ;;
    feature.centre) echo '' ;;
    feature.edge) echo '' ;;
    feature.arrival) echo '' ;;
    feature.origin) echo '' ;;
    feature.depth) echo '' ;;
    feature.height) echo '' ;;
    feature.amplitude) echo '' ;;
    feature.width) echo '' ;;
    feature.diameter) echo '' ;;
    feature.half_width) echo '' ;;
    feature.rim_diameter) echo '' ;;
    feature.rim_height) echo '' ;;
    feature.wavelength) echo '' ;;
    feature.wavelength_end) echo '' ;;
    feature.length) echo '' ;;
    feature.shoulder) echo '' ;;
    feature.shoulder_at) echo '' ;;
    feature.shoulder_width) echo '' ;;
    feature.flank) echo '' ;;
    feature.radius) echo '' ;;
    feature.grow) echo '' ;;
    feature.grow_from) echo '' ;;
    feature.repeat) echo '' ;;
    feature.copies) echo 'endless' ;;
    feature.file) echo '' ;;
    feature.unit_x) echo '' ;;
    feature.unit_z) echo '' ;;
    feature.spacing) echo '' ;;
    feature.column_x) echo '' ;;
    feature.column_z) echo '' ;;
    feature.line) echo '' ;;
    feature.from) echo '' ;;
    feature.to) echo '' ;;
    feature.scale) echo '' ;;
    feature.invert) echo 'yes no' ;;
    feature.stretch) echo '' ;;
    feature.reverse) echo 'yes no' ;;
    feature.max_gap) echo '' ;;
    feature.max_missing) echo '' ;;
    feature.outliers) echo '' ;;
    feature.level) echo 'none mean line polynomial ends circle auto' ;;
    feature.degree) echo '' ;;
    feature.lambda_c) echo '' ;;
    feature.lambda_s) echo '' ;;
    feature.offset) echo '' ;;
    feature.taper) echo '' ;;
    feature.extend) echo 'none periodic mirror' ;;
    feature.Rq) echo '' ;;
    feature.spectrum) echo 'self-affine exponential' ;;
    feature.hurst) echo '' ;;
    feature.rolloff) echo '' ;;
    feature.shortest) echo '' ;;
    feature.correlation) echo '' ;;
    feature.skewness) echo '' ;;
    feature.kurtosis) echo '' ;;
    feature.seed) echo '' ;;
    output.file) echo '' ;;
    output.title) echo '' ;;
    output.every) echo '' ;;
    output.interval) echo '' ;;
    output.at) echo '' ;;
    output.feature_at) echo '' ;;
    output.fields) echo 'pressure film_thickness roughness density viscosity mass_flow cavitated shear_stress_1 shear_stress_2 temperature_1 temperature_2 temperature_mean temperature_middle heat_flux_1 heat_flux_2 filling oil_content' ;;
    output.precision) echo 'f64 f32' ;;
    output.from) echo '' ;;
    output.to) echo '' ;;
    output.stride) echo '' ;;
    output.compression) echo '' ;;
    output.checkpoint) echo '' ;;
    paper.smoother) echo 'line hybrid gauss-seidel dipole' ;;
    paper.switch) echo '' ;;
    paper.relax_seidel) echo '' ;;
    paper.relax_dipole) echo '' ;;
    paper.paper_balance) echo 'yes no' ;;
    paper.cycles) echo '' ;;
    paper.mlmi_order) echo 'auto' ;;
    paper.mlmi_range) echo 'auto' ;;
    stress.surface) echo '1 2 both' ;;
    stress.depth_min) echo 'auto' ;;
    stress.depth_max) echo '' ;;
    stress.depths_per_octave) echo '' ;;
    stress.every) echo '' ;;
    stress.fields) echo 'sigma_x sigma_z tau_xz sigma_y von_mises max_shear tresca hydrostatic' ;;
    stress.window) echo 'feature' ;;
    stress.traction) echo 'auto yes no' ;;
    fatigue.criterion) echo 'circle orthogonal critical-plane dang-van von-mises tresca' ;;
    fatigue.alpha) echo '' ;;
    fatigue.limit_pressure) echo 'none' ;;
    fatigue.exponent) echo '31/3' ;;
    fatigue.depth_exponent) echo '7/3' ;;
    fatigue.weibull) echo '9/8 10/9' ;;
    fatigue.least_depth) echo 'auto' ;;
    fatigue.raceway) echo '' ;;
    fatigue.count) echo '' ;;
    fatigue.residual_x) echo '' ;;
    fatigue.residual_y) echo '' ;;
    body.material) echo 'steel silicon-nitride tungsten-carbide bronze glass sapphire' ;;
    body.modulus) echo '' ;;
    body.poisson) echo '' ;;
    body.conductivity) echo '' ;;
    body.heat_capacity) echo '' ;;
    body.density) echo '' ;;
    body.radius) echo 'flat' ;;
    esac # keys
}

# The keys; of a feature those with the name that is typed.
_overroll_keys() {
    local name=NAME
    [[ $1 =~ ^feature\.([^.]+)\. ]] && name=${BASH_REMATCH[1]}
    declare -f _overroll_values |
        sed -n "s/^ *\([a-z]*\.[A-Za-z_0-9]*\))\$/\1=/p" |
        sed "s/^feature\./feature.$name./"
}

_overroll_commands() {
    declare -f _overroll_options | sed -n 's/^ *\([a-z]*\))$/\1/p'
}

# _overroll_words WORD...: those that begin like the word at the cursor.
_overroll_words() {
    local word
    COMPREPLY=()
    for word; do
        [[ $word == "${COMP_WORDS[COMP_CWORD]}"* ]] && COMPREPLY+=("$word")
    done
    return 0
}

# Words that may follow an option.
_overroll_choices() {
    case $1:$2 in
    *:--kind) echo 'snapshot history map trace stress risk depth passes' ;;
    export:--field | plot:--field) echo 'pressure film_thickness roughness' ;;
    *:--units) echo 'stored hertzian si' ;;
    *:--format) echo 'csv gnuplot matlab' ;;
    *:--form) echo 'png svg pdf' ;;
    *:--scheme) _overroll_values time.scheme ;;
    *:--smoother) _overroll_values paper.smoother ;;
    profile:--level) _overroll_values feature.level ;;
    profile:--unit-x) echo 'um mm nm m inch b' ;;
    profile:--unit-z) echo 'um nm mm m inch b^2/R' ;;
    esac
}

# Behind --set: a key, or, behind its =, a word. (bash takes = for a word of
# its own.)
_overroll_set() {
    local key=$1 word=$2
    if [[ -z $key ]]; then
        # shellcheck disable=SC2046 # a list of words
        _overroll_words $(_overroll_keys "$word")
        compopt -o nospace 2>/dev/null
        return 0
    fi
    [[ $key =~ ^feature\. ]] && key=feature.${key##*.}
    [[ $word == = ]] && COMP_WORDS[COMP_CWORD]=
    # shellcheck disable=SC2046 # a list of words
    _overroll_words $(_overroll_values "$key")
}

_overroll() {
    local verb=${COMP_WORDS[1]} word=${COMP_WORDS[COMP_CWORD]} k=COMP_CWORD
    local before=${COMP_WORDS[COMP_CWORD - 1]} choices
    COMPREPLY=()
    # shellcheck disable=SC2046 # lists of words
    if ((COMP_CWORD == 1)); then
        _overroll_words $(_overroll_commands) --version --help
    elif [[ $before == --set && $word != = ]]; then
        _overroll_set '' "$word"
    elif [[ $word == = && ${COMP_WORDS[k - 2]} == --set ]]; then
        _overroll_set "$before" "$word"
    elif [[ $before == = && ${COMP_WORDS[k - 3]} == --set ]]; then
        _overroll_set "${COMP_WORDS[k - 2]}" "$word"
    elif choices=$(_overroll_choices "$verb" "$before") && [[ $choices ]]; then
        # shellcheck disable=SC2086 # a list of words
        _overroll_words $choices
    elif [[ $word == -* ]]; then
        _overroll_words $(_overroll_options "$verb")
    elif [[ $verb == help ]]; then
        _overroll_words $(_overroll_commands) contact lubricant domain solver \
            time load speed feature output units
    elif [[ $verb == init && $before == init ]]; then
        _overroll_words roller gear cam numbers discs
    fi
} # else files

complete -o default -F _overroll overroll
