#!/usr/bin/env python3
"""layout.py LANGUAGE: a program in this language that prints the size of every struct of talus.h, the offset of every field and
the value of every constant, one a line. All languages must print the same."""

import pathlib
import sys

BINDINGS = pathlib.Path(__file__).resolve().parents[2] / "client_sample/c_api/bindings"
sys.path.insert(0, str(BINDINGS))
from talus_header import Constants, Struct, read  # noqa: E402
from make import csharp_names, rust_name  # noqa: E402

# A program around the lines; a line; what gives a struct's size, a field's offset and a constant.
LANGUAGES = {
    "c": ("#include <stddef.h>\n#include <stdio.h>\n#include <talus.h>\nint main(void) {{\n{0}return 0;\n}}\n",
          'printf("{0} %lld\\n", (long long)({1}));\n', "sizeof({0})", "offsetof({0}, {1})", "{0}"),
    "python": ("import ctypes\nimport talus_ctypes as c\n{0}", 'print("{0}", {1})\n', "ctypes.sizeof(c.{0})", "c.{0}.{1}.offset", "c.{0}"),
    "lua": ('local ffi = require("ffi")\nffi.cdef(io.open(arg[1]):read("*a"))\n{0}', 'print("{0} " .. {1})\n',
            'ffi.sizeof("{0}")', 'ffi.offsetof("{0}", "{1}")', "ffi.C.{0}"),
    "cffi": ('import cffi\nimport sys\nffi = cffi.FFI()\nffi.cdef(open(sys.argv[1]).read())\nlibrary = ffi.dlopen(None)\n{0}',
             'print("{0}", {1})\n', 'ffi.sizeof("{0}")', 'ffi.offsetof("{0}", "{1}")', "library.{0}"),
    # C#'s sizeof() takes blittable structs only.
    "csharp": ("using System;\nusing System.Runtime.InteropServices;\nstatic class Layout {{ static unsafe void Main() {{\n{0}}} }}\n",
               'Console.WriteLine("{0} {{0}}", {1});\n', "sizeof(Talus.{0})",
               'Marshal.OffsetOf(typeof(Talus.{0}), "{1}")', "Talus.{0}"),
    "rust": ("use talus::raw::*;\nfn main() {{\n{0}}}\n", 'println!("{0} {{}}", {1});\n', "std::mem::size_of::<{0}>()",
             "{{ let it = {0}::default(); std::ptr::addr_of!(it.{1}) as usize - std::ptr::addr_of!(it) as usize }}", "{0}"),
}


def program(language):
    whole, line, size, offset, constant = LANGUAGES[language]
    lines = []
    for item in read((BINDINGS.parent / "include/talus.h").read_text()):
        if isinstance(item, Struct):
            lines.append(line.format(item.name, size.format(item.name)))
            for field in item.fields:
                name = {"rust": rust_name(field.name), "csharp": csharp_names(field)[0]}.get(language, field.name)
                lines.append(line.format(f"{item.name}.{field.name}", offset.format(item.name, name)))
        if isinstance(item, Constants):
            lines += [line.format(each.name, constant.format(each.name)) for each in item.members]
    return whole.format("".join(lines))


if __name__ == "__main__":
    if sys.argv[1:] not in [[language] for language in LANGUAGES]:
        sys.exit(f"layout.py takes one language of {', '.join(LANGUAGES)}")
    print(program(sys.argv[1]), end="")
