# SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
# SPDX-License-Identifier: BSD-3-Clause
# Shared by the scripts in tools/: says what it does, installs what is missing, builds a preset.

say() { printf '\033[1m==> %s\033[0m\n' "$*"; }
fail() { printf '%s: %s\n' "$(basename "$0")" "$*" >&2; exit 2; }

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"
  elif command -v sudo >/dev/null; then sudo "$@"
  else fail "packages are missing and neither root nor sudo is there: install the packages of tools/packages.txt"
  fi
}

# install_packages [package...]: those of tools/packages.txt and the given ones that are missing.
install_packages() {
  local wanted missing=()
  mapfile -t wanted < <(grep -v '^#' "$repository/tools/packages.txt"; printf '%s\n' "$@")
  for package in "${wanted[@]}"; do
    [ -z "$package" ] && continue
    dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed && continue
    # Node.js from elsewhere than Debian brings its own npm and cannot stand beside Debian's.
    [ "$package" = npm ] && command -v npm >/dev/null && continue
    missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    say "Packages: all ${#wanted[@]} are there"
    return
  fi
  say "Packages: installing ${#missing[@]} through apt: ${missing[*]}"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get update -qq
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}" >/dev/null
}

# install_page_modules: three.js, and Playwright for the tests, at the versions of the lock file. Without them
# all else still works: the page is left out.
install_page_modules() {
  local page=$repository/tools/view/page
  if [ "$page/node_modules/.package-lock.json" -nt "$page/package-lock.json" ]; then
    say "Page: three.js is there"
    return
  fi
  say "Page: installing three.js through npm"
  (cd "$page" && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error >/dev/null) ||
    say "Page: npm could not install three.js; going on without the page"
}

# build_preset <preset> [target...]: configures and builds; the compiler cache makes the second time quick.
build_preset() {
  local preset=$1; shift
  # Precompiled headers and a moved checkout must not spoil the cache.
  export CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_NOHASHDIR=1 CCACHE_BASEDIR="$repository"
  say "Configuring preset $preset"
  (cd "$repository" && cmake --preset "$preset" --log-level=WARNING)
  say "Building preset $preset on $(nproc) cores (the first time takes minutes)"
  (cd "$repository" && cmake --build --preset "$preset" --parallel "$(nproc)" ${*:+--target "$@"})
}
