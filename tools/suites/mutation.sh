# Small faults in the source, one at a time: do the tests notice? At least 90 % must be, and 85 % in each room.
# usage: mutation.sh FILE, which gets the name of the folder with the outcome of each room.
# TERRAZZO_MUTATION_SEED chooses other faults.
set -u
. tools/packages.sh
need_packages build tests
echo build-mutation >>"$1"
rm -f build-mutation/meson-logs/testlog.json
exec tools/mutate --seed "${TERRAZZO_MUTATION_SEED:-1}" --count 240
