#!/usr/bin/env bash
# Runs a program with the newest Mesa that Debian has: its llvmpipe has cooperative matrices and floats of 16 bits, which a stable
# system's may lack. As cargo's runner, it runs tests:
#
#   CARGO_TARGET_X86_64_UNKNOWN_LINUX_GNU_RUNNER=$PWD/scripts/newest-mesa.sh cargo test --workspace --test kernels
#
# It takes root. The first run makes a system of Debian's newest packages in target/mesa, or in the folder that ORGANZA_MESA names: 700
# MB, in four minutes.
set -euo pipefail
here=$PWD
workspace=$(cd "$(dirname "$0")/.." && pwd)
system=${ORGANZA_MESA:-${CARGO_TARGET_DIR:-$workspace/target}/mesa}
if [[ ! -d $system/usr/share/vulkan/icd.d ]]; then
  command -v mmdebstrap >/dev/null || { apt-get update -q && apt-get install -qy --no-install-recommends mmdebstrap; } >&2
  # The mirror that this system uses.
  mirror=$(grep -rhoE '(URIs: |^deb (\[[^]]*\] )?)https?://[^ ]*/debian/?( |$)' /etc/apt/sources.list /etc/apt/sources.list.d 2>/dev/null |
    grep -oE 'https?://[^ ]+' | head -n 1 || true)
  rm -rf "$system.new"
  mmdebstrap --quiet --variant=apt --aptopt='Acquire::Check-Valid-Until "false"' --include=libvulkan1,mesa-vulkan-drivers \
    sid "$system.new" "${mirror:-http://deb.debian.org/debian}" >&2
  mv "$system.new" "$system"
fi
program=$(readlink -f "$1")
shift
exec unshare --mount bash -c '
  set -euo pipefail
  system=$1 here=$2 workspace=$3 program=$4
  shift 4
  mount -t proc proc "$system/proc"
  mount --rbind /dev "$system/dev"
  for folder in /tmp "$here" "$workspace" "$(dirname "$program")"; do
    mkdir -p "$system$folder"
    mount --rbind "$folder" "$system$folder"
  done
  exec chroot "$system" /usr/bin/env -C "$here" VK_DRIVER_FILES=/usr/share/vulkan/icd.d/lvp_icd.json "$program" "$@"
' bash "$system" "$here" "$workspace" "$program" "$@"
