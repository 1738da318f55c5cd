# Reads docs/modules.txt, the paths of all headers and sources, and every #include line (grep -n's FILE:LINE:TEXT), and
# prints what breaks the table. MODE=table prints the table as Markdown, MODE=found what the includes need.
# Files, in this order: docs/modules.txt, the list of paths, the includes.
function fail(text) { if (MODE == "check") print text; failed = 1 }

# The module of a path: the longest listed folder that holds it.
function module_of(path,   folder) {
  if (path in owner) return owner[path]
  folder = path
  while (sub(/\/[^\/]*$/, "", folder)) if (folder in known) return owner[path] = folder
  return owner[path] = ""
}

# The file that an include names, or "" where it is none of ours. Quoted names are looked for where the compiler looks:
# beside the file, in its own module, in the modules that it may include, and, to name the wrong one, in all others.
function file_of(from, name, quoted,   folder, module, list, n, i) {
  if (quoted) {
    folder = from
    sub(/\/[^\/]*$/, "", folder)
    module = module_of(from)
    n = split(module " " allowed_list[module], list, " ")
    if ((folder "/" name) in exists) return folder "/" name
    if (from ~ /^server\// && ("server/" name) in exists) return "server/" name
    if (from ~ /^client_sample\// && ("client_sample/" name) in exists) return "client_sample/" name
    for (i = 1; i <= n; ++i) {
      if ((list[i] "/" name) in exists) return list[i] "/" name
      if ((list[i] "/src/" name) in exists) return list[i] "/src/" name
    }
    for (i = 1; i <= modules; ++i) {
      if ((by_number[i] "/" name) in exists) return by_number[i] "/" name
      if ((by_number[i] "/src/" name) in exists) return by_number[i] "/src/" name
    }
  }
  if (name in exported) return exported[name]
  if (quoted || name ~ /^talus\//) {
    if (name !~ /^talus\/(protocol\/talus_generated|(build_)?version)\.h$/) fail(from ": " name " is no header of a module")
  }
  return ""
}

# Looks for a way from module back to itself.
function visit(module, way,   next_one, list, n, i) {
  if (state[module] == 2) return
  if (state[module] == 1) { fail("docs/modules.txt: a cycle:" substr(way, 4) " -> " module); return }
  state[module] = 1
  n = split(allowed_list[module], list, " ")
  for (i = 1; i <= n; ++i) visit(list[i], way " -> " module)
  state[module] = 2
}

BEGIN {
  impure = "^(thread|mutex|shared_mutex|condition_variable|future|atomic|chrono|ctime|time[.]h|fstream|cstdio|iostream|filesystem|random|unistd[.]h|png[.]h|asio.*|spdlog.*|sys/.*)$"
}
FNR == 1 { ++part }

part == 1 {
  if ($0 ~ /^#/ || $0 ~ /^ *$/) next
  if (split($0, field, "|") != 3) { fail("docs/modules.txt:" FNR ": not 'module | modules | job'"); next }
  split(field[1], word, " ")
  module = word[1]
  if (module in known) fail("docs/modules.txt:" FNR ": " module " a second time")
  known[module] = ++modules
  by_number[modules] = module
  above = module
  if (sub(/\/[^\/]*$/, "", above)) parent[above] = 1
  pure[module] = word[2] == "pure"
  gsub(/^ +| +$/, "", field[2]); gsub(/^ +| +$/, "", field[3])
  allowed_list[module] = field[2]
  job[module] = field[3]
  next
}

part == 2 {
  exists[$0] = 1
  if (match($0, /\/include\/talus\//)) exported[substr($0, RSTART + 9)] = $0
  module = module_of($0)
  folder[module] = 1
  # Folders below a module's are free, unless modules stand there: then each is a module of its own.
  rest = substr($0, length(module) + 2)
  if (module == "" || (module in parent && rest ~ /\// && rest !~ /^(include|src)\//)) {
    fail($0 ": its folder is no module of docs/modules.txt")
  }
  next
}

part == 3 {
  match($0, /^[^:]*:[0-9]*:/)
  place = substr($0, 1, RLENGTH - 1)
  text = substr($0, RLENGTH + 1)
  from = place
  sub(/:[0-9]*$/, "", from)
  if (!match(text, /[<"][^>"]*[>"]/)) next
  name = substr(text, RSTART + 1, RLENGTH - 2)
  quoted = substr(text, RSTART, 1) == "\""
  module = module_of(from)
  if (module == "") next
  if (name ~ /^\.\.\/|\/\.\.\//) fail(place ": includes name modules, not paths: " name)
  if (pure[module] && name ~ impure) fail(place ": " module " is pure, and <" name "> is not")
  target = file_of(from, name, quoted)
  if (target == "") next
  other = module_of(target)
  if (other == module || other == "") next
  needs[module, other] = place
  # Modules with a folder include/ keep their other headers to themselves.
  if (target ~ /\/src\//) fail(place ": " target " is private to " other)
  if (!((" " allowed_list[module] " ") ~ (" " other " ")) && !((module, other) in told)) {
    told[module, other] = 1
    fail(place ": " module " may not include " other " (docs/modules.txt)")
  }
}

END {
  for (i = 1; i <= modules; ++i) {
    module = by_number[i]
    if (!(module in folder)) fail("docs/modules.txt: " module " has no source")
    n = split(allowed_list[module], list, " ")
    for (j = 1; j <= n; ++j) {
      if (!(list[j] in known)) { fail("docs/modules.txt: " module " names " list[j] ", which is no module"); continue }
      if (!((module, list[j]) in needs)) fail("docs/modules.txt: " module " includes nothing of " list[j])
    }
  }
  for (i = 1; i <= modules; ++i) visit(by_number[i], "")
  if (MODE == "table") {
    print "| module | may include | job |\n| --- | --- | --- |"
    for (i = 1; i <= modules; ++i) {
      module = by_number[i]
      list_text = allowed_list[module]
      gsub(/[^ ]+/, "`&`", list_text)
      gsub(/ /, ", ", list_text)
      printf "| `%s`%s | %s | %s |\n", module, pure[module] ? ", pure" : "", list_text, job[module]
    }
    exit 0
  }
  if (MODE == "found") {
    for (i = 1; i <= modules; ++i) {
      line = ""
      for (j = 1; j <= modules; ++j) if ((by_number[i], by_number[j]) in needs) line = line " " by_number[j]
      printf "%s |%s | %s\n", by_number[i] (pure[by_number[i]] ? " pure" : ""), line, job[by_number[i]]
    }
    exit 0
  }
  exit failed
}
