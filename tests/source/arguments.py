# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a program that calls every public function with NULL for each pointer
and NaN for each number in turn, the other arguments being good ones:

    arguments.py PREPROCESSED.h >arguments.c

What it includes first, arguments.h, makes the good ones, one for each type.  A
child process of its own makes each call; the program prints those that crash,
hang, or say that all is well."""

import re
import sys

# Parameters that may be NULL, or NaN, wherever they have this name ...
OPTIONAL = set("allocator err data context object hook directory origin file "
               "title reason warnings".split())
# ... or in this function.
MAY_BE = {
    "ovr_fail_about": {"about"},
    "ovr_fail_meant": {"meant"},
    "ovr_life": {"risk", "length"},
    "ovr_lubricant_make": {"p0", "z"},
    "ovr_run_create": {"options"},
    "ovr_run_resume": {"options"},
    "ovr_surfaces_create": {"speed"},
    "ovr_study_sample": {"quantities"},
    "ovr_sweep": {"options"},
    "ovr_sweep_collect": {"path"},
}


NUMBERS = {"double", "float", "int", "long", "unsigned", "size_t", "_Bool"}


def functions(text):
    """(what it returns, name, [(type, name)])"""
    text = " ".join(text.split())
    pattern = re.compile(
        r'__attribute__\(\(visibility\("default"\)\)\) ([^;{}]*?)(\w+)'
        r'\(((?:[^()]|\((?:[^()]|\([^()]*\))*\))*)\)[^;{]*;')
    inline = re.compile(r"static inline ([^;{}()]*?)(\w+)\(([^(){}]*)\) \{")
    for found in [*pattern.finditer(text), *inline.finditer(text)]:
        yield found[1].strip(), found[2], parameters(found[3])


def parameters(text):
    if text.strip() == "void":
        return []
    parts, depth, part = [], 0, ""
    for c in text:
        depth += (c == "(") - (c == ")")
        if c == "," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += c
    return [parameter(p.strip()) for p in parts + [part]]


def parameter(text):
    if text == "...":
        return "...", ""
    inner = re.match(r"(.*\(\*)(\w+)(\)\(.*\))$", text)
    if inner:
        return inner[1] + inner[3], inner[2]
    array = re.match(r"(.*?)(\w+)\[\w*\]$", text)
    if array:
        return array[1].strip() + " *", array[2]
    plain = re.match(r"(.*?)(\w+)$", text)
    return plain[1].strip(), plain[2]


def is_pointer(kind):
    return kind.endswith("*") or "(*" in kind or kind.endswith("*const")


def good(kind):
    """The macro of arguments.h that stands for a good value of the type."""
    words = re.findall(r"\w+|\*", kind)
    return "GOOD_" + "_".join({"*": "to"}.get(w, w) for w in words
                              if w != "const")


def otherwise(kind, filled):
    """What it is where arguments.h says nothing."""
    target = re.sub(r"\bconst\b|\*$", "", kind.replace("*const", "*")).strip()
    if not is_pointer(kind):
        return "1" if kind in NUMBERS else "0"
    if target in filled:
        return f"copied(&(const {target}[]){{{target}_default()}}, " \
               f"sizeof({target}))"
    return "fresh()"


def call(function, arguments):
    return f"{function}({', '.join(arguments)})"


def cases(function, given):
    """(what is bad, the arguments, whether it may be)"""
    arguments = [good(kind) for kind, _ in given if kind != "..."]
    for k, (kind, name) in enumerate(given):
        optional = name in OPTIONAL | MAY_BE.get(function, set())
        bad = list(arguments)
        if is_pointer(kind):
            bad[k] = "NULL"
        elif kind in ("double", "float"):
            bad[k] = "NAN"
        else:
            continue
        yield f"{name} {bad[k]}", bad, optional


def body(returns, made):
    if returns == "ovr_status":
        return f"return {made} ? REFUSED : TAKEN;"
    if returns == "void":
        return f"{made}; return SURVIVED;"
    if is_pointer(returns):
        return f"return {made} ? TAKEN : REFUSED;"
    return f"(void){made}; return SURVIVED;"


def main():
    text = open(sys.argv[1]).read()
    all_of = list(functions(text))
    filled = {name[:-8] for _, name, _ in all_of
              if name.endswith("_default")}
    print('#include "arguments.h"\n')
    for kind in sorted({kind for _, _, given in all_of
                        for kind, _ in given if kind != "..."}):
        print(f"#ifndef {good(kind)}\n#define {good(kind)} "
              f"{otherwise(kind, filled)}\n#endif")
    rows = []
    for returns, name, given in all_of:
        for what, arguments, optional in cases(name, given):
            made = call(name, arguments)
            print(f"static int call_{len(rows)}(void)\n"
                  f"{{ {body(returns, made)} }}")
            rows.append(f'    {{"{name}", "{what}", call_{len(rows)}, '
                        f"{int(optional)}}},")
    print("static const row rows[] = {", *rows, "};", sep="\n")
    print("int main(void) { return try_all(rows, "
          "sizeof rows / sizeof *rows); }")


main()
