# The Debian 12 packages of the commands ./demo and ./check, and the function that installs what is missing.
# Sourced by both. Input: names of groups. Invariant: a machine that has them all is not touched and hears nothing.
# With TERRAZZO_NO_INSTALL=1 nothing is checked or installed: for systems whose packages go by other names.

packages_build="g++ meson ninja-build pkg-config python3 libhwy-dev khronos-api libx11-dev libx11-xcb-dev libxcb-shm0-dev
  libglvnd-core-dev libgl-dev libegl-dev libopengl-dev"
packages_tests="libosmesa6-dev libgtest-dev libgmock-dev nlohmann-json3-dev libopenimageio-dev libcli11-dev libfmt-dev
  libbenchmark-dev libtinygltf-dev libstb-dev libglfw3-dev libsdl2-dev assimp-testmodels xvfb python3-opengl
  python3-pyglet mesa-utils apitrace gnuplot-nox python3-numpy python3-pil xfonts-base libgl1-mesa-dri"
packages_programs="gltron neverball chromium-bsu billard-gl armagetronad foobillardplus openscenegraph xscreensaver-gl
  xscreensaver-gl-extra rss-glx libirrlicht-dev python3-venv"
packages_piglit="piglit"
packages_clang="clang"
packages_arm="g++-aarch64-linux-gnu g++-arm-linux-gnueabihf qemu-user"

# need_packages GROUP...: returns when every package of the groups is installed, else says why not and ends the script.
need_packages() {
    [ "${TERRAZZO_NO_INSTALL:-0}" = 1 ] && return 0
    local wanted="" missing="" name group
    for group in "$@"; do
        name="packages_$group"
        wanted="$wanted ${!name}"
    done
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        echo "This system has no apt. These packages (Debian's names) are needed:" >&2
        echo $wanted | fold -s -w 100 >&2
        echo "Install what your system calls them, then run again with TERRAZZO_NO_INSTALL=1." >&2
        exit 1
    fi
    for name in $wanted; do
        [ "$(dpkg-query -W -f '${db:Status-Abbrev}' "$name" 2>/dev/null | cut -c1-2)" = ii ] || missing="$missing $name"
    done
    [ -n "$missing" ] || return 0
    install_packages $missing
}

install_packages() {
    local as_root=""
    if [ "$(id -u)" != 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "These packages are missing, and there is neither root nor sudo to install them:" "$@" >&2
            exit 1
        fi
        as_root=sudo
    fi
    local log
    log=$(mktemp)
    echo "Installing with apt:" "$@"
    local install="$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends"
    # The lists may be absent (a fresh machine) or old (a package no longer at its address): ask for new ones then.
    if ! $install "$@" >"$log" 2>&1; then
        $as_root apt-get update >>"$log" 2>&1
        if ! $install "$@" >>"$log" 2>&1; then
            tail -20 "$log" >&2
            echo "apt could not install them; the whole log is $log" >&2
            exit 1
        fi
    fi
    rm -f "$log"
}
