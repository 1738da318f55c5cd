#!/usr/bin/env bash
# The AVX-512 kernels on a processor without AVX-512: Debian's kernel and the tests of build/release in Bochs, which
# emulates a Skylake-X. Shows that they give the right bits, not how fast. Takes some minutes; output in build/avx512.
#
# Bochs 2.7 gives wrong bytes for `vpbroadcastb (memory), %zmm{%k}`, which a processor gives right and g++ makes of the
# kernel that cuts a slice of a chunk from planes (core/voxel/src/kernels.cpp) unless told not to optimise. So that kernel's
# test is left out, and golden is the one by -O0.
set -euo pipefail
cd "$(dirname "$0")/../.."
repository="$PWD"
place="$repository/build/avx512"
limit_s=1500
rm -rf "$place/root" "$place/iso"
mkdir -p "$place"/{kernel,root,iso/isolinux}

# The kernel is unpacked, not installed.
if ! ls "$place"/kernel/boot/vmlinuz-* >/dev/null 2>&1; then
  package="$(apt-cache depends linux-image-cloud-amd64 | awk '/Depends: linux-image/ { print $2; exit }')"
  (cd "$place/kernel" && apt-get -o APT::Sandbox::User=root download -qq "$package" && dpkg -x ./*.deb . && rm ./*.deb)
fi

root="$place/root"
mkdir -p "$root"/{bin,proc,sys,dev,lib64,programs} "$root$repository"/{core,tests/golden}
cp /bin/busybox "$root/bin/busybox"
ln -s busybox "$root/bin/sh"
cp build/release/tests/terrain/test_terrain build/release/tests/voxel/test_voxel \
  build/release/tests/golden/talus_golden_O0 "$root/programs"
for program in "$root"/programs/*; do ldd "$program" | grep -oE '/lib[^ ]+'; done | sort -u | while read -r library; do
  mkdir -p "$root${library%/*}"
  cp -L "$library" "$root$library"
done
cp -r core/worlds "$root$repository/core"
cp -r tests/golden/golden.txt tests/golden/worlds "$root$repository/tests/golden"
cat >"$root/init" <<INIT
#!/bin/sh
/bin/busybox --install -s /bin
mount -t proc proc /proc
mount -t devtmpfs dev /dev
exec >/dev/ttyS0 2>&1 </dev/null
export PATH=/bin TALUS_INSTRUCTION_SET=avx512
export LD_BIND_NOW=1  # the emulator trips over the state that lazy binding saves
failed=0
for tests in test_terrain test_voxel; do
  echo "== \$tests"
  /programs/\$tests -w NoTests '"*instruction set*"~"slices are put together*"' --use-colour no || failed=1
done
echo "== talus_golden_O0"
/programs/talus_golden_O0 "$repository/tests/golden/golden.txt" 16 || failed=1
[ \$failed = 0 ] && echo "ALL AS EXPECTED BY AVX-512"
sleep 2  # until all of it is on the line
poweroff -f
INIT
chmod +x "$root/init"
(cd "$root" && find . | cpio -o -H newc --quiet -R 0:0) | gzip -1 >"$place/iso/initrd"
cp "$place"/kernel/boot/vmlinuz-* "$place/iso/vmlinuz"
cp /usr/lib/ISOLINUX/isolinux.bin /usr/lib/syslinux/modules/bios/ldlinux.c32 "$place/iso/isolinux"
# Bochs reports sizes for xsavec and xsaves that do not add up, for which Linux would turn AVX off.
cat >"$place/iso/isolinux/isolinux.cfg" <<'CONFIG'
default talus
prompt 0
timeout 1
label talus
 kernel /vmlinuz
 initrd /initrd
 append console=ttyS0,115200 mitigations=off nokaslr tsc=reliable panic=-1 quiet noxsaves clearcpuid=xsavec,xsaves
CONFIG
xorriso -as mkisofs -quiet -o "$place/boot.iso" -b isolinux/isolinux.bin -c isolinux/boot.cat -no-emul-boot \
  -boot-load-size 4 -boot-info-table "$place/iso" 2>/dev/null

cat >"$place/bochsrc" <<CONFIG
config_interface: textconfig
display_library: term
cpu: model=corei7_skylake_x, count=1, ips=50000000, reset_on_triple_fault=0, ignore_bad_msrs=1
memory: guest=1024, host=1024
romimage: file=/usr/share/bochs/BIOS-bochs-latest
vgaromimage: file=/usr/share/bochs/VGABIOS-lgpl-latest
ata0: enabled=1, ioaddr1=0x1f0, ioaddr2=0x3f0, irq=14
ata0-master: type=cdrom, path=$place/boot.iso, status=inserted
boot: cdrom
com1: enabled=1, mode=file, dev=$place/output.txt
clock: sync=none
speaker: enabled=0
sound: waveoutdrv=dummy
log: $place/bochs.log
panic: action=fatal
CONFIG
printf 'c\nq\n' >"$place/debugger"  # Debian's Bochs stops in its debugger: continue, then quit
rm -f "$place/output.txt" "$place/screen" "$place/errors"
# Bochs draws on a terminal of its own, which somebody must read, or it waits once that is full.
(
  for _ in $(seq 60); do
    sleep 1
    terminal="$(grep -aoE '/dev/pts/[0-9]+' "$place/errors" 2>/dev/null | head -1)" || continue
    exec timeout "$limit_s" cat "$terminal" >/dev/null 2>&1
  done
) &
TERM=xterm timeout "$limit_s" script -qfec \
  "stty cols 100 rows 40; bochs -q -rc '$place/debugger' -f '$place/bochsrc' 2>'$place/errors'" "$place/screen" \
  </dev/null >/dev/null 2>&1 || true  # powering off is a panic to Bochs
wait
tr -d '\r' <"$place/output.txt" | grep -aE '^(==|All tests|test cases|assertions|as in|differs|.*FAILED|ALL)' || true
grep -qa 'ALL AS EXPECTED BY AVX-512' "$place/output.txt" || {
  echo "not everything passed; all output is in $place/output.txt" >&2
  exit 1
}
