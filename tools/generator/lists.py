"""Writes what display lists need: one record per core command, the recorder and the player.

A record is plain data: its arguments, with arrays behind it (`name`_offset bytes from its start, 0 for null). Images
are unpacked when they are recorded and stand there tightly packed, as the client's memory and pixel store modes may
change until the list is called (GL 1.5 §5.4).
"""

from .dispatch import BANNER, named_parameters

IMAGE_PARAMETERS = {"pixels", "bitmap", "mask"}

# A form that is known to fail when it is compiled; the error belongs to the call of the list. GL_NO_ERROR stands for
# one that does nothing but is not allowed everywhere.
ERROR_RECORD = """struct ErrorRecord {
    static constexpr Opcode kOpcode = Opcode::kError;
    RecordHeader header;
    Allowed allowed;
    GLenum code;
    const char* rule;
};
"""


def commands(policy):
    """Core commands that have a record of their own."""
    return [m.command for m in policy.members
            if m.kind == "core" and policy.listable(m.command) and policy.recording(m.command) != "by hand"]


def is_image(parameter):
    return parameter.is_pointer and parameter.name in IMAGE_PARAMETERS


def record_struct(command):
    fields = ""
    for p in command.parameters:
        fields += f"    std::uint32_t {p.name}_offset;\n" if p.is_pointer else f"    {p.type} {p.name};\n"
    return (f"struct {command.short}Record {{\n"
            f"    static constexpr Opcode kOpcode = Opcode::k{command.short};\n"
            f"    RecordHeader header;\n{fields}}};\n")


def records_header(policy):
    names = [c.short for c in commands(policy)]
    opcodes = "".join(f"    k{name},\n" for name in ["Error", "Primitives", "Arrays", *names])
    lines = [BANNER, "#pragma once\n", '#include <GL/gl.h>\n\n#include "gl/error.h"\n#include "gl/list_record.h"\n',
             "namespace terrazzo::gl {\n", f"enum class Opcode : std::uint16_t {{\n{opcodes}}};\n"]
    lines += [ERROR_RECORD, *[record_struct(c) for c in commands(policy)]]
    lines.append("}  // namespace terrazzo::gl")
    return "\n".join(lines) + "\n"


def element_count(policy, command, parameter):
    """C++ for the number of elements behind a pointer argument."""
    count = policy.core[command.name].get("count")
    if count:
        return count
    if "pname" in parameter.length:
        return f"thunk::{policy.count_function(command)}(pname).size"
    return parameter.length


def image_arguments(command, parameter):
    """C++ for what there is to know of the image behind a pointer argument."""
    names = {p.name for p in command.parameters}
    if parameter.name == "mask":
        return "ImageSize{32, 32}, GL_COLOR_INDEX, GL_BITMAP"
    size = ", ".join(n if n in names else "1" for n in ("width", "height", "depth"))
    return f"ImageSize{{{size}, {3 if 'depth' in names else 2}}}" + (", format, type" if "format" in names else ", GL_COLOR_INDEX, GL_BITMAP")


def largest_image(command):
    """C++ for the size beyond which a command that takes an image fails."""
    if not command.short.startswith("Tex"):
        return "kLargestPixelRectangle"
    return "kLargest3dTextureImage" if command.short.endswith("3D") else "kLargestTextureImage"


def is_unpacked(command):
    """Whether what a pointer argument points at may be in the unpack buffer."""
    return any(map(is_image, command.parameters)) or command.short.startswith(("CompressedTex", "PixelMap"))


def find_pixels(policy, command, parameter):
    """C++ that finds the pixels behind a pointer argument, or returns with the error there is."""
    name = parameter.name
    if is_image(parameter):
        found = f"find_list_image(ctx, {image_arguments(command, parameter)}, {name})"
    else:
        found = f"find_list_elements(ctx, {element_count(policy, command, parameter)}, {name})"
    return [f"    const PixelMemory {name}_memory = {found};",
            f"    if (!{name}_memory.is_usable()) return record_error(ctx, {name}_memory.rule.code, {name}_memory.rule.words);"]


def source(policy, command, parameter):
    """C++ for the copy of what is behind a pointer argument."""
    name = parameter.name
    if is_image(parameter):
        return f"UnpackedImage(ctx, {largest_image(command)}, {image_arguments(command, parameter)}, {name}_memory.data)"
    at = f"reinterpret_cast<{parameter.type.replace('const void', 'const std::byte')}>({name}_memory.data)" if is_unpacked(command) else name
    return f"CopiedArray({at}, {element_count(policy, command, parameter)})"


def recorder(policy, command):
    """Compile::Foo: appends a record, and carries the command out too in GL_COMPILE_AND_EXECUTE."""
    short = command.short
    arguments = "".join(f", {p.name}" for p in command.parameters)
    execute = f"ctx.dispatch.execute->{short}(&ctx{arguments})"
    lines = [f"void Compile::{short}(Context& ctx{named_parameters(command)}) {{"]
    makes_image = any(is_image(p) for p in command.parameters) or short.startswith("CompressedTexImage")
    if "target" in arguments and makes_image:
        lines.append(f"    if (is_proxy_target(target)) return {execute};")
    pointers = [p for p in command.parameters if p.is_pointer]
    if is_unpacked(command):
        for p in pointers:
            lines += find_pixels(policy, command, p)
    lines.append("    record(ctx, [&](DisplayList& display_list) {")
    for p in pointers:
        lines.append(f"        const auto {p.name}_source = {source(policy, command, p)};")
    behind = " + ".join(f"{p.name}_source.padded_size()" for p in pointers)
    reference = "auto& made = " if command.parameters else ""
    lines.append(f"        {reference}display_list.append<{short}Record>({behind});")
    offset = f"sizeof({short}Record)"
    for p in command.parameters:
        if p.is_pointer:
            lines.append(f"        made.{p.name}_offset = {p.name}_source.store(made, {offset});")
            offset += f" + {p.name}_source.padded_size()"
        else:
            lines.append(f"        made.{p.name} = {p.name};")
    lines.append("    });")
    lines.append(f"    if (ctx.lists.execute_too) {execute};\n}}\n")
    return "\n".join(lines)


def compile_header(policy):
    """What the thunks do while a list is compiled."""
    lines = [BANNER, "#pragma once\n", '#include "gl/call.h"\n', "namespace terrazzo::gl {\n", "struct Compile {",
             "    static constexpr bool kRecords = true;",
             "    static void error(Context& ctx, Allowed allowed, GLenum code, const char* rule);"]
    for member in policy.members:
        if member.kind == "core" and policy.listable(member.command):
            lines.append(f"    static void {member.command.short}(Context& ctx{named_parameters(member.command)});")
    lines.append("};\n\n}  // namespace terrazzo::gl")
    return "\n".join(lines) + "\n"


def recorder_source(policy):
    lines = [BANNER, '#include "gl/generated/compile.h"\n#include "gl/generated/records.h"\n'
             '#include "gl/generated/thunks.h"\n#include "gl/list_recorder.h"\n', "namespace terrazzo::gl {\n"]
    lines += [recorder(policy, c) for c in commands(policy) if policy.recording(c) == "generated"]
    lines.append("}  // namespace terrazzo::gl")
    return "\n".join(lines) + "\n"


def player_case(command):
    arguments = ""
    for p in command.parameters:
        arguments += f", behind<{p.type}>(r, r.{p.name}_offset)" if p.is_pointer else f", r.{p.name}"
    tight = "            const TightUnpack tight(ctx);\n" if is_unpacked(command) else ""
    reference = f"            const auto& r = record_cast<{command.short}Record>(header);\n"
    return (f"        case Opcode::k{command.short}: {{\n{reference if command.parameters else ''}{tight}"
            f"            return gl.{command.short}(&ctx{arguments});\n        }}\n")


def player_source(policy):
    cases = "".join(player_case(c) for c in commands(policy))
    names = "".join(f'        case Opcode::k{c.short}: return "{c.name}";\n' for c in commands(policy))
    return "\n".join([
        BANNER, '#include "gl/generated/dispatch.h"\n#include "gl/generated/records.h"\n#include "gl/list_arrays.h"\n'
        '#include "gl/list_player.h"\n#include "gl/list_primitives.h"\n',
        "namespace terrazzo::gl {\n",
        "void play_record(Context& ctx, const RecordHeader& header) {",
        "    const Dispatch& gl = *ctx.dispatch.execute;\n    switch (header.opcode) {",
        "        case Opcode::kError: return play_error(ctx, record_cast<ErrorRecord>(header));",
        "        case Opcode::kPrimitives: return play_primitives(ctx, record_cast<PrimitivesRecord>(header));",
        "        case Opcode::kArrays: return play_arrays(ctx, record_cast<ArraysRecord>(header));",
        f"{cases}    }}\n}}\n",
        "const char* record_name(Opcode opcode) {\n    switch (opcode) {",
        f'        case Opcode::kError: break;\n        case Opcode::kPrimitives: return "glBegin";\n'
        f'        case Opcode::kArrays: return "glDrawArrays";\n{names}    }}\n    return "";\n}}\n',
        "}  // namespace terrazzo::gl"]) + "\n"


def outputs(policy):
    return {
        "records.h": records_header(policy),
        "compile.h": compile_header(policy),
        "recorder.cpp": recorder_source(policy),
        "player.cpp": player_source(policy),
    }
