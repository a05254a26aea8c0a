# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether every link and picture of the pages of a folder leads to a file of
that folder, and to an anchor that is there."""
import os
import sys
import urllib.parse
from html.parser import HTMLParser


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif name in ("href", "src") and value is not None:
                self.links.append(value)


def broken(folder):
    """(page, link, why) of every link that leads nowhere."""
    names = [os.path.join(at, name) for at, _, found in os.walk(folder)
             for name in found if name.endswith(".html")]
    pages = {os.path.normpath(name): Page(name) for name in names}
    for name, page in sorted(pages.items()):
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("http", "https", "data", "mailto", "blob"):
                continue
            target = name
            if parts.path:
                target = os.path.normpath(os.path.join(
                    os.path.dirname(name), urllib.parse.unquote(parts.path)))
            anchor = urllib.parse.unquote(parts.fragment)
            if not os.path.isfile(target):
                yield name, link, "no such file"
            elif anchor and target in pages and \
                    anchor not in pages[target].anchors:
                yield name, link, "no such place in it"


if __name__ == "__main__":
    found = list(broken(sys.argv[1]))
    for name, link, why in found:
        print(f"{name}: {link}: {why}")
    sys.exit(1 if found else 0)
