"""Check a built site: a search for what people of the trades type finds the page that is meant for them.

python docs/check_search.py build/docs
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Any

#: What is typed, and the page that it must lead to.
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
    """Return the words of a query that count: the site's search leaves out numbers and single letters."""
    return [word for word in re.findall(r"\w+", query.lower()) if len(word) > 1 and not word.isdigit()]


def read_index(path: Path) -> dict[str, Any]:
    """Return the index, which is the argument of a call in JavaScript."""
    text = path.read_text(encoding="utf-8")
    return dict(json.loads(text[text.index("(") + 1 : text.rindex(")")]))


def pages_with(index: dict[str, Any], stem: str) -> set[str]:
    """Return the pages that have a word, in their text or their titles."""
    found: set[str] = set()
    for table in (index["terms"], index["titleterms"]):
        places = table.get(stem, [])
        found |= {index["docnames"][place] for place in (places if isinstance(places, list) else [places])}
    return found


def main(site: Path) -> int:
    """Print which searches fail; return 1 if there are any."""
    from sphinx.search.en import SearchEnglish

    index, language = read_index(site / "searchindex.js"), SearchEnglish({})
    lost = [
        f"{query!r} does not find {page}"
        for query, page in SEARCHED.items()
        if not all(page in pages_with(index, language.stem(word)) for word in words_of(query))
    ]
    print("\n".join(lost) or f"{len(SEARCHED)} searches find their pages")
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
