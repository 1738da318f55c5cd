"""Checks the documents: relative links and #anchors resolve; documents and "sections" that code names exist; lines
outside tables and code blocks have at most 120 characters. Prints the faults, and exits with 1 if there are any."""

import argparse
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CODE = set(".c .cpp .h .in .js .mjs .ts .py .sh .cmake .txt .toml .yml .yaml .conf".split())
MAX_LINE = 120


def tracked() -> list[str]:
    if not (ROOT / ".git").exists():  # an unpacked archive
        paths = (path for path in ROOT.rglob("*") if path.is_file() and not {"build", "node_modules"} & {*path.parts})
        return [path.relative_to(ROOT).as_posix() for path in paths]
    listed = subprocess.check_output(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, text=True)
    return [name for name in listed.splitlines() if (ROOT / name).is_file()]


def headings(text: str) -> list[str]:
    return [re.sub(r"\[([^]]*)\]\([^)]*\)|[`*]", r"\1", line) for line in re.findall(r"(?m)^#+ +(.*?) *$", text)]


def anchors(text: str) -> set[str]:
    """The anchors that GitHub makes: a heading that is repeated gets -1, -2 and so on."""
    names = [re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings(text)]
    return {name + f"-{names[:i].count(name)}" * (name in names[:i]) for i, name in enumerate(names)}


def faults(files: list[str]) -> list[str]:
    found = []
    texts = {name: re.sub(r"(?ms)^ *(```|~~~).*?^ *\1$", lambda code: "\n" * code[0].count("\n"),
                          (ROOT / name).read_text()) for name in files if name.endswith(".md")}
    for name, text in texts.items():
        for number, line in enumerate(text.splitlines(), 1):
            if len(line) > MAX_LINE and not line.startswith(("|", "    ")):
                found.append(f"{name}:{number}: {len(line)} characters, at most {MAX_LINE}")
        for link in re.findall(r"\[[^]]*\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", text)):
            path, _, anchor = link.partition("#")
            target = ((ROOT / name).parent / path if path else ROOT / name).resolve()
            inside = target.relative_to(ROOT).as_posix() if target.is_relative_to(ROOT) and target.exists() else None
            if not re.match(r"\w+:", link) and (not inside or anchor and anchor not in anchors(texts.get(inside, ""))):
                found.append(f"{name}: the link {link} does not resolve")
    sections = {name: {*headings(text), *re.findall(r"\*\*([^*]+?)\.?\*\*", text)} for name, text in texts.items()}
    for name in (name for name in files if pathlib.Path(name).suffix in CODE):
        text = re.sub(r"\n\s*(?:///?|#|\*)\s*", " ", (ROOT / name).read_text(errors="replace"))
        for path, section in re.findall(r"([\w./-]*\w\.md)\b(?:,? \"([^\"]+)\")?", text):
            named = [each for each in texts if f"/{each}".endswith("/" + path.lstrip("./"))]
            if not any(not section or section in sections[each] for each in named):
                found.append(f"{name}: no document has {path}" + f', "{section}"' * bool(section))
    return found


if __name__ == "__main__":
    argparse.ArgumentParser(description=__doc__).parse_args()
    sys.exit("\n".join(faults(tracked())) or 0)
