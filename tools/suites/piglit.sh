# Debian's piglit through GLX and EGL: fails when a test ends worse than tests/piglit/outcomes.txt says.
# usage: piglit.sh FILE, which gets the build folder's name.
set -u
. tools/packages.sh
. tools/build.sh
need_packages build tests piglit
echo build >>"$1"
rm -f build/meson-logs/testlog.*
build_in build || exit 1
meson test -C build --no-rebuild --verbose --suite piglit
