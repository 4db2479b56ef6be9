#!/usr/bin/env bash
# Sets up, builds, and opens the workbench on the sample town; without a display does the same job on the command line.
# usage: installer/run.sh [FILE…]
source "$(dirname "$0")/setup.sh"

install_missing build workbench
build release -DLODESTONE_TESTS=OFF

bin=$root/build/release
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  say "Opening the workbench"
  if [ $# -gt 0 ]; then exec "$bin/gui/lodestone" "$@"; else exec "$bin/gui/lodestone" --sample; fi
fi

say "No display: the same job on the command line"
cli=$bin/cli/lodestone-cli
[ $# -gt 0 ] || set -- "$root/resources/sample/town.city.json" --barriers "$root/resources/sample/town_streets.geojson"
out=$root/out
mkdir -p "$out"
"$cli" chain "$@" -o "$out/chain" --report "$out/chain-report.json" || [ $? = 3 ]
"$cli" render "$@" --original -o "$out/original.png" || [ $? = 3 ]
for epsilon in 100 1000 10000; do
  "$cli" render "$@" --epsilon $epsilon -o "$out/legible-$epsilon.png" || [ $? = 3 ]
done
say "The chain is in $out/chain, pictures beside it:"
find "$out" -type f | sort
