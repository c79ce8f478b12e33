# SPDX-License-Identifier: MIT
"""Reads the part of C that formulas and shaders are written in: text becomes trees with types.

src/formulas/c.h describes that part. Whatever is outside of it raises Refused, with file and line:
the shading languages either lack it or mean something else by it.
"""
import re
from collections import namedtuple

TOKEN = re.compile(r"""(?P<comment>/\*.*?\*/)|(?P<directive>^\#(?:[^\n/]|/(?!\*))*)|
    (?P<number>\.?\d(?:0?[xX][\da-fA-F.]+|[\w.])*(?:(?<=[eEpP])[+-]\w+)?)|(?P<name>[A-Za-z_]\w*)|
    (?P<op>->|\+\+|--|<<=|>>=|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[-+*/%&|^~!<>=?:;,.(){}\[\]])|
    (?P<blank>\n\s*\n)|(?P<space>\s+)|(?P<other>.)""", re.X | re.M | re.S)
NUMBERS = {"float": r"(\d+\.\d*|\.\d+)(e[-+]?\d+)?f|0[xX][\da-fA-F.]+p[-+]?\d+f",
           "uint": r"(0[xX][\da-fA-F]+|\d+)u", "int": r"0[xX][\da-fA-F]+|\d+"}

# Binary operators by their rank; assignments stand apart.
LEVELS = [["||"], ["&&"], ["|"], ["^"], ["&"], ["==", "!="], ["<", "<=", ">", ">="], ["<<", ">>"],
          ["+", "-"], ["*", "/", "%"]]
RANK = {operator: rank for rank, level in enumerate(LEVELS) for operator in level}
ASSIGNMENTS = ("=", "+=", "-=", "*=", "&=", "|=", "^=")
NEGATIONS = {"-": ("float", "int"), "!": ("bool",), "~": ("int", "uint")}

ZEROS = {"float": "0.0f", "int": "0", "uint": "0u", "bool": "false"}
SCALARS = tuple(ZEROS)
VECTORS = {"vec3": dict.fromkeys("xyz", "float"), "uvec3": dict.fromkeys("xyz", "uint"),
           "vec4": dict.fromkeys("xyzw", "float")}
CASTS = {("int", "float"), ("uint", "float"), ("float", "int"), ("uint", "int"), ("int", "uint")}

# Words of GLSL, HLSL or WGSL that C leaves to names of variables and members
RESERVED = frozenset("""
    active alias as asm async attribute auto await become buffer cast centroid class coherent common
    compile crate demote diagnostic discard double enable export extends extern external filter
    final fixed flat fn from get half handle highp impl implements import in inout input interface
    invariant let line linear lowp macro match matrix mediump meta mod module move mut namespace new
    noinline null of out output override partition pass patch pixelshader point precise precision
    premerge priv protected pub readonly ref register resource sample sampler self set shared smooth
    snorm std string subroutine super superp target technique template texture this triangle try
    undef uniform unless unorm use using varying vector vertexshader virtual where with writeonly
    yield""".split())


class Refused(Exception):
    """What is outside of the part of C: file, line, and why."""


# An expression; its text is a name, an operator or a number, its parts are operands
Tree = namedtuple("Tree", "kind type text parts in_parentheses", defaults=("", (), False))

# What stands in files, structures and blocks. A comment beside code stands behind it on its line.
# The value of a member is the length of an array. Operators of assignments are =, ++ and --. The
# branches of an if are pairs of a condition, which is None for the last else, and a block.
Comment = namedtuple("Comment", "text is_beside", defaults=(False,))
Declare = namedtuple("Declare", "type name value is_const", defaults=(None, False))
Assign = namedtuple("Assign", "target operator value", defaults=(None,))
Return = namedtuple("Return", "value")
If = namedtuple("If", "branches")
For = namedtuple("For", "start condition step body")
Define = namedtuple("Define", "name value")
Struct = namedtuple("Struct", "name members")
Function = namedtuple("Function", "type name parameters body")

BLANK = Comment("")


def number(text):
    """A number as an expression, or None."""
    for type_, pattern in NUMBERS.items():
        if re.fullmatch(pattern, text):
            return Tree("number", type_, text)
    return None


class Known:
    """What the files that are read so far declare."""

    def __init__(self):
        self.structs = {name: dict(members) for name, members in VECTORS.items()}
        self.functions = {}  # by name: the type of the result, and those of the parameters
        self.constants = {}
        self.values = {"true": "bool", "false": "bool"}


class Source:
    """Reads one file; `known` has what those before it declare, and gets what this one does."""

    def __init__(self, path, known):
        self.path, self.known = path, known
        self.at, self.tokens, self.scopes, self.result = 0, [], [], None
        line, end = 1, 0
        text = path.read_text()
        for m in TOKEN.finditer(text):
            kind = m.lastgroup
            behind = self.tokens and self.tokens[-1][0] not in ("comment", "beside", "blank")
            if kind == "comment" and behind and "\n" not in text[end:m.start()]:
                kind = "beside"
            if kind != "space":
                self.tokens.append((kind, m.group(), line))
                end = m.end()
            line += m.group().count("\n")
        self.tokens.append(("end", "the end of the file", line))

    # Tokens

    def refuse(self, why):
        raise Refused(f"{self.path}:{self.tokens[self.at][2]}: {why}")

    def between(self):
        """The comments and empty lines that come next."""
        found = []
        while self.tokens[self.at][0] in ("comment", "beside", "blank"):
            kind, text, _ = self.tokens[self.at]
            found.append(BLANK if kind == "blank" else Comment(text, kind == "beside"))
            self.at += 1
        return found

    def peek(self, ahead=0):
        """The kind and the text of a token that comes next, or the one after, and so on."""
        for kind, text, _ in self.tokens[self.at:]:
            if kind not in ("comment", "beside", "blank"):
                if ahead == 0:
                    break
                ahead -= 1
        return kind, text

    def next(self, ahead=0):
        return self.peek(ahead)[1]

    def take(self, *wanted):
        """Takes the next token; comments inside of statements get lost."""
        kind, text = self.peek()
        if wanted and text not in wanted or kind == "end":
            self.refuse(f"{' or '.join(wanted) or 'more'} is wanted, not {text}")
        self.between()
        self.at += 1
        return text

    def name(self):
        kind, text = self.peek()
        if kind != "name":
            self.refuse(f"a name is wanted, not {text}")
        return self.take()

    def new_name(self):
        """The name of a variable, a parameter or a member."""
        if self.next() in RESERVED:
            self.refuse(f"{self.next()} is a word of a shading language")
        return self.name()

    # Types

    def is_type(self):
        return self.next() in ("const", "struct", *SCALARS, *VECTORS)

    def type(self):
        name = self.take()
        if name == "struct":
            name = self.name()
        elif name not in SCALARS and name not in VECTORS:
            self.refuse(f"{name} is no type that shaders have")
        if name not in SCALARS and name not in self.known.structs:
            self.refuse(f"struct {name} is unknown")
        if self.next() == "*":
            self.refuse("shaders have no pointers")
        return name

    def suited(self, type_, tree):
        """An expression of the type that is wanted. Of those that are not, only whole numbers
        become one, and only where that is uint."""
        if tree.type == type_:
            return tree
        if type_ == "uint" and tree.type == "int" and tree.kind == "number":
            return Tree("number", "uint", tree.text + "u")
        return self.refuse(f"{type_} is wanted, not {tree.type}: no type becomes another unasked")

    def agreed(self, a, b):
        """Two operands of one type."""
        if a.type == "int" and a.kind == "number":
            return self.suited(b.type, a), b
        return a, self.suited(a.type, b)

    # Expressions

    def expression(self):
        tree = self.binary(0)
        if self.next() != "?":
            return tree
        self.take()
        yes = self.expression()
        self.take(":")
        yes, no = self.agreed(yes, self.expression())
        if yes.type not in ("float", "int", "uint"):
            self.refuse(f"?: chooses numbers, not {yes.type}: write an if")
        return Tree("pick", yes.type, "?", [self.suited("bool", tree), yes, no])

    def binary(self, level):
        if level == len(LEVELS):
            return self.unary()
        left = self.binary(level + 1)
        while self.next() in LEVELS[level]:
            left = self.joined(self.take(), left, self.binary(level + 1))
        return left

    def joined(self, operator, a, b):
        rank = RANK[operator]
        if rank < 2:
            a, b = self.suited("bool", a), self.suited("bool", b)
            return Tree("binary", "bool", operator, [a, b])
        if operator in ("<<", ">>"):
            b = self.suited("uint", b)
        else:
            a, b = self.agreed(a, b)
        if a.type not in ("float", "int", "uint"):
            self.refuse(f"shaders have no {operator} of {a.type}")
        if a.type == "float" and operator == "/":
            self.refuse("shaders only approximate the quotient of floats: use inverse()")
        if a.type == "float" and operator in ("%", "<<", ">>", "&", "|", "^"):
            self.refuse(f"shaders have no {operator} of float")
        return Tree("binary", "bool" if 5 <= rank <= 6 else a.type, operator, [a, b])

    def unary(self):
        if self.next() in ("-", "!", "~"):
            operator, operand = self.take(), self.unary()
            if operand.type not in NEGATIONS[operator]:
                self.refuse(f"shaders have no {operator} of {operand.type}")
            return Tree("unary", operand.type, operator, [operand])
        if self.next() == "(" and self.next(1) in SCALARS:
            self.take()
            type_ = self.take()
            self.take(")")
            operand = self.unary()
            if (operand.type, type_) not in CASTS:
                self.refuse(f"shaders do not convert {operand.type} to {type_}")
            return Tree("cast", type_, "", [operand])
        return self.postfix()

    def postfix(self):
        tree = self.primary()
        while self.next() in (".", "["):
            if self.take() == ".":
                member = self.name()
                if member not in self.known.structs.get(tree.type, ()):
                    self.refuse(f"{tree.type} has no member {member}")
                tree = Tree("member", self.known.structs[tree.type][member], member, [tree])
            else:
                index = self.expression()
                self.take("]")
                if not tree.type.endswith("[]") or index.type not in ("int", "uint"):
                    self.refuse(f"{tree.type} has no element {index.type}")
                tree = Tree("index", tree.type[:-2], "", [tree, index])
        return tree

    def primary(self):
        kind, text = self.peek()
        if text == "(":
            self.take()
            tree = self.expression()
            self.take(")")
            return tree._replace(in_parentheses=True)
        if kind == "number":
            return self.number()
        name = self.name()
        if self.next() == "(":
            return self.call(name)
        for scope in reversed(self.scopes):
            if name in scope:
                return Tree("name", scope[name][0], name)
        for kind, types in (("name", self.known.values), ("constant", self.known.constants)):
            if name in types:
                return Tree(kind, types[name], name)
        return self.refuse(f"{name} is unknown")

    def number(self):
        text = self.take()
        tree = number(text)
        if tree is None:
            self.refuse(f"{text} is no float, uint or int: floats end with f")
        return tree

    def call(self, name):
        if name not in self.known.functions:
            self.refuse(f"{name}() is unknown")
        type_, wanted = self.known.functions[name]
        arguments = []
        self.take("(")
        while self.next() != ")":
            if arguments:
                self.take(",")
            arguments.append(self.expression())
            if len(arguments) <= len(wanted):
                arguments[-1] = self.suited(wanted[len(arguments) - 1], arguments[-1])
        if len(arguments) != len(wanted):
            self.refuse(f"{name}() takes {len(wanted)} arguments, not {len(arguments)}")
        self.take(")")
        return Tree("call", type_, name, arguments)

    def initialiser(self, type_):
        """A structure or a vector in braces, with all members in order: what is left out is 0."""
        members = self.known.structs.get(type_, {})
        names, given, at = list(members), {}, 0
        self.take("{")
        while self.next() != "}":
            is_named = self.next() == "."
            if is_named:
                at = self.designated(type_, names)
            if at == len(names) or names[at] in given:
                self.refuse(f"{type_} is initialised with too many numbers, or twice")
            given[names[at]] = self.initial(members[names[at]], is_named)
            at += 1
            if self.next() != "}":
                self.take(",")
        self.take("}")
        return Tree("braces", type_, "", [given.get(name) or self.zero(members[name])
                                          for name in names])

    def designated(self, type_, names):
        """The number of the member that comes next with its dot."""
        self.take(".")
        member = self.name()
        if member not in names:
            self.refuse(f"{type_} has no member {member}")
        return names.index(member)

    def initial(self, type_, is_named):
        """The value of a member. Behind its name may come a member of it, which alone is not 0."""
        if is_named and self.next() == ".":
            members = self.known.structs.get(type_, {})
            parts = [self.zero(of) for of in members.values()]
            at = self.designated(type_, list(members))
            parts[at] = self.initial(list(members.values())[at], True)
            return Tree("braces", type_, "", parts)
        if is_named:
            self.take("=")
        if self.next() == "{":
            return self.initialiser(type_)
        return self.suited(type_, self.expression())

    def zero(self, type_):
        if type_ in ZEROS:
            return Tree("name" if type_ == "bool" else "number", type_, ZEROS[type_])
        if type_.endswith("[]"):
            self.refuse("braces initialise no arrays")
        members = self.known.structs[type_].values()
        return Tree("braces", type_, "", [self.zero(of) for of in members])

    # Statements

    def declare(self):
        """Declarations to the semicolon."""
        is_const = self.next() == "const"
        if is_const:
            self.take()
        type_, declared = self.type(), []
        while not declared or self.take(",", ";") == ",":
            name, value = self.new_name(), None
            if self.next() == "=":
                self.take()
                value = self.initial(type_, False)
            if is_const and value is None:
                self.refuse(f"{name} is constant and has no value")
            self.scopes[-1][name] = (type_, is_const)
            declared.append(Declare(type_, name, value, is_const))
        return declared

    def assign(self):
        """An assignment, without its semicolon."""
        target = self.postfix()
        root = target
        while root.kind in ("member", "index"):
            root = root.parts[0]
        fixed = next((scope[root.text][1] for scope in reversed(self.scopes) if root.text in scope),
                     True)
        if root.kind != "name" or fixed:
            self.refuse("only variables change: neither constants nor parameters")
        operator = self.take(*ASSIGNMENTS, "++", "--")
        if operator in ("++", "--"):
            if target.type not in ("int", "uint"):
                self.refuse(f"{operator} is for whole numbers, not {target.type}")
            return Assign(target, operator)
        value = self.expression()
        if operator != "=":
            value = self.joined(operator[0], target, value)
        return Assign(target, "=", self.suited(target.type, value))

    def condition(self):
        self.take("(")
        tree = self.suited("bool", self.expression())
        self.take(")")
        return tree

    def block(self):
        self.take("{")
        self.scopes.append({})
        found = self.between()
        while self.next() != "}":
            found += self.statement()
            found += self.between()
        self.take("}")
        self.scopes.pop()
        return found

    def statement(self):
        first = self.next()
        if self.is_type():
            return self.declare()
        if first == "if":
            return [self.if_()]
        if first == "for":
            return [self.for_()]
        if first in ("while", "do", "switch", "break", "continue", "goto"):
            self.refuse(f"shaders are written without {first}")
        if first == "return":
            self.take()
            statement = Return(self.suited(self.result, self.expression()))
        else:
            statement = self.assign()
        self.take(";")
        return [statement]

    def if_(self):
        branches = []
        while True:
            self.take("if")
            condition = self.condition()
            branches.append((condition, self.block()))
            if self.next() != "else":
                return If(branches)
            self.take()
            if self.next() != "if":
                branches.append((None, self.block()))
                return If(branches)

    def for_(self):
        self.take("for")
        self.take("(")
        self.scopes.append({})
        start = self.declare()
        if len(start) != 1 or start[0].value is None:
            self.refuse("a loop has one variable, with a value")
        condition = self.suited("bool", self.expression())
        self.take(";")
        step = self.assign()
        self.take(")")
        loop = For(start[0], condition, step, self.block())
        self.scopes.pop()
        return loop

    # Files

    def directive(self):
        """A line that begins with #: a constant, or None for what only C needs."""
        text = self.next().rstrip()
        m = re.fullmatch(r"#define (\w+) (\S+)", text)
        value = number(m[2]) if m else None
        if value:
            self.take()
            self.known.constants[m[1]] = value.type
            return Define(m[1], value)
        if not re.match(r"#(ifndef|define) \w+_H$|#include \"|#endif$", text):
            self.refuse("shaders have no directive but #define of a number")
        self.take()
        return None

    def struct(self):
        self.take("struct")
        name = self.name()
        self.take("{")
        members = self.between()
        types = self.known.structs[name] = {}
        while self.next() != "}":
            type_, separator = self.type(), ","
            while separator == ",":
                member, length = self.new_name(), None
                if self.next() == "[":
                    self.take()
                    length = self.suited("int", self.number())
                    self.take("]")
                members.append(Declare(type_, member, length))
                types[member] = type_ + ("[]" if length else "")
                separator = self.take(",", ";")
            members += self.between()
        self.take("}")
        self.take(";")
        return Struct(name, members)

    def function(self):
        """A function; it is known behind its end, so that none calls itself."""
        self.take("static")
        self.take("inline")
        self.result, name, parameters = self.type(), self.name(), []
        self.scopes = [{}]
        self.take("(")
        if self.next() == "void":
            self.take()
        while self.next() != ")":
            if parameters:
                self.take(",")
            parameters.append(Declare(self.type(), self.new_name()))
            self.scopes[0][parameters[-1].name] = (parameters[-1].type, True)
        self.take(")")
        function = Function(self.result, name, parameters, self.block())
        self.known.functions[name] = (self.result, [p.type for p in parameters])
        return function

    def file(self):
        """All that the file has, in order."""
        found = self.between()
        while self.tokens[self.at][0] != "end":
            if self.peek()[0] == "directive":
                found += filter(None, [self.directive()])
            elif self.next() == "struct" and self.next(2) == "{":
                found.append(self.struct())
            else:
                found.append(self.function())
            found += self.between()
        return found
