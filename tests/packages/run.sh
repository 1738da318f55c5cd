#!/usr/bin/env bash
# run.sh [KIND...]: as root, installs each package of out/packages where nothing else of Talus is, and uses it.
set -euo pipefail
cd "$(dirname "$0")/../.."
source tests/packages/common.sh
((EUID == 0)) || die "needs root, for roots and networks of its own"
packages=out/packages talusd=build/release/server/talusd
for kind in "${@:-deb portable sdk npm wheel crate}"; do
  for each in $kind; do
    began=$SECONDS
    case "$each" in
      deb) tests/packages/debs.sh "$packages" "$(dpkg --print-architecture)" ;;
      arm64) tests/packages/debs.sh "$packages" arm64 ;;
      portable | sdk | npm | wheel | crate | image) "tests/packages/$each.sh" "$packages" "$talusd" ;;
      windows) python3 -B tests/machines/windows.py "$(only_one "$packages/talus-*-windows-*.zip")" ;;
      *) die "'$each' is no kind of package" ;;
    esac
    say "$each took $((SECONDS - began)) s"
  done
done
