#!/usr/bin/env bash
# install.sh CMAKE BUILD LIBDIR EXAMPLES CC SANITIZE: installs libtalus and libtalus-local alone, and builds the examples as a
# user does: by the flags that pkg-config tells, as C99.
set -euo pipefail
cmake="$1" build="$2" libdir="$3" examples="$4" compiler="$5" sanitize="$6"
prefix="$build/c-api-install-test"
rm -rf "$prefix"
"$cmake" --install "$build" --prefix "$prefix" --component c_api
export PKG_CONFIG_PATH="$prefix/$libdir/pkgconfig"
version="$(awk '/^#define TALUS_API_M(AJ|IN)OR / { printf "%s%s", dot, $3; dot = "." }' "$prefix/include/talus.h")"
[[ "$(pkg-config --modversion talus)" == "$version" ]] || { echo "pkg-config says $(pkg-config --modversion talus), not the interface's $version"; exit 1; }
# compiled EXAMPLE LIBRARY
compiled() {
  local flags
  read -ra flags <<<"$(pkg-config --cflags --libs "$2")"
  [[ -z "$sanitize" ]] || flags+=("-fsanitize=$sanitize")
  "$compiler" -std=c99 -Wall -Wextra -pedantic -Werror "$examples/$1.c" -o "$prefix/$1" "${flags[@]}"
}
compiled fly talus
# Nobody listens on port 1: the program runs, links and says so.
if said="$(LD_LIBRARY_PATH="$prefix/$libdir" "$prefix/fly" 127.0.0.1 1 2>&1)"; then
  echo "it ended well without a server: $said"
  exit 1
fi
[[ "$said" == "127.0.0.1:1: no server answers there: Connection refused" ]] || { echo "it said: $said"; exit 1; }
compiled single_player talus-local
LD_LIBRARY_PATH="$prefix/$libdir" "$prefix/single_player" "$prefix/game.talus"
