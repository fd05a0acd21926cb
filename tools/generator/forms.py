"""Writes the thunks: every form of a command, its arguments converted, calls the core form.

A thunk is a template over what is done with the core form: `Execute` carries it out, `Compile` records it in the
display list that is being made. A null pointer is refused with GL_INVALID_VALUE, so that it never takes the program
down; the specification leaves it undefined.
"""

import re

from .policy import PolicyError, count_function_name

FLOATING = {"GLfloat", "GLdouble", "GLclampf", "GLclampd"}
SIGNED = {"GLbyte", "GLshort", "GLint"}
UNSIGNED = {"GLubyte", "GLushort", "GLuint"}


def element_type(pointer_type):
    return pointer_type.replace("const", "").replace("*", "").strip()


def convert(expression, source, target, normalised=False):
    """C++ for one value of type `source` as type `target`."""
    if source == target:
        return expression
    if normalised and source in SIGNED | UNSIGNED:
        return f"normalised({expression})"
    if source in FLOATING and target in SIGNED:
        return f"rounded({expression})"
    return f"static_cast<{target}>({expression})"


def place(policy, member):
    """Argument of Do::error: whether the command's own errors count between Begin and End too."""
    return "Allowed::kAnywhere" if policy.inside_begin_end(member) else "Allowed::kOutsideBeginEnd"


def null_check(policy, member):
    """Refuses null pointers, except where an element count of 0 or the policy makes them meaningful."""
    lines = ""
    command = member.command
    scalars = {p.name for p in command.parameters if not p.is_pointer}
    for p in command.parameters:
        if not p.is_pointer or policy.may_be_null(command, p):
            continue
        condition = f"!{p.name}" + (f" && {p.length} > 0" if p.length in scalars else "")
        result = "return" if command.result == "void" else f"return {command.result}()"
        lines += (f"    if ({condition}) [[unlikely]] {{\n"
                  f'        Do::error(*ctx, {place(policy, member)}, GL_INVALID_VALUE, "{p.name} is null");\n        {result};\n    }}\n')
    return lines


def scalars_of(command):
    """The command's arguments with fixed-size vectors taken apart: (expression, type) pairs."""
    for p in command.parameters:
        if not p.is_pointer:
            yield p.name, p.type
            continue
        if not p.length.isdigit():
            raise PolicyError(f"{command.name}: gl.xml does not say how long {p.name} is")
        for i in range(int(p.length)):
            yield f"{p.name}[{i}]", element_type(p.type)


def core_body(policy, member):
    arguments = "".join(f", {p.name}" for p in member.command.parameters)
    result = "" if member.command.result == "void" else "return "
    return f"    {result}Do::{member.core.short}(*ctx{arguments});\n"


def components_body(policy, member):
    """Vertex2iv -> Vertex4f(v[0], v[1], 0, 1): vectors taken apart, values converted, missing ones filled in."""
    wanted = [p.type for p in member.core.parameters]
    given = list(scalars_of(member.command))
    if len(given) > len(wanted):
        raise PolicyError(f"{member.command.name} has more values than {member.core.name}")
    arguments = [convert(e, t, w, member.options.get("normalised")) for (e, t), w in zip(given, wanted)]
    arguments += [f"{wanted[i]}({member.options['pad'][i]})" for i in range(len(given), len(wanted))]
    return f"    Do::{member.core.short}(*ctx, {', '.join(arguments)});\n"


def matrix_body(policy, member):
    source = member.command.parameters[0]
    target = element_type(member.core.parameters[0].type)
    order = [(i % 4) * 4 + i // 4 for i in range(16)] if "Transpose" in member.command.name else range(16)
    values = ", ".join(convert(f"{source.name}[{i}]", element_type(source.type), target) for i in order)
    return f"    const {target} matrix[16] = {{{values}}};\n    Do::{member.core.short}(*ctx, matrix);\n"


def values_body(policy, member):
    """Lighti, Lightiv ... -> Lightfv. A single value for a parameter that is a vector is its first component, as in the
    reference; the others are 0. Where `refuses` says so it is an error outside display lists."""
    count = count_function_name(member.options["values"])
    given = member.command.parameters[-1]
    leading = "".join(f", {p.name}" for p in member.command.parameters[:-1])
    pname = "pname" if any(p.name == "pname" for p in member.command.parameters) else None
    if not pname:
        raise PolicyError(f"{member.command.name} has no pname")
    if given.is_pointer:
        return (f"    const ParameterValues values({given.name}, {count}(pname));\n"
                f"    Do::{member.core.short}(*ctx{leading}, values.data());\n")
    refusal = ""
    if member.options.get("refuses"):
        refusal = (f"    if (!Do::kRecords && {count}(pname).size > 1)\n"
                   f'        return Do::error(*ctx, {place(policy, member)}, GL_INVALID_ENUM, "pname takes a vector");\n')
    return (f"{refusal}    const {given.type} vector[4] = {{{given.name}}};\n"
            f"    const ParameterValues values(vector, {count}(pname));\n"
            f"    Do::{member.core.short}(*ctx{leading}, values.data());\n")


def query_body(policy, member):
    """GetLightiv -> GetLightfv and conversion of what it answers; nothing is written after an error."""
    count = count_function_name(member.options["values"])
    leading = "".join(f", {p.name}" for p in member.command.parameters[:-1])
    out = member.command.parameters[-1].name
    return (f"    QueriedValues values(*ctx);\n    Do::{member.core.short}(*ctx{leading}, values.data());\n"
            f"    values.write({out}, {count}(pname));\n")


def forward_body(policy, member):
    """The same command with arguments left out or of another type, matched by name."""
    given = {p.name: p.type for p in member.command.parameters}
    wanted = {p.name for p in member.core.parameters}
    checks = "".join(
        f'    if ({p.name} < 0) return Do::error(*ctx, {place(policy, member)}, GL_INVALID_VALUE, "{p.name} is negative");\n'
        for p in member.command.parameters if p.type == "GLsizei" and p.name not in wanted)
    arguments = []
    for p in member.core.parameters:
        if p.name not in given:
            raise PolicyError(f"{member.command.name} lacks {p.name}")
        arguments.append(convert(p.name, given[p.name], p.type))
    return f"{checks}    Do::{member.core.short}(*ctx, {', '.join(arguments)});\n"


BODIES = {"core": core_body, "components": components_body, "matrix": matrix_body, "values": values_body,
          "query": query_body, "forward": forward_body}


def thunk(policy, member):
    command = member.command
    body = BODIES[member.kind](policy, member)
    used = [p for p in command.parameters if re.search(rf"\b{p.name}\b", body)]
    parameters = "".join(f", {p.type} {p.name if p in used else ''}".rstrip() for p in command.parameters)
    return (f"template <class Do>\n{command.result} {command.short}(Context* ctx{parameters}) noexcept {{\n"
            f"{null_check(policy, member)}{body}}}\n")


def thunks_header(policy, banner):
    lines = [banner, "#pragma once\n", '#include "gl/context.h"\n#include "gl/convert.h"\n',
             "namespace terrazzo::gl::thunk {\n"]
    lines += [count_function(group, values) for group, values in policy.parameters.items()]
    lines += [thunk(policy, m) for m in policy.members]
    lines.append("}  // namespace terrazzo::gl::thunk")
    return "\n".join(lines) + "\n"


def count_function(group, parameters):
    """pname -> how many values the parameter has, 0 for a pname that does not exist."""
    cases = ""
    for pname, value in parameters.items():
        size, normalised = (int(value.split()[0]), "true") if isinstance(value, str) else (value, "false")
        cases += f"        case {pname}: return {{{size}, {normalised}}};\n"
    return (f"constexpr ParameterCount {count_function_name(group)}(GLenum pname) {{\n    switch (pname) {{\n{cases}"
            f"        default: return {{0, false}};\n    }}\n}}\n")
