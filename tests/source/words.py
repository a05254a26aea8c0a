#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the English of comments, messages, manual pages and Markdown.

    words.py --check             fails if a count exceeds the baseline (default)
    words.py --write             lowers the baseline to the present counts
    words.py --table             counts per rule and kind of text
    words.py --list [PATH ...]   every hit in files or folders, with its advice
    words.py --sample N          N random hits of each rule (--seed K)

--rule NAME,... and --kind KIND,... restrict the last three.  The rules are in
tools/STYLE.md; each is a regular expression or a function of one sentence.
Kinds: head (first comment of a source file), comment (the others), message
(strings of at least four words), man, md, test (comments of tests).

The baseline, words.baseline, has one line per folder, kind and rule: "FOLDER
KIND RULE COUNT".  A count without a line must be zero.  Of lines for the same
count the lowest holds, and lines of another form are ignored, so that merged
or conflicting versions of the file can be read; --write cleans them.
"""
import argparse
import collections
import glob
import os
import random
import re
import sys

BASELINE = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        "words.baseline")
# Ends a sentence, where letters alone do not show it.
END = "\1"
# Quote the mistakes that they advise against.
EXEMPT = ("tools/STYLE.md", "tools/GLOSSARY.md")

# ---------------------------------------------------------------- extraction


def c_tokens(text):
    """Comments and string literals of C: (kind, offset, text)."""
    pattern = re.compile(
        r"/\*.*?(?:\*/|\Z)|//[^\n]*|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])*'",
        re.S)
    for match in pattern.finditer(text):
        token = match.group()
        if token.startswith("/"):
            yield "comment", match.start(), token
        elif token.startswith('"'):
            yield "string", match.start(), token


def comment_text(comment, paragraphs):
    """Text of a comment without stars, and without lines of formulas."""
    comment = re.sub(r"^/\*+|\*+/$|^//", "", comment)
    lines = [re.sub(r"^\s*\*? ?", "", line) for line in comment.split("\n")]
    kept = []
    for k, line in enumerate(lines):
        if k and line.startswith("   ") and \
                not re.match(r"\s*[A-Za-z]+ [a-z]+ [a-z]+", line):
            continue
        # A paragraph and an item of a list end the sentence before them.
        if paragraphs and kept and (
                not line.strip() or
                re.match(r"\s*(\d+\.|-)\s+[A-Za-z]", line)):
            kept.append(END)
            line = re.sub(r"^\s*(\d+\.|-)\s+", "", line)
        kept.append(line)
    text = re.sub(r"\s+", " ", " ".join(kept))
    if paragraphs:
        text = re.sub(r"(?<=[0-9])\. (?=[A-Z][a-z])", "." + END, text)
    return re.sub("( ?" + END + ")+ ?", END, text).strip(" -" + END)


def texts_of_c(path, test):
    """(kind, line, text, whether a comment has its line to itself)."""
    with open(path, errors="replace") as file:
        text = file.read()

    def line_of(offset):
        return text.count("\n", 0, offset) + 1

    heads = 0
    strings = None  # adjacent literals, which the compiler joins
    for kind, start, token in c_tokens(text):
        if kind == "string":
            if strings and re.fullmatch(r"(\s|PRI\w+|\\\n)*",
                                        text[strings[1]:start]):
                strings[2] += token[1:-1]
                strings[1] = start + len(token)
                continue
            if strings and not test:
                yield "message", line_of(strings[0]), strings[2], True
            strings = [start, start + len(token), token[1:-1]]
            continue
        if re.match(r"/\* -{9}", token):
            continue  # the title of a section
        words = comment_text(token, not test)
        if "SPDX" in words or len(words.split()) < 2:
            continue
        first = not re.sub(r"/\*.*?\*/|//[^\n]*|\s", "", text[:start],
                           flags=re.S)
        head = first and not heads
        heads += head
        own = not text[text.rfind("\n", 0, start) + 1:start].strip()
        yield ("test" if test else "head" if head else "comment",
               line_of(start), words, own)
    if strings and not test:
        yield "message", line_of(strings[0]), strings[2], True


def texts_of_man(path):
    paragraph, start, verbatim = [], 0, False

    def take():
        joined = re.sub(r"\s+", " ", " ".join(paragraph)).strip()
        paragraph.clear()
        return [("man", start, joined, True)] if joined else []

    def add(line):
        # A sentence of a manual page ends at the end of a line.
        paragraph.append(line + END if re.search(r"[^.][.]$", line)
                         else line)

    with open(path) as file:
        for number, line in enumerate(file, 1):
            line = line.rstrip("\n")
            if re.match(r"\.(EX|nf|TS)\b", line):
                verbatim = True
            elif re.match(r"\.(EE|fi|TE)\b", line):
                verbatim = False
                continue
            if verbatim:
                continue
            if re.match(r"\.(SH|SS|TP|TQ|PP|RS|RE|br|in)\b", line):
                yield from take()
                continue
            macro = re.match(r"\.([BIR]{1,2})\s+(.*)", line)
            if macro:
                parts = [part.strip('"') for part in
                         re.findall(r'"[^"]*"|\S+', macro.group(2))]
                line = ("" if len(macro.group(1)) == 2 else " ").join(parts)
            elif line.startswith((".", "'")):
                continue
            line = re.sub(r"\\f.|\\&|\\c", "", line).replace("\\-", "-")
            line = line.replace("\\ ", " ").replace("\\(aq", "'")
            if not paragraph:
                start = number
            add(line)
    yield from take()


def texts_of_md(path):
    verbatim, paragraph, start = False, [], 0

    def take():
        joined = " ".join(paragraph)
        paragraph.clear()
        return [("md", start, joined, True)] if joined else []

    with open(path) as file:
        for number, line in enumerate(file, 1):
            if line.startswith("```"):
                verbatim = not verbatim
                continue
            if verbatim or line.startswith("    ") and not paragraph:
                continue
            if not line.strip() or line.startswith(("#", "|", "-", "*")):
                yield from take()
                if line.startswith("|"):
                    for cell in line.split("|"):
                        if len(cell.split()) >= 4:
                            yield "md", number, cell.strip(), True
                    continue
            if line.strip() and not line.startswith("#"):
                if not paragraph:
                    start = number
                paragraph.append(line.strip())
    yield from take()


def texts(root):
    """(path, kind, line, text, own) of everything that is checked."""
    for folder in ("src", "include", "tests"):
        for path in sorted(glob.glob(f"{root}/{folder}/**/*.[ch]",
                                     recursive=True)):
            for entry in texts_of_c(path, folder == "tests"):
                yield (os.path.relpath(path, root), *entry)
    for path in sorted(glob.glob(f"{root}/src/*/overroll*.[1-9]")):
        for entry in texts_of_man(path):
            yield (os.path.relpath(path, root), *entry)
    for path in ["README.md", "CHANGELOG.md"] + sorted(
            os.path.relpath(path, root) for path in
            glob.glob(f"{root}/tools/**/*.md", recursive=True)):
        if path not in EXEMPT:
            for entry in texts_of_md(os.path.join(root, path)):
                yield (path, *entry)


def sentences(text):
    return [part.strip() for whole in text.split(END) for part in re.split(
        r'(?<=[a-z)\]][.!?])\s+(?=[A-Z\[`"])', whole) if part.strip()]


# --------------------------------------------------------------------- rules

# Each: whether it is an error, the advice, a function of (sentence, kind,
# whether it is the first of its text, whether a comment has its line alone).
RULES = collections.OrderedDict()


def rule(name, error, advice, pattern, flags=re.I, kinds=None, first=False):
    compiled = re.compile(pattern, flags)

    def hit(sentence, kind, is_first, _own):
        return bool((not kinds or kind in kinds) and (is_first or not first)
                    and compiled.search(sentence))

    RULES[name] = (error, advice, hit)


# What a term of this project is called in the field (tools/GLOSSARY.md).
TERMS = {
    r"(smallest|thinnest) films?": "minimum film thickness",
    r"largest pressures?": "maximum pressure",
    r"central film(?! thick| constr)": "central film thickness",
    r"minimum film(?! thick)": "minimum film thickness",
    r"foreseen|foretell\w*|foresees?": "predicted, estimate",
    r"on metal|metal bears|of metal bears|what metal":
        "asperity load share, carried by asperity contact",
    r"surfaces? (that|which) touch|where surfaces touch|what touches":
        "asperity contact, mixed lubrication",
    r"errors? of (the )?discretization|discretisation":
        "discretization error",
    r"(?<!\w)\d* ?meshes (wide|thick|apart|deep|of|a|longer|below)|\bmeshes\b":
        "mesh sizes, grid intervals, grids",
    r"(wet|dry) nodes?|nodes? (is|are) (wet|dry)|\bwet or dry\b":
        "pressurized (full-film), cavitated node",
    r"(right|good) to \d": "accurate to within",
    r"dry contact of Hertz|contact of Hertz": "Hertzian (dry) contact",
    r"inlet.{0,12}farther out|farther out": "further upstream",
    r"\bturning speeds?\b": "rotational speed",
    r"\bspots (and|of|settle)\b": "local Newton window",
    r"\bhollow\b": "concave",
    r"half turns?\b": "half revolution",
    r"(the )?whole way\b|[a-z] of way\b|way of the contact|at the way R1|"
    r"on its way, which": "path of contact, distance travelled",
    r"\bshots?\b": "snapshot",
    r"\bto and fro\b": "reciprocating, oscillating",
}
rule("term", True, "use the term of the field (tools/GLOSSARY.md)",
     r"\b(?:" + "|".join(TERMS) + r")")
rule("tell-say", True, "print, report, return, state, specify, warn",
     r"\b(is|are|was|were|be|been|not) (told(?! apart)|said)\b|"
     r"\b(tells?|says?) (of|the|a|an|what|where|how|which|it|so|that|all|its|"
     r"more|when|why|whether|no)\b|^(Tells?|Says?)\b|"
     r"\bwho (is|gives|has)\b")
rule("odd-verb", True, "stands: is stored, appears; comes, goes: arrives, "
     "passes, is written; takes: uses, needs, accepts",
     r"\b(stands? (in|at|on|there|beside|above|below|here)|goes on\b|"
     r"gone on|goes (by|with|out|to)\b|(is|are) come to|"
     r"comes? (in|to|by|out|with|on top)\b|takes? (of|off|what|this|so)|"
     r"lives? off|lets? \w+ (through|see)|gives? way|makes? of\b|"
     r"brings? (in|on|along)|would do\b|that does\b|does without)")
rule("person", False,
     "programs and nodes do not want, know, speak, see, live or die",
     r"\b(wants?|knows? (no|nothing|of|what|where|how|it)|speaks?|nobody|"
     r"anybody|somebody|lives? (in|on)|dies? of|does harm|do(es)? no harm|"
     r"harms?|forgets?|remembers?|believed?|trusted?)\b")
rule("inverted", False, "put the subject first",
     r"^(Of (?!course)|By (?!default)|Behind|Beside|Among) ?[^.]{1,70}?\b"
     r"(is|are|was|were|has|have|had|goes|stands?|comes?|counts?|gives?|"
     r"takes?|needs?|must|may|can|nothing)\b|"
     r"^(Told|Refused|Sought|Left|Given|Asked|Stored|Kept|Added|Met) "
     r"(is|are)\b|\b(so it is|nor is|and so of|so they are|so is it)\b|"
     r"\b(are|is) then (the|those|that)\b")
rule("noun-clause", False, 'name the thing instead of "what ...", "who ..."',
     r"^(What|Who|Whoever|Whatever) "
     r"(?!(is|are|do|does|should|makes?) (the|a|an|this|we)\b)[a-z]|"
     r"[,;:] what \w+|"
     r"\b(of|by|with|from|than|beside|to|and|or|for) what "
     r"(is|are|was|it|they|has|have|the|a|no|touches|comes|goes)\b")
rule("first-pronoun", False,
     "a text must not begin with a pronoun that refers to nothing",
     r"^(It|That|Those|They|These|Its|Their|The same|The one|The other|So|"
     r"Such|One (that|of)|Ones)\b(?! (is an error|is true|are font))", re.M,
     kinds=("comment", "head", "message", "test"), first=True)
rule("that-of", False, "repeat the noun",
     r"\b(that|those|the one|the ones) (of|that|in|on|at|to be|with|which)\b"
     r"[^.]*\b(that|those|the one|the ones|it|they|them)\b")
rule("so-many", False, "give the quantity a name",
     r"\b(so (many|much|often|far) (as|of|a|the|cases|runs|steps|meshes|"
     r"bytes|both|points|passes|that|moments|layers)|at so many|by so much)"
     r"\b|\bas (many|much) as\b|\ba tenth of it\b")
rule("archaic", True, "again; except; without; although",
     r"\b(anew|but for|for want of|wherein|thereof|whereof|beforehand|"
     r"unaided|aright|naught|mended|farther|seldom|else than|no less than|"
     r"at once\b(?= (when|it)))\b|\bunless given\b")
rule("prep", False, "behind: after, downstream of; beside: next to, in "
     "addition to, together with; over: divided by, relative to",
     r"\b(behind|beside)\b|\bover that of\b|\bover its own\b|"
     r"\bover (the )?(nominal|those|what|Rq|the load)\b")

VERBS = re.compile(
    r"\b(is|are|was|were|be|has|have|had|does|do|did|can|cannot|could|may|"
    r"might|must|will|would|shall|should|needs?|takes?|gives?|holds?|uses?|"
    r"makes?|sets?|prints?|writes?|reads?|returns?|solves?|computes?|shows?|"
    r"draws?|finds?|runs?|stops?|starts?|ends?|begins?|follows?|contains?|"
    r"means?|goes|stands?|lies?|comes?|falls?|rises?|depends?|adds?|keeps?|"
    r"lets?|puts?|becomes?|applies|allows?|changes?|works?|counts?|meets?|"
    r"leaves?|fits?|agrees?|differs?|moves?|passes|carries|carry|bears?|"
    r"yields?|flows?|sums?|says?|tells?|sees?|fails?|remains?|see|resumes?|"
    r"accepts?|names?|replaces?|lists?|asks?|plays?|includes?|costs?|"
    r"cuts?|implies|thins?|repeats?|var(y|ies)|cancels?|represents?|reduces?|"
    r"contributes?|causes?|grows|skews?|responds?|stays?|shakes?|extends?|"
    r"indents?|converged|builds?|increases?|failed|loses?|exchanges?|apply|disappears?|"
    r"compares?|measures?|explains?|describes?|overrides?|picks?|marches|"
    r"leads?|selects?|stores?|models?|consists?|downloads?|assumes?|"
    r"provides?|treat|heat|go|grow|enter|come|run|give|take|"
    r"need|have|keep|draw|say|read|write|solve|rides?|spreads?|hold|use|make|"
    r"follow|share|split|break|converge|diverge|combine|appear|begin|work)\b",
    re.I)
RULES["no-verb"] = (False, "a sentence in running text needs a verb",
                    lambda s, kind, first, own: kind in ("man", "md")
                    and len(s.split()) >= 8 and s[0].isupper()
                    and s.rstrip().endswith(".") and not VERBS.search(s))
RULES["long"] = (False, "at most 30 words in a sentence",
                 lambda s, kind, first, own: kind != "message"
                 and len(s.split()) > 30)
# "0: none; NAN: unknown" lists special values.
SPECIAL = re.compile(r"(;|^|,|\.) ?(-?\d+|NAN|NULL|true|false|I|A):(?= )")
RULES["chained"] = (
    False, "one idea in a sentence: one ; or : and two relative clauses",
    lambda s, kind, first, own:
    len(re.findall(r"[;:](?= )", SPECIAL.sub("", s))) >=
    2 + (kind == "message") or
    len(re.findall(r"\b(which|that|what|whose|who|where)\b", s)) >= 4)
RULES["lower-case"] = (
    False, "a comment on its own line begins with a capital",
    lambda s, kind, first, own: kind in ("comment", "head", "test") and own
    and first and bool(re.match(r"[a-z]+ [a-z]", s)))
VAGUE = re.compile(r"(Serves|Tells|Says|Knows|Puts|Lets|Makes of|Takes|Brings|"
                   r"Goes|Gives|Looks|Leaves|Passes on|Does)\b")
RULES["vague-verb"] = (
    True, "computes, returns, writes, allocates, parses, checks",
    lambda s, kind, first, own: kind in ("comment", "head", "test") and first
    and bool(VAGUE.match(s)))

# ---------------------------------------------------------------------- main


def find_hits(root, rules, kinds):
    """[(path, line, kind, rule, sentence)], number of sentences per kind."""
    hits, total = [], collections.Counter()
    for path, kind, line, text, own in texts(root):
        if kind == "message" and not (
                len(text.split()) >= 4 and
                re.search("[a-z]{3} [a-z]{2}", text)):
            continue
        if kinds and kind not in kinds:
            continue
        for k, sentence in enumerate(sentences(text)):
            total[kind] += 1
            for name, (_, _, hit) in RULES.items():
                if (not rules or name in rules) and \
                        hit(sentence, kind, k == 0, own):
                    hits.append((path, line, kind, name, sentence))
    return hits, total


def read_baseline(path):
    allowed = {}
    if os.path.exists(path):
        with open(path) as file:
            for line in file:
                parts = line.split()
                if len(parts) == 4 and parts[3].isdigit():
                    key, count = tuple(parts[:3]), int(parts[3])
                    allowed[key] = min(count, allowed.get(key, count))
    return allowed


def key_of(hit):
    path, _, kind, name, _ = hit
    return os.path.dirname(path) or ".", kind, name


def check(hits, baseline):
    counts = collections.Counter(map(key_of, hits))
    allowed = read_baseline(baseline)
    risen = [key for key in sorted(counts) if counts[key] > allowed.get(key, 0)]
    for key in risen:
        print("%s: %s: %s: %d, allowed %d: %s" % (
            *key, counts[key], allowed.get(key, 0), RULES[key[2]][1]))
        for hit in hits:
            if key_of(hit) == key:
                print("    %s:%d: %s" % (hit[0], hit[1], hit[4][:200]))
    lower = sum(counts[key] < count for key, count in allowed.items())
    print("%d hits; %d counts risen; %d can be lowered (words.py --write)"
          % (len(hits), len(risen), lower))
    return 1 if risen else 0


def write(hits, baseline):
    counts = collections.Counter(map(key_of, hits))
    allowed = read_baseline(baseline) or dict(counts)
    with open(baseline, "w") as file:
        for key in sorted(allowed):
            count = min(counts[key], allowed[key])
            if count:
                print(*key, count, file=file)
    return 0


def print_table(hits, total):
    counts = collections.Counter((name, kind) for _, _, kind, name, _ in hits)
    kinds = sorted(total)
    print("%-14s %-6s" % ("rule", "") + "".join("%9s" % k for k in kinds)
          + "%9s" % "all")
    for name, (error, _, _) in RULES.items():
        row = [counts[name, kind] for kind in kinds]
        print("%-14s %-6s" % (name, "error" if error else "")
              + "".join("%9d" % n for n in row + [sum(row)]))
    print("%-14s %-6s" % ("sentences", "") + "".join(
        "%9d" % total[kind] for kind in kinds) + "%9d" % sum(total.values()))
    return 0


def print_hits(hits, paths):
    for path, line, kind, name, sentence in hits:
        if not paths or any(path == p or path.startswith(p + "/")
                            for p in paths):
            print("%s:%d: %s (%s): %s" % (path, line, name, RULES[name][1],
                                          sentence[:230]))
    return 0


def main():
    parser = argparse.ArgumentParser(description="Checks the English.")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true")
    what.add_argument("--write", action="store_true")
    what.add_argument("--table", action="store_true")
    what.add_argument("--list", nargs="*", metavar="PATH")
    what.add_argument("--sample", type=int, default=0)
    parser.add_argument("--root", default=os.path.normpath(
        os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")))
    parser.add_argument("--baseline", default=BASELINE)
    parser.add_argument("--rule")
    parser.add_argument("--kind")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chosen = options.table or options.sample or options.list is not None
    if not chosen and (options.rule or options.kind):
        parser.error("--rule and --kind restrict --table, --list and --sample")
    hits, total = find_hits(
        options.root, options.rule.split(",") if options.rule else None,
        options.kind.split(",") if options.kind else None)
    if options.write:
        return write(hits, options.baseline)
    if options.table:
        return print_table(hits, total)
    if options.list is not None:
        return print_hits(hits, [os.path.normpath(p) for p in options.list])
    if options.sample:
        draw = random.Random(options.seed)
        for name in RULES:
            of_rule = [hit for hit in hits if hit[3] == name]
            print_hits(draw.sample(of_rule, min(options.sample, len(of_rule))),
                       [])
        return 0
    return check(hits, options.baseline)


sys.exit(main())
