#!/usr/bin/env bash
# check_debs.sh CPACK BUILD VERSION: Debian's packages of this build: their files, what they depend on, their conffile. Nothing is
# installed; run.sh does that.
set -euo pipefail
cpack="$1" build="$2" version="$3"
made="$build/packages-test"
rm -rf "$made"
fail() { printf '%s\n' "$*" >&2; exit 1; }
# Not compressed, which takes most of the time.
said="$("$cpack" --config "$build/CPackConfig.cmake" -G DEB -B "$made" -D CPACK_DEBIAN_COMPRESSION_TYPE=none 2>&1)" || fail "$said"
architecture="$(dpkg --print-architecture)"
deb() { printf '%s/%s_%s_%s.deb' "$made" "$1" "$version" "$architecture"; }

# has PACKAGE PATH...: it has these.
has() {
  local package="$1" files path
  shift
  files=$'\n'"$(dpkg-deb --fsys-tarfile "$(deb "$package")" | tar -t)"$'\n'
  for path in "$@"; do [[ "$files" == *$'\n'".$path"$'\n'* ]] || fail "$package has no $path but$files"; done
}
has talusd /usr/bin/talusd /etc/talus/talusd.toml /usr/lib/systemd/system/talusd.service /usr/share/talus/worlds/mesas.toml \
  /usr/share/doc/talus/{OPERATIONS,CHANGELOG}.md /usr/share/doc/talusd/copyright
has talus-tools /usr/bin/talus-gen /usr/bin/talus-client /usr/bin/talus-load
has libtalus1 /usr/lib/libtalus.so.1
has libtalus-local1 /usr/lib/libtalus-local.so.1
mapfile -t csharp < <(cd "$(dirname "$0")/../../client_sample/c_api/bindings" && printf '/usr/share/talus/bindings/%s\n' TalusClient.cs *.cs)
has libtalus-dev /usr/lib/libtalus{,-local}.so /usr/include/talus{,_local}.h "${csharp[@]}" /usr/lib/pkgconfig/talus{,-local}.pc /usr/include/talus/client/client.h /usr/lib/cmake/talus/talus-config.cmake /usr/lib/libtalus_client.a
[[ "$(ls "$made"/*.deb | wc -l)" == 5 ]] || fail "not five packages: $(ls "$made")"
twice="$(for file in "$made"/*.deb; do dpkg-deb --fsys-tarfile "$file" | tar -t; done | grep -v '/$' | sort | uniq -d)"
[[ -z "$twice" ]] || fail "in two packages: $twice"
links="$(for file in "$made"/*.deb; do dpkg-deb --fsys-tarfile "$file" | tar -t; done | grep -E '^\./(usr/local|usr/etc|tmp|home)' || true)"
[[ -z "$links" ]] || fail "at a place that is not a package's: $links"

depends() { dpkg-deb -f "$(deb "$1")" Depends; }
for library in libc6 librocksdb7.8 libssl3 adduser; do
  [[ ", $(depends talusd)" == *", $library"[\ ,]* ]] || fail "talusd depends on '$(depends talusd)', not on $library"
done
[[ "$(depends libtalus-dev)" == "libtalus1 (= $version), libtalus-local1 (= $version)" ]] || fail "libtalus-dev depends on '$(depends libtalus-dev)'"
[[ "$(depends talusd) $(depends talus-tools) $(depends libtalus1) $(depends libtalus-local1)" != *-dev* ]] || fail "a program depends on a -dev package"

dpkg-deb --control "$(deb talusd)" "$made/control"
[[ "$(cat "$made/control/conffiles")" == /etc/talus/talusd.toml ]] || fail "its conffiles: $(cat "$made/control/conffiles")"
for script in postinst prerm postrm; do
  [[ -x "$made/control/$script" ]] || fail "$script does not run"
  sh -n "$made/control/$script"
done
dpkg-deb -x "$(deb talusd)" "$made/root"
elsewhere="$(grep -rl '/usr/local/\(bin\|etc/talus\|share/talus\|share/doc\)' "$made/root" --include='*.service' --include='*.md' || true)"
[[ -z "$elsewhere" ]] || fail "names /usr/local: $elsewhere"
[[ "$(grep -c '^User=talus$' "$made/root/usr/lib/systemd/system/talusd.service")" == 1 ]] || fail "the unit has another user than the package"
rm -rf "$made"
