#!/bin/sh
# Runs a Windows program without its own files in the home folder.
WINEPREFIX="${WINEPREFIX:-/tmp/talus-wine-$(id -u)}"
export WINEPREFIX WINEDEBUG=-all
exec wine "$@"
