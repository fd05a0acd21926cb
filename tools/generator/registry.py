"""Reads gl.xml: which commands exist, their C types, their aliases and the GL version that brought them."""

import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

KEYWORDS = {"near", "far", "register", "default"}


@dataclass
class Parameter:
    type: str  # C type as text, "const GLfloat *"
    name: str
    length: str  # gl.xml's len attribute, "" when there is none
    group: str = ""  # of enumerants that it takes
    object_class: str = ""  # of objects whose names it takes: "texture"

    @property
    def is_pointer(self):
        return self.type.endswith("*")


@dataclass
class Command:
    name: str  # "glBlendFunc"
    result: str  # C return type
    parameters: list = field(default_factory=list)
    alias: str = ""

    @property
    def short(self):
        """Member name in the dispatch table: "BlendFunc"."""
        return self.name[2:]

    @property
    def snake(self):
        """Name of the handwritten function: glTexImage2D -> tex_image_2d, glTexParameterfv -> tex_parameterfv."""
        name = re.sub(r"(\d)D", r"_\1d", self.short)
        return re.sub(r"(?<=[a-z0-9])([A-Z])", r"_\1", name).lower()

    def types(self):
        return ", ".join(p.type for p in self.parameters)

    def declaration(self):
        """The parameter list with names."""
        return ", ".join(f"{p.type} {p.name}" for p in self.parameters)

    def arguments(self):
        return ", ".join(p.name for p in self.parameters)


def text_without_name(element):
    text = "".join(t for child in [element] for t in own_text(child))
    return re.sub(r"\s+", " ", text).strip().replace(" *", "*")


def own_text(element):
    yield element.text or ""
    for child in element:
        if child.tag != "name":
            yield child.text or ""
        yield child.tail or ""


def read_parameter(element):
    name = element.find("name").text
    return Parameter(text_without_name(element), name + "_" if name in KEYWORDS else name, element.get("len", ""),
                     element.get("group", ""), element.get("class", ""))


def read_command(element):
    proto = element.find("proto")
    command = Command(proto.find("name").text, text_without_name(proto))
    command.parameters = [read_parameter(p) for p in element.findall("param")]
    alias = element.find("alias")
    command.alias = alias.get("name") if alias is not None else ""
    return command


def required_enumerants(element):
    return [e.get("name") for e in element.findall("require/enum")]


class Registry:
    """All commands of gl.xml by name, the groups of enumerants, and what each desktop GL version and each extension adds."""

    def __init__(self, path):
        root = ElementTree.parse(path).getroot()
        self.commands = {}
        for element in root.findall("commands/command"):
            command = read_command(element)
            self.commands[command.name] = command
        self.groups = {}  # "BlendingFactor" -> names of its enumerants
        for enumerant in root.findall("enums/enum"):
            for group in filter(None, enumerant.get("group", "").split(",")):
                self.groups.setdefault(group, []).append(enumerant.get("name"))
        self.values = {e.get("name"): int(e.get("value"), 0) for e in root.findall("enums/enum")
                       if e.get("api", "gl") == "gl"}
        self.versions = {}  # "1.1" -> names, in the order of the versions
        self.enumerants = {}  # "1.1", "GL_EXT_abgr" -> names of the enumerants that it requires
        for feature in root.findall("feature[@api='gl']"):
            names = [c.get("name") for c in feature.findall("require/command")]
            self.versions[feature.get("number")] = names
            self.enumerants[feature.get("number")] = required_enumerants(feature)
        self.extensions = {}  # "GL_EXT_abgr" -> names of its commands, of extensions to desktop GL
        for extension in root.findall("extensions/extension"):
            if "gl" in extension.get("supported", "").split("|"):
                names = [c.get("name") for c in extension.findall("require/command")]
                self.extensions[extension.get("name")] = names
                self.enumerants[extension.get("name")] = required_enumerants(extension)
