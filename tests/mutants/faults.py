"""Chooses one-line faults in the sources of a checkout, by rule and seed.

A fault is named by its kind and by the text of its line, not by its place: a line that moves to another file or folder
of its group keeps its fault, and two states of the sources get faults that can be compared.
"""
import collections
import dataclasses
import hashlib
import os
import pathlib
import re

GROUPS = ('rendering', 'shaders', 'io', 'viewer')
SUFFIXES = {'.cpp', '.h', '.comp', '.frag', '.vert', '.glsl'}


@dataclasses.dataclass(frozen=True)
class Fault:
    group: str
    kind: str
    file: str  # relative to the checkout
    line: int  # from 1
    before: str  # the line without its newline
    after: str

    @property
    def text(self):
        return normalised(self.before)


def normalised(line):
    return ' '.join(re.sub(r'//.*', '', line).split())


# ---- Which text is code ----

_BLANK = re.compile(r'''//[^\n]*|/\*.*?\*/|R"(?P<mark>[^\s()\\"]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"'''
                    r'''|(?<![0-9A-Za-z_])(?:u8|[uUL])?'(?:\\.|[^'\\\n])+\'''', re.DOTALL)
_DIRECTIVE = re.compile(r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', re.MULTILINE)
_ASSERTION = re.compile(r'\b(?:static_assert|assert|Q_ASSERT|layout)\s*\(')
_ELSEWHERE = re.compile(r'#\s*if(?:def)?\b\s*(?:0\s*$|.*\b(?:_WIN32|_MSC_VER|__APPLE__)\b)')


def _blanked(match):
    text = match.group()
    if not text.startswith('/'):  # strings and characters stay visible as such
        return '"' + re.sub(r'[^\n]', '"', text[1:])
    return re.sub(r'[^\n]', ' ', text)


def code_of(source):
    """The source in its own places, with comments, directives and assertions blank and strings made of quotation marks."""
    code = _BLANK.sub(_blanked, source)
    directives = [(m.start(), m.group()) for m in _DIRECTIVE.finditer(code)]
    parts = list(code)

    def blank(start, end):
        parts[start:end] = [c if c == '\n' else ' ' for c in parts[start:end]]

    left_out = []  # for each open #if: where it starts, if no build compiles what it holds
    for start, text in directives:
        if re.match(r'\s*#\s*if', text):
            left_out.append(start if _ELSEWHERE.match(text.strip()) else None)
        elif re.match(r'\s*#\s*(else|elif|endif)', text) and left_out:
            if left_out[-1] is not None:
                blank(left_out[-1], start)
            if 'endif' in text:
                left_out.pop()
            else:
                left_out[-1] = None
        blank(start, start + len(text))
    for match in _ASSERTION.finditer(code):
        blank(match.start(), _closing(code, match.end() - 1) + 1)
    return ''.join(parts)


def _closing(code, start):
    """Where the bracket at `start` closes; the end of the code if nowhere."""
    depth = 0
    for i in range(start, len(code)):
        depth += (code[i] in '([{') - (code[i] in ')]}')
        if depth == 0:
            return i
    return len(code) - 1


# ---- Kinds: each finds its places in a line, as (start, end, replacement) ----

_TYPE_BEFORE = re.compile(r'(?:[\w>&*]\s+)\w+$')
_KEYWORD_BEFORE = re.compile(r'\b(?:return|case|else|in|and|or|not)\s+\w+$')


def _declares(code, bracket):
    """Whether the bracket is the size of an array that is declared: `float x[3]`, `float[3](…)`."""
    before = code[:bracket]
    if re.search(r'\b(?:float|u?int|[iu]?vec\d|double|char|auto&*|auto&&|new \w+|delete|operator)\s*$', before):
        return True
    return bool(_TYPE_BEFORE.search(before)) and not _KEYWORD_BEFORE.search(before)


def signs(code, _):
    for match in re.finditer(r'(?<![-+"\w.])(?<!" )([-+])(=?)(?![-+>="])(?! ")|(?<=[\w)\]])([-+])(?=[\w(])(?!\+|-|>)', code):
        sign = match.group(1) or match.group(3)
        before = code[:match.start()]
        if re.search(r'\d\.?\d*[eE]$', before) or re.search(r'operator\s*$', before):
            continue
        at = match.start()
        yield at, at + 1, '-' if sign == '+' else '+'


def bounds(code, _):
    if re.match(r'\s*template\b', code):
        return
    for match in re.finditer(r'(?<= )(<=|>=|<|>)(?= )', code):
        sign = match.group()
        yield match.start(), match.end(), sign[0] if len(sign) == 2 else sign + '='


def indices(code, _):
    for match in re.finditer(r'(?<=[\w)\]])\.([xyzw])\b(?!\s*=[^=])', code):
        yield match.start() + 1, match.end(), {'x': 'y', 'y': 'x', 'z': 'y', 'w': 'z'}[match.group(1)]
    for match in re.finditer(r'(?<=[\w)\]])\[(?=[^\]\["])', code):
        end = _closing(code, match.start())
        inside = code[match.end():end]
        if code[end] == ']' and '"' not in inside and not _declares(code, match.start()):
            yield end, end, ' + 1'


def constants(code, text):
    for match in re.finditer(r"(?<![\w.])(?:0[xX][\da-fA-F']+|(?:\d[\d']*\.?[\d']*|\.\d+)(?:[eE][-+]?\d+)?)(\w*)", code):
        before, after = code[:match.start()], code[match.end():]
        bracket = before.rfind('[')
        if re.search(r'[\w>]<$|[\w>]<[\w:]+, $', before) or re.match(r'>', after):  # arguments of templates
            continue
        if bracket >= 0 and ']' not in before[bracket:] and _declares(code, bracket):
            continue
        changed = _changed(match.group(), text)
        if changed:
            yield match.start(), match.end(), changed


def _changed(literal, text):
    if re.match(r'0[xX]', literal):
        digits = re.match(r"0[xX][\da-fA-F']+", literal).group()
        return f"0x{int(digits.replace(chr(39), ''), 16) + 1:x}" + literal[len(digits):]
    digits = re.match(r"[\d'.]+(?:[eE][-+]?\d+)?", literal).group()
    suffix, plain = literal[len(digits):], digits.replace("'", '')
    if re.search(r'[.eE]', plain):
        value = float(plain)
        changed = format(value * 1.01, '.9g')
        return None if value == 0.0 else (changed if re.search(r'[.e]', changed) else changed + '.0') + suffix
    value = int(plain, 8 if re.fullmatch(r'0[0-7]+', plain) else 10)
    up = value == 0 or _hash('step', text, literal) % 2 == 0
    return str(value + 1 if up else value - 1) + suffix


_NO_STATEMENT = re.compile(r'\s*(?:return|break|continue|goto|throw|using|typedef|delete|case|default|co_\w+)\b')
_CHAIN = re.compile(r'\s*(?:emit\s+)?(?:\+\+|--|\*)?(?P<head>[A-Za-z_]\w*)(?P<rest>(?:(?:::|\.|->)\s*~?\w+|\(\)|\[\])*)'
                    r'\s*(?P<end>\(\)|(?:[-+*/%&|^]|<<|>>)?=[^=].*|\+\+|--)?;\s*$')


def dropped(code, _):
    """A whole statement: an assignment, a call or a step. Brackets are emptied first, so that a chain is seen as one."""
    if _NO_STATEMENT.match(code) or code.count('(') != code.count(')') or code.count('{') != code.count('}'):
        return
    plain = code
    while True:
        shorter = re.sub(r'\(([^()\[\]{}]+)\)|\[[^()\[\]{}]+\]|\{[^()\[\]{}]*\}',
                         lambda m: {'(': '()', '[': '[]', '{': ''}[m.group()[0]], plain)
        if shorter == plain:
            break
        plain = shorter
    match = _CHAIN.match(plain)
    if not match:
        return
    makes = match['head'][0].isupper() and not re.search(r'::|\.|->', match['rest'])  # a constructor or a macro
    acts = '()' in match['rest'] or match['end'] or re.match(r'\s*(?:\+\+|--)', plain)
    if acts and not (makes and '()' in match['rest']):
        indent = len(code) - len(code.lstrip())
        yield indent, len(code.rstrip()), ''


KINDS = {'sign': signs, 'bound': bounds, 'index': indices, 'constant': constants, 'dropped line': dropped}


# ---- From files to faults ----

def group_of(path):
    top = path.split('/')[0]
    if path.startswith('rendering/shaders/'):
        return 'shaders'
    return top if top in GROUPS else None


def sources_of(checkout):
    for top in ('rendering', 'io', 'viewer'):
        for folder, folders, files in os.walk(pathlib.Path(checkout) / top):
            folders.sort()
            for name in sorted(files):
                if pathlib.PurePath(name).suffix in SUFFIXES:
                    yield pathlib.Path(folder, name).relative_to(checkout).as_posix()


def has_bodies(path, code):
    """Headers without a function's body only declare."""
    return not path.endswith('.h') or bool(re.search(r'\)\s*(?:const\s*)?(?:noexcept\s*)?(?:override\s*)?\{\s*\S', code))


def faults_of_file(checkout, path):
    source = (pathlib.Path(checkout) / path).read_text(encoding='utf-8')
    code = code_of(source)
    if not has_bodies(path, code):
        return
    lines, ended = source.split('\n'), True
    for number, (line, visible) in enumerate(zip(lines, code.split('\n')), 1):
        if not visible.strip():
            continue
        text = normalised(line)
        for kind, places in KINDS.items():
            if kind == 'dropped line' and not ended:
                continue
            changes = sorted(places(visible, text))
            if changes:
                start, end, new = changes[_hash('place', kind, text) % len(changes)]
                yield Fault(group_of(path), kind, path, number, line, (line[:start] + new + line[end:]).rstrip())
        ended = visible.rstrip()[-1] in ';{}'


def _hash(*words):
    return int.from_bytes(hashlib.sha256('\0'.join(map(str, words)).encode()).digest()[:8], 'big')


def candidates(checkout, seed, count):
    """For each of `count` faults its candidates, best first: group after group and kind after kind in turn. Where a fault
    does not compile the next one takes its place; no two of the lists share a candidate."""
    cells = [(GROUPS[k % len(GROUPS)], list(KINDS)[k // len(GROUPS) % len(KINDS)]) for k in range(count)]
    found = collections.defaultdict(dict)
    paths = sorted(sources_of(checkout), key=lambda path: (pathlib.PurePath(path).name, path))
    for path in paths:
        for fault in faults_of_file(checkout, path):
            # A line that stands there several times is one candidate, at its first place by the file's name.
            found[fault.group, fault.kind].setdefault(fault.text, fault)
    ordered = {cell: sorted(faults.values(), key=lambda f: _hash(seed, f.group, f.kind, f.text))
               for cell, faults in found.items()}
    return [ordered.get(cell, [])[cells[:k].count(cell)::cells.count(cell)] for k, cell in enumerate(cells)]
