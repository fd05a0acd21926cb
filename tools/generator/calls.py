"""Writes a table of every exported GL function that calls it with arguments of a test's choice."""

from .dispatch import BANNER, GL_HEADERS

DECLARATION = """// What to give for an argument, by kind.
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
    // One letter a parameter: e GLenum, n GLsizei, i other integers, f float or double, p pointer to read, q to write.
    const char* kinds;
    void (*with)(const Arguments* one_for_each_parameter);

    // The same for all parameters.
    void call(const Arguments& all) const {
        Arguments each[16];
        std::fill_n(each, 16, all);
        with(each);
    }
};
"""


REAL_TYPES = ("GLfloat", "GLdouble", "GLclampf", "GLclampd")


def argument(parameter, index):
    if parameter.is_pointer:
        # Handles and callbacks are pointers without a star; they belong to no implemented command.
        return f"({parameter.type})a[{index}].pointer"
    if parameter.type in REAL_TYPES:
        return f"static_cast<{parameter.type}>(a[{index}].real)"
    return f"({parameter.type})a[{index}].integer"


def kind(parameter):
    if parameter.is_pointer:
        return "p" if "const" in parameter.type else "q"
    if parameter.type in REAL_TYPES:
        return "f"
    return {"GLenum": "e", "GLsizei": "n"}.get(parameter.type, "i")


def row(policy, name):
    command = policy.registry.commands[name]
    target = policy.target(name)
    flags = ["false"] * 3
    if target:
        listable = policy.listable(policy.registry.commands[target])
        flags = [str(f).lower() for f in (True, policy.matches("inside_begin_end", target), listable)]
    kinds = "".join(kind(p) for p in command.parameters)
    values = ", ".join(argument(p, i) for i, p in enumerate(command.parameters))
    unused = "" if command.parameters else "[[maybe_unused]] "
    return (f'    {{"{name}", {", ".join(flags)}, "{kinds}", '
            f"[]({unused}const Arguments* a) {{ {name}({values}); }}}},")


def calls_header(policy):
    names = policy.entry_names()
    prototypes = []
    for name in names:
        command = policy.registry.commands[name]
        prototypes.append(f"{command.result} {name}({command.types()});")
    return "\n".join([BANNER, "#pragma once\n", "#include <algorithm>\n", GL_HEADERS, '#include "gl/entry.h"\n', 'extern "C" {', *prototypes, "}\n",
                      "namespace terrazzo::gl {\n", DECLARATION, "inline constexpr Call kEveryCall[] = {",
                      *[row(policy, n) for n in names], "};\n", "}  // namespace terrazzo::gl"]) + "\n"


def outputs(policy):
    return {"calls.h": calls_header(policy)}
