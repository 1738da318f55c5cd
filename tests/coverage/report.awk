# Reads docs/modules.txt and gcov's annotated sources, and prints the lines not reached: first a table of modules, then
# each file's ranges. A line that any compilation reached is reached.
function module_of(path,   folder) {
  folder = path
  while (sub(/\/[^\/]*$/, "", folder)) if (folder in known) return folder
  return ""
}

# The lines of a file that were never reached, as "12, 15-18". Lines without code do not split a range.
function ranges(file,   line, first, last, text, open) {
  for (line = 1; line <= length_of[file]; ++line) {
    if (!((file, line) in hits)) continue
    if (hits[file, line] == 0) {
      if (!open) first = line
      last = line
      open = 1
    } else if (open) {
      text = text (text == "" ? "" : ", ") (first == last ? first : first "-" last)
      open = 0
    }
  }
  if (open) text = text (text == "" ? "" : ", ") (first == last ? first : first "-" last)
  return text
}

FNR == 1 { ++part }
part == 1 {
  if ($0 ~ /^#/ || $0 ~ /^ *$/) next
  split($1, word, " ")
  known[word[1]] = 1
  by_number[++modules] = word[1]
  next
}
/^ *-: *0:Source:/ {
  file = $0
  sub(/^ *-: *0:Source:/, "", file)
  module = module_of(file)
  if (module != "" && !(file in seen)) {
    seen[file] = module
    files[++count] = file
  }
  next
}
module == "" { next }
# "  12*:  34:code": a count and a line. "-" is no code, "#####" and "=====" were not reached.
match($0, /^ *[-#=0-9*]+: *[0-9]+:/) {
  split($0, field, ":")
  gsub(/[ *]/, "", field[1])
  line = field[2] + 0
  if (field[1] == "-" || line == 0) next
  reached = field[1] !~ /^[#=]/
  if (!((file, line) in hits)) hits[file, line] = 0
  if (reached) hits[file, line] = 1
  if (line > length_of[file]) length_of[file] = line
}

END {
  for (i = 1; i <= count; ++i) {
    for (line = 1; line <= length_of[files[i]]; ++line) {
      if (!((files[i], line) in hits)) continue
      ++lines[seen[files[i]]]
      reached_of[seen[files[i]]] += hits[files[i], line]
    }
  }
  printf "%-28s %7s %8s %8s\n", "module", "lines", "reached", "%"
  for (i = 1; i <= modules; ++i) {
    module = by_number[i]
    if (!lines[module]) continue
    printf "%-28s %7d %8d %8.1f\n", module, lines[module], reached_of[module], 100 * reached_of[module] / lines[module]
    all += lines[module]
    all_reached += reached_of[module]
  }
  if (!all) { print "no module's line was compiled for coverage"; exit 1 }
  printf "%-28s %7d %8d %8.1f\n\nlines not reached:\n", "all", all, all_reached, 100 * all_reached / all
  for (i = 1; i <= modules; ++i) {
    for (j = 1; j <= count; ++j) {
      if (seen[files[j]] != by_number[i]) continue
      text = ranges(files[j])
      if (text != "") print files[j] ": " text
    }
  }
}
