# The programs that people know, from Debian's packages, on Terrazzo beside Mesa.
# usage: programs.sh FILE, which gets the build folder's name.
set -u
. tools/packages.sh
. tools/build.sh
need_packages build tests programs
echo build >>"$1"
rm -f build/meson-logs/testlog.*
# Which programs are built here depends on what is installed by now.
configure_in build && meson setup --reconfigure build >/dev/null || exit 1
build_in build || exit 1
meson test -C build --no-rebuild --print-errorlogs --suite programs
