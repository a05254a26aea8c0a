# SPDX-License-Identifier: GPL-3.0-or-later
"""Markdown as this project writes it, to HTML: headings, paragraphs, lists of
one level, tables, code, pictures, links, **strong**, *emphasis*, `code`."""
import html
import re

INLINE = re.compile(r"`([^`]+)`|!\[([^\]]*)\]\(([^)]*)\)|\[([^\]]*)\]\(([^)]*)\)"
                    r"|<(https?://[^>]+)>|\*\*([^*]+)\*\*|\*([^*]+)\*")


def slug(title):
    """The anchor of a heading, as GitHub makes it."""
    words = re.sub(r"[`*]", "", title).lower()
    return re.sub(r"[^\w\- ]", "", words).replace(" ", "-")


def inline(text, link):
    """`link(target)` is the address that stands for a link's, or None: then
    its words stand alone."""
    def one(match):
        code, alt, picture, words, target, address, strong, slanted = \
            match.groups()
        if code is not None:
            return f"<code>{html.escape(code)}</code>"
        if picture is not None:
            return (f'<img src="{html.escape(link(picture) or picture)}" '
                    f'alt="{html.escape(alt)}">')
        if words is not None:
            where = link(target)
            inside = inline(words, link)
            return f'<a href="{html.escape(where)}">{inside}</a>' \
                if where else inside
        if address is not None:
            return f'<a href="{html.escape(address)}">{html.escape(address)}</a>'
        if strong is not None:
            return f"<strong>{inline(strong, link)}</strong>"
        return f"<em>{inline(slanted, link)}</em>"

    parts, last = [], 0
    for match in INLINE.finditer(text):
        parts += [html.escape(text[last:match.start()], quote=False),
                  one(match)]
        last = match.end()
    return "".join(parts) + html.escape(text[last:], quote=False)


def cells(line):
    """The cells of a row; \\| is a bar inside a cell."""
    parts = re.split(r"(?<!\\)\|", line.strip().strip("|"))
    return [cell.strip().replace("\\|", "|") for cell in parts]


def table(lines, link):
    right = [mark.endswith(":") for mark in cells(lines[1])]
    yield '<div class="wide"><table>'
    for k, line in enumerate(lines):
        if k == 1:
            continue
        kind = "td" if k else "th"
        row = "".join(
            f'<{kind}{" class=number" if right[j] else ""}>'
            f"{inline(cell, link)}</{kind}>"
            for j, cell in enumerate(cells(line)))
        yield f"<tr>{row}</tr>"
    yield "</table></div>"


def entries(lines):
    """The items of a list, their continued lines joined."""
    items = []
    for line in lines:
        if re.match(r"[-*] ", line):
            items.append(line[2:])
        else:
            items[-1] += " " + line.strip()
    return items


def blocks(text):
    """(kind, lines) of what stands between empty lines."""
    kind, lines = None, []
    for line in text.split("\n") + [""]:
        if kind == "fence":
            if line.startswith("```"):
                yield kind, lines
                kind, lines = None, []
            else:
                lines.append(line)
            continue
        if line.startswith("```"):
            if lines:
                yield kind, lines
            kind, lines = "fence", []
            continue
        here = ("empty" if not line.strip() else
                "heading" if line.startswith("#") else
                "table" if line.startswith("|") else
                "code" if line.startswith("    ") and kind in (None, "code")
                else "list" if re.match(r"[-*] ", line) or
                (kind == "list" and line.startswith("  ")) else "text")
        if here == "text" and kind == "list" and not line.startswith("  "):
            here = "text"
        if here != kind or here == "heading":
            if lines:
                yield kind, lines
            lines = []
        kind = None if here == "empty" else here
        if kind:
            lines.append(line)


def to_html(text, link):
    text = re.sub(r"<!--.*?-->\n*", "", text, flags=re.S)
    parts = []
    for kind, lines in blocks(text):
        if kind == "heading":
            level = len(lines[0]) - len(lines[0].lstrip("#"))
            title = lines[0].strip("# ")
            parts.append(f'<h{level} id="{slug(title)}">'
                         f"{inline(title, link)}</h{level}>")
        elif kind in ("fence", "code"):
            cut = 4 if kind == "code" else 0
            code = "\n".join(line[cut:] for line in lines)
            parts.append(f"<pre><code>{html.escape(code)}</code></pre>")
        elif kind == "table":
            parts += table(lines, link)
        elif kind == "list":
            parts += ["<ul>", *(f"<li>{inline(item, link)}</li>"
                                for item in entries(lines)), "</ul>"]
        else:
            parts.append(f"<p>{inline(' '.join(lines), link)}</p>")
    return "\n".join(parts)
