#!/usr/bin/env bash
# The source that .cmake/build_version/write.cmake writes, in a repository, of another owner too, and in archives.
set -euo pipefail
cmake="$1"
source="$(cd "$(dirname "$0")/../.." && pwd)"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
unset GIT_DIR GIT_WORK_TREE
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null # which may trust every owner

# named FOLDER WANTED: the version of a build of FOLDER is WANTED.
named() {
  "$cmake" -DSOURCE="$1" -DVERSION=1.2.3 -DOUTPUT="$scratch/written.cpp" -P "$source/.cmake/build_version/write.cmake"
  grep -qF "kBuildVersion = \"$2\";" "$scratch/written.cpp" ||
    { printf '%s: not "%s", but\n%s\n' "$1" "$2" "$(cat "$scratch/written.cpp")" >&2; exit 1; }
}

mkdir -p "$scratch/clone/.cmake/build_version"
cp "$source/.gitattributes" "$scratch/clone/"
cp "$source/.cmake/build_version/commit.txt" "$scratch/clone/.cmake/build_version/"
named "$scratch/clone" 1.2.3 # as unpacked from elsewhere: no repository, and nothing was filled in

cd "$scratch/clone"
git init -q .
git add -A
git -c user.name=a -c user.email=a@example.com -c commit.gpgsign=false commit -q -m "Begin"
commit="$(git rev-parse HEAD)"
named "$scratch/clone" "1.2.3 (${commit:0:8})"

mkdir "$scratch/archive"
git archive HEAD | tar -x -C "$scratch/archive"
named "$scratch/archive" "1.2.3 (${commit:0:8})"

if ((EUID == 0)); then
  chown -R 12345:12345 "$scratch/clone"
  if git rev-parse HEAD >/dev/null 2>&1; then echo "git did not refuse a clone of another owner" >&2; exit 1; fi
  named "$scratch/clone" "1.2.3 (${commit:0:8})"
fi
