"""Reads tools/policy.toml and answers, for every exported name, how it is carried out."""

import fnmatch
import tomllib


class PolicyError(Exception):
    """The policy contradicts itself or the registry."""


class Policy:
    def __init__(self, path, registry, exports):
        with open(path, "rb") as file:
            self.data = tomllib.load(file)
        self.registry = registry
        self.exports = exports
        self.core = [name for chapter in self.data["core"].values() for name in chapter]
        for name in self.core:
            if name not in registry.commands:
                raise PolicyError(f"{name} is not a command of gl.xml")

    def matches(self, rule, name):
        """Whether `name` is in the group of [rules] called `rule`."""
        return any(fnmatch.fnmatchcase(name, pattern) for pattern in self.data["rules"][rule])

    def implemented(self):
        """Dispatch members, in name order: every command that has code behind it."""
        return [self.registry.commands[name] for name in sorted(self.core)]

    def entry_targets(self):
        """Exported name -> the dispatch member behind it, or None when it is not implemented."""
        members = {c.name for c in self.implemented()}
        targets = {}
        for name in self.exports:
            if name.startswith("gl"):
                alias = self.registry.commands[name].alias
                targets[name] = name if name in members else alias if alias in members else None
        return targets

    def gl_version(self):
        """The highest version all of whose commands, and those of the versions before it, are implemented."""
        members = {c.name for c in self.implemented()}
        best = "1.0"
        for number, names in self.registry.versions.items():
            if not members.issuperset(names):
                break
            best = number
        return best
