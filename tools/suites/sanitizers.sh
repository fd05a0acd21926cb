# The tests of memory and threads in sanitized builds: address and undefined behaviour together, then threads.
# usage: sanitizers.sh FILE, which gets the build folders' names.
set -u
. tools/packages.sh
. tools/build.sh
. tools/sanitized.sh
need_packages build tests

# sanitized NAME SUITE...
sanitized() {
    local folder=build-$1 suites=() suite
    echo "$folder" >>"$report"
    configure_sanitized "$1" || return 1
    shift
    for suite in "$@"; do suites+=(--suite "$suite"); done
    rm -f "$folder"/meson-logs/testlog.*
    sanitized_tests -C "$folder" --print-errorlogs --timeout-multiplier 10 "${suites[@]}"
}

report=$1 status=0
sanitized asan unit bad_input kernels stress survival osmesa || status=1
TERRAZZO_THREADS=4 sanitized tsan stress survival threads || status=1
exit $status
