"""Which faults a place can have: the small mistakes that an engineer makes and a compiler accepts.

Input: a Source and its places. Output: Faults, each the place's text with one thing wrong. Nothing here knows what the
code is for; what no behaviour depends on is listed in equivalent.toml.
"""
import dataclasses
import re

SWAPPED_SIGNS = {
    "<": ["<="], "<=": ["<"], ">": [">="], ">=": [">"], "==": ["!="], "!=": ["=="],
    "+": ["-"], "-": ["+"], "*": ["+"], "/": ["*"], "%": ["/"], "<<": [">>"], ">>": ["<<"], "&": ["|"], "|": ["&"],
    "&&": ["||"], "||": ["&&"], "+=": ["-=", "="], "-=": ["+="], "|=": ["&=", "="], "&=": ["|="]}
SIGN_CLASS = {"<": "boundary", "<=": "boundary", ">": "boundary", ">=": "boundary", "==": "comparison",
              "!=": "comparison", "&&": "logic", "||": "logic"}
SWAPPED_NAMES = {}
for pair in ("x y|y x|z w|w z|width height|height width|red green|green blue|blue red|alpha red|first last|last first"
             "|rgb alpha|front back|back front|source destination|destination source|near far|far near"
             "|ambient diffuse|diffuse specular|specular ambient|left right|right left|top bottom|bottom top"
             "|rows columns|columns rows|row column|column row|min max|max min|s t|t s|r q|q r|pack unpack|unpack pack"
             "|draw read|read draw|begin end|offset size|depth stencil|stencil depth|true false|false true"
             "|floor ceil|ceil floor|minimum maximum|maximum minimum|fail depth_fail|depth_fail depth_pass"
             "|push_back pop_back|x0 y0|y0 x0|x1 y1|y1 x1|x0 x1|y0 y1|width_log2 height_log2"
             "|skip_rows skip_pixels|skip_pixels skip_rows|binding texture|lower_bound upper_bound|upper_bound lower_bound"
             ).split("|"):
    SWAPPED_NAMES[pair.split()[0]] = pair.split()[1]


@dataclasses.dataclass
class Fault:
    file: str
    line: int
    kind: str
    before: str  # the place's text, which names the fault together with `after`
    after: str
    place: object
    number: int = 0
    occurrence: int = 0  # among faults of the file that read the same

    @property
    def text(self):
        return (self.file, self.kind, squeeze(self.before), squeeze(self.after))

    @property
    def key(self):
        return (*self.text, self.occurrence)


def squeeze(text):
    return " ".join(text.split())


def neighbours(names):
    """Each name -> the one that comes after it in order of first use."""
    order = list(dict.fromkeys(names))
    return {name: order[(i + 1) % len(order)] for i, name in enumerate(order)} if len(order) > 1 else {}


class FaultFinder:
    def __init__(self, file, source, family):
        """`family`: for Enum::kName, all names of Enum that the room uses."""
        self.file, self.source, self.family = file, source, family
        names = [t.text for t in source.tokens if t.kind == "name" and re.match(r"(GLX?|EGL)_[A-Z]", t.text)]
        is_error = re.compile(r"(GL_INVALID|GL_OUT_OF|GL_STACK|EGL_BAD)_").match
        self.gl = {**neighbours(name for name in names if not is_error(name)), **neighbours(filter(is_error, names))}

    def faults(self):
        for place in self.source.places:
            seen = set()
            before = self.source.text[place.start:place.end]
            for kind, after in self._of(place, before):
                if squeeze(after) != squeeze(before) and after not in seen:
                    seen.add(after)
                    yield Fault(self.file, self.source.line_of(place.start), kind, before, after, place)

    def _of(self, place, before):
        if place.kind == "lock":
            yield "lock", ""
            return
        if place.kind == "jump":
            yield "jump", ""
            return
        if place.kind == "switch":
            labels = place.labels
            for i, label in enumerate(labels):
                yield "label", f"drop {label}"
                yield "label", f"swap {label} {labels[(i + 1) % len(labels)]}"
            return
        if place.kind == "condition":
            yield "negated", f"!({before})"
            if re.match(r"(\{\s*)?(return|continue|throw)", place.guards) or "record_error" in place.guards:
                yield "check", "false"
        if place.kind == "statement":
            yield "forgotten", ""
        yield from self._tokens(place, before)
        yield from self._arguments(place, before)
        yield from self._conjuncts(place, before)

    def _tokens(self, place, before):
        tokens, offset = place.tokens, place.start

        def replaced(token, text):
            return before[:token.start - offset] + text + before[token.end - offset:]

        for i, token in enumerate(tokens):
            text = token.text
            spaced = before[token.start - offset - 1:token.start - offset] == " " and before[
                token.end - offset:token.end - offset + 1] == " "
            if token.kind == "sign" and text in SWAPPED_SIGNS and spaced:
                for other in SWAPPED_SIGNS[text]:
                    yield SIGN_CLASS.get(text, "arithmetic"), replaced(token, other)
            elif text == "!" and i + 1 < len(tokens):
                yield "negated", replaced(token, "")
            elif token.kind == "number":
                yield from (("number", replaced(token, other)) for other in other_numbers(text))
            elif token.kind == "name":
                for kind, other in self._other_names(tokens, i):
                    yield kind, replaced(token, other)
                if text == "clamp" and i + 1 < len(tokens) and tokens[i + 1].text == "(":
                    yield from self._unclamped(tokens, i, before, offset)

    def _other_names(self, tokens, i):
        name = tokens[i].text
        before = tokens[i - 1].text if i > 0 else ""
        if name in self.gl:
            yield "enumerant", self.gl[name]
        elif before == "::" and i >= 2 and re.match(r"k[A-Z]", name):
            other = self.family.get(tokens[i - 2].text, {}).get(name)
            if other:
                yield "enumerant", other
        elif name in SWAPPED_NAMES:
            yield "clamp" if name in ("min", "max") else "swapped", SWAPPED_NAMES[name]

    def _unclamped(self, tokens, i, before, offset):
        depth = 0
        for k in range(i + 1, len(tokens)):
            depth += {"(": 1, ")": -1}.get(tokens[k].text, 0)
            if depth == 1 and tokens[k].text == ",":
                end = k
                while depth > 0 and end + 1 < len(tokens):
                    end += 1
                    depth += {"(": 1, ")": -1}.get(tokens[end].text, 0)
                start = i - 2 if i >= 2 and tokens[i - 1].text == "::" else i
                value = before[tokens[i + 1].start - offset:tokens[k].start - offset] + ")"
                yield "clamp", before[:tokens[start].start - offset] + value + before[tokens[end].end - offset:]
                return

    def _arguments(self, place, before):
        """Two neighbouring arguments the other way round."""
        tokens, offset = place.tokens, place.start
        for i, token in enumerate(tokens):
            if token.text != "(" or i == 0 or tokens[i - 1].kind != "name":
                continue
            depth, starts, commas = 0, [i + 1], []
            for k in range(i, len(tokens)):
                depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(tokens[k].text, 0)
                if depth == 1 and tokens[k].text == ",":
                    commas.append(k)
                    starts.append(k + 1)
                if depth == 0:
                    ends = commas + [k]
                    break
            else:
                continue
            spans = [(tokens[a].start - offset, tokens[b - 1].end - offset) for a, b in zip(starts, ends) if a < b]
            for (a, b), (c, d) in zip(spans, spans[1:]):
                first, second = before[a:b], before[c:d]
                if first == "ctx" or max(len(first), len(second)) > 40 or '"' in first + second:
                    continue
                yield "arguments", before[:a] + second + before[b:c] + first + before[d:]

    def _conjuncts(self, place, before):
        """One part of a condition left out."""
        tokens, offset = place.tokens, place.start
        for i, token in enumerate(tokens):
            if token.text not in ("&&", "||"):
                continue
            depth, k = 0, i + 1
            while k < len(tokens):
                text = tokens[k].text
                if depth == 0 and (text in (")", "]", "}", ",", ";", "?", ":", "||") or text == "&&"):
                    break
                depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(text, 0)
                k += 1
            yield "check", before[:token.start - offset] + before[tokens[k - 1].end - offset:]


def other_numbers(text):
    if re.fullmatch(r"\d+[uU]?", text):
        digits, suffix = re.fullmatch(r"(\d+)([uU]?)", text).groups()
        value = int(digits)
        yield f"{value + 1}{suffix}"
        if value > 0:
            yield f"{value - 1}{suffix}"
    elif re.fullmatch(r"\d+\.\d*f?", text):
        suffix = "f" if text.endswith("f") else ""
        value = float(text.rstrip("f"))
        yield f"{value + 1}{suffix}" if value != 1 else f"0.5{suffix}"
        if value not in (0, 1):
            yield f"{value / 2}{suffix}"


def families(sources):
    """Enum -> {kName: the next one}, over all files of the tree."""
    names = {}
    for source in sources:
        tokens = source.tokens
        for i in range(2, len(tokens)):
            if tokens[i - 1].text == "::" and re.match(r"k[A-Z]", tokens[i].text) and tokens[i - 2].kind == "name":
                names.setdefault(tokens[i - 2].text, []).append(tokens[i].text)
    return {enum: neighbours(used) for enum, used in names.items()}
