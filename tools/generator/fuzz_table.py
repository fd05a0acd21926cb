"""Writes the fuzzer's table: every exported GL command with the registry's own signature, groups of enumerants, classes
of objects and lengths of client memory (tests/fuzz/table.h)."""

from .dispatch import BANNER, GL_HEADERS
from .forms import element_type

LETTERS = {
    "GLenum": "e", "GLbitfield": "m", "GLsizei": "n", "GLint": "i", "GLuint": "u", "GLfloat": "f", "GLclampf": "f",
    "GLdouble": "d", "GLclampd": "d", "GLbyte": "b", "GLubyte": "B", "GLshort": "s", "GLushort": "S", "GLboolean": "o",
    "GLintptr": "p", "GLsizeiptr": "p", "GLintptrARB": "p", "GLsizeiptrARB": "p", "void": "v", "GLvoid": "v",
}
# Types that <GL/gl.h> lacks, of commands that are not implemented.
OTHER_TYPES = {"GLclampx": "GLint", "GLDEBUGPROCKHR": "GLDEBUGPROC"}
CLASSES = {"texture": "kTexture", "query": "kQuery", "renderbuffer": "kRenderbuffer", "buffer": "kBuffer",
           "framebuffer": "kFramebuffer", "display list": "kList"}


def letter(parameter):
    """One letter for the type of the value, or of what a pointer points at; other types are only ever zero."""
    if parameter.type.count("*") > 1:
        return "P"
    return LETTERS.get(element_type(parameter.type), "z")


def known_enumerants(policy):
    """The enumerants of the versions and extensions that are offered."""
    registry, known = policy.registry, set()
    for version, names in registry.enumerants.items():
        if version in policy.offered or version in registry.versions and version <= policy.gl_version():
            known.update(names)
    return known


def group_tables(policy, commands):
    """C++ for the groups that the commands' parameters take: what is offered first, then the rest."""
    known, registry = known_enumerants(policy), policy.registry
    wanted = sorted({p.group for c in commands for p in c.parameters if p.group in registry.groups})
    rows, index = [], {}
    for name in wanted:
        names = [n for n in registry.groups[name] if n in registry.values]
        names = [n for n in names if n in known] + [n for n in names if n not in known]
        offered = sum(n in known for n in names)
        if not names:
            continue
        index[name] = len(rows)
        values = ", ".join(f'{{{registry.values[n]:#x}, "{n}"}}' for n in names)
        rows.append((name, f"constexpr Enumerant k{name}[] = {{{values}}};", offered, len(names)))
    return rows, index


def parameter_row(parameter, index):
    flags = [parameter.is_pointer, parameter.is_pointer and "const" not in parameter.type]
    group = index.get(parameter.group, -1)
    object_class = CLASSES.get(parameter.object_class, "kNone")
    return (f'{{"{parameter.name}", \'{letter(parameter)}\', {", ".join(str(f).lower() for f in flags)}, {group}, '
            f'ObjectClass::{object_class}, "{parameter.length}"}}')


def command_row(policy, command, index):
    target = policy.target(command.name)
    member = next((m for m in policy.members if m.command.name == target), None)
    family = member.core.name if member else ""
    types = "".join(f", {OTHER_TYPES.get(p.type, p.type)}" for p in command.parameters)
    return f'    {{"{command.name}", "{family}", &invoke<{command.result}{types}>, {parameters_of(command)}}},'


def parameters_of(command):
    return f"kParametersOf_{command.name}" if command.parameters else "{}"


def parameter_rows(command, index):
    rows = ", ".join(parameter_row(p, index) for p in command.parameters)
    return f"constexpr Parameter {parameters_of(command)}[] = {{{rows}}};"


def table_source(policy):
    names = policy.known_exports()
    commands = [policy.registry.commands[n] for n in names]
    groups, index = group_tables(policy, commands)
    lines = [BANNER, GL_HEADERS, '#include "fuzz/invoke.h"\n#include "fuzz/table.h"\n', "namespace terrazzo::fuzz {\nnamespace {\n"]
    lines += [row for _, row, _, _ in groups]
    lines += ["\nconstexpr EnumGroup kGroups[] = {"]
    lines += [f'    {{"{name}", k{name}, {offered}}},' for name, _, offered, _ in groups]
    lines += ["};\n", *[parameter_rows(c, index) for c in commands if c.parameters]]
    lines += ["\nconstexpr Command kCommands[] = {", *[command_row(policy, c, index) for c in commands], "};\n",
              "}  // namespace\n", "std::span<const EnumGroup> groups() {\n    return kGroups;\n}\n",
              "std::span<const Command> commands() {\n    return kCommands;\n}\n", "}  // namespace terrazzo::fuzz"]
    return "\n".join(lines) + "\n"


def outputs(policy):
    return {"fuzz_table.cpp": table_source(policy)}
