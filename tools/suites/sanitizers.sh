# The tests of memory and threads in sanitized builds: address and undefined behaviour together, then threads.
# usage: sanitizers.sh FILE, which gets the build folders' names.
set -u
. tools/packages.sh
. tools/build.sh
need_packages build tests

# The programs load two GL libraries and leave the C++ runtime's own caches behind; leaks are valgrind's matter. A library
# that is preloaded comes before the runtime, which does no harm: the program brings the runtime too.
export ASAN_OPTIONS=detect_leaks=0:abort_on_error=1:detect_stack_use_after_return=1:verify_asan_link_order=0
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
# Children of fork make threads of their own.
export TSAN_OPTIONS=halt_on_error=1:second_deadlock_stack=1:die_after_fork=0

# sanitized NAME SANITIZERS ISAS SUITE...
sanitized() {
    local folder=build-$1 sanitizers=$2 isas=$3 suites=() suite
    shift 3
    for suite in "$@"; do suites+=(--suite "$suite"); done
    # Optimised, or the ISA's always-inlined layers take minutes; sanitized objects refer to symbols of the runtime.
    configure_in "$folder" -Dbuildtype=debugoptimized -Db_ndebug=false -Db_sanitize="$sanitizers" -Db_lundef=false -Disa="$isas" \
        -Dprograms=false || return 1
    rm -f "$folder"/meson-logs/testlog.*
    # Address space layout at its most random leaves no room where the sanitizers of gcc 12 want theirs.
    setarch "$(uname -m)" -R meson test -C "$folder" --print-errorlogs --timeout-multiplier 10 "${suites[@]}"
}

status=0
echo build-asan >>"$1"
sanitized asan address,undefined "" unit bad_input kernels stress osmesa || status=1
echo build-tsan >>"$1"
# Which threads meet where does not depend on the instruction set: those that every processor of the family has will do.
case $(uname -m) in x86_64) isas=sse4 ;; *) isas="" ;; esac
TERRAZZO_THREADS=4 sanitized tsan thread "$isas" stress threads || status=1
exit $status
