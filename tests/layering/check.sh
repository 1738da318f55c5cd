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
breaks core/voxel 'talus/(terrain|height_files|protocol|client|tools)' 'core/voxel knows core/vectors alone'
breaks core/terrain 'talus/(height_files|protocol|client|tools)' 'core/terrain knows core/voxel and core/vectors'
breaks core/height_files 'talus/(protocol|client|tools)' 'core/height_files knows core/terrain alone'
for base in files progress pictures; do
  breaks "core/$base" "talus/(vectors|voxel|terrain|height_files|protocol|tls|client|tools)" "core/$base knows no other module"
done
breaks core/tools 'talus/(protocol|tls|client)' 'core/tools knows core alone'
breaks protocol 'talus/(files|progress|voxel|terrain|height_files|client|tools)' 'protocol knows nobody'
breaks server 'talus/(client|tools)' 'the server knows core and protocol'
breaks client_sample 'talus/(terrain|height_files|tools)' 'a client knows core/voxel and protocol'
breaks client_sample/library '(command_line|measure|cli|load)/|talus/(files|progress|pictures)' 'the client library knows core/voxel and protocol alone'
breaks client_sample/measure 'talus/|(command_line|cli|load)/' 'measure knows no other module'
breaks client_sample/command_line '(measure|cli|load)/' 'command_line knows the client library'
breaks client_sample/cli '(load|library)/' 'talus-client knows the client library, command_line and measure'
breaks client_sample/load '(cli|library)/' 'talus-load knows the client library, command_line and measure'
for pure in core/vectors core/voxel core/terrain protocol; do
  breaks "$pure" "($impure)[>\"]?" 'a pure room has no I/O, threads or clock'
done
# A relative include could walk out of its room unseen.
breaks . '\.\./' 'includes name rooms, not paths'
if find . -path ./build -prune -o -type d \( -name utils -o -name common -o -name helpers \) -print | grep .; then
  echo "a thing lives with what it serves: no utils, common or helpers"
  failed=1
fi
exit "$failed"
