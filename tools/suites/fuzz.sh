# The fuzzer for a long time, in sanitized builds: address and undefined behaviour together, then threads. Each is ten
# million calls; a line every ten seconds says how far it is, and a failure how to repeat it.
# usage: fuzz.sh FILE, which gets the build folders' names.
set -u
. tools/packages.sh
. tools/build.sh
need_packages build tests

# fuzzed NAME SANITIZERS ISAS: the build folders are those of the suite "sanitizers".
fuzzed() {
    local folder=build-$1
    configure_in "$folder" -Dbuildtype=debugoptimized -Db_ndebug=false -Db_sanitize="$2" -Db_lundef=false -Disa="$3" \
        -Dprograms=false || return 1
    ninja -C "$folder" tests/fuzz/fuzz || return 1
    rm -f "$folder"/meson-logs/testlog.*
    # Address space layout at its most random leaves no room where the sanitizers of gcc 12 want theirs.
    setarch "$(uname -m)" -R meson test -C "$folder" --verbose --suite fuzz_long
}

status=0
echo build-asan >>"$1"
fuzzed asan address,undefined "" || status=1
echo build-tsan >>"$1"
case $(uname -m) in x86_64) isas=sse4 ;; *) isas="" ;; esac
TERRAZZO_THREADS=4 fuzzed tsan thread "$isas" || status=1
exit $status
