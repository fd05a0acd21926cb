# ARM without a board: 64-bit and 32-bit cross builds whose tests run in qemu's user mode.
# usage: arm.sh FILE, which gets the build folders' names.
# qemu keeps x86's strong order of memory, so races do not show here: that is what the suite sanitizers is for.
set -u
. tools/packages.sh
. tools/build.sh
need_packages build arm

libraries="libc6-dev libstdc++-12-dev libhwy-dev libgtest-dev libgmock-dev libosmesa6-dev nlohmann-json3-dev"

# on_arm arm64|armhf
on_arm() {
    local folder=build-$1 root=$PWD/build-$1-root
    echo "$folder" >>"$report"
    if [ ! -f "$root/cross.ini" ]; then
        echo "Fetching the libraries of $1"
        tools/arm/make_sysroot.sh "$1" "$root" $libraries || return 1
        sed "s#@SYSROOT@#$root#" "tools/arm/$1.ini.in" >"$root/cross.ini"
    fi
    configure_in "$folder" --cross-file "$root/cross.ini" -Dprograms=false -Dwindows=false || return 1
    rm -f "$folder"/meson-logs/testlog.*
    meson test -C "$folder" --print-errorlogs --timeout-multiplier 20 --suite unit --suite kernels --suite stress
}

report=$1 status=0
on_arm arm64 || status=1
on_arm armhf || status=1
exit $status
