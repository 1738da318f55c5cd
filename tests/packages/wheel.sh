#!/usr/bin/env bash
# wheel.sh PACKAGES TALUSD: installs the wheel in a new virtual environment, and uses it against talusd.
set -euo pipefail
source "$(dirname "$0")/common.sh"
wheel="$(realpath "$(only_one "$1/talus_client-*.whl")")" talusd="$(realpath "$2")"
[[ "$wheel" == *-py3-none-any.whl ]] || die "$wheel is for some machines only, and has nothing that is"
scratch="$(mktemp -d)"
server=""
trap 'end "$server"; rm -rf "$scratch"' EXIT
cd "$scratch"
/usr/bin/python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check "$wheel"

"$talusd" --listen 127.0.0.1:0 >talusd.log 2>&1 &
server=$!
wait_for_line talusd.log 'listening on' "$server"
address="$(sed -n 's/.*listening on \([^ ]*\).*/\1/p' talusd.log | head -n 1)"
env -u PYTHONPATH venv/bin/python - "$address" venv <<'PY'
import sys
import talus

assert f"/{sys.argv[2]}/" in talus.__file__, talus.__file__
with talus.connect(sys.argv[1]) as world:
    x, y, z = world.spawn
    chunk = world.chunk(x // 32, y // 32, z // 32)
    assert (chunk.voxels.shape, str(chunk.voxels.dtype)) == ((32, 32, 32), "uint16")
    chunks = list(world.view(x, z, radius=2))
    solid = sum(int((chunk.voxels != 0).sum()) for chunk in chunks)
    assert chunks and solid
    print(f"{len(chunks)} chunks, {solid} solid; ground {world.heights([(x, z)])[0]}")
PY
say "$(basename "$wheel"): in a new virtual environment"
