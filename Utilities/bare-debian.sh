# A bare Debian in a folder of its own, for scripts that try things there; sourced after common.sh. Needs root.
packages+=(debootstrap)

# make_bare SUITE: fills the folder $bare, which goes when the script ends.
make_bare() {
  local mirror
  # The mirror that this machine takes its own packages from.
  mirror=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' "Created-By: Packages" |
    awk '$2 == "bookworm" { print $1; exit }')
  say "A bare Debian: $1"
  bare=$(mktemp -d)
  trap remove_bare EXIT
  debootstrap --variant=minbase "$1" "$bare" "$mirror" >/dev/null
  mount -t proc proc "$bare/proc"
  inside apt-get update -qq 2>/dev/null
}

remove_bare() {
  umount "$bare/proc" || true
  rm -rf --one-file-system "$bare"
}

inside() { chroot "$bare" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"; }

inside_with_display() { inside xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"; }

install_inside() {
  inside apt-get install -y -qq --no-install-recommends "$@" >"$bare/install.log" 2>&1 || {
    cat "$bare/install.log" >&2
    exit 1
  }
}
