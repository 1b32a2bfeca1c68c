"""Check a built site: internal links have a target, pages load no external files, all figures are drawn.

python docs/check_links.py build/docs
"""

from __future__ import annotations

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

#: Attributes that refer to another file, by tag: links that readers follow, and files that browsers load.
FOLLOWED = {"a": "href"}
LOADED = {"img": "src", "script": "src", "link": "href", "source": "src", "iframe": "src"}


class Page(HTMLParser):
    """Anchors of a page, and the targets of its links and files."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.places: set[str] = {"", "top"}
        self.targets: list[tuple[str, str]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Collect anchors and targets."""
        values = dict(attrs)
        self.places |= {value for key in ("id", "name") if (value := values.get(key))}
        target = values.get((FOLLOWED | LOADED).get(tag, ""))
        if target:
            self.targets.append((tag, target))


def faults(site: Path) -> list[str]:
    """Return one line for each broken link, each external file and each figure that is not drawn."""
    paths = [path.resolve() for path in sorted(site.rglob("*.html")) if "_static" not in path.parts]
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in paths}
    found = []
    for path, page in pages.items():
        if "&lt;Figure size" in path.read_text(encoding="utf-8"):
            found.append(f"{path.relative_to(site.resolve())}: page shows the name of a figure instead of the figure")
        for tag, target in page.targets:
            url = urlsplit(target)
            where = f"{path.relative_to(site.resolve())}: <{tag}> {target}"
            if url.scheme or url.netloc:
                if tag in LOADED and url.scheme != "data":
                    found.append(f"{where}: loaded from the network")
                continue
            aim = (path.parent / unquote(url.path)).resolve() if url.path else path
            if not aim.exists():
                found.append(f"{where}: no such file")
            elif aim in pages and unquote(url.fragment) not in pages[aim].places:
                found.append(f"{where}: no such anchor")
    return found


def main(site: Path) -> int:
    """Print all faults; return 1 if there are any."""
    found = faults(site)
    print("\n".join(found) or "no broken links, and nothing is loaded from the network")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
