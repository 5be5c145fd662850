# What the tests of the package share; sourced. Sets `root`, a temporary folder that is gone at the end.
# shellcheck shell=sh disable=SC2034
build=$1
cpack=$2
root=$(mktemp -d)
server=
trap '[ -z "$server" ] || kill "$server" 2>/dev/null || :; rm -rf "$root"' EXIT

fail() { echo "$1" >&2; exit 1; }

# Makes the package; `package` is its file.
make_package() {
  "$cpack" --config "$build/CPackConfig.cmake" -B "$root/packages" > "$root/cpack.log" 2>&1 || { cat "$root/cpack.log"; exit 1; }
  package=$(ls "$root"/packages/cnclab_*.deb)
}

# start_server PLACE: the unit's own command line, with the paths below PLACE and any free port; `address` is where it listens.
start_server() {
  place=$1
  command=$(sed -n 's/^ExecStart=//p' "$place/usr/lib/systemd/system/cnclab-server.service" |
            sed "s|/usr/bin/|$place&|; s|/etc/cnclab|$place&|; s|/var/lib/cnclab|$place&|")
  mkdir -p "$place/var/lib"
  rm -f "$root/output"
  mkfifo "$root/output"
  # shellcheck disable=SC2086
  $command --listen 127.0.0.1:0 > "$root/output" 2> "$root/server.log" &
  server=$!
  address=
  while read -r word rest; do
    [ "$word" = listening ] && { address=${rest%% *}; break; }
  done < "$root/output"
  [ -n "$address" ] || { cat "$root/server.log"; fail "the installed server did not start"; }
}

# Ends it as systemd does.
end_server() {
  kill -TERM "$server"
  wait "$server" || fail "the installed server did not end with 0"
  server=
}
