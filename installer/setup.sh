# Sourced by the scripts beside it: installs what is missing, builds.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '\033[1m==> %s\033[0m\n' "$*"; }
fail() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# packages SECTION…: the names listed in packages.txt under these sections
packages() {
  local wanted=" $* " section=""
  while read -r line; do
    case $line in
      "" | \#*) ;;
      \[*\]) section=${line//[][]/} ;;
      *) [[ $wanted == *" $section "* ]] && echo "$line" ;;
    esac
  done <"$root/installer/packages.txt"
  return 0
}

as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "these packages are missing and neither root nor sudo is at hand to install them: ${missing[*]}"
  fi
}

# install_missing SECTION…: nothing to do takes a fraction of a second and needs no network
install_missing() {
  missing=()
  local installed
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' 2>/dev/null | awk '$2=="installed"{print $1}') ||
    fail "dpkg is not here: these scripts install Debian 12 packages (see installer/packages.txt for what to install by hand)"
  for package in $(packages "$@"); do
    grep -qx "$package" <<<"$installed" || missing+=("$package")
  done
  [ ${#missing[@]} = 0 ] && return 0
  # shellcheck disable=SC1091
  . /etc/os-release
  if [ "${ID:-} ${VERSION_ID:-}" != "debian 12" ]; then
    fail "${PRETTY_NAME:-this system} is not Debian 12, where Lodestone is built and tested. Missing here: ${missing[*]}"
  fi
  say "Installing Debian packages: ${missing[*]}"
  as_root apt-get update -qq
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null ||
    fail "apt-get could not install: ${missing[*]}"
}

# build PRESET [cmake options…]: into build/PRESET
build() {
  local preset=$1
  shift
  say "Building ($preset)"
  cd "$root"
  export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
  if ! cmake --preset "$preset" "$@" >build-"$preset".log 2>&1; then
    cat build-"$preset".log >&2
    fail "cmake could not configure"
  fi
  rm -f build-"$preset".log
  cmake --build --preset "$preset" -j "${LODESTONE_JOBS:-$(nproc)}" -- --quiet
}
