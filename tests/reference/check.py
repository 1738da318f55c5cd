"""Compares server/talusd.toml and the tables of docs/REFERENCE.md and docs/OPERATIONS.md with what the code has;
--write writes them.

    python3 -B tests/reference/check.py [--write] [TALUS-REFERENCE TALUSD]

The programs are those of build/release unless given. Settings and metrics come from talus-reference, flags from --help
of talusd, alerts from docker/alerts.yml, with a comment that begins with "Do: " as the runbook.
"""

import pathlib
import re
import subprocess
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOML = ROOT / "server/talusd.toml"
OPERATIONS = ROOT / "docs/OPERATIONS.md"
REFERENCE = ROOT / "docs/REFERENCE.md"
STORE = ("stat verify backup restore compact export import rebase rename join-cluster leave-cluster fork history"
         " rollback").split()
COMMANDS = ["", "token", "top", "pregen", "cluster init", "cluster check", "cluster status"]
COMMANDS += [f"store {name}" for name in STORE]
COMMON = {"--help", "--version", "--config", "--data"}  # of the commands of talusd


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def cell(text):
    return " ".join(text.split()).replace("|", "\\|")


def row(*cells):
    return f"| {' | '.join(cell(text) for text in cells)} |".replace("|  |", "| |")


def wrapped(text):
    return textwrap.fill(text, 120, subsequent_indent="  " if text.startswith("- ") else "",
                         break_long_words=False, break_on_hyphens=False)


def options(text):
    """(flag, meaning) of each option and positional in the output of --help."""
    found = []
    for line in text.splitlines():
        line = re.sub(r" Excludes:( --[a-z-]+)+ *", "  ", line)
        option = re.match(r"^ {2,4}(-\S.*?|[A-Z]+ TEXT.*?)(?: {2,}(\S.*))?$", line)
        if option:
            found.append([option[1], option[2] or ""])
        elif re.match(r"^ {20,}\S", line) and found:
            found[-1][1] += " " + line.strip()
        elif line and not line.startswith("  "):
            if found and not line.startswith(("Options", "[Option", "Positionals")):
                break
    return found


def flags(talusd):
    """A row for each flag; commands whose flags agree share it."""
    commands = {}
    for command in COMMANDS:
        for flag, meaning in options(output(talusd, *command.split(), "--help")):
            name = re.search(r"--[a-z-]+|^[A-Z]+", flag)[0]
            if command and name in COMMON or name == "--help":
                continue
            meaning = re.sub(r"^.*\((TALUS_[A-Z_]+)\)$", r"as `\1`", meaning)
            flag = re.sub(r"^-\w,|(?<=\w) (TEXT|REQUIRED)|:[A-Z]+ in \[[^]]*\]", "", flag).strip()
            commands.setdefault((flag, meaning), []).append(f"`{command or 'talusd'}`")
    rows = [row(", ".join(names), f"`{flag}`", meaning) for (flag, meaning), names in commands.items()]
    return "\n".join(["| command | flag | meaning |", "| --- | --- | --- |"] + rows)


def cells(line):
    """The cells of a row, none of other lines."""
    return re.split(r"(?<!\\) \| ", line[2:-2]) if line.startswith("| ") else []


def settings(text):
    """The tables without their column "reload", below a list of the settings that need no restart."""
    lines, reload, section = [], {}, ""
    for line in text.strip("\n").splitlines():
        if line.startswith("### "):
            section = line[4:]
        if values := cells(line):
            when = values.pop(3)
            line = f"| {' | '.join(values)} |"
            if values[0].startswith("`"):
                reload.setdefault(section, {})[f"`{section}.{values[0].strip('`')}`"] = when
        lines.append(line)
    lists = []
    for when, words in {"at once": "At once", "new sessions": "For new sessions and connections"}.items():
        keys = []
        for section, of in reload.items():
            names, others = [key for key in of if of[key] == when], [key for key in of if of[key] != when]
            keys += [" except ".join([f"`{section}.*`"] + others)] if len(names) > len(others) else names
        lists.append(wrapped(f"- {words}: {', '.join(keys)}."))
    return "\n".join(lists + ["- After a restart: all others.", ""] + lines)


def metrics(text):
    """A list of the metrics, below a sentence that has their types."""
    rows = [cells(line) for line in text.splitlines() if line.startswith("| `")]
    histograms = ", ".join(re.sub("{.*}", "", name) for name, kind, _ in rows if kind == "histogram")
    types = f"A name that ends in `_total` is a counter. Histograms are {histograms}. All others are gauges."
    return "\n".join([wrapped(types), ""] + [wrapped(f"- {name}: {meaning}") for name, _, meaning in rows])


def alerts():
    rows, pages = ["| alert | meaning | do |", "| --- | --- | --- |"], []
    text = (ROOT / "docker/alerts.yml").read_text()
    for rule in re.split(r"(?m)^ +- alert: ", text)[1:]:
        name = "`" + rule.split("\n", 1)[0] + "`"
        comments = " ".join(re.findall(r"(?m)^ +# (.*)$", rule.split("annotations:")[0]))
        runbook = comments.removeprefix("Do: ") if comments.startswith("Do: ") else ""
        if re.search(r"severity: (\w+)", rule)[1] == "page":
            pages.append(name)
        meaning = re.search(r"(?m)^ +description: (.*)$", rule)[1]
        rows.append(row(name, meaning, runbook[:1].upper() + runbook[1:]))
    return "\n".join([wrapped(f"The severity is `page` for {', '.join(pages)}, else `ticket`."), ""] + rows)


def with_tables(text, tables):
    """The document with each table or list between its marks."""
    for name, table in tables.items():
        first = f"<!-- {name}: written by tests/reference/check.py --write -->\n"
        last = f"<!-- end of {name} -->\n"
        begin, end = text.index(first) + len(first), text.index(last)
        text = text[:begin] + "\n" + table.strip("\n") + "\n\n" + text[end:]
    return text


def main(arguments):
    write = "--write" in arguments
    programs = [argument for argument in arguments if argument != "--write"]
    build = ROOT / "build/release"
    reference, talusd = programs or [build / "tests/reference/talus-reference", build / "server/talusd"]
    made = {
        TOML: output(reference, "toml"),
        REFERENCE: with_tables(REFERENCE.read_text(), {
            "settings": settings(output(reference, "settings")),
            "flags": flags(talusd),
            "metrics": metrics(output(reference, "metrics")),
            "alerts": alerts(),
        }),
        OPERATIONS: with_tables(OPERATIONS.read_text(), {"pools": output(reference, "pools")}),
    }
    stale = [file for file, text in made.items() if file.read_text() != text]
    for file in stale:
        if write:
            file.write_text(made[file])
        else:
            print(f"{file.relative_to(ROOT)} is not what the tables have: python3 -B tests/reference/check.py --write")
    return 1 if stale and not write else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
