#!/usr/bin/env python3
"""Makes the bindings of talus.h: talus.cdef.h (LuaJIT, cffi), talus_ctypes.py, Talus.cs, and the crate's talus.rs."""

import argparse
import html
import pathlib
import re
import sys

from talus_header import Alias, COMMENT, Constants, Function, IGNORED, MACRO, Macro, Opaque, Section, Struct, read

HERE = pathlib.Path(__file__).resolve().parent
HEADER = HERE.parent / "include/talus.h"
MADE = "Made from talus.h by client_sample/c_api/bindings/make.py"


def comment(doc, mark, indent=""):
    return "".join(f"{indent}{mark} {line}".rstrip() + "\n" for line in doc.splitlines())


# ---- LuaJIT, cffi: the header itself, as both parse it ----


def cdef(text, items):
    macros = iter([item for item in items if isinstance(item, Macro)])
    text = MACRO.sub(lambda _: "/* {0.name}({1}) is {0.formula}: {0.doc} */".format(each := next(macros), ", ".join(each.parameters)), text)
    text = re.sub(rf"#define (\w+) +(\d+)(?: +({COMMENT}))?", lambda it: f"enum {{ {it[1]} = {it[2]} }};" + f" {it[3]}" * bool(it[3]), text)
    text = re.sub(rf"(?m)^(?:{IGNORED.pattern})\n", "", text).replace("TALUS_API ", "")
    return f"/* {MADE}. */\n/* clang-format off */\n" + re.sub(r"\n{3,}", "\n\n", text.rstrip() + "\n")


# ---- Python ----

PYTHON_HEAD = '''"""libtalus by ctypes: load() has its functions. {made}."""

import ctypes
import os
import sys

{about}

class Sized(ctypes.Structure):
    """Sets its own size; the other fields are 0."""

    def __init__(self, **fields):
        super().__init__(size=ctypes.sizeof(type(self)), **fields)
'''
PYTHON_FOOT = '''
def load(path=None):
    """The library at the path; otherwise beside this file or the program, or where the system finds it."""
    beside, name = ("talus.dll", "talus.dll") if sys.platform == "win32" else ("libtalus.so", "libtalus.so.1")
    # Absolute: otherwise Windows does not search a DLL's folder for what it needs.
    program = getattr(sys.modules["__main__"], "__file__", None) or __file__
    folders = [os.path.dirname(os.path.abspath(each)) for each in (__file__, program)]
    paths = [each for each in (os.path.join(folder, beside) for folder in folders) if os.path.exists(each)]
    library = ctypes.CDLL(path or (paths + [name])[0])
    for name, result, *parameters in FUNCTIONS:
        function = getattr(library, name)
        function.restype, function.argtypes = result, parameters
    return library
'''


def ctypes_type(type_, structs):
    plain = {"float": "c_float", "char": "c_char", "size_t": "c_size_t", "talus_status": "c_int32"}
    base = type_.base if type_.base in structs else f"ctypes.{plain.get(type_.base, f'c_{type_.base[:-2]}')}"
    if type_.base == "void":
        return "None"
    stars = len(type_.pointees_const)
    if base == "ctypes.c_char" and stars:
        base, stars = "ctypes.c_char_p", stars - 1
    if type_.base in structs and not structs[type_.base]:
        base, stars = "ctypes.c_void_p", stars - 1
    base = "ctypes.POINTER(" * stars + base + ")" * stars
    return f"{base} * {type_.length}" if type_.length else base


def python(_text, items):
    structs = {item.name: isinstance(item, Struct) for item in items if isinstance(item, (Struct, Opaque))}
    out, functions = [PYTHON_HEAD.format(made=MADE, about=comment(items[0].doc, "#"))], ["\nFUNCTIONS = [\n"]
    for item in items[1:]:
        if isinstance(item, Section):
            functions.append(comment(item.doc, "#", "    "))
        if isinstance(item, Constants):
            out.append("\n" * bool(item.doc or len(item.members) > 1) + comment(item.doc, "#"))
            out += [comment(each.doc, "#") + f"{each.name} = {each.value}\n" for each in item.members]
        if isinstance(item, Macro):
            out.append(f'\n\ndef {item.name}({", ".join(item.parameters)}):\n    """{item.doc}"""\n    return {item.formula}\n\n\n')
        if isinstance(item, Struct):
            out.append(f"\n\nclass {item.name}(Sized):\n" + (f'    """{item.doc}"""\n\n' if item.doc else "") + "    _fields_ = [\n")
            for field in item.fields:
                out.append(comment(field.doc, "#", "        ") + f'        ("{field.name}", {ctypes_type(field.type, structs)}),\n')
            out.append("    ]\n\n")
        if isinstance(item, Function):
            types = [ctypes_type(type_, structs) for type_ in (item.result, *(each.type for each in item.parameters))]
            functions.append(comment(item.doc, "#", "    ") + f'    ("{item.name}", {", ".join(types)}),\n')
    return "".join([*out, *functions, "]\n\n", PYTHON_FOOT])


# ---- Rust ----

RUST_TYPES = {
    "uint8_t": "u8", "uint16_t": "u16", "uint32_t": "u32", "uint64_t": "u64", "int32_t": "i32", "int64_t": "i64",
    "float": "f32", "size_t": "usize", "char": "c_char",
}
RUST_HEAD = """// {made}.
#![allow(non_camel_case_types, non_snake_case)]

use std::os::raw::c_char;

{about}"""
RUST_STRUCT = """
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct {name} {{
{fields}}}

impl Default for {name} {{
    /// Its size; the other fields are 0.
    fn default() -> Self {{
        // Numbers and pointers may all be 0.
        Self {{ size: std::mem::size_of::<Self>() as u32, ..unsafe {{ std::mem::zeroed() }} }}
    }}
}}
"""


def rust_type(type_):
    base = RUST_TYPES.get(type_.base, type_.base)
    for const in type_.pointees_const:
        base = ("*const " if const else "*mut ") + base
    return f"[{base}; {type_.length}]" if type_.length else base


def rust_name(name):
    return {"type": "type_"}.get(name, name)


def rust(_text, items):
    out, functions = [RUST_HEAD.format(made=MADE, about=comment(items[0].doc, "//"))], ['\n#[link(name = "talus")]\nextern "C" {\n']
    for item in items[1:]:
        if isinstance(item, Section):
            functions.append("\n" + comment(item.doc, "//", "    "))
        if isinstance(item, Alias):
            out.append(f"\npub type {item.name} = {RUST_TYPES[item.of]};\n")
        if isinstance(item, Constants):
            out.append("\n" * bool(item.doc or len(item.members) > 1) + comment(item.doc, "//"))
            type_ = RUST_TYPES.get(item.type, item.type)
            out += [comment(each.doc, "///") + f"pub const {each.name}: {type_} = {each.value};\n" for each in item.members]
        if isinstance(item, Macro):
            parameters = ", ".join(f"{name}: usize" for name in item.parameters)
            out.append(comment(item.doc, "///") + f"pub const fn {item.name}({parameters}) -> usize {{\n    {item.formula}\n}}\n")
        if isinstance(item, Opaque):
            out.append("\n" + comment(item.doc, "///") + f"#[repr(C)]\npub struct {item.name} {{\n    _opaque: [u8; 0],\n}}\n")
        if isinstance(item, Struct):
            fields = [comment(each.doc, "///", "    ") + f"    pub {rust_name(each.name)}: {rust_type(each.type)},\n" for each in item.fields]
            out.append(RUST_STRUCT.format(name=item.name, fields="".join(fields)).replace("\n", "\n" + comment(item.doc, "///"), 1))
        if isinstance(item, Function):
            parameters = ", ".join(f"{rust_name(each.name)}: {rust_type(each.type)}" for each in item.parameters)
            result = "" if item.result.base == "void" else f" -> {rust_type(item.result)}"
            functions.append(comment(item.doc, "///", "    ") + f"    pub fn {item.name}({parameters}){result};\n")
    return "".join([*out, *functions, "}\n"])


# ---- C# ----

CSHARP_TYPES = {
    "uint8_t": "byte", "uint16_t": "ushort", "uint32_t": "uint", "uint64_t": "ulong", "int32_t": "int", "int64_t": "long",
    "float": "float", "size_t": "UIntPtr", "talus_status": "int", "void": "void",
}
CSHARP_HEAD = """// {made}.
using System;
using System.Runtime.InteropServices;
using System.Text;

{about}
public static class Talus
{{
    private const string Library = "talus";

    /// <summary>A string of the library; null if there is none.</summary>
    public static string Text(IntPtr text)
    {{
        if (text == IntPtr.Zero) return null;
        int length = 0;
        while (Marshal.ReadByte(text, length) != 0) ++length;
        var bytes = new byte[length];
        Marshal.Copy(text, bytes, 0, length);
        return Encoding.UTF8.GetString(bytes);
    }}

    /// <summary>A string for the library, to be freed by Marshal.FreeHGlobal().</summary>
    public static IntPtr Allocate(string text)
    {{
        byte[] bytes = Encoding.UTF8.GetBytes(text + "\\0");
        IntPtr copy = Marshal.AllocHGlobal(bytes.Length);
        Marshal.Copy(bytes, 0, copy, bytes.Length);
        return copy;
    }}
"""


# By the first constant: the enum's name, what its members' names leave out, and what it is.
CSHARP_ENUMS = {
    "TALUS_OK": ("TalusStatus", "TALUS_", "TALUS_OK and so on; errors are below 0."),
    "TALUS_TLS": ("TalusConnectFlags", "TALUS_", "Flags of a connection."),
    "TALUS_GAS": ("TalusPhase", "TALUS_", "Phase of a material."),
    "TALUS_EVENT_JOINED": ("TalusEventType", "TALUS_EVENT_", "TALUS_EVENT_JOINED and so on. New minor versions may add types: ignore unknown ones."),
}


def csharp_enum(constants, name, prefix, doc):
    flags = name.endswith("Flags")
    lines = [f"\n{summary(doc, '')}" + "[Flags]\n" * flags + f"public enum {name}\n{{\n" + "    None = 0,\n" * flags]
    for each in constants.members:
        member = "".join(word.capitalize() for word in each.name[len(prefix):].split("_"))
        lines.append(summary(each.doc, "    ") + f"    {member} = {each.value},\n")
    return "".join([*lines, "}\n"])


def summary(doc, indent):
    text = html.escape(doc, quote=False)
    return comment(f"<summary>{text}</summary>", "///", indent) if doc else ""


def csharp_names(field):
    """An array is a field for each element: the struct stays blittable, so that calls copy nothing."""
    return [f"{field.name}_{i + 1}" for i in range(field.type.length)] or [field.name]


def csharp_field(field):
    return f"public {'IntPtr' if field.type.pointees_const else CSHARP_TYPES[field.type.base]} {', '.join(csharp_names(field))};"


def csharp_parameter(parameter, following, structs):
    type_, name = parameter.type, {"event": "@event"}.get(parameter.name, parameter.name)
    stars = len(type_.pointees_const)
    if not stars:
        return f"{CSHARP_TYPES[type_.base]} {name}"
    if type_.base in structs:
        return f"ref {type_.base} {name}"
    if type_.base not in CSHARP_TYPES:  # opaque, or text
        return f"IntPtr {name}" if stars == 1 else f"IntPtr[] {name}" if type_.pointees_const[1] else f"out IntPtr {name}"
    if type_.pointees_const[0]:
        return f"{CSHARP_TYPES[type_.base]}[] {name}"
    # As many as the next one says, or one.
    array = following is not None and following.type.base == "size_t"
    return f"[Out] {CSHARP_TYPES[type_.base]}[] {name}" if array else f"out {CSHARP_TYPES[type_.base]} {name}"


def csharp(_text, items):
    structs = {item.name for item in items if isinstance(item, Struct)}
    out = [CSHARP_HEAD.format(made=MADE, about=comment(items[0].doc, "//"))]
    for item in items[1:]:
        if isinstance(item, Section):
            out.append("\n" + comment(item.doc, "//", "    "))
        if isinstance(item, Constants):
            out.append("\n" * bool(item.doc or len(item.members) > 1) + comment(item.doc, "//", "    "))
            type_ = CSHARP_TYPES[item.type]
            out += [summary(each.doc, "    ") + f"    public const {type_} {each.name} = {each.value};\n" for each in item.members]
        if isinstance(item, Macro):
            parameters = ", ".join(f"int {name}" for name in item.parameters)
            out.append(summary(item.doc, "    ") + f"    public static int {item.name}({parameters}) {{ return {item.formula}; }}\n")
        if isinstance(item, Struct):
            out.append("\n" + summary(item.doc, "    ") + f"    [StructLayout(LayoutKind.Sequential)]\n    public struct {item.name}\n    {{\n")
            out += [summary(each.doc, "        ") + f"        {csharp_field(each)}\n" for each in item.fields]
            out.append(f"\n        private static readonly uint Size = (uint)Marshal.SizeOf(typeof({item.name}));\n"
                       "        /// <summary>With its size; the other fields are 0.</summary>\n"
                       f"        public static {item.name} Create() {{ return new {item.name} {{ size = Size }}; }}\n"
                       "    }\n")
        if isinstance(item, Function):
            parameters = [csharp_parameter(each, following, structs) for each, following in zip(item.parameters, [*item.parameters[1:], None])]
            result = "IntPtr" if item.result.pointees_const else CSHARP_TYPES[item.result.base]
            overloads = [", ".join(parameters)]
            if "[Out]" in overloads[0]:  # into native memory
                overloads.append(re.sub(r"\[Out\] \w+\[\]", "IntPtr", overloads[0]))
            for overload in overloads:
                out.append(summary(item.doc, "    ") + "    [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]\n"
                           f"    public static extern {result} {item.name}({overload});\n")
    enums = {item.members[0].name: item for item in items if isinstance(item, Constants)}
    return "".join([*out, "}\n", *(csharp_enum(enums[first], *how) for first, how in CSHARP_ENUMS.items())])


BINDINGS = {
    HERE / "talus.cdef.h": cdef,
    HERE / "talus_ctypes.py": python,
    HERE / "Talus.cs": csharp,
    HERE.parent.parent / "rust/src/talus.rs": rust,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing, and fail if a file is not what talus.h makes")
    check = parser.parse_args().check
    text = HEADER.read_text()
    items = read(text)
    stale = []
    for path, make in BINDINGS.items():
        made = make(text, items)
        if not check:
            path.write_text(made)
        elif not path.exists() or path.read_text() != made:
            stale.append(path.name)
    if stale:
        sys.exit(f"stale: {', '.join(stale)}; run make.py")


if __name__ == "__main__":
    main()
