# A module's text as wasm2wat prints it, with a global "counted" of the instructions that were executed: each straight run of
# them adds its length first.
function flush() {
  if (length(run)) printf "global.get $counted\ni64.const %d\ni64.add\nglobal.set $counted\n%s", count, run
  run = ""
  count = 0
}
/^  \(/ {
  flush()
  inside = /^  \(func/
  if (/^  \(export/ && !exported++) print "  (global $counted (mut i64) (i64.const 0)) (export \"counted\" (global $counted))"
}
!inside || /^ *\(/ { print; next }
{
  run = run $0 "\n"
  if ($1 !~ /^(block|loop|else|end)\)*$/) ++count
}
$1 ~ /^(loop|if|else|end|br|br_if|br_table|return|unreachable)\)*$/ { flush() }
END { flush() }
