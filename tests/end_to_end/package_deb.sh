#!/usr/bin/env bash
# The Debian package in a bare Debian 12 of its own: install it with apt, run the server as its user,
# put a recipe and a robot, get a plan, remove it, purge it.
#   package_deb.sh BUILD_FOLDER
# Builds the package there first. LARES_CHROOT names a tree that debootstrap made, to copy instead of
# making one. Skipped (77) without root or debootstrap.
set -uo pipefail
root="$(cd "$(dirname "$0")/../.." && pwd)"
build="$(readlink -f "${1:-$root/build/release}")"
failures=0 checks=0 server=""

skip() { echo "skipped: $*"; exit 77; }
[ "$(id -u)" = 0 ] || skip "a bare Debian can be made by root only"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"

tree="$(mktemp -d)"
finish() {
  [ -n "$server" ] && { kill -KILL "$server"; wait "$server"; } 2>/dev/null
  mountpoint -q "$tree/proc" && umount "$tree/proc"
  rm -rf --one-file-system "$tree"
  echo "$((checks - failures)) of $checks checks hold"
  [ "$failures" = 0 ] && [ "$checks" -gt 30 ]
  exit
}
trap finish EXIT

# in_tree COMMAND… : runs it in the bare Debian, without anything of this session's environment.
in_tree() {
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    HOME=/root chroot "$tree" "$@"
}
# expect CODE COMMAND…, has TEXT… : as in session.sh.
expect() {
  local wanted="$1" code=0
  shift
  output="$("$@" 2>&1)" || code=$?
  checks=$((checks + 1))
  [ "$code" = "$wanted" ] && return
  failures=$((failures + 1))
  printf 'FAILED: %s\n  exit code %s, expected %s\n%s\n' "$*" "$code" "$wanted" "$output"
}
has() {
  local text
  for text in "$@"; do
    checks=$((checks + 1))
    grep -qF -- "$text" <<<"$output" && continue
    failures=$((failures + 1))
    printf "FAILED: '%s' is missing in:\n%s\n" "$text" "$output"
  done
}
there() { for file in "$@"; do expect 0 test -e "$tree$file"; done; }
gone() { for file in "$@"; do expect 1 test -e "$tree$file"; done; }

# ---- The package ---------------------------------------------------------------------------------
cmake --build "$build" --target package >"$tree/package.log" 2>&1 || {
  tail -n 30 "$tree/package.log"
  failures=1
  exit
}
deb="$(ls -t "$build"/lares_*.deb | head -1)"
rm "$tree/package.log"
expect 0 dpkg-deb --info "$deb"
has "Package: lares" "Architecture: $(dpkg --print-architecture)" "Depends: " "libswipl9" "libc6 (>=" \
  "adduser"
expect 0 dpkg-deb --contents "$deb"
has ./usr/bin/lares ./usr/share/lares/ontology/core.ttl ./usr/share/lares/ontology/priors/lares.tsv \
  ./usr/share/man/man1/lares-plan-diff.1.gz ./usr/lib/systemd/system/lares.service \
  ./usr/share/doc/lares/copyright ./usr/share/doc/lares/changelog.gz ./usr/share/doc/lares/install.md
checks=$((checks + 1))
if grep -vE '^.{10} root/root ' <<<"$output" | grep -q .; then
  failures=$((failures + 1))
  echo "FAILED: not everything is root's: $output"
fi
if command -v systemd-analyze >/dev/null; then
  # The unit is checked as installed; that its program is missing on this machine is no fault of it.
  unit="$(mktemp -d)"
  dpkg-deb --fsys-tarfile "$deb" | tar -x -C "$unit" --strip-components=5 \
    ./usr/lib/systemd/system/lares.service
  sed -i 's,^ExecStart=/usr/bin/lares,ExecStart=/bin/true,' "$unit/lares.service"
  expect 0 systemd-analyze verify --man=no "$unit/lares.service"
  expect 0 systemd-analyze security --offline=yes --threshold=25 "$unit/lares.service"
  rm -rf "$unit"
fi

# ---- A bare Debian -------------------------------------------------------------------------------
if [ -n "${LARES_CHROOT:-}" ]; then
  cp -a "$LARES_CHROOT/." "$tree/"
else
  echo "Making a bare Debian (some minutes) …"
  debootstrap --variant=minbase bookworm "$tree" >"$tree.log" 2>&1 || {
    tail -n 5 "$tree.log"
    rm -f "$tree.log"
    skip "debootstrap found no mirror"
  }
  rm -f "$tree.log"
fi
mount -t proc proc "$tree/proc"
cp /etc/resolv.conf "$tree/etc/resolv.conf"
cp "$deb" "$tree/root/lares.deb"
expect 0 in_tree apt-get update -qq
expect 0 in_tree apt-get install -y -qq --no-install-recommends /root/lares.deb
expect 0 in_tree dpkg-query -W -f '${Status}' lares && has "install ok installed"
expect 0 in_tree lares --version && has "lares 0.1.0"
expect 0 in_tree getent passwd lares && has /var/lib/lares nologin
expect 0 in_tree stat -c '%U:%G %a' /var/lib/lares && has "lares:lares 750"
there /usr/share/bash-completion/completions/lares /usr/share/zsh/vendor-completions/_lares \
  /usr/share/fish/vendor_completions.d/lares.fish /usr/share/man/man1/lares.1.gz
wanted=/etc/systemd/system/multi-user.target.wants/lares.service
expect 0 in_tree test -e "$wanted"
# What it reads stands in one place, and nothing of it elsewhere.
expect 1 in_tree sh -c "find / -xdev -path /proc -prune -o -name '*.ttl' -print | grep -v ^/usr/share/"

# ---- The server, as its user, with as little as the unit leaves it -------------------------------
port=$((20000 + RANDOM % 20000))
env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin chroot "$tree" setpriv --reuid lares --regid lares --clear-groups \
  --no-new-privs --bounding-set -all --inh-caps -all \
  lares serve --port "$port" --data /var/lib/lares >"$tree/root/serve.out" 2>&1 &
server=$!
lares() { in_tree env LARES_SERVER="http://127.0.0.1:$port" lares "$@"; }
for _ in $(seq 300); do
  lares status >/dev/null 2>&1 && break
  kill -0 "$server" 2>/dev/null || { cat "$tree/root/serve.out"; break; }
  sleep 0.2
done
expect 0 lares status && has "Lares 0.1.0"
expect 0 lares recipe put /usr/share/lares/recipes/library/object-search.ttl && has ObjectSearch
expect 0 lares robot put /usr/share/lares/robots/models/scout.ttl && has scout
expect 0 lares plan ObjectSearch --object Cup --robot scout && has "start-vision" "Plan: ObjectSearch"
expect 0 lares environment put flat --type Home --layer semantic=/usr/share/doc/lares/examples/demo/flat.ttl
expect 0 lares where Cup --environment flat
expect 0 lares prolog "subclass(lares:'Cup', lares:'Container')" && has yes
expect 0 in_tree find /var/lib/lares -not -user lares
[ -z "$output" ] || { failures=$((failures + 1)); echo "FAILED: not the server's: $output"; }
kill -TERM "$server" && wait "$server"
expect 0 grep -c stopped "$tree/root/serve.out"
server=""

# ---- Going -----------------------------------------------------------------------------------------
expect 0 in_tree apt-get install -y -qq --reinstall --no-install-recommends /root/lares.deb
expect 0 in_tree apt-get remove -y -qq lares
gone /usr/bin/lares /usr/share/lares /usr/lib/systemd/system/lares.service /usr/share/man/man1/lares.1.gz
there /var/lib/lares
expect 0 in_tree apt-get purge -y -qq lares
gone /var/lib/lares
expect 1 in_tree test -L "$wanted"
expect 2 in_tree getent passwd lares
