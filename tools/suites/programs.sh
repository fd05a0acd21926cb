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
status=0
meson test -C build --no-rebuild --print-errorlogs --suite programs || status=1

# PyOpenGL's own tests are in its source archive alone, which pip has, with what they need. Without pip's index they are
# left out.
pyopengl=$PWD/build/pyopengl version=3.1.10
fetch_pyopengl() {
    [ -d "$pyopengl/pyopengl-$version/tests" ] && return 0
    python3 -m venv "$pyopengl" &&
        "$pyopengl/bin/pip" install -q pygame numpy psutil python-xlib pytest "PyOpenGL==$version" &&
        "$pyopengl/bin/pip" download -q --no-deps --no-binary :all: -d "$pyopengl" "PyOpenGL==$version" &&
        tar -xf "$pyopengl/pyopengl-$version.tar.gz" -C "$pyopengl"
}
if fetch_pyopengl >build/pyopengl.log 2>&1; then
    for way in vendor plain; do
        echo "PyOpenGL's own tests, $way:"
        SDL_AUDIODRIVER=dummy python3 tests/windows/on_display.py "--$way" "$PWD/build/src/frontends/$way" \
            "$pyopengl/bin/python" tests/programs/pyopengl_tests.py "$pyopengl/pyopengl-$version/tests" || status=1
    done
else
    echo "PyOpenGL's own tests are left out: pip could not fetch them (build/pyopengl.log)"
fi
exit $status
