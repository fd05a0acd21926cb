"""What the tests of the house share: the source files, their rooms and their includes."""
import pathlib
import re

# Dependencies point from a room to itself or to one further down this list.
ROOMS = ("frontends", "gl", "pipeline", "raster", "simd")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def source_files(root):
    return sorted(path for path in (pathlib.Path(root) / "src").rglob("*") if path.suffix in (".h", ".cpp"))


def room_of(root, path):
    """The room of a file under src, or None for what stands in src itself."""
    parts = path.relative_to(pathlib.Path(root) / "src").parts
    return parts[0] if parts[0] in ROOMS else None


def without_comments(text):
    return re.sub(r'//[^\n]*|/\*.*?\*/', "", text, flags=re.DOTALL)
