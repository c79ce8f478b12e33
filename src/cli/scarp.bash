# SPDX-License-Identifier: MIT
# Completion of scarp's commands, options and their words for bash. Options and presets come from the
# program's own help. Installed where bash-completion finds it.

_scarp_options()
{
    "$1" help "$2" 2>/dev/null | sed -n 's/^  \(--[a-z-]*\).*/\1/p'
}

# The words of an option, which the program names when it refuses another one.
_scarp_words()
{
    "$1" "$2" "$3" "" 2>&1 >/dev/null | sed -n "s/^scarp: $3: '' is not //; s/,//g; s/ or / /p"
}

_scarp_presets()
{
    "$1" help recipe 2>/dev/null | sed -n '/^presets /,/^$/s/^  \([a-z]*\) .*/\1/p'
}

_scarp()
{
    local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]}
    local before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
    local words=

    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        words="terrain view sheet sample recipe info help --help --version"
    elif [ "$command" = recipe ] && [ "$COMP_CWORD" -eq 2 ] && [[ $word != -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_scarp_presets "$program")" -f -- "$word")
        return
    elif [ "$command" = help ]; then
        [ "$COMP_CWORD" -eq 2 ] && words="terrain view sheet sample recipe info"
    else
        case $before in
        --basis | --fade | --fractal) words=$(_scarp_words "$program" "$command" "$before") ;;
        --preset) words="none $(_scarp_presets "$program")" ;;
        --isa) words="scalar sse4.1 avx2 avx512 neon generic wasm128" ;;
        --normal-y) words="up down" ;;
        --palette)
            mapfile -t COMPREPLY < <(compgen -W "alpine temperate desert arctic grey" -f -- "$word")
            return
            ;;
        --layer) words="relief hillshade" ;;
        --dims) words="2 3" ;;
        --delimiter) words="comma semicolon tab space" ;;
        --shader) words="glsl hlsl wgsl" ;;
        --input-format | --output-format) words="csv text npy" ;;
        --recipe | --heights | --normals | --hillshade | --relief | --gradient | --input | --output | --uniforms | --answers)
            mapfile -t COMPREPLY < <(compgen -f -- "$word")
            return
            ;;
        *)
            # After an option with a value of its own, nothing can be offered.
            if ! "$program" help "$command" 2>/dev/null | grep -Eq "^  $before [A-Z]"; then
                words=$(_scarp_options "$program" "$command")
            fi
            ;;
        esac
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}

complete -o filenames -F _scarp scarp
