# SPDX-License-Identifier: MIT
"""Finds what a rule may change in a C source, and writes the source with all changes in it.

A *site* is an expression inside a function, and a *mutation* the text in its place. Rules:

    operators      + and -, * and /, & and |, << and >>, && and || change places; ^ becomes |, % becomes *;
                   the same of += and its like
    comparisons    each one becomes its opposite; < <= > >= take, or leave, the case of equality, too
    signs          unary - ! ~ go away
    choices        the results of ?: change places
    whole numbers  one more, one less; of hexadecimal ones, one bit changes
    floats         0.01 % more, and the sign changes; 0 becomes 0.001

Each mutation is behind scarp_rule_is(number), so one compilation serves all of them. Expressions that
have to be constant are left out where they can be told by their place: in static variables, sizes of
arrays and labels. Others do not compile, and rules.py leaves them out then. No text outside of functions
is changed.
"""
import re
import zlib

TOKEN = re.compile(r"""
    (?P<space>\s+|/\*.*?\*/|//[^\n]*)
  | (?P<hash>^[ \t]*\#(?:\\\n|/\*.*?\*/|[^\n])*)
  | (?P<string>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
  | (?P<number>\.?[0-9](?:[eEpP][+-]|[\w.])*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<sign>\.\.\.|<<=|>>=|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)
""", re.VERBOSE | re.DOTALL | re.MULTILINE)

BINARY = {"*": 10, "/": 10, "%": 10, "+": 9, "-": 9, "<<": 8, ">>": 8, "<": 7, ">": 7, "<=": 7, ">=": 7,
          "==": 6, "!=": 6, "&": 5, "^": 4, "|": 3, "&&": 2, "||": 1}
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
BECOMES = {"+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "%": ["*"], "&": ["|"], "|": ["&"], "^": ["|"],
           "<<": [">>"], ">>": ["<<"], "&&": ["||"], "||": ["&&"], "==": ["!="], "!=": ["=="],
           "<": [">=", "<="], ">": ["<=", ">="], "<=": [">", "<"], ">=": ["<", ">"]}
PAIRS = {"(": ")", "[": "]", "{": "}"}
TYPE_WORDS = set("const volatile struct enum union unsigned signed int char long short float double void "
                 "bool size_t register".split())
TYPE_NAME = re.compile(r"\w+_t$|v[fuid]$|v[fuid]_(four|sixteen|pair)$|u?vec[234]$|uint$")
STOPS = {"return", "case", "else", "do", "goto", "default"}
# What is in their parentheses has to be constant.
CONSTANT = {"_Static_assert", "__attribute__", "_Alignas", "_Alignof", "UINT64_C", "INT64_C"}


class Site:
    """`text[start:end]`, in a function, may become one of `mutations`."""

    def __init__(self, start, end, at, function, mutations):
        self.start, self.end, self.at, self.function, self.mutations = start, end, at, function, mutations


class Token:
    def __init__(self, kind, text, start):
        self.kind, self.text, self.start, self.end = kind, text, start, start + len(text)


def tokens_of(text):
    return [Token(m.lastgroup, m.group(), m.start()) for m in TOKEN.finditer(text)
            if m.lastgroup not in ("space", "hash")]


def typedefs_of(text):
    """Names of types that the text defines."""
    return set(re.findall(r"typedef\b[^;{(]*?\b(\w+)\s*(?:__attribute__[^;]*)?;", text)
               + re.findall(r"typedef\b[^;{]*?\b(\w+)\([^;]*;", text)
               + re.findall(r"^}\s*(\w+);", text, re.MULTILINE))


class Source:
    """The sites of a source. `sites` are in the order of their starts, outer ones first; `left_out`
    counts operators and numbers where nothing can be switched at run time."""

    def __init__(self, text, types=()):
        self.text = text
        self.types = set(types) | typedefs_of(text)
        self.tokens = tokens_of(text)
        self.partner = self.match()
        self.sites = []
        self.left_out = sum(t.kind == "number" or t.text in BECOMES for t in self.tokens)
        depth_end = 0
        for i, token in enumerate(self.tokens):
            if i >= depth_end and token.text == "{" and i in self.partner:
                depth_end = self.partner[i]
                if i > 0 and self.tokens[i - 1].text == ")":
                    self.function = self.tokens[self.partner[i - 1] - 1].text
                    self.visit_body(i + 1, depth_end)
        self.sites.sort(key=lambda s: (s.start, -s.end))

    def match(self):
        partner, open_ones = {}, []
        for i, token in enumerate(self.tokens):
            if token.kind == "sign" and token.text in PAIRS:
                open_ones.append(i)
            elif token.kind == "sign" and token.text in PAIRS.values() and open_ones:
                k = open_ones.pop()
                partner[i], partner[k] = k, i
        return partner

    def is_type(self, token):
        return token.kind == "word" and (token.text in TYPE_WORDS or token.text in self.types
                                         or TYPE_NAME.match(token.text) is not None)

    def is_cast(self, close):
        """Whether the parenthesis that ends there is a cast's."""
        first = self.partner.get(close)
        if self.tokens[close].text != ")" or first is None or not self.is_type(self.tokens[first + 1]):
            return False
        before = self.tokens[first - 1]
        return not (before.kind == "word" and before.text not in STOPS or before.text in (")", "]"))

    def is_binary(self, i):
        """Whether this is an operator between two operands."""
        token, before = self.tokens[i], self.tokens[i - 1]
        if token.kind != "sign" or token.text not in BINARY:
            return False
        if token.text not in ("+", "-", "*", "&"):
            return True
        if token.text == "*" and (self.is_type(before) or self.tokens[i + 1].text in ("const", "restrict")
                                  or self.tokens[i - 2].text in ("struct", "enum", "union")):
            return False
        if before.text == ")":
            return not self.is_cast(i - 1)
        return before.kind in ("number", "string") or before.text in ("]", "++", "--") or (
            before.kind == "word" and before.text not in STOPS and before.text != "sizeof")

    def left_of(self, i, level):
        """The first token of the left operand, if the operator binds as `level` says."""
        k = i - 1
        while k >= 0:
            token = self.tokens[k]
            if token.text in (")", "]") and k in self.partner:
                k = self.partner[k] - 1
                continue
            if token.text in ("(", "[", "{", "}", ";", ",", "?", ":") or token.text in ASSIGNMENTS or (
                    token.text in STOPS) or (self.is_binary(k) and BINARY[token.text] < level):
                break
            k -= 1
        return k + 1

    def right_of(self, i, level):
        """The token after the right operand. Level 0 is that of assignments: it takes in ?:, too."""
        k = i + 1
        while k < len(self.tokens):
            token = self.tokens[k]
            if token.text in ("(", "[") or (token.text == "{" and self.tokens[k - 1].text == ")"):
                k = self.partner[k] + 1
                continue
            if token.text in (")", "]", "{", "}", ";", ",") or (
                    level > 0 and (token.text in ("?", ":") or token.text in ASSIGNMENTS)) or (
                        self.is_binary(k) and BINARY[token.text] <= level):
                break
            k += 1
        return k

    def unary_end(self, i):
        """The token after the operand of the unary operator at i."""
        k = i + 1
        while self.tokens[k].text in ("-", "+", "!", "~", "*", "&", "++", "--") or (
                self.tokens[k].text == "(" and self.is_cast(self.partner[k])):
            k = self.partner[k] + 1 if self.tokens[k].text == "(" else k + 1
        k = self.partner[k] + 1 if self.tokens[k].text == "(" else k + 1
        while self.tokens[k].text in ("(", "[", ".", "->", "++", "--"):
            k = self.partner[k] + 1 if self.tokens[k].text in ("(", "[") else (
                k + 2 if self.tokens[k].text in (".", "->") else k + 1)
        return k

    def words(self, first, end):
        """The text from token `first` to the one before `end`, on one line and without comments."""
        text = ""
        for k in range(first, end):
            gap = k > first and self.tokens[k].start > self.tokens[k - 1].end
            text += " " * gap + self.tokens[k].text
        return text

    def add(self, first, end, at, mutations):
        if first < at or at + 1 < end or self.tokens[at].kind == "number":
            token = self.tokens[at]
            self.left_out -= token.kind == "number" or token.text in BECOMES
            self.sites.append(Site(self.tokens[first].start, self.tokens[end - 1].end,
                                   self.tokens[at].start, self.function, mutations))

    def visit_body(self, first, end):
        i = statement = first
        assigned = False
        while i < end:
            token = self.tokens[i]
            if token.text in (";", "{", "}"):
                statement, assigned = i + 1, False
            elif token.text == "=":
                assigned = True
            elif token.text == "static" or token.text == "case":
                while self.tokens[i].text not in (";", ":"):
                    i += 1
            elif token.text in CONSTANT:
                i = self.partner[i + 1]
            elif token.text == "[" and not assigned and self.is_type(self.tokens[statement]):
                i = self.partner[i]
            elif token.kind == "number":
                negative = self.tokens[i - 1].text == "-" and not self.is_binary(i - 1)
                beside = numbers_beside(token.text, token.start)
                self.add(i, i + 1, i, [b for b in beside if not (negative and b[0] == "-")])
            elif token.text == "?":
                self.visit_choice(i)
            elif token.text in ASSIGNMENTS and token.text[:-1] in BECOMES:
                left, right = self.left_of(i, 0), self.right_of(i, 0)
                self.add(left, right, i, ["%s %s= %s" % (self.words(left, i), other, self.words(i + 1, right))
                                          for other in BECOMES[token.text[:-1]]])
            elif self.is_binary(i):
                level = BINARY[token.text]
                left, right = self.left_of(i, level), self.right_of(i, level)
                self.add(left, right, i, ["%s %s %s" % (self.words(left, i), other, self.words(i + 1, right))
                                          for other in BECOMES[token.text]])
            elif token.text in ("-", "!", "~"):
                right = self.unary_end(i)
                self.add(i, right, i, [self.words(i + 1, right)])
            i += 1

    def visit_choice(self, i):
        left, k, depth = self.left_of(i, 0), i + 1, 1
        while depth > 0:
            if self.tokens[k].text in ("(", "[", "{"):
                k = self.partner[k]
            depth += {"?": 1, ":": -1}.get(self.tokens[k].text, 0)
            k += 1
        end = self.right_of(k - 1, 0)
        for m in range(k, end): # the last result may end at the colon of a choice around this one
            depth += {"?": 1, ":": -1}.get(self.tokens[m].text, 0)
            if depth < 0:
                end = m
                break
        self.add(left, end, i, ["%s ? %s : %s" % (self.words(left, i), self.words(k, end),
                                                  self.words(i + 1, k - 1))])

    def line_of(self, site):
        return self.text.count("\n", 0, site.at) + 1

    def rewrite(self, numbers):
        """The text with the mutations of `numbers`, {(site, index of its mutation): number}. Lines stay
        where they are. Later sites may lie inside of earlier ones."""
        chosen = [(site, [(numbers[k, m], text) for m, text in enumerate(site.mutations) if (k, m) in numbers])
                  for k, site in enumerate(self.sites)]
        chosen = [c for c in chosen if c[1]]
        return self.rewrite_span(0, len(self.text), chosen)

    def rewrite_span(self, start, end, chosen):
        out, at, k = [], start, 0
        while k < len(chosen):
            site, mutations = chosen[k]
            inner = k + 1
            while inner < len(chosen) and chosen[inner][0].start < site.end:
                inner += 1
            out.append(self.text[at:site.start])
            out.append("(" + "".join("scarp_rule_is(%d) ? (%s) : " % m for m in mutations) + "("
                       + self.rewrite_span(site.start, site.end, chosen[k + 1:inner]) + "))")
            at, k = site.end, inner
        out.append(self.text[at:end])
        return "".join(out)


def numbers_beside(text, place):
    """What a literal becomes."""
    hexadecimal = text[:2] in ("0x", "0X")
    is_float = "." in text or (hexadecimal and re.search("[pP]", text)) or (
        not hexadecimal and re.search("[eE]", text))
    if is_float:
        digits = text.rstrip("fFlL")
        suffix = text[len(digits):]
        if hexadecimal: # f may be a digit only before the exponent
            value = float.fromhex(digits)
        else:
            value = float(digits)
        if value == 0.0:
            return ["0.001" + suffix]
        more = value * 1.0001
        return [(more.hex() if hexadecimal else "%.9g" % more) + suffix, "-" + text]
    digits = text.rstrip("uUlL")
    suffix = text[len(digits):]
    value = int(digits, 16 if hexadecimal else 8 if digits[0] == "0" and len(digits) > 1 else 10)
    if hexadecimal:
        bits = 4 * (len(digits) - 2)
        return ["0x%x%s" % (value ^ 1 << zlib.crc32(b"%d" % place) % bits, suffix)]
    return ["%d%s" % (value + 1, suffix)] + (["%d%s" % (value - 1, suffix)] if value > 0 else [])
