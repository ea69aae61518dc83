#!/usr/bin/env bash
# Installs what gnomon needs on a Debian 12 (or newer) machine: sourced by host_min/run.sh and validation/run.sh, or run by itself.
# Does nothing, and asks for no rights, when everything is there. GNOMON_NO_INSTALL=1 leaves the machine alone.
set -euo pipefail

# What `gnomon` needs to make a picture. GNOMON_MINIMAL=1: only this; no oracle, no tests, no charts.
gnomon_packages=(
  g++ cmake ninja-build
  libvulkan-dev mesa-vulkan-drivers
  glslang-tools spirv-tools libspirv-cross-c-shared-dev
  libglm-dev libtinygltf-dev libstb-dev nlohmann-json3-dev
  libopenexr-dev libcli11-dev libfmt-dev
)
gnomon_cmake_options=(-DGNOMON_VALIDATION=OFF -DGNOMON_VIZ=OFF)
gnomon_formatter=clang-format-14   # the one of Debian 12: another version formats otherwise
if [ "${GNOMON_MINIMAL:-0}" != 1 ]; then
  gnomon_packages+=(
    vulkan-validationlayers
    libgtest-dev libbenchmark-dev libcgal-dev libgmp-dev libmpfr-dev libembree-dev libtbb-dev
    libvtk9-dev xvfb xauth
    chromium chromium-driver python3-selenium fonts-dejavu-core parallel
    "$gnomon_formatter"
  )
  gnomon_cmake_options=(-DGNOMON_VALIDATION=ON -DGNOMON_VIZ=ON)   # a build folder remembers what it was last told
fi
gnomon_oldest_mesa=24.1   # before it, lavapipe gives silently wrong results (README, "Driver")

gnomon_as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"
  elif command -v sudo >/dev/null; then sudo "$@"
  else echo "setup: root rights are needed to run '$*': run as root or install sudo" >&2; return 1; fi
}

gnomon_apt() { gnomon_as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o Dpkg::Use-Pty=0 "$@" >/dev/null; }

gnomon_installed_version() { dpkg-query -W -f '${db:Status-Status} ${Version}\n' "$1" 2>/dev/null | sed -n 's/^installed //p' | sed -n 1p; }

gnomon_install_packages() {
  local package missing=()
  for package in "${gnomon_packages[@]}"; do
    [ -n "$(gnomon_installed_version "$package")" ] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "setup: installing ${missing[*]}"
  gnomon_apt update
  gnomon_apt install --no-install-recommends "${missing[@]}"
}

# Debian 12 itself carries Mesa 22.3; its backports suite has a newer one. The suite is taken from the mirror the machine already uses.
gnomon_install_lavapipe() {
  local version mirror codename
  version=$(gnomon_installed_version mesa-vulkan-drivers)
  dpkg --compare-versions "$version" ge "$gnomon_oldest_mesa" && return 0
  read -r mirror codename < <(apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(ORIGIN) $(COMPONENT)' 'Identifier: Packages' |
    awk '$3 == "Debian" && $4 == "main" && $2 !~ /-/ { print $1, $2; exit }') || true
  if [ -z "${mirror:-}" ]; then
    echo "setup: mesa-vulkan-drivers $version is older than $gnomon_oldest_mesa and no Debian mirror is set up: install a newer Mesa by hand" >&2
    return 1
  fi
  echo "setup: Mesa $version is too old, installing the one of $codename-backports"
  printf '%s\n' 'Types: deb' "URIs: $mirror" "Suites: $codename-backports" 'Components: main' \
    'Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg' |
    gnomon_as_root tee "/etc/apt/sources.list.d/gnomon-backports.sources" >/dev/null
  gnomon_apt update
  gnomon_apt install --no-install-recommends -t "$codename-backports" mesa-vulkan-drivers
  version=$(gnomon_installed_version mesa-vulkan-drivers)
  dpkg --compare-versions "$version" ge "$gnomon_oldest_mesa" ||
    { echo "setup: mesa-vulkan-drivers is still $version; $gnomon_oldest_mesa or newer is needed" >&2; return 1; }
}

if [ "${GNOMON_NO_INSTALL:-0}" != 1 ] && command -v apt-get >/dev/null; then
  gnomon_install_packages
  gnomon_install_lavapipe
fi
