#!/usr/bin/env bash
# The committed dist/ is what the sources and the lock file make, small enough, and asks nobody but its own server.
set -euo pipefail
cd "$(dirname "$0")/.."
fail() { printf 'dist/: %s\n' "$*" >&2; exit 1; }

built="$(mktemp -d)"
trap 'rm -rf "$built"' EXIT
npx --no-install vite build --outDir "$built" --emptyOutDir --logLevel warn
diff -r "$built" dist || fail "is not what 'npm run build' makes of these sources; build it and commit it"

# First load: the page, and what it asks for before it draws. Workers and the engine count; the map comes later.
first="$(node test/first_load.mjs dist)"
all="$(find dist -type f ! -name '*.wasm' -printf '%s\n' | awk '{ sum += $1 } END { print sum }')"
printf 'first load: %d bytes by gzip -9 (at most 400000); all of dist/ but the generator: %d bytes (at most 1000000)\n' "$first" "$all"
((first <= 400000)) || fail "the first load is over 400 kB compressed"
((all <= 1000000)) || fail "is over 1 MB"

# The generator is that of talus-js, and nothing asks for it where a server sends the world.
for module in dist/assets/*.wasm; do
  name="$(basename "$module")"
  cmp "$module" "../talus-js/wasm/${name%-*}.wasm" || fail "has another generator than talus-js"
done
! find dist -name '*.map' | grep -q . || fail "has source maps"
! grep -lE '<script(>| [^>]*>[^<])|<style| style=| on[a-z]+="' dist/*.html || fail "has inline scripts or styles, which the policy forbids"
# XML namespaces and texts of libraries are no requests; what a page loads is in src, href, url() and import().
! grep -hoE "(src|href)=\"(https?:)?//[^\"]*|url\((https?:)?//[^)]*|import\(\"https?:[^\"]*" -r dist || fail "asks another host"
