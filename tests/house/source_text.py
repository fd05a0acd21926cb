"""What the tests of the house share: the source files, their rooms and their includes."""
import pathlib
import re

# Dependencies point from a room to itself or to one further down this list. A room without inner ones in the list is all
# that stands under its name; rooms between the two belong to the outer one.
ROOMS = ("frontends", "gl", "pipeline/geometry", "pipeline/schedule", "raster", "raster/target", "simd")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def source_files(root):
    return sorted(path for path in (pathlib.Path(root) / "src").rglob("*") if path.suffix in (".h", ".cpp"))


def room_of(root, path):
    """The innermost room of a file under src, or None for what stands in src itself."""
    folder = path.relative_to(pathlib.Path(root) / "src").parent
    names = [str(folder)] + [str(outer) for outer in folder.parents]
    return next((name for name in names if name in ROOMS), None)


def without_comments(text):
    return re.sub(r'//[^\n]*|/\*.*?\*/', "", text, flags=re.DOTALL)
