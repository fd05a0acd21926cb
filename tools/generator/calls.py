"""Writes a table of every exported GL function that calls it with arguments of a test's choice."""

from .dispatch import BANNER, GL_HEADERS

DECLARATION = """// What to give for every argument, by kind.
struct Arguments {
    long long integer;
    double real;
    void* pointer;
};

struct Call {
    const char* name;
    bool implemented;
    bool inside_begin_end;  // allowed between Begin and End
    bool in_lists;          // recorded in display lists
    void (*call)(const Arguments&);
};
"""


def argument(parameter):
    if parameter.is_pointer:
        # Handles and callbacks are pointers without a star; they belong to no implemented command.
        return f"({parameter.type})a.pointer"
    if parameter.type in ("GLfloat", "GLdouble", "GLclampf", "GLclampd"):
        return f"static_cast<{parameter.type}>(a.real)"
    return f"({parameter.type})a.integer"


def row(policy, name):
    command = policy.registry.commands[name]
    target = policy.target(name)
    flags = ["false"] * 3
    if target:
        listable = policy.listable(policy.registry.commands[target])
        flags = [str(f).lower() for f in (True, policy.matches("inside_begin_end", target), listable)]
    values = ", ".join(argument(p) for p in command.parameters)
    unused = "" if command.parameters else "[[maybe_unused]] "
    return f'    {{"{name}", {", ".join(flags)}, []({unused}const Arguments& a) {{ {name}({values}); }}}},'


def calls_header(policy):
    names = [n for n in policy.exports if n.startswith("gl")]
    prototypes = []
    for name in names:
        command = policy.registry.commands[name]
        prototypes.append(f"{command.result} {name}({command.types()});")
    return "\n".join([BANNER, "#pragma once\n", GL_HEADERS, '#include "gl/entry.h"\n', 'extern "C" {', *prototypes, "}\n",
                      "namespace terrazzo::gl {\n", DECLARATION, "inline constexpr Call kEveryCall[] = {",
                      *[row(policy, n) for n in names], "};\n", "}  // namespace terrazzo::gl"]) + "\n"


def outputs(policy):
    return {"calls.h": calls_header(policy)}
