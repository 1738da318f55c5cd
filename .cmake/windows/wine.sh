#!/bin/sh
# Runs a Windows program, without files in the home folder and without Wine's offers to install more. Wine reads arguments and
# names of files by the locale.
WINEPREFIX="${WINEPREFIX:-/tmp/talus-wine-$(id -u)}"
export WINEPREFIX WINEDEBUG=-all WINEDLLOVERRIDES=mscoree,mshtml= LC_ALL=C.UTF-8
exec wine "$@"
