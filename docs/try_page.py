"""Write the page "Try it" as plain files without modules and requests, which browsers can also open from a folder.

One script contains all JavaScript modules, a second one the library for WebAssembly, which `make wasm` builds, and the
tables of published materials. Without the library there is no page.
"""

from __future__ import annotations

import json
import re
import shutil
from graphlib import TopologicalSorter
from pathlib import Path

import viscoroll
from viscoroll.app.tabulated import published_materials

PAGE = Path(viscoroll.__file__).parent / "app" / "page"

_IMPORT = re.compile(r'^import (\{[^}]*\}) from "\./(\w+)\.js";\n', re.MULTILINE)
_EXPORT = re.compile(r"^export (?=(?:async )?(?:function|const|class) (\w+))", re.MULTILINE)
_COMMENT = re.compile(r"^ *(?:/\*\*.*?\*/|//[^\n]*)\n", re.MULTILINE | re.DOTALL)
#: Parts of the page, and what replaces them on the site.
_CHANGES = {
    '{"solver": "none"}': '{"solver": "wasm"}',
    '<script type="module" src="main.js"></script>': (
        '<script src="solver.js" defer></script>\n    <script src="page.js" defer></script>'
    ),
    "<h1>viscoroll</h1>": '<h1><a href="../index.html">viscoroll</a></h1>',
    '<p id="where"></p>': '<p id="where"></p>\n      <p><a href="../try.html">How the page works</a></p>',
}


def bundle(folder: Path, main: str = "main") -> str:
    """Return the modules of a folder as one script, each as a function that returns its exports."""
    texts = {path.stem: _COMMENT.sub("", path.read_text(encoding="utf-8")) for path in folder.glob("*.js")}
    needs = {name: [needed for _, needed in _IMPORT.findall(text)] for name, text in texts.items()}
    order = [name for name in TopologicalSorter(needs).static_order() if name != main] + [main]
    parts = []
    for name in order:
        body = _EXPORT.sub("", _IMPORT.sub(r"const \1 = \2_module;\n", texts[name]))
        exported = ", ".join(_EXPORT.findall(texts[name]))
        parts.append(f"const {name}_module = (() => {{\n{body}return {{ {exported} }};\n}})();\n")
    left = [
        name for name, part in zip(order, parts, strict=True) if re.search(r"^(import|export)\b", part, re.MULTILINE)
    ]
    if left:
        raise ValueError(f"import and export must name their objects, in {', '.join(left)}")
    return '(() => {\n"use strict";\n' + "".join(parts) + "})();\n"


def write_page(folder: Path, library: Path) -> bool:
    """Write the page into a folder; return False, without a page, if the script of the library does not exist."""
    shutil.rmtree(folder, ignore_errors=True)
    if not library.exists():
        return False
    folder.mkdir(parents=True)
    worker = library.read_text(encoding="utf-8") + "\nviscoroll.serve();\n"
    materials = json.dumps(published_materials(), separators=(",", ":"))
    solver = f"var viscorollWorker = {json.dumps(worker)};\nvar viscorollMaterials = {materials};\n"
    (folder / "solver.js").write_text(solver, encoding="utf-8")
    text = (PAGE / "index.html").read_text(encoding="utf-8")
    for before, after in _CHANGES.items():
        if before not in text:
            raise ValueError(f"index.html must contain {before}")
        text = text.replace(before, after)
    (folder / "index.html").write_text(text, encoding="utf-8")
    (folder / "page.js").write_text(bundle(PAGE), encoding="utf-8")
    shutil.copyfile(PAGE / "page.css", folder / "page.css")
    return True
