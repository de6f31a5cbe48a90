# Bare Debian systems for the checks of this folder, which source it with their arguments [RELEASE [BASE]]. Ends with 77
# (skipped) without root and debootstrap. Sets release, source (the tree) and work, a folder that is removed at the end.

release=${1:-bookworm}
if [ "$(id -u)" != 0 ] || ! command -v debootstrap >/dev/null; then
  echo "skipped: needs root and debootstrap"
  exit 77
fi
source=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
base=${2:-$work/base}

# new_system NAME: makes a bare system in $work/NAME, with this machine's own package source.
new_system() {
  if [ ! -e "$base/etc/debian_version" ]; then
    local mirror
    mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -n 1)
    debootstrap --variant=minbase "$release" "$base" "$mirror"
  fi
  cp -a "$base" "$work/$1"
  cp -L /etc/resolv.conf /etc/hosts "$work/$1/etc/"
}

# inside NAME COMMAND...: runs a command in a system, in namespaces of its own: its mounts and processes end with it.
inside() {
  unshare --mount --pid --ipc --fork --kill-child --propagation private bash -euc '
    mount -t proc proc "$0/proc"
    mount --rbind /dev "$0/dev"
    mount --rbind /sys "$0/sys"
    mount -t tmpfs tmpfs "$0/dev/shm"
    exec chroot "$0" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"' "$work/$1" "${@:2}"
}

say() { echo "=== $release: $*"; }
