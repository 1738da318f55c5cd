"""talus.h as data. Any line it cannot parse is an error that names the line."""

import re
from typing import NamedTuple


class Type(NamedTuple):
    base: str  # uint32_t, char, talus_client, ...
    pointees_const: tuple = ()  # for each *, the innermost first: whether what it points to is const
    length: int = 0  # of an array; 0: it is none


class Variable(NamedTuple):
    name: str
    type: Type
    doc: str = ""


class Constant(NamedTuple):
    name: str
    value: int
    doc: str


class Section(NamedTuple):
    doc: str


class Constants(NamedTuple):
    type: str  # int32_t, uint32_t or the alias that stands before it
    members: list[Constant]
    doc: str


class Macro(NamedTuple):
    name: str
    parameters: list[str]
    formula: str  # the same in C, C#, Python and Rust
    doc: str


class Alias(NamedTuple):
    name: str
    of: str


class Opaque(NamedTuple):
    name: str
    doc: str


class Struct(NamedTuple):
    name: str
    fields: list[Variable]
    doc: str


class Function(NamedTuple):
    name: str
    result: Type
    parameters: list[Variable]
    doc: str


COMMENT = r"/\*.*?\*/"
TYPE = r"(?:const )?\w+(?:\s*\*(?:\s*const\b)?)*"
IGNORED = re.compile(r'#(?:if|ifdef|ifndef|elif|else|endif|include)\b.*|#define (?:TALUS_H|TALUS_API .*)|extern "C" \{|\}')
DEFINE = re.compile(rf"#define (\w+) +(\d+)(?: +({COMMENT}))?")
MACRO = re.compile(rf"#define (\w+)\((\w+(?:, \w+)*)\) +\((.*)\)(?: +({COMMENT}))?")
ALIAS = re.compile(r"typedef (\w+) (\w+);")
OPAQUE = re.compile(r"typedef struct (\w+) \1;")
STRUCT = re.compile(r"typedef struct (\w+) \{(.*?)\} \1;", re.S)
ENUM = re.compile(r"enum \{(.*?)\};", re.S)
FUNCTION = re.compile(rf"TALUS_API\s+({TYPE})\s*(\w+)\(([^)]*)\);")


def plain(*comments):
    """The text of comments, without their frame."""
    lines = [re.sub(r"^ *\*? ?", "", line) for comment in comments if comment for line in comment.strip()[2:-2].strip().splitlines()]
    return "\n".join(line.rstrip() for line in lines).strip()


def type_of(text, length=0):
    words = re.findall(r"\w+|\*", text)
    const = words[0] == "const"
    base, *rest = words[const:]
    pointees = []
    for word in rest:
        if word == "*":
            pointees.append(const)
        const = word == "const"
    return Type(base, tuple(pointees), length)


def variables(text, doc=""):
    """Those of one declaration: "int64_t x, y", "const char* host", "uint16_t ring_radius[6]"."""
    found = re.fullmatch(rf"({TYPE})\s*(\w+(?:, \w+)*)(?:\[(\d+)\])?", text)
    if not found:
        raise ValueError(f"'{text}' is no declaration such as 'uint32_t a, b', 'const char* c' or 'float d[6]'")
    names = found[2].split(", ")
    return [Variable(name, type_of(found[1], int(found[3] or 0)), "" if i else doc) for i, name in enumerate(names)]


def members(body, separator):
    """Code and comment of each, the comment before it or beside it. Headings of several, which end in a colon, are left out."""
    pattern = rf"((?:\s*{COMMENT})*)\s*([^/{separator}]+){separator}?(?: *({COMMENT}))?"
    for found in re.finditer(pattern, body, re.S):
        if code := " ".join(found[2].split()):
            before = [each for each in re.findall(COMMENT, found[1], re.S) if not each.endswith(": */")]
            yield code, plain(*before, found[3])


def enumerators(body):
    for code, doc in members(body, ","):
        found = re.fullmatch(r"(\w+) = (-?\d+)", code)
        if not found:
            raise ValueError(f"'{code}' is no enumerator such as 'TALUS_OK = 0'")
        yield Constant(found[1], int(found[2]), doc)


def declaration(text, position, doc, before):
    """What stands there, and where it ends."""
    if found := DEFINE.match(text, position):
        return Constants("uint32_t", [Constant(found[1], int(found[2]), plain(found[3]))], doc), found.end()
    if found := MACRO.match(text, position):
        formula = re.sub(r"(?<=\w)\*(?=\w)", " * ", re.sub(r"\((\w+)\)", r"\1", found[3]))
        return Macro(found[1], found[2].split(", "), formula, plain(found[4])), found.end()
    if found := ENUM.match(text, position):
        constants = list(enumerators(found[1]))
        signed = "int32_t" if min(constant.value for constant in constants) < 0 else "uint32_t"
        return Constants(before.name if isinstance(before, Alias) else signed, constants, doc), found.end()
    if found := OPAQUE.match(text, position):
        return Opaque(found[1], doc), found.end()
    if found := STRUCT.match(text, position):
        fields = [field for code, field_doc in members(found[2], ";") for field in variables(code, field_doc)]
        return Struct(found[1], fields, doc), found.end()
    if found := ALIAS.match(text, position):
        return Alias(found[2], found[1]), found.end()
    if found := FUNCTION.match(text, position):
        parameters = [] if found[3] == "void" else " ".join(found[3].split()).split(", ")
        declared = [variables(parameter)[0] for parameter in parameters]
        # An array that is a parameter is a pointer.
        declared = [Variable(each.name, Type(each.type.base, (parameter.startswith("const "),)) if each.type.length else each.type)
                    for each, parameter in zip(declared, parameters)]
        return Function(found[2], type_of(found[1]), declared, doc), found.end()
    raise ValueError(f"'{text[position:].splitlines()[0]}' is no constant, macro, enum, typedef, struct or function of TALUS_API")


def read(text):
    """Its declarations in their order. The first is a Section with the comment at its head."""
    items = []
    doc, position = "", 0
    while rest := re.compile(r"\s*").match(text, position):
        position = rest.end()
        if position == len(text):
            return items
        if comment := re.compile(COMMENT, re.S).match(text, position):
            position, doc = comment.end(), plain(comment[0])
            if not items or text.startswith("\n\n", position):
                items.append(Section(doc))
                doc = ""
            continue
        if ignored := IGNORED.match(text, position):
            position, doc = ignored.end(), ""
            continue
        try:
            item, position = declaration(text, position, doc, items[-1] if items else None)
        except ValueError as error:
            raise SystemExit(f"talus.h:{text.count(chr(10), 0, position) + 1}: {error}") from None
        items.append(item)
        doc = ""
