#!/bin/sh
# Runs a Windows program without its own files in the home folder. Wine reads arguments and names of files by the locale.
WINEPREFIX="${WINEPREFIX:-/tmp/talus-wine-$(id -u)}"
export WINEPREFIX WINEDEBUG=-all LC_ALL=C.UTF-8
exec wine "$@"
