"""Where in C++ a fault can be put: places whose text can be chosen at run time.

Input: the text of a file of src/. Output: Places, each a span that can hold several wrong texts beside the right one:
an expression statement, a return statement, a condition, an initialiser, the value of a switch, a lock. This is no
parser of C++ but of this tree's style: it relies on clang-format's spaces, and whatever it gets wrong does not compile
and is left out. Code that the compiler must evaluate (constexpr) is passed over.
"""
import bisect
import dataclasses
import re

TOKEN = re.compile(r"""
    (?P<skip>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*)
  | (?P<string>(?:u8|[uUL])?"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+')
  | (?P<number>\.?\d(?:[eE][+-]|'?[\w.])*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<sign><<=|>>=|<=>|->\*|\.\.\.|::|->|\+\+|--|<<|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[][{}()<>;:,.?~!+\-*/%&|^=])
""", re.VERBOSE | re.DOTALL | re.MULTILINE)

OPEN, CLOSE = {"(": ")", "[": "]", "{": "}"}, {")", "]", "}"}
NOT_AT_RUN_TIME = {"constexpr", "consteval", "static_assert", "using", "typedef", "struct", "class", "enum", "union",
                   "static", "alignas", "template", "goto", "asm", "friend", "extern", "thread_local"}


@dataclasses.dataclass(frozen=True)
class Token:
    kind: str
    text: str
    start: int
    end: int


@dataclasses.dataclass
class Place:
    kind: str  # statement, return, jump, condition, value, switch, lock
    tokens: list
    labels: list = dataclasses.field(default_factory=list)  # of a switch
    guards: str = ""  # of a condition: the text of what it decides about

    @property
    def start(self):
        return self.tokens[0].start

    @property
    def end(self):
        return self.tokens[-1].end


def tokenize(text):
    tokens, at = [], 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            at += 1
            continue
        if match.lastgroup != "skip":
            tokens.append(Token(match.lastgroup, match.group(), match.start(), match.end()))
        at = match.end()
    return tokens


def one_line(text):
    """The text without comments and line ends, every character where it was."""
    comments = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/', re.DOTALL)
    text = comments.sub(lambda m: m[0] if m[0].startswith('"') else re.sub(r"[^\n]", " ", m[0]), text)
    return text.replace("\n", " ")


class Source:
    """All places of one file, and its text on one line: a place's text can be written several times into a line."""

    def __init__(self, text):
        self.tokens = tokenize(text)
        self.text = one_line(text)
        self.partner = {}
        stack = []
        for i, token in enumerate(self.tokens):
            if token.text in OPEN:
                stack.append(i)
            elif token.text in CLOSE and stack:
                self.partner[stack.pop()] = i
        self.places = []
        self.line_starts = [0] + [i + 1 for i, character in enumerate(text) if character == "\n"]
        self._scope(0, len(self.tokens))

    def line_of(self, offset):
        return bisect.bisect_right(self.line_starts, offset)

    def _is(self, i, *texts):
        return 0 <= i < len(self.tokens) and self.tokens[i].text in texts

    def _close(self, i):
        return self.partner.get(i, len(self.tokens) - 1)

    def _scope(self, i, end):
        """Namespaces, classes and what stands between functions."""
        head = i
        while i < end:
            if self._is(i, "{"):
                words = {token.text for token in self.tokens[head:i]}
                after = self.tokens[i - 1].text
                close = self._close(i)
                if words & {"namespace", "struct", "class", "union", "extern"} and after not in (")", "=", "const"):
                    self._scope(i + 1, close)
                elif self._opens_body(i) and not words & {"constexpr", "consteval", "enum"} and "(" in words:
                    self._block(i + 1, close)
                i = close + 1
                if not self._is(i, ",", ";"):
                    head = i
            elif self._is(i, "(", "["):
                i = self._close(i) + 1
            else:
                if self._is(i, ";"):
                    head = i + 1
                i += 1

    def _opens_body(self, i):
        before = self.tokens[i - 1].text
        if before in (")", "]", "const", "noexcept", "override", "mutable", "try", "else", "do"):
            return True
        back = i - 1  # a trailing return type
        while back > 0 and i - back < 12 and self.tokens[back].text not in (";", "{", "}", "(", ")"):
            if self.tokens[back].text == "->":
                return self.tokens[back - 1].text in (")", "const", "mutable")
            back -= 1
        return False

    def _block(self, i, end):
        while i < end:
            i = self._statement(i, end)

    def _add(self, kind, first, last, **more):
        if first < last:
            self.places.append(Place(kind, self.tokens[first:last], **more))

    def _statement(self, i, end):
        word = self.tokens[i].text
        if word == "{":
            self._block(i + 1, self._close(i))
            return self._close(i) + 1
        if word in (";", "}", "else", "do", "try"):
            return i + 1
        if word == "[" and self._is(i + 1, "["):
            return self._close(i) + 1
        if word in ("case", "default"):
            while not self._is(i, ":"):
                i += 1
            return i + 1
        if word in ("if", "while"):
            constant = self._is(i + 1, "constexpr")
            i += 2 if constant else 1
            close = self._close(i)
            if not constant:
                self._condition(i + 1, close)
            return close + 1
        if word == "switch":
            close = self._close(i + 1)
            self._switch(i + 2, close)
            return close + 1
        if word == "for":
            close = self._close(i + 1)
            stops = self._top_level(i + 2, close, ";")
            if len(stops) == 2:
                self._initialiser(i + 2, stops[0])
                self._condition(stops[0] + 1, stops[1])
                self._add("expression", stops[1] + 1, close)
            return close + 1
        if word == "catch":
            return self._close(i + 1) + 1
        stop = self._top_level(i, end, ";", first=True)
        if word in NOT_AT_RUN_TIME:
            return stop + 1
        self._lambdas(i, stop)
        if word == "return":
            self._add("return", i, stop)
        elif word in ("break", "continue"):
            self._add("jump", i, stop)
        elif any(self.tokens[k].text in ("lock_guard", "scoped_lock") for k in range(i, min(i + 5, stop))):
            self._add("lock", i, stop)
        elif self._is_declaration(i, stop):
            self._initialiser(i, stop)
        else:
            self._add("statement", i, stop)
        return stop + 1

    def _top_level(self, i, end, what, first=False):
        found = []
        while i < end:
            if self._is(i, what):
                if first:
                    return i
                found.append(i)
            i = self._close(i) + 1 if self.tokens[i].text in OPEN else i + 1
        return end if first else found

    def _lambdas(self, i, stop):
        for k in range(i, stop):
            if self._is(k, "{") and self._opens_body(k) and self._is(k - 1, ")", "]", "mutable", "const"):
                self._block(k + 1, self._close(k))

    def _condition(self, first, last):
        if self._top_level(first, last, ";") or self._top_level(first, last, "="):
            return
        self._lambdas(first, last)
        after = self.tokens[last].end if last < len(self.tokens) else len(self.text)
        self._add("condition", first, last, guards=self.text[after:after + 80].strip())

    def _switch(self, first, close):
        labels = []
        if self._is(close + 1, "{"):
            end = self._close(close + 1)
            i = close + 2
            while i < end:
                if self._is(i, "switch"):
                    i = self._close(self._close(i + 1) + 1)
                elif self._is(i, "case"):
                    stop = i
                    while not self._is(stop, ":"):
                        stop += 1
                    labels.append(self.text[self.tokens[i + 1].start:self.tokens[stop - 1].end])
                i += 1
        self._add("switch", first, close, labels=labels)

    def _is_declaration(self, i, stop):
        if self._is(i, "const", "auto"):
            return True
        while i < stop and self.tokens[i].kind == "name":
            i += 1
            if self._is(i, "<") and self.tokens[i].start == self.tokens[i - 1].end:
                depth = 0
                while i < stop:
                    depth += {"<": 1, ">": -1, ">>": -2}.get(self.tokens[i].text, 0)
                    i += 1
                    if depth <= 0:
                        break
            if not self._is(i, "::"):
                break
            i += 1
        while self._is(i, "*", "&", "const"):
            i += 1
        return i < stop and self.tokens[i].kind == "name" and self.tokens[i - 1].text not in (".", "->")

    def _initialiser(self, i, stop):
        equals = self._top_level(i, stop, "=")
        if not equals or self._is(i, "static"):
            return
        first = equals[0] + 1
        commas = [k for k in self._top_level(first, stop, ",")]
        last = commas[0] if commas else stop
        if first < last and not self._is(first, "{", "["):
            self._add("value", first, last)
