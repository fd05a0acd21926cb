#!/usr/bin/env bash
# A folder with the ARM libraries that cross builds link and emulated tests load.
# usage: make_sysroot.sh arm64|armhf FOLDER PACKAGE...
# apt resolves and fetches the packages and what they depend on into a private state inside FOLDER; they are unpacked,
# not installed, so the machine's own list of architectures and packages stays as it is. About half a minute.
set -euo pipefail
architecture=$1
mkdir -p "$2"
folder=$(cd "$2" && pwd)
shift 2
state=$folder/.apt
mkdir -p "$state/lists/partial" "$state/archives/partial" "$state/preferences.d"
: >"$state/status"

# The machine's own mirror and release, for the other architecture.
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | head -n 1)
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
keys=/usr/share/keyrings/debian-archive-keyring.gpg
for suite in "$release" "$release-updates"; do
    echo "deb [arch=$architecture signed-by=$keys] $mirror $suite main"
done >"$state/sources.list"

options=(-qq -o Dir::State="$state" -o Dir::State::lists="$state/lists" -o Dir::State::status="$state/status"
    -o Dir::Cache="$state" -o Dir::Cache::archives="$state/archives" -o Dir::Etc::sourcelist="$state/sources.list"
    -o Dir::Etc::sourceparts=/dev/null -o Dir::Etc::preferencesparts="$state/preferences.d"
    -o APT::Architecture="$architecture" -o APT::Architectures::="$architecture" -o APT::Install-Recommends=false
    -o Acquire::Languages=none -o APT::Sandbox::User=root -o Debug::NoLocking=true
    -o APT::Update::Post-Invoke::= -o APT::Update::Post-Invoke-Success::=)
apt-get "${options[@]}" update
apt-get "${options[@]}" --yes --download-only install "$@"
for package in "$state"/archives/*.deb; do dpkg-deb --extract "$package" "$folder"; done

# Debian's merged /usr, which a package's maintainer scripts would have made.
for name in lib bin sbin; do
    [ -d "$folder/$name" ] && [ ! -L "$folder/$name" ] && cp -a "$folder/$name/." "$folder/usr/$name/" && rm -r "${folder:?}/$name"
    ln -sfn "usr/$name" "$folder/$name"
done
# Absolute links would lead to the machine's own files.
find "$folder/usr" -type l -lname '/*' | while read -r link; do
    ln -sfnr "$folder$(readlink "$link")" "$link"
done
rm -r "$state"
