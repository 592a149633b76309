"""The house: no ring of files anywhere, counting what is imported for its types alone."""

from __future__ import annotations

import ast
import re
from pathlib import Path

ROOT = Path(__file__).parents[1] / "dhcli"

KNOWN = (
    # a tree, and an angle in it, shows itself as text by its writer, which walks it
    {"dhcli.notation.angle", "dhcli.notation.tree", "dhcli.notation.writer"},
)
"""The ring that has a reason to stay."""


def module_of(path: Path) -> str:
    """The name that a file is imported by."""
    parts = path.relative_to(ROOT.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def texts() -> dict[str, str]:
    """Every module as it is written; to parse them all takes seconds."""
    return {module_of(path): path.read_text("utf-8") for path in ROOT.rglob("*.py")}


IMPORT = re.compile(r"^[ \t]*(?:from ([\w.]+) import (?:\(([^)]*)\)|([^\n(]+))|import ([\w., ]+))", re.MULTILINE)
"""A statement as the formatter writes it: the module, and its names in brackets or on a line, or modules alone."""


def imports(files: dict[str, str]) -> dict[str, frozenset[str]]:
    """Every module with the modules of the package that it names, wherever in the file the import stands."""
    found: dict[str, frozenset[str]] = {}
    for name, text in files.items():
        named: set[str] = set()
        for module, many, few, alone in IMPORT.findall(text):
            names = re.findall(r"(?:^|,)\s*([\w.]+)", re.sub(r"#.*", "", many or few or alone))
            inner = {f"{module}.{each}" for each in names} & files.keys()
            named |= (inner or {module}) if module else set(names)
        found[name] = frozenset(named & files.keys() - {name})
    return found


def rings(graph: dict[str, frozenset[str]]) -> list[frozenset[str]]:
    """The sets of modules each of which leads to all others of its set, by Tarjan's algorithm."""
    order: dict[str, int] = {}
    low: dict[str, int] = {}
    waiting: list[str] = []
    found: list[frozenset[str]] = []

    def visit(name: str) -> None:
        order[name] = low[name] = len(order)
        waiting.append(name)
        for other in sorted(graph[name]):
            if other not in order:
                visit(other)
            if other in waiting:
                low[name] = min(low[name], low[other])
        if low[name] == order[name]:
            ring = frozenset(waiting[waiting.index(name) :])
            del waiting[waiting.index(name) :]
            if len(ring) > 1:
                found.append(ring)

    for name in sorted(graph):
        if name not in order:
            visit(name)
    return found


def test_no_files_import_each_other_in_a_ring() -> None:
    """A file can be understood with those below it alone; so whatever is needed on both sides stands below both."""
    assert [sorted(ring) for ring in rings(imports(texts())) if not any(ring <= known for known in KNOWN)] == []


def test_a_ring_would_be_found() -> None:
    """Of two files, of three, and not where two only share a third one."""
    graph = {"a": frozenset("b"), "b": frozenset("c"), "c": frozenset("ad"), "d": frozenset("e"), "e": frozenset()}
    assert rings(graph) == [frozenset("abc")]
    assert rings({"a": frozenset("c"), "b": frozenset("c"), "c": frozenset()}) == []


def test_an_import_would_be_found() -> None:
    """Wherever it stands and however it is written: for types alone, in a function, in brackets with a remark."""
    files = {
        "a": "import os, b\n\nif TYPE_CHECKING:\n    from b.c import D, E as F\n",
        "b": 'def f():\n    """Words from a book."""\n    from b import c\n',
        "b.c": "from b import (\n    d,  # a remark, and a\n    e as g,\n    h,\n)\n",
        **dict.fromkeys(("b.d", "b.e", "b.h"), "from b.d import a"),
    }
    found = imports(files)
    assert {name: " ".join(sorted(named)) for name, named in found.items()} == {
        "a": "b b.c",
        "b": "b.c",
        "b.c": "b.d b.e b.h",
        "b.d": "",
        "b.e": "b.d",
        "b.h": "b.d",
    }


def frozen_otherwise(tree: ast.Module) -> list[str]:
    """The classes of a file that are frozen by `dataclass`, which compiles six functions for each."""
    return [
        node.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ClassDef)
        for maker in node.decorator_list
        if isinstance(maker, ast.Call) and any(word.arg == "frozen" for word in maker.keywords)
    ]


def test_what_is_frozen_is_made_by_the_one_maker() -> None:
    """`@frozen` compiles nothing, and what it makes inherits from its own kind alone."""
    found = {name: frozen_otherwise(ast.parse(text)) for name, text in texts().items() if "frozen=" in text}
    assert not {name: classes for name, classes in found.items() if classes}
    example = ast.parse("@dataclass(frozen=True)\nclass A: ...\n@frozen\nclass B: ...")
    assert frozen_otherwise(example) == ["A"]


def test_what_is_looked_for_is_compiled_when_it_is() -> None:
    """No file compiles a regular expression while it is imported: `regex` does, when it is used."""
    found = [path.name for path in ROOT.rglob("*.py") if "re.compile(" in path.read_text("utf-8")]
    assert found == ["regex.py"]
