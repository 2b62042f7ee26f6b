#!/bin/sh
# key-ring.sh PROGRAM ARGUMENTS: runs it beside an open key ring, whose files are in a folder of its own, FENESTRA_KEY_RING.
# Called on a session bus of its own, so the ring of who runs the tests is left alone.
if ! command -v gnome-keyring-daemon >/dev/null; then
  echo "needs gnome-keyring-daemon of Debian's package gnome-keyring"
  exit 77
fi
FENESTRA_KEY_RING=$(mktemp -d)
export FENESTRA_KEY_RING XDG_DATA_HOME="$FENESTRA_KEY_RING/data" XDG_RUNTIME_DIR="$FENESTRA_KEY_RING/run"
mkdir -m 700 "$XDG_RUNTIME_DIR"
printf 'opens the ring' | gnome-keyring-daemon --unlock --components=secrets >/dev/null || exit 1
"$@"
result=$?
rm -rf "$FENESTRA_KEY_RING"
exit $result
