# Build folders with the sanitizers of gcc, for the suites that run tests in them. Sourced, after tools/build.sh.

# The programs load two GL libraries and leave the C++ runtime's own caches behind; leaks are valgrind's matter. A library
# that is preloaded comes before the runtime, which does no harm: the program brings the runtime too.
export ASAN_OPTIONS=detect_leaks=0:abort_on_error=1:detect_stack_use_after_return=1:verify_asan_link_order=0
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
# Children of fork make threads of their own.
export TSAN_OPTIONS=halt_on_error=1:second_deadlock_stack=1:die_after_fork=0

# widest_isa: the largest instruction set of this family that this processor has; nothing where there is no choice.
widest_isa() {
    case $(uname -m) in
        x86_64)
            if grep -qw avx512vl /proc/cpuinfo; then echo avx512
            elif grep -qw avx2 /proc/cpuinfo; then echo avx2
            else echo sse4; fi ;;
    esac
}

# configure_sanitized asan|tsan: the folder build-asan or build-tsan.
configure_sanitized() {
    local sanitizers isas=""
    # Kernels take minutes to compile with sanitizers. Addresses: the smallest vectors, whose code is the same at every
    # width, and the widest, whose reads reach furthest. Which threads meet where does not depend on the width at all.
    case $1 in
        asan) sanitizers=address,undefined; [ "$(widest_isa)" ] && isas=$(printf '%s\n' sse4 "$(widest_isa)" | sort -u | paste -sd,) ;;
        tsan) sanitizers=thread; [ "$(widest_isa)" ] && isas=sse4 ;;
    esac
    # Optimised, or the ISA's always-inlined layers take minutes; sanitized objects refer to symbols of the runtime.
    configure_in "build-$1" -Dbuildtype=debugoptimized -Db_ndebug=false -Db_sanitize=$sanitizers -Db_lundef=false \
        -Disa="$isas" -Dprograms=false
}

# Address space layout at its most random leaves no room where the sanitizers of gcc 12 want theirs.
sanitized_tests() { setarch "$(uname -m)" -R meson test "$@"; }
