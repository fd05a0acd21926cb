# The same tests with the other compiler, which must not have anything to warn about either.
# usage: clang.sh FILE, which gets the build folder's name.
set -u
. tools/packages.sh
. tools/build.sh
need_packages build tests clang
echo build-clang >>"$1"
rm -f build-clang/meson-logs/testlog.*
CC=clang CXX=clang++ build_in build-clang -Dwerror=true || exit 1
meson test -C build-clang --no-rebuild --print-errorlogs --timeout-multiplier 4 --no-suite long --no-suite scenes
