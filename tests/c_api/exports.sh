#!/usr/bin/env bash
# exports.sh LIBRARY HEADER PREFIX NEEDED: the library exports the functions that the header declares, each with a version, has the
# soname of the header's major version, PREFIX_API_MAJOR, and needs no libraries but these and the compiler's.
set -euo pipefail
library="$1" header="$2" prefix="$3" allowed="${4// /|}"
failed=0
# TALUS_API of each function, which the formatter may break into lines.
declared="$(grep -v '^#' "$header" | tr '\n' ' ' | grep -o 'TALUS_API [^(]*(' | grep -o 'talus_[a-z_]*(' | tr -d '(' | LC_ALL=C sort)"
exported="$(nm -D --defined-only "$library" | awk '$2 != "A" { print $3 }' | LC_ALL=C sort)"
if ! diff <(sed "s/\$/@@${prefix}_1.0/" <<<"$declared") <(echo "$exported"); then
  echo "$library: its exports are not the functions of $header"
  failed=1
fi
major="$(awk -v name="${prefix}_API_MAJOR" '$2 == name { print $3 }' "$header")"
name="$(basename "${library%%.so*}").so.$major"
if ! readelf -d "$library" | grep -qF "soname: [$name]"; then
  echo "$library: its soname is not $name"
  failed=1
fi
needed="$(readelf -d "$library" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' |
  grep -vE "^(lib($allowed)|libstdc\\+\\+|libgcc_s|libm|libc|lib[a-z]*san|ld-linux-x86-64)(-[0-9.]*)?\.so" || true)"
if [[ -n "$needed" ]]; then
  echo "$library: needs what client_sample/c_api/README.md does not name: $needed"
  failed=1
fi
exit "$failed"
