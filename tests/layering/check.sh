#!/usr/bin/env bash
# The arrows of the house, checked on every include: a room includes only the rooms it may know, and the pure
# rooms touch no clock, thread, file or socket. CMake's include paths say the same; this says it in one line.
set -euo pipefail
cd "$(dirname "$0")/../.."

failed=0
# breaks FOLDER PATTERN WHY: complains about every include under FOLDER that matches PATTERN.
breaks() {
  local found
  found="$(grep -rnE --include='*.h' --include='*.cpp' "^\s*#\s*include\s*[<\"]($2)" "$1" || true)"
  [[ -z "$found" ]] && return
  printf '%s\n' "$found" | sed "s|\$|    <- $3|"
  failed=1
}

impure='thread|mutex|shared_mutex|condition_variable|future|atomic|chrono|ctime|time\.h|fstream|cstdio|iostream|filesystem|random|asio|spdlog|sys/|unistd\.h|png\.h'
breaks core/vectors 'talus/(voxel|terrain|height_files|protocol|client|tools)' 'core/vectors knows nobody'
breaks core/toml 'talus/(vectors|voxel|terrain|height_files|protocol|client|tools)' 'core/toml knows nobody'
breaks core/voxel 'talus/(terrain|height_files|protocol|client|tools)' 'core/voxel knows core/vectors alone'
breaks core/terrain 'talus/(height_files|protocol|client|tools)' 'core/terrain knows core/voxel, core/toml and core/vectors'
breaks core/height_files 'talus/(protocol|client|tools)' 'core/height_files knows core/terrain alone'
breaks core/tools 'talus/(protocol|client)' 'core/tools knows core alone'
breaks protocol 'talus/(voxel|terrain|height_files|client|tools)' 'protocol knows nobody'
breaks server 'talus/(client|tools)' 'the server knows core and protocol'
breaks client_sample 'talus/(terrain|height_files|tools)' 'a client knows core/voxel and protocol'
for pure in core/vectors core/toml core/voxel core/terrain protocol; do
  breaks "$pure" "($impure)[>\"]?" 'a pure room has no I/O, threads or clock'
done
# A relative include could walk out of its room unseen.
breaks . '\.\./' 'includes name rooms, not paths'
if find . -path ./build -prune -o -type d \( -name utils -o -name common -o -name helpers \) -print | grep .; then
  echo "a thing lives with what it serves: no utils, common or helpers"
  failed=1
fi
exit "$failed"
