"""Check a built site: searches for typical terms of an application find the page about this application.

python docs/check_search.py build/docs
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Any

#: Search terms, and the page that each must find.
SEARCHED = {
    "caster": "jobs/caster",
    "rebound": "jobs/caster",
    "Shore D": "jobs/caster",
    "skate": "jobs/skate",
    "rolling isolation": "jobs/isolation",
    "solve_ivp": "jobs/isolation",
    "LAMMPS pair": "jobs/particles",
    "conveyor": "jobs/idler",
    "idler": "jobs/idler",
    "DIN 22123": "jobs/idler",
}


def words_of(query: str) -> list[str]:
    """Return the relevant words of a query: the search of the site ignores numbers and single letters."""
    return [word for word in re.findall(r"\w+", query.lower()) if len(word) > 1 and not word.isdigit()]


def read_index(path: Path) -> dict[str, Any]:
    """Return the search index, which is the argument of a JavaScript call."""
    text = path.read_text(encoding="utf-8")
    return dict(json.loads(text[text.index("(") + 1 : text.rindex(")")]))


def pages_with(index: dict[str, Any], stem: str) -> set[str]:
    """Return the pages that contain a word in their text or title."""
    found: set[str] = set()
    for table in (index["terms"], index["titleterms"]):
        places = table.get(stem, [])
        found |= {index["docnames"][place] for place in (places if isinstance(places, list) else [places])}
    return found


def main(site: Path) -> int:
    """Print the searches that fail; return 1 if there are any."""
    from sphinx.search.en import SearchEnglish

    index, language = read_index(site / "searchindex.js"), SearchEnglish({})
    lost = [
        f"{query!r} does not find {page}"
        for query, page in SEARCHED.items()
        if not all(page in pages_with(index, language.stem(word)) for word in words_of(query))
    ]
    print("\n".join(lost) or f"{len(SEARCHED)} searches find the expected pages")
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
