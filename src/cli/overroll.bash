# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Completion of overroll for bash.

# Options of a command; written by tools/update-manual.
_overroll_options() {
    case $1 in
    steady) echo '--estimate-error --set --M --L --level --scheme --smoother -q -v --json --help' ;;
    run) echo '-o --force --estimate-error --set --M --L --level --scheme --smoother -q -v --json --help' ;;
    resume) echo '--set --M --L --level --scheme --smoother -q -v --json --help' ;;
    check) echo '--set --M --L --level --scheme --smoother -q -v --json --help' ;;
    info) echo '-q -v --json --help' ;;
    sweep) echo '-j -o --list --task --collect --retry --redo -q -v --json --help' ;;
    export) echo '--snapshot --time --all --long --wide --at --field --units --format -o --force -q -v --json --help' ;;
    plot) echo '-o --kind --at --overlay --field --script --hertzian --si -x --time --p-max --h-max --size --title --no-hertz --no-roughness --force -q -v --json --help' ;;
    frames) echo '-o --movie --rate --every --form --jobs --script --hertzian --si -x --time --p-max --h-max --size --title --no-hertz --no-roughness --force -q -v --json --help' ;;
    view) echo '-o --title --force -q -v --json --help' ;;
    profile) echo '--unit-x --unit-z --spacing --column-x --column-z --line --from --to --level --degree --lambda-c --lambda-s --outliers --max-gap --max-missing --scale --offset --invert --reverse --case --convert --plot --force -q -v --json --help' ;;
    init) echo '--oil -o --force -q -v --json --help' ;;
    help) echo '--roff --bash -q -v --json --help' ;;
    esac # options
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

_overroll() {
    local verb=${COMP_WORDS[1]} before=${COMP_WORDS[COMP_CWORD - 1]}
    COMPREPLY=()
    # shellcheck disable=SC2046 # lists of words
    if ((COMP_CWORD == 1)); then
        _overroll_words $(_overroll_commands) --version --help
    elif [[ ${COMP_WORDS[COMP_CWORD]} == -* ]]; then
        _overroll_words $(_overroll_options "$verb")
    elif [[ $before == --scheme ]]; then
        _overroll_words upstream1 upstream2 characteristic
    elif [[ $verb == help ]]; then
        _overroll_words $(_overroll_commands) contact lubricant domain solver \
            time load speed feature output units
    elif [[ $verb == init && $before == init ]]; then
        _overroll_words roller gear cam numbers
    fi
} # else files

complete -o default -F _overroll overroll
