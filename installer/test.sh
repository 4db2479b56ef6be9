#!/usr/bin/env bash
# Sets up, builds, runs every test: with a virtual display and without any.
# usage: installer/test.sh [ctest options…]     long property runs: installer/test.sh -L long
source "$(dirname "$0")/setup.sh"

install_missing build workbench test
build release -DLODESTONE_TESTS=ON

say "Testing"
[ $# -gt 0 ] || set -- -LE long
ctest --test-dir "$root/build/release" --output-on-failure -j "${LODESTONE_JOBS:-$(nproc)}" "$@"
