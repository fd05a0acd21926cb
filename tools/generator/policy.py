"""Reads tools/policy.toml and answers, for every exported name, how it is carried out.

A command is either core (written by hand in src/gl) or a form: the same command with other argument types, made from
a core one. A command without either is not implemented.
"""

import re
import tomllib
from dataclasses import dataclass


class PolicyError(Exception):
    """The policy contradicts itself or the registry."""


@dataclass
class Member:
    """An implemented command: a member of the dispatch table."""

    command: object
    core: object  # the handwritten command behind it; itself for a core command
    kind: str  # "core" or the name of a section of [forms]
    options: dict  # the policy's line


class Policy:
    """`exports` are the names of the smallest library, OSMesa; `more_exports` those that larger ones have."""

    def __init__(self, path, registry, exports, more_exports=()):
        with open(path, "rb") as file:
            data = tomllib.load(file)
        self.registry = registry
        self.exports = exports
        self.more_exports = more_exports
        self.rules = data["rules"]
        self.parameters = data["parameters"]
        self.aliases = data["aliases"]
        self.offered = data["extensions"]["offered"]
        self.core = {name: options for chapter in data["core"].values() for name, options in chapter.items()}
        self.forms = data["forms"]
        for name in self.core:
            if name not in registry.commands:
                raise PolicyError(f"{name} is not a command of gl.xml")
        self.members = sorted(self.core_members() + self.form_members(), key=lambda m: m.command.name)
        self.names = {m.command.name for m in self.members}

    def matches(self, rule, name):
        """Whether `name` is in the group of [rules] called `rule`."""
        return any(re.fullmatch(pattern, name) for pattern in self.rules[rule])

    def core_members(self):
        return [Member(self.registry.commands[n], self.registry.commands[n], "core", o) for n, o in self.core.items()]

    def form_members(self):
        members = []
        for kind, lines in self.forms.items():
            for core_name, options in lines.items():
                names = self.form_names(core_name, options["from"])
                if core_name in self.core:
                    core = self.registry.commands[core_name]
                    members += [Member(self.registry.commands[n], core, kind, options) for n in names]
        return members

    def known_exports(self):
        """All exported names of GL commands that gl.xml describes, without those of OpenGL ES's extensions and of
        extensions of single vendors: libGL exports these as well, but they are not offered."""
        others = re.compile(".*(OES|NV|NVX|APPLE|ANGLE|QCOM|IMG)")
        exported = set(self.exports)
        more = [n for n in self.more_exports
                if n in self.registry.commands and n not in exported and not others.fullmatch(n)]
        return sorted([n for n in self.exports if n.startswith("gl")] + more)

    def entry_names(self):
        """The names that every library has an entry for: those of OSMesa, and all that is implemented."""
        exported = set(self.exports)
        return [n for n in self.known_exports() if n in exported or self.target(n)]

    def form_names(self, core_name, pattern):
        names = [n for n in self.known_exports() if re.fullmatch(pattern, n) and n != core_name]
        if not names:
            raise PolicyError(f"no exported command matches {pattern}, the forms of {core_name}")
        return names

    def inside_begin_end(self, member):
        return self.matches("inside_begin_end", member.command.name)

    def outside_begin_end(self, member):
        """What the command does outside Begin and End when not the same: "ignored" or "illegal"."""
        return self.core[member.core.name].get("outside_begin_end")

    def inlined(self, command):
        """The handwritten body is in a header, small, and throws nothing."""
        return self.core[command.name].get("inline", False)

    def listable(self, command):
        """Recorded in a display list, rather than carried out at once (GL 1.5 §5.4)."""
        return command.result == "void" and not self.matches("not_in_lists", command.name)

    def recording(self, command):
        """Who records the command in display lists: "generated" code, which is the default, or code "by hand", with
        records of its own or, when it is "batched", with the generated ones as well."""
        return self.core[command.name].get("record", "generated")

    def may_be_null(self, command, parameter):
        """Whether the handwritten code gives a null pointer a meaning of its own."""
        return self.matches("may_be_null", f"{command.name}:{parameter.name}")

    def count_function(self, core):
        """Name of the function pname -> number of values, for a core command that takes a parameter vector."""
        for lines in self.forms.values():
            if "values" in lines.get(core.name, {}):
                return count_function_name(lines[core.name]["values"])
        return None

    def target(self, name):
        """The dispatch member behind an exported name; None when it is not implemented."""
        for candidate in (name, self.registry.commands[name].alias, self.aliases.get(name)):
            if candidate in self.names:
                return candidate
        return None

    def gl_version(self):
        """The highest version all of whose commands, and those of the versions before it, are implemented."""
        best = "1.0"
        for number, names in self.registry.versions.items():
            if not self.names.issuperset(names):
                break
            best = number
        return best

    def gl_extensions(self):
        """What GL_EXTENSIONS answers: the offered ones, every command of which must be implemented."""
        for extension in self.offered:
            if extension not in self.registry.extensions:
                raise PolicyError(f"{extension} is not an extension of gl.xml")
            for name in self.registry.extensions[extension]:
                if not self.target(name):
                    raise PolicyError(f"{extension} is offered without {name}")
        return " ".join(sorted(self.offered))


def count_function_name(group):
    return re.sub(r"(?<=[a-z0-9])([A-Z])", r"_\1", group).lower() + "_count"
