# bash completion of vybeg and vybeg-cli.
#
# Commands, options and what kind of value an option takes are read from --help, so that a new option
# is known at once. Only names that --help lists within a sentence stand here, in _vybeg_names.

# The values of an option that takes one of several names, or nothing.
_vybeg_names() {
    case $1 in
        --algorithm)
            echo in-phase phase-shift moving-axes demodulation conjugate-gradient maximum-likelihood
            ;;
        --model) echo auto structured free ;;
        --raw) echo i16 i32 f32 f64 ;;
        --delimiter) echo comma semicolon tab space bar ;;
        --decimal) echo point comma ;;
        --time-unit) echo s ms us ns ;;
        --tolerance) echo kappa= skew= delay= crosstalk= phase-drift= gain-drift= ;;
    esac
}

# _vybeg_options PROGRAM [COMMAND]: lines "--option" or "--option PLACEHOLDER".
_vybeg_options() {
    "$@" --help 2>/dev/null |
        sed -nE '/^Options:/,/^$/{
            s/ (REQUIRED|Needs:|Excludes:).*//
            t next
            :next
            s/^  (-[^ ,]+,)?(--[^ ]+)( {2,}.*)?$/\2/p; t
            s/^  (-[^ ,]+,)?(--[^ ]+) ([^ ]+).*/\2 \3/p
        }'
}

# The placeholder of option $1 in lines of _vybeg_options, or nothing; fails where there is no such.
_vybeg_placeholder() {
    local option placeholder
    while read -r option placeholder; do
        if [[ $option == "$1" ]]; then
            printf '%s\n' "$placeholder"
            return 0
        fi
    done
    return 1
}

# _vybeg_files PATTERN: files of these names, and folders on the way to them.
_vybeg_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(
        shopt -s extglob
        { compgen -f -X "!$1" -- "$cur"; compgen -d -- "$cur"; } | sort -u
    )
}

# _vybeg_value OPTION PLACEHOLDER: completes what an option takes.
_vybeg_value() {
    local names
    names=$(_vybeg_names "$1")
    case $2 in
        DIR)
            compopt -o filenames 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -d -- "$cur")
            return
            ;;
        REPORT*) _vybeg_files '*.pdf' && return ;;
        FIGURE*) _vybeg_files '*.@(svg|pdf|png)' && return ;;
        *.csv) _vybeg_files '*.csv' && return ;;
        *.json) _vybeg_files '*.json' && return ;;
        FILE* | TRACK*) _vybeg_files '*' && return ;;
        *'|'*) names=$(tr '|' '\n' <<<"$2" | grep -E '^[a-z]+$') ;; # words; capitals are variables
    esac
    mapfile -t COMPREPLY < <(compgen -W "$names" -- "$cur")
    [[ ${COMPREPLY[0]-} != *= ]] || compopt -o nospace 2>/dev/null
}

_vybeg() {
    local cur=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]} placeholder options
    local program=("${1/#\~/$HOME}")
    COMPREPLY=()
    if [[ ${1##*/} == vybeg-cli ]]; then
        local commands
        commands=$("${program[0]}" --help 2>/dev/null |
            sed -nE '/^Subcommands:/,/^$/s/^  ([a-z][-a-z]*) .*/\1/p')
        if ((COMP_CWORD == 1)); then
            [[ $cur != -* ]] || commands=$(_vybeg_options "${program[0]}")
            mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$cur")
            return
        fi
        program+=("${COMP_WORDS[1]}")
        grep -qxF -e "${program[1]}" <<<"$commands" || return
    fi
    options=$(_vybeg_options "${program[@]}")
    # bash makes three words of --option=value.
    if [[ $cur == = ]]; then
        cur=
    elif [[ $option == = ]]; then
        option=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    [[ $option != -o ]] || option=--output
    if placeholder=$(_vybeg_placeholder "$option" <<<"$options") && [[ -n $placeholder ]]; then
        _vybeg_value "$option" "$placeholder"
    elif [[ $cur == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(cut -d ' ' -f 1 <<<"$options")" -- "$cur")
    else
        _vybeg_files '*' # a recording is recognised by its content, not by its name
    fi
}

complete -F _vybeg vybeg vybeg-cli
