#!/bin/sh
# SPDX-License-Identifier: MIT
# Two versions of the library in one process do not mix: neither a static copy inside a plugin with the
# library of the program, nor two shared libraries. The other version is the library as one file with
# another number. It has the set scalar only, so that it compiles quickly.
. ./common.sh
[ "$system" = Linux ] || skip "written for ELF"
[ "$cross$emulator" = 0 ] || skip "it is the linker that is tested, not the processor"
! sanitized || skip "plugins would need the sanitizer's library"
case $c_compiler_id in
GNU | *Clang) ;;
*) skip "the single file is for gcc and clang" ;;
esac

fresh versions
major=${version%%.*} minor=${version#*.}
minor=${minor%%.*}
other=$major.$((minor + 1)).0
[ "$major" = 0 ] || other=$((major + 1)).0.0

# abi_of VERSION: as in compile.cmake
abi_of()
{
    case $1 in
    0.*) echo "${1%.*}" ;;
    *) echo "${1%%.*}" ;;
    esac
}

# single VERSION: the library as one file and its header, in the directory of that name
single()
{
    "$cmake" -D "SOURCE=$source_dir" -D "OUTPUT=$dir/$1" -D "VERSION=$1" \
        -P "$source_dir/cmake/single.cmake"
    rm -f "$dir/$1/scarp.h" # the sources may be such as nobody may write
    major=${1%%.*} minor=${1#*.}
    sed "s/\\(#define SCARP_VERSION_MAJOR\\) .*/\\1 $major/
        s/\\(#define SCARP_VERSION_MINOR\\) .*/\\1 ${minor%%.*}/
        s/\\(#define SCARP_VERSION_PATCH\\) .*/\\1 ${1##*.}/" "$source_dir/include/scarp.h" >"$dir/$1/scarp.h"
}

# shared ARGUMENT...: compiles a shared object
shared()
{
    # shellcheck disable=SC2086 # words
    "$c_compiler" -std=c11 -O0 -fPIC -shared -ffp-contract=off -DSCARP_AVX512=0 -DSCARP_AVX2=0 \
        -DSCARP_SSE41=0 -DSCARP_NEON=0 "$@" $link_flags -lm
}

# shared_library VERSION: the shared library of that version, in its directory
shared_library()
{
    sed "s/@SCARP_ABI@/$(abi_of "$1")/" "$source_dir/cmake/scarp.map.in" >"$dir/$1/scarp.map"
    shared -DSCARP_BUILDING_SHARED "$dir/$1/scarp_single.c" "-Wl,--version-script=$dir/$1/scarp.map" \
        "-Wl,-soname,libscarp.so.$(abi_of "$1")" -o "$dir/$1/libscarp.so.$(abi_of "$1")"
}

# module NAME VERSION ARGUMENT...: libNAME.so, whose NAME_version() asks scarp.h of that version
module()
{
    printf '#include <scarp.h>\nconst char *%s_version(void);
const char *%s_version(void)\n{\n    return scarp_version();\n}\n' "$1" "$1" >"$dir/$1.c"
    name=$1 include=$2
    shift 2
    shared -I "$include" "$dir/$name.c" "$@" -o "$dir/lib$name.so"
}

cat >"$dir/program.c" <<'EOF'
#include <dlfcn.h>
#include <stdio.h>

const char *scarp_version(void);

int main(int argc, char **argv)
{
    void *plugin = dlopen(argv[argc - 1], RTLD_NOW | RTLD_GLOBAL);
    const char *(*version)(void) = NULL;
    if (plugin != NULL) {
        *(void **)&version = dlsym(plugin, "plugin_version");
    }
    if (version == NULL) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    printf("%s %s\n", scarp_version(), version());
    return 0;
}
EOF
cat >"$dir/both.c" <<'EOF'
#include <stdio.h>

const char *first_version(void), *second_version(void);

int main(void)
{
    printf("%s %s\n", first_version(), second_version());
    return 0;
}
EOF

# expect COMMAND...: it prints this version and the other one
expect()
{
    found=$("$@")
    echo "$found"
    [ "$found" = "$version $other" ] || fail "not $version $other"
}

single "$other"
echo "a static copy inside a plugin"
module plugin "$dir/$other" "$dir/$other/scarp_single.c"
if [ -n "$nm" ] && "$nm" -D --defined-only "$dir/libplugin.so" | grep -E ' scarpi?_'; then
    fail "the plugin exports what it has of the library"
fi
"$c_compiler" -std=gnu11 -rdynamic "$dir/program.c" "$library" "-Wl,-rpath,$(dirname "$library")" -ldl -lm \
    -o "$dir/program"
expect "$dir/program" "$dir/libplugin.so"

echo "two shared libraries"
shared_library "$other"
first=$library
if [ "$library_type" != SHARED_LIBRARY ]; then
    single "$version"
    shared_library "$version"
    first=$dir/$version/libscarp.so.$(abi_of "$version")
fi
module first "$source_dir/include" "$first" "-Wl,-rpath,$(dirname "$first")"
module second "$dir/$other" "$dir/$other/libscarp.so.$(abi_of "$other")" "-Wl,-rpath,$dir/$other"
"$c_compiler" "$dir/both.c" -L"$dir" -lfirst -lsecond "-Wl,-rpath,$dir" -o "$dir/both"
expect "$dir/both"
