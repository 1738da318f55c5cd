#!/usr/bin/env bash
# exports.sh LIBRARY HEADER: the library exports the functions that the header declares, each with a version, has the
# soname of the header's major version, and needs no libraries but those listed here.
set -euo pipefail
library="$1" header="$2"
failed=0
# TALUS_API of each function, which the formatter may break into lines.
declared="$(grep -v '^#' "$header" | tr '\n' ' ' | grep -o 'TALUS_API [^(]*(' | grep -o 'talus_[a-z_]*(' | tr -d '(' | LC_ALL=C sort)"
exported="$(nm -D --defined-only "$library" | awk '$2 != "A" { print $3 }' | LC_ALL=C sort)"
if ! diff <(sed 's/$/@@TALUS_1.0/' <<<"$declared") <(echo "$exported"); then
  echo "$library: its exports are not the functions of $header"
  failed=1
fi
major="$(awk '$2 == "TALUS_API_MAJOR" { print $3 }' "$header")"
if ! readelf -d "$library" | grep -qF "soname: [libtalus.so.$major]"; then
  echo "$library: its soname is not libtalus.so.$major"
  failed=1
fi
needed="$(readelf -d "$library" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' |
  grep -vE '^(libssl|libcrypto|libhwy|libxxhash|libstdc\+\+|libgcc_s|libm|libc|lib[a-z]*san|ld-linux-x86-64)\.so' || true)"
if [[ -n "$needed" ]]; then
  echo "$library: needs what client_sample/c_api/README.md does not name: $needed"
  failed=1
fi
exit "$failed"
