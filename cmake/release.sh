#!/bin/bash
# SPDX-License-Identifier: MIT
# Makes all that a release gives away from the commit that is checked out, twice, and keeps it if both
# times give the same bytes. cmake/release.md says when to run it. It tags, pushes and publishes nothing.
#
#   cmake/release.sh [OPTION...] OUTPUT
#
#   --rehearse        the tag and the date of the changelog may be missing, and golden lines and the binary
#                     interface be newer than what is promised; MANIFEST.txt says so
#   --once            makes everything once, and compares nothing
#   --fuzz SECONDS    first runs the fuzz targets for about that long, on all processors; by default 3600, and not
#                     at all (0) with --rehearse or --once
#   --require-all     a missing tool is an error; else what needs it is left out, and MANIFEST.txt says so
#   --parts LIST      only these parts, with commas between them; release/pack.sh has their names
#   --repository URL  where the packages for npm and cargo say that their source is
#   --contact TEXT    whom Debian's packages name as their maintainer: "NAME <ADDRESS>"
#
# OUTPUT is an empty folder, or is made. It gets the artifacts, MANIFEST.txt, a bill of materials (SPDX 2.3)
# and SHA256SUMS. JOBS in the environment is how many processes compile at once, by default as many as there
# are processors; TMPDIR is where. Exits with 1 if something cannot be built or the bytes differ, and with 2
# if the commit is no release yet, or the options are wrong.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd -P)
# shellcheck source=cmake/release/checks.sh
. "$root/cmake/release/checks.sh"

refuse() # TEXT
{
    echo "release.sh: $*" >&2
    exit 2
}

# What keeps this commit from being a release, and not from being rehearsed
notes=
lacks() # TEXT
{
    [ "$rehearse" ] || refuse "$*"
    notes+="$*"$'\n'
}

rehearse='' require_all='' repository='' contact='' output=''
passes=2
fuzz=''
parts=source,archive,deb,single,wheel,crate,npm,playground,csharp,shaders
while [ $# != 0 ]; do
    case $1 in
    --rehearse) rehearse=yes ;;
    --once) passes=1 ;;
    --require-all) require_all=yes ;;
    --fuzz | --parts | --repository | --contact)
        [ $# -ge 2 ] || refuse "$1 needs a value"
        name=${1#--}
        printf -v "$name" %s "$2"
        shift
        ;;
    -*) refuse "there is no option $1" ;;
    *)
        [ -z "$output" ] || refuse "one folder takes the release, not two: $output, $1"
        output=$1
        ;;
    esac
    shift
done
[ "$output" ] || refuse "no folder is named for the release"
[ "$fuzz" ] || { [ -z "$rehearse" ] && [ $passes = 2 ] && fuzz=3600 || fuzz=0; }
[[ $fuzz =~ ^[0-9]{1,6}$ ]] || refuse "--fuzz takes seconds, 999999 at most, not $fuzz"
for part in ${parts//,/ }; do
    [[ ,source,archive,deb,single,wheel,crate,npm,playground,csharp,shaders, == *,$part,* ]] ||
        refuse "there is no part $part"
done
for tool in git gzip python3 sha256sum tar; do
    command -v $tool >/dev/null || refuse "$tool is missing"
done
[ ! -e "$output" ] || [ -d "$output" ] || refuse "$output is no folder"
[ -z "$(ls -A "$output" 2>/dev/null)" ] || refuse "$output is not empty"

# Settings of the caller must not get in.
unset AR ARFLAGS CFLAGS CPPFLAGS CXXFLAGS LDFLAGS DESTDIR MAKEFLAGS MAKELEVEL MFLAGS GZIP TAR_OPTIONS XZ_OPT \
    CMAKE_GENERATOR CMAKE_BUILD_TYPE CMAKE_BUILD_PARALLEL_LEVEL CMAKE_TOOLCHAIN_FILE CMAKE_INSTALL_MODE \
    CARGO_TARGET_DIR CARGO_INCREMENTAL RUSTFLAGS DPKG_DEB_COMPRESSOR_TYPE DPKG_DEB_COMPRESSOR_LEVEL \
    GIT_DIR GIT_WORK_TREE PYTHONPATH PYTHONHOME LANGUAGE CPATH C_INCLUDE_PATH CPLUS_INCLUDE_PATH LIBRARY_PATH \
    LD_LIBRARY_PATH LD_PRELOAD PKG_CONFIG_PATH CMAKE_PREFIX_PATH CMAKE_C_COMPILER_LAUNCHER CMAKE_CXX_COMPILER_LAUNCHER
export PYTHONDONTWRITEBYTECODE=1
umask 022

started=$SECONDS
work=$(mktemp -d "${TMPDIR:-/tmp}/scarp-release.XXXXXX")
other=$work/the-second-pass-has-a-longer-path
keep=''
cleanup()
{
    [ "$keep" ] || rm -rf "$work" "$other"
}
trap cleanup EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

check_version
check_commit
check_changelog
check_tag
check_golden
check_interface

SOURCE_DATE_EPOCH=$(git -C "$root" log -1 --format=%ct)
export SOURCE_DATE_EPOCH
jobs=${JOBS:-$(nproc)}
if [ "$rehearse" ] && [ "$notes" ]; then
    echo "a rehearsal:"
    sed '/./s/^/    /' <<<"${notes%$'\n'}"
fi
echo "scarp $version, commit $commit"

try_fuzz

# pass FOLDER JOBS SETTING...: everything into FOLDER/out, out of the source archive. SETTINGs are variables
# of the environment that must make no difference.
pass()
{
    local folder=$1 count=$2 name=scarp-$version
    shift 2
    mkdir -p "$folder/out" "$folder/scratch"
    git -C "$root" -c tar.umask=0022 -c core.autocrlf=false archive --format=tar --prefix="$name/" "$commit" |
        gzip -9n >"$folder/scratch/$name.tar.gz"
    tar -xzf "$folder/scratch/$name.tar.gz" -C "$folder"
    [[ ,$parts, != *,source,* ]] || cp "$folder/scratch/$name.tar.gz" "$folder/out"
    env "$@" JOBS="$count" SCARP_REQUIRE_ALL="$require_all" SCARP_REPOSITORY="$repository" SCARP_CONTACT="$contact" \
        bash "$folder/$name/cmake/release/pack.sh" "$parts" "$folder/out" "$folder/scratch" || exit 1
    env "$@" python3 "$folder/$name/cmake/release/describe.py" "$folder/out" "$folder/scratch" \
        "version=$version" "commit=$commit" "time=$SOURCE_DATE_EPOCH" "notes=$notes" \
        "repository=$repository" "contact=$contact" "parts=$parts" || exit 1
    (cd "$folder/out" && LC_ALL=C && export LC_ALL && sha256sum -- * >"$folder/SHA256SUMS")
    mv "$folder/SHA256SUMS" "$folder/out"
}

pass "$work/1" "$jobs" LC_ALL=C TZ=UTC
if [ $passes = 2 ]; then
    # Another file system lists folders in another order, if there is one.
    shm=$(df -Pk /dev/shm 2>/dev/null | awk 'NR == 2 { print $4 }')
    if [ -w /dev/shm ] && [ "${shm:-0}" -gt 2000000 ]; then
        other=$(mktemp -d /dev/shm/scarp-release-the-second-pass-has-a-longer-path.XXXXXX)
    fi
    echo "once more"
    language=$(locale -a 2>/dev/null | grep -i 'utf-\?8$' | grep -v '^C' | head -n 1) || true
    pass "$other" $((jobs + 1)) LC_ALL="${language:-C.UTF-8}" TZ=XST-9:30
    if ! differ=$(diff -rq "$work/1/out" "$other/out"); then
        keep=yes
        # The bill of materials has sums of the others.
        names=$(cd "$work/1/out" && for name in *; do
            [[ $name = SHA256SUMS || $name = *.spdx.json ]] || cmp -s "$name" "$other/out/$name" || echo "$name"
        done)
        names=${names:-scarp-$version.spdx.json}
        echo "release.sh: the two passes differ in: ${names//$'\n'/, }" >&2
        grep '^Only in' <<<"$differ" >&2 || true
        first=${names%%$'\n'*}
        if command -v diffoscope >/dev/null; then
            echo "look: diffoscope '$work/1/out/$first' '$other/out/$first'" >&2
        else
            echo "both are kept: $work/1/out/$first, $other/out/$first" >&2
        fi
        exit 1
    fi
    echo "both passes have the same bytes"
fi

mkdir -p "$output"
cp "$work"/1/out/* "$output"
cat "$output/MANIFEST.txt"
echo "$((SECONDS - started)) seconds"
