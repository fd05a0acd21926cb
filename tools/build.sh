# Configuring and compiling with progress, for ./demo, ./check and the suites. Sourced.
# On a terminal ninja shows its own line; elsewhere one line every tenth of the way, and whatever the compiler says.

# configure_in FOLDER [MESON OPTION...]: configures FOLDER if that has not been done.
configure_in() {
    local folder=$1
    shift
    [ -f "$folder/build.ninja" ] && return 0
    echo "Configuring $folder"
    mkdir -p "$folder"
    if ! meson setup "$folder" "$@" >"$folder/setup.log" 2>&1; then
        tail -20 "$folder/setup.log" >&2
        return 1
    fi
}

# build_in FOLDER [MESON OPTION...]: configures FOLDER where needed, then brings it up to date.
build_in() {
    local folder=$1
    configure_in "$@" || return 1
    if [ -t 1 ]; then
        ninja -C "$folder"
    else
        echo "Building $folder"
        NINJA_STATUS='%p ' ninja -C "$folder" | awk '
            /^ *[0-9]+% / { tenth = int($1 / 10); if (tenth > shown) { shown = tenth; print "  " $1 } fflush(); next }
            /^ninja: (Entering|no work)/ { next }
            { print; fflush() }'
        return "${PIPESTATUS[0]}"
    fi
}
