# SPDX-License-Identifier: MIT
# Completion of scarp's commands, options and their words for bash. The options come from the
# program's own help, where those of warp, base and mask stand side by side. Installed where bash-completion finds it.

_scarp_options()
{
    "$1" help "$2" 2>/dev/null | sed -n -e 's/^  \(--[a-z-]*\).*/\1/p' -e '/^ \{18\}--\(warp\|base\|mask\)-/p'
}

_scarp()
{
    local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]}
    local before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
    local words= row=$before
    case $before in
    --warp-* | --base-* | --mask-*) row=--${before#--*-} ;;
    esac

    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        words="terrain view sheet sample info help --help --version"
    elif [ "$command" = help ]; then
        [ "$COMP_CWORD" -eq 2 ] && words="terrain view sheet sample info"
    else
        case $row in
        --basis) words="gradient value simplex cell-f1 cell-f2 cell-edge cell-soft cell-value" ;;
        --fade) words="quintic cubic" ;;
        --fractal) words="fbm turbulence ridged erosion pingpong hybrid swiss jordan" ;;
        --preset) words="none alps dunes islands canyon badlands hills volcanic highlands cirques karst crests folds" ;;
        --isa) words="scalar sse4.1 avx2 avx512 neon generic wasm128" ;;
        --normal-y) words="up down" ;;
        --palette)
            mapfile -t COMPREPLY < <(compgen -W "alpine temperate desert arctic grey" -f -- "$word")
            return
            ;;
        --layer) words="relief hillshade" ;;
        --dims) words="2 3" ;;
        --input-format | --output-format) words="csv text npy" ;;
        --heights | --normals | --hillshade | --relief | --gradient | --input | --output)
            mapfile -t COMPREPLY < <(compgen -f -- "$word")
            return
            ;;
        *)
            # After an option with a value of its own, nothing can be offered.
            if ! "$program" help "$command" 2>/dev/null | grep -Eq "^  ($before|$row) [A-Z]"; then
                words=$(_scarp_options "$program" "$command")
            fi
            ;;
        esac
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}

complete -o filenames -F _scarp scarp
