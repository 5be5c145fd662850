#!/bin/sh
# package_test.sh BUILD CPACK: makes the Debian package, unpacks it into a temporary root and starts the server there.
set -eu
# shellcheck source=package.sh source-path=SCRIPTDIR
. "$(dirname "$0")/package.sh"

make_package
dpkg-deb --extract "$package" "$root/installed"
dpkg-deb --info "$package" conffiles | grep -qx /etc/cnclab/lab.toml || fail "lab.toml is no conffile"
for file in usr/bin/cnclab-server usr/bin/cnclab-station usr/bin/cnclab-instructor usr/bin/cnclab-tool \
            usr/lib/systemd/system/cnclab-server.service usr/share/doc/cnclab/administration.md \
            usr/share/doc/cnclab/examples/bild7.cnc etc/cnclab/lab.toml; do
  [ -s "$root/installed/$file" ] || fail "$file is missing in the package"
done

# The unit: nothing in it that systemd does not know.
unit=$root/installed/usr/lib/systemd/system/cnclab-server.service
if command -v systemd-analyze > /dev/null; then
  # The program stands in this root, not in the system's.
  mkdir "$root/unit"
  sed "s|/usr/bin/|$root/installed/usr/bin/|; /^Documentation=/d" "$unit" > "$root/unit/cnclab-server.service"
  found=$(systemd-analyze verify --man=no "$root/unit/cnclab-server.service" 2>&1 | grep -F cnclab-server || :)
  [ -z "$found" ] || fail "systemd-analyze verify: $found"
else
  echo "no systemd-analyze here: the unit was not verified"
fi

start_server "$root/installed"
end_server
[ -s "$root/installed/var/lib/cnclab/cnclab.db" ] || fail "no database was made"
echo "unpacked, started on $address, ended"
