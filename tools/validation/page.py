# SPDX-License-Identifier: GPL-3.0-or-later
"""The comparisons as one page: Markdown, and HTML with its figures inside."""
import html
import math

COLOURS = ["#444444", "#0b5fa5", "#c8501e", "#2f8f4e", "#7a4fa3", "#a8860b"]
WIDTH, HEIGHT, LEFT, BOTTOM, RIGHT, TOP = 640, 360, 60, 46, 14, 30
STYLE = """
body { font: 15px/1.45 sans-serif; max-width: 60em; margin: 2em auto;
  padding: 0 1em; color: #222 }
table { border-collapse: collapse; width: 100% }
th, td { text-align: left; padding: .2em .6em; vertical-align: top;
  border-bottom: 1px solid #ddd }
td.number { text-align: right; white-space: nowrap }
tr.outside td { background: #fbe3dc }
.source { color: #666 }
svg { max-width: 100%; height: auto }"""


def difference(row):
    if row.relative:
        return f"{100 * row.difference:+.2g} %"
    return f"{row.difference:+.2g}"


def band(row):
    low, high = row.band
    if row.relative:
        return f"{100 * low:.2g} to {100 * high:.2g} %"
    return f"{low:.2g} to {high:.2g}"


HEADS = ["", "published", "overroll", "difference", "may be", "why"]


def cells(row):
    origin = (", from memory: not counted" if row.remembered else
              ", derived here: not counted" if row.derived else "")
    return [row.what + origin, f"{row.published:.5g}", f"{row.ours:.5g}",
            difference(row), band(row), row.why]


# --------------------------------------------------------------------- figure


class Axis:
    """Values on a line of pixels, with round ticks."""

    def __init__(self, values, first, last, log):
        self.log, self.first, self.last = log, first, last
        low, high = min(values), max(values)
        if log:
            self.low, self.high = math.log10(low), math.log10(high)
        else:
            room = 0.05 * (high - low)
            self.low, self.high = min(low - room, 0 if low > 0 else low), \
                high + room

    def at(self, value):
        value = math.log10(value) if self.log else value
        return self.first + (value - self.low) / (self.high - self.low) * \
            (self.last - self.first)

    def ticks(self):
        if self.log:
            return [m * 10.0**k for k in range(math.floor(self.low),
                                               math.ceil(self.high) + 1)
                    for m in (1, 2, 5)
                    if self.low <= math.log10(m * 10.0**k) <= self.high]
        step = 10**math.floor(math.log10((self.high - self.low) / 3))
        step *= 2 if (self.high - self.low) / step > 8 else 1
        first = math.ceil(self.low / step)
        return [k * step for k in range(first,
                                        math.floor(self.high / step) + 1)]


def text(x, y, words, anchor="middle", more=""):
    return (f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>'
            f'{html.escape(words)}</text>')


def grid(across, up):
    for value in across.ticks():
        x = across.at(value)
        yield (f'<path d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}" '
               'stroke="#e4e4e4"/>')
        yield text(x, HEIGHT - BOTTOM + 16, f"{value:g}")
    for value in up.ticks():
        y = up.at(value)
        yield (f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" '
               'stroke="#e4e4e4"/>')
        yield text(LEFT - 6, y + 4, f"{value:g}", "end")


def draw(series, colour, across, up):
    places = [(across.at(x), up.at(y)) for x, y in series.points]
    if series.curve:
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
        yield (f'<polyline points="{path}" fill="none" stroke="{colour}" '
               'stroke-width="1.6"/>')
    else:
        for x, y in places:
            yield (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.4" '
                   f'fill="{colour}"/>')


def svg(figure):
    points = [p for s in figure.series for p in s.points]
    across = Axis([x for x, _ in points], LEFT, WIDTH - RIGHT, figure.log_x)
    up = Axis([y for _, y in points], HEIGHT - BOTTOM, TOP, figure.log_y)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} '
             f'{HEIGHT}" font-family="sans-serif" font-size="12">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>',
             *grid(across, up)]
    for k, series in enumerate(figure.series):
        colour = COLOURS[k % len(COLOURS)]
        parts += draw(series, colour, across, up)
        y = TOP + 14 + 16 * k
        parts.append(text(WIDTH - RIGHT - 24, y, series.name, "end"))
        parts.append(f'<rect x="{WIDTH - RIGHT - 18}" y="{y - 8}" width="12" '
                     f'height="{3 if series.curve else 8}" fill="{colour}"/>')
    middle = (TOP + HEIGHT - BOTTOM) / 2
    parts += [text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 8, figure.x),
              text(14, middle, figure.y,
                   more=f' transform="rotate(-90 14 {middle})"'),
              text((LEFT + WIDTH - RIGHT) / 2, 18, figure.title,
                   more=' font-weight="bold"'), "</svg>"]
    return "\n".join(parts)


# ----------------------------------------------------------------------- page


def counted(sections):
    rows = [row for section in sections for row in section.rows
            if not (row.remembered or row.derived)]
    outside = sum(not row.inside for row in rows)
    return (f"{len(rows)} published numbers beside overroll's, "
            f"{len(rows) - outside} of them as near as they may be expected "
            f"to be, {outside} not. Bands of 2, 5 or 7 per cent are what fits "
            "of their time may be off, set with the differences known.")


def markdown(sections, version):
    lines = ["# overroll beside published results", "",
             f"{version}; made by `tools/validation/run`. {counted(sections)}"]
    for section in sections:
        lines += ["", f"## {section.title}", "", section.text, "",
                  section.source + ".", "",
                  "| " + " | ".join(HEADS) + " |", "|---|--:|--:|--:|--:|---|"]
        lines += ["| " + " | ".join(cells(row)) + " |"
                  for row in section.rows]
    return "\n".join(lines) + "\n"


def table(rows):
    yield "<table><tr>" + "".join(f"<th>{h}</th>" for h in HEADS) + "</tr>"
    for row in rows:
        yield "<tr>" if row.inside else '<tr class="outside">'
        for k, cell in enumerate(cells(row)):
            kind = ' class="number"' if 0 < k < 5 else ""
            yield f"<td{kind}>{html.escape(cell)}</td>"
        yield "</tr>"
    yield "</table>"


def page(sections, version):
    parts = ['<!DOCTYPE html><html lang="en"><meta charset="utf-8">',
             "<title>overroll beside published results</title>",
             f"<style>{STYLE}</style>",
             "<h1>overroll beside published results</h1>",
             f"<p>{html.escape(version)}; made by "
             f"<code>tools/validation/run</code>. {counted(sections)}</p>"]
    for section in sections:
        parts += [f"<h2>{html.escape(section.title)}</h2>",
                  f"<p>{html.escape(section.text)}</p>",
                  f'<p class="source">{html.escape(section.source)}.</p>']
        parts += [f"<p>{svg(figure)}</p>" for figure in section.figures]
        parts += table(section.rows)
    return "\n".join(parts) + "</html>\n"
