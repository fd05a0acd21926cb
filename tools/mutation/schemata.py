"""Puts many faults into one copy of the source, each behind a number, so that all of them cost one build.

Input: the source tree and the chosen faults. Output: a tree beside it in which each place says
`mutant(17) ? wrong : right`. Which number is on is read from the environment (mutant.h). Files that hold no fault are
copied as they are, and files that did not change keep their time, so that a second run compiles little.
"""
import os
import pathlib
import re

HEADER = """// Which fault is on, and which places a program came by. Part of tools/mutate.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <mutex>

namespace terrazzo {

struct Mutants {
    Mutants() {
        if (const char* number = std::getenv("TERRAZZO_MUTANT")) chosen = std::atoi(number);
        if (const char* path = std::getenv("TERRAZZO_MUTANTS_REACHED")) {
            const int file = ::open(path, O_RDWR | O_CLOEXEC);
            struct ::stat status = {};
            if (file < 0 || ::fstat(file, &status) != 0) return;
            void* bytes = ::mmap(nullptr, static_cast<std::size_t>(status.st_size), PROT_READ | PROT_WRITE, MAP_SHARED,
                                 file, 0);
            if (bytes != MAP_FAILED) reached = static_cast<unsigned char*>(bytes);
            ::close(file);
        }
    }
    int chosen = 0;
    unsigned char* reached = nullptr;
};
inline Mutants g_mutants;

[[gnu::always_inline]] inline bool mutant(int number) {
    if (g_mutants.reached) [[unlikely]]
        g_mutants.reached[number] = 1;
    return number == g_mutants.chosen;
}

// The value of a switch, with one of its labels gone or taken for another.
template <typename Value>
[[gnu::always_inline]] inline Value without_label(int number, Value value, Value label) {
    return mutant(number) && value == label ? static_cast<Value>(0x7e) : value;
}
template <typename Value>
[[gnu::always_inline]] inline Value with_label(int number, Value value, Value label, Value other) {
    return mutant(number) && value == label ? other : value;
}

template <typename Mutex>
class MutantLock {
  public:
    MutantLock(int number, Mutex& mutex) : m_mutex(mutant(number) ? nullptr : &mutex) {
        if (m_mutex) m_mutex->lock();
    }
    ~MutantLock() {
        if (m_mutex) m_mutex->unlock();
    }
    MutantLock(const MutantLock&) = delete;
    MutantLock& operator=(const MutantLock&) = delete;

  private:
    Mutex* m_mutex;
};

}  // namespace terrazzo
"""
FOLDERS = ("src", "tests", "tools", "scenes", "piglit-lite", "bench")
FILES = ("meson.build", "meson_options.txt", "README.md", "LICENSE")


def choice(kind, right, faults):
    """C++ that is `right` unless one of the faults is on."""
    if kind == "lock":
        parts = re.fullmatch(r"(?:const )?std::(?:lock_guard|scoped_lock)(?:<.*?>)? (\w+)\((.*)\)", right.strip())
        return f"const terrazzo::MutantLock {parts[1]}({faults[0].number}, {parts[2]})" if parts else right
    if kind == "jump":
        return f"if (!terrazzo::mutant({faults[0].number})) {right}"
    if kind == "switch":
        text, value = right, f"std::decay_t<decltype({right})>"
        for fault in faults:
            what, *labels = fault.after.split()
            cast = ", ".join(f"static_cast<{value}>({label})" for label in labels)
            name = "without_label" if what == "drop" else "with_label"
            text = f"terrazzo::{name}<{value}>({fault.number}, {text}, {cast})"
        return text
    if kind in ("statement", "return"):
        text = ""
        for fault in faults:
            text += f"if (terrazzo::mutant({fault.number})) {{ {fault.after}; }} else "
        return text + right
    wrap = {"condition": "static_cast<bool>({})", "expression": "static_cast<void>({})"}.get(kind, "({})")
    text = wrap.format(right)
    for fault in faults:
        text = f"(terrazzo::mutant({fault.number}) ? {wrap.format(fault.after)} : {text})"
    return text


def instrument(text, source, faults):
    """The file's text with its faults, every line where it was."""
    places = {}
    for fault in faults:
        places.setdefault((fault.place.start, fault.place.end), []).append(fault)
    for (start, end), here in sorted(places.items(), reverse=True):
        lines = "\n" * text.count("\n", start, end)
        text = text[:start] + choice(here[0].place.kind, source.text[start:end], here) + lines + text[end:]
    return f'#include "mutant.h"\n#line 1\n{text}'


def write(path, data):
    if not path.is_file() or path.read_bytes() != data:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def write_tree(root, copy, sources, faults):
    """`sources`: file name -> (text, Source)."""
    by_file = {}
    for fault in faults:
        by_file.setdefault(fault.file, []).append(fault)
    wanted = {copy / "src/mutant.h"}
    write(copy / "src/mutant.h", HEADER.encode())
    for name in FOLDERS + FILES:
        top = root / name
        paths = [top] if top.is_file() else [
            pathlib.Path(folder) / file for folder, folders, files in os.walk(top) for file in files
            if "__pycache__" not in folder]
        for path in paths:
            relative = path.relative_to(root)
            here = by_file.get(str(relative))
            data = instrument(*sources[str(relative)], here).encode() if here else path.read_bytes()
            write(copy / relative, data)
            if os.access(path, os.X_OK):
                (copy / relative).chmod(0o755)
            wanted.add(copy / relative)
    for folder in FOLDERS:
        for path in (copy / folder).rglob("*"):
            if path.is_file() and path not in wanted and "__pycache__" not in path.parts:
                path.unlink()


def broken(output, copy, faults):
    """The faults that the compiler's messages point at."""
    def at(lines):
        pointed = set()
        for path, line in lines:
            for marker in ("src/",):
                name = path[path.find("/" + marker) + 1:] if "/" + marker in path else path
                pointed.update(fault.number for fault in faults if fault.file == name and
                               fault.line <= int(line) <= fault.last_line)
        return pointed

    found = at(re.findall(r"^(\S+?):(\d+):\d+: (?:fatal )?error:", output, re.MULTILINE))
    found |= at(re.findall(r"^(\S+?):(\d+):\d+:   required from", output, re.MULTILINE)) if not found else set()
    if not found:
        failed = set(re.findall(r"^FAILED: (\S+)", output, re.MULTILINE))
        found = {fault.number for fault in faults
                 if any(pathlib.Path(fault.file).name in name.replace("_", "/") for name in failed)}
    return found
