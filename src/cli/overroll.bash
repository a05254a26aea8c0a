# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Completion of overroll for bash.

# Options of a command.
_overroll_options() {
    case $1 in
    # OPTIONS: the rows of the table come here when this file is built.
    esac
}

# Words of a key of the case.
_overroll_values() {
    case $1 in
    # KEYS: the rows of the table come here when this file is built.
    esac
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
    *:--kind) echo 'snapshot history map trace stress risk depth passes' \
        element plastic distribution ;;
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
    elif [[ $verb == find ]] && ((COMP_CWORD > 2)); then
        _overroll_words largest smallest between and so that is at most least \
            $(_overroll_keys '' | tr -d =)
    elif [[ $verb == help ]]; then
        _overroll_words $(_overroll_commands) contact lubricant domain solver \
            time load speed feature output units
    elif [[ $verb == init && $before == init ]]; then
        _overroll_words roller gear cam numbers discs
    fi
} # else files

complete -o default -F _overroll overroll
