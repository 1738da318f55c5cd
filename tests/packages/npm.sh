#!/usr/bin/env bash
# npm.sh PACKAGES TALUSD: installs talus-client in a new project, compiles a program against it by the oldest and the newest
# TypeScript, and runs it against talusd.
set -euo pipefail
source "$(dirname "$0")/common.sh"
package="$(realpath "$(only_one "$1/talus-client-*.tgz")")" talusd="$(realpath "$2")"
scratch="$(mktemp -d)"
server=""
trap 'end "$server"; rm -rf "$scratch"' EXIT
cd "$scratch"

"$talusd" --listen 127.0.0.1:0 >talusd.log 2>&1 &
server=$!
wait_for_line talusd.log 'listening on' "$server"
address="$(sed -n 's/.*listening on \([^ ]*\).*/\1/p' talusd.log | head -n 1)"

cat >game.ts <<'TS'
import { ChunkStore, connect, decodeChunk, type World } from 'talus-client/node';
import { connect as connectInBrowser } from 'talus-client';
import { decodeChunk as decodeAlone } from 'talus-client/decode';

const client = connect({ url: `tcp://${process.argv[2]}` });
let chunks = 0, solid = 0;
client.on('chunk', ({ key, payload, hash }) => {
  const { voxels, uniform } = decodeChunk(payload, { hash });
  const all: Uint16Array | null = voxels;
  chunks += 1;
  solid += all === null ? (uniform === 0 ? 0 : 32768) : all.reduce((sum: number, id: number) => sum + (id === 0 ? 0 : 1), 0);
  if (key.lod !== 0) throw new Error(`level ${key.lod}`);
});
client.on('viewComplete', () => client.close());
const world: World = await client.ready();
client.setView({ centre: world.spawn, horizontalRadius: 2, verticalRadius: 2 });
client.on('closed', () => console.log(`${chunks} chunks, ${solid} solid, ${[connectInBrowser, decodeAlone, ChunkStore].map((one) => typeof one)}`));
TS
results=()
for typescript in 5.0.4 latest; do
  rm -rf node_modules package.json package-lock.json game.js
  echo '{ "name": "game", "version": "1.0.0", "private": true, "type": "module" }' >package.json
  npm install --silent --no-audit --no-fund "$package" "typescript@$typescript" @types/node@18.19.130
  npx tsc --strict --target es2022 --module nodenext --moduleResolution nodenext --types node game.ts
  said="$(timeout 120 node game.js "$address")"
  [[ "$said" =~ ^[1-9][0-9]*\ chunks,\ [1-9][0-9]*\ solid,\ function,function,function$ ]] || die "it said: $said"
  results+=("TypeScript $(npx tsc --version | sed 's/Version //'): $said")
done
say "$(basename "$package"): in a new project"
printf '%s\n' "${results[@]}"
