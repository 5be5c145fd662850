#!/bin/sh
# install_test.sh BUILD CPACK: dpkg installs, upgrades, removes and purges the package in a root of its own. dpkg wants to
# be root for that: who is not is made so in a user namespace; where that is forbidden too the test is skipped (77).
set -eu
if [ "$(id -u)" -ne 0 ]; then
  unshare --map-root-user true 2> /dev/null && exec unshare --map-root-user "$0" "$@"
  echo "skipped: dpkg installs only as root, and user namespaces are not allowed here"
  exit 77
fi
PATH=/usr/sbin:/sbin:$PATH  # dpkg insists on the programs there
# shellcheck source=package.sh source-path=SCRIPTDIR
. "$(dirname "$0")/package.sh"

system=$root/system
configuration=$system/etc/cnclab/lab.toml
mkdir -p "$system/var/lib/dpkg"
: > "$system/var/lib/dpkg/status"
# Nothing that the package depends on is installed in that root.
in_system() {
  dpkg --root="$system" --log="$root/dpkg.log" --force-depends "$@" > "$root/dpkg.out" 2>&1 < /dev/null ||
    { cat "$root/dpkg.out"; fail "dpkg $* failed"; }
}
expect_state() {
  state=$(dpkg-query --admindir="$system/var/lib/dpkg" -W -f='${db:Status-Status} ${Version}' cnclab 2> /dev/null || echo none)
  [ "$state" = "$1" ] || fail "the package is '$state', expected '$1'"
}
# newer VERSION [LINE]: the same package as a later version, with LINE added to the lab.toml that it brings.
newer() {
  rm -rf "$root/newer"
  dpkg-deb --raw-extract "$package" "$root/newer"
  sed -i "s/^Version: .*/Version: $1/" "$root/newer/DEBIAN/control"
  [ -z "${2-}" ] || echo "$2" >> "$root/newer/etc/cnclab/lab.toml"
  dpkg-deb --root-owner-group -Znone --build "$root/newer" "$root/newer.deb" > /dev/null
}

make_package
version=$(dpkg-deb --field "$package" Version)

in_system --install "$package"
expect_state "installed $version"
start_server "$system"
end_server
[ -s "$system/var/lib/cnclab/cnclab.db" ] || fail "no database was made"

# What the school has set stays: without a question where the package brings nothing new, and where it does beside it.
sed -i 's/^language = "de"/language = "en"/' "$configuration"
grep -q '^language = "en"' "$configuration" || fail "lab.toml has no language to change"
cp "$configuration" "$root/changed.toml"
newer "$version+1"
in_system --install "$root/newer.deb"
expect_state "installed $version+1"
cmp "$root/changed.toml" "$configuration" || fail "an upgrade changed lab.toml"
newer "$version+2" '# new in this version'
in_system --force-confold --install "$root/newer.deb"
expect_state "installed $version+2"
cmp "$root/changed.toml" "$configuration" || fail "an upgrade with another lab.toml changed the school's"
grep -q 'new in this version' "$configuration.dpkg-dist" || fail "the new lab.toml is not beside the school's"
start_server "$system"
end_server

# Removed: the programs go, settings and data stay. Purged: the settings go too, the data stay.
in_system --remove cnclab
expect_state "config-files $version+2"
[ ! -e "$system/usr/bin/cnclab-server" ] || fail "--remove left the server"
cmp "$root/changed.toml" "$configuration" || fail "--remove took lab.toml"
in_system --purge cnclab
expect_state none
[ ! -e "$system/etc/cnclab" ] || fail "--purge left /etc/cnclab"
[ -s "$system/var/lib/cnclab/cnclab.db" ] || fail "--purge took the lab's data"
echo "installed, upgraded twice, removed, purged"
