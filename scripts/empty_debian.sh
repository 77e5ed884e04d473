# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# An empty Debian in a folder, in which to try what a new user does. Sourced after scripts/setup.sh; root only.

# can_make_debian: whether this machine can make one; prints the reason if not.
can_make_debian() {
  [[ $EUID -eq 0 ]] || { echo "only root can make one"; return 1; }
  command -v debootstrap >/dev/null || install_packages debootstrap || true
  command -v debootstrap >/dev/null || { echo "there is no debootstrap"; return 1; }
}

# debian_mirror: prints the address that this machine's packages of Debian come from.
debian_mirror() {
  apt-get indextargets --format '$(REPO_URI) $(ORIGIN) $(RELEASE)' "Created-By: Packages" |
    awk -v release="$(. /etc/os-release && echo "$VERSION_CODENAME")" '$2 == "Debian" && $3 == release { print $1; exit }'
}

# make_empty_debian RELEASE ROOT: makes it, with git, certificates and the lists of packages, in an empty folder. A packed copy
# beside the build is used for a day. Packages that this machine has downloaded are shared.
make_empty_debian() {
  local release=$1 root=$2 packed=build/empty-$1.tar
  mkdir -p build "$root"
  if [[ -z $(find "$packed" -mmin -1440 2>/dev/null) ]]; then
    say "making an empty Debian ($release)"
    debootstrap --variant=minbase --include=git,ca-certificates "$release" "$root" "$(debian_mirror)" >&2 || return 1
    # Packages are written without waiting for the disk: a crash would end the trial anyway.
    echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io"
    tar --create --one-file-system --file "$packed.part" --directory "$root" . || return 1
    mv "$packed.part" "$packed" || return 1
  else
    tar --extract --file "$packed" --directory "$root" || return 1
  fi
  chmod 755 "$root"  # of mktemp, it lets no other user of that Debian in
  cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  echo "127.0.0.1 localhost" >"$root/etc/hosts"  # an installer writes it; browsers are driven through it
  mount -t proc proc "$root/proc" || return 1
  # Private: what is mounted in it must not appear in the machine's /dev.
  mount --bind --make-private /dev "$root/dev" || return 1
  mount -t devpts devpts "$root/dev/pts" || return 1
  mount --rbind --make-rslave /sys "$root/sys" || return 1  # Slurm's daemons read the control groups
  mount --bind /var/cache/apt/archives "$root/var/cache/apt/archives" || return 1
  inside "$root" apt-get --quiet update >&2
}

# remove_empty_debian ROOT: unmounts what was mounted, and removes the folder.
remove_empty_debian() {
  local folder
  for folder in var/cache/apt/archives dev/pts dev proc sys; do
    ! mountpoint -q "$1/$folder" || umount --recursive --lazy "$1/$folder" ||
      { say "$1 stays: $1/$folder is a folder of this machine, and cannot be unmounted"; return 1; }
  done
  rm -rf --one-file-system "$1"
}

# inside ROOT COMMAND...: runs a command in it as root, with an empty environment and the home folder /srv.
inside() {
  local root=$1
  shift
  chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/srv "$@"
}
