# The fuzzer for a long time, in sanitized builds: address and undefined behaviour together, then threads. Each is ten
# million calls; a line every ten seconds says how far it is, and a failure how to repeat it.
# usage: fuzz.sh FILE, which gets the build folders' names.
set -u
. tools/packages.sh
. tools/build.sh
. tools/sanitized.sh
need_packages build tests

# fuzzed asan|tsan: the build folders are those of the suite "sanitizers".
fuzzed() {
    local folder=build-$1
    echo "$folder" >>"$report"
    configure_sanitized "$1" || return 1
    ninja -C "$folder" tests/fuzz/fuzz || return 1
    rm -f "$folder"/meson-logs/testlog.*
    sanitized_tests -C "$folder" --verbose --suite fuzz_long
}

report=$1 status=0
fuzzed asan || status=1
TERRAZZO_THREADS=4 fuzzed tsan || status=1
exit $status
