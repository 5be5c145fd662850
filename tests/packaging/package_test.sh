#!/bin/sh
# package_test.sh BUILD CPACK: makes the Debian package, unpacks it into a temporary root and starts the server there.
set -eu
build=$1
cpack=$2
root=$(mktemp -d)
server=
trap '[ -z "$server" ] || kill "$server" 2>/dev/null || :; rm -rf "$root"' EXIT
fail() { echo "$1" >&2; exit 1; }

"$cpack" --config "$build/CPackConfig.cmake" -B "$root/packages" > "$root/cpack.log" 2>&1 || { cat "$root/cpack.log"; exit 1; }
package=$(ls "$root"/packages/cnclab_*.deb)
dpkg-deb --extract "$package" "$root/installed"
dpkg-deb --info "$package" conffiles | grep -qx /etc/cnclab/lab.toml || fail "lab.toml is no conffile"
for file in usr/bin/cnclab-server usr/bin/cnclab-station usr/bin/cnclab-instructor usr/bin/cnclab-tool \
            usr/lib/systemd/system/cnclab-server.service usr/share/doc/cnclab/administration.md etc/cnclab/lab.toml; do
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

# The command line of the service, with the paths of this root and any free port.
command=$(sed -n 's/^ExecStart=//p' "$unit")
command=$(echo "$command" | sed "s|/usr/bin/|$root/installed/usr/bin/|; s|/etc/cnclab|$root/installed/etc/cnclab|; s|/var/lib/cnclab|$root/data|")
mkfifo "$root/output"
# shellcheck disable=SC2086
$command --listen 127.0.0.1:0 > "$root/output" 2> "$root/server.log" &
server=$!
address=
while read -r word rest; do
  [ "$word" = listening ] && { address=${rest%% *}; break; }
done < "$root/output"
[ -n "$address" ] || { cat "$root/server.log"; fail "the installed server did not start"; }
kill -TERM "$server"
wait "$server" || fail "the installed server did not end with 0"
server=
[ -s "$root/data/cnclab.db" ] || fail "no database was made"
echo "installed, started on $address, ended"
