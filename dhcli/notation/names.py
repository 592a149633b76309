"""How names are spelled: subscripts, Greek letters, look-alikes, and the order in which people list them."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Mapping
from functools import lru_cache

from dhcli.errors import did_you_mean
from dhcli.regex import regex

GREEK = {
    "α": "alpha",
    "β": "beta",
    "γ": "gamma",
    "δ": "delta",
    "ε": "epsilon",
    "ϵ": "epsilon",
    "ζ": "zeta",
    "η": "eta",
    "θ": "theta",
    "ϑ": "theta",
    "ι": "iota",
    "κ": "kappa",
    "λ": "lambda",
    "μ": "mu",
    "ν": "nu",
    "ξ": "xi",
    "ρ": "rho",
    "σ": "sigma",
    "τ": "tau",
    "φ": "phi",
    "ϕ": "phi",
    "χ": "chi",
    "ψ": "psi",
    "ω": "omega",
}
"""Greek letters and their names; `π` is a number and not here."""

GREEK_NAMES = frozenset(GREEK.values()) | {"vartheta", "varphi", "varepsilon"}
MOST_SUGGESTIONS = 3
_VARIANTS = {"vartheta": "theta", "varphi": "phi", "varepsilon": "epsilon"}
SUBSCRIPTS = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_SPLIT = regex(r"(\D*)(\d*)")
_TRIG = regex(rf"(?:cos|sin|[cs])(?={'|'.join(sorted(GREEK_NAMES))})")
_CAPITAL_GREEK = regex(rf"(?=[A-Z])(?:{'|'.join(name.capitalize() for name in sorted(GREEK_NAMES))})\d*$")
_STEM = regex(r"(?P<stem>[A-Za-z]+)(?P<index>\d*)(?:_(?P<letters>.+))?")


@lru_cache(maxsize=4096)
def natural_key(name: str) -> tuple[tuple[str, int], ...]:
    """A sort key under which theta2 comes before theta10."""
    return tuple((text.lower(), int(digits or 0)) for text, digits in _SPLIT.findall(name) if text or digits)


@lru_cache(maxsize=4096)
def canonical(name: str) -> str:
    r"""One spelling for all the ways people write a name.

    `θ1`, `theta_1`, `\theta_{1}`, `θ₁`, and `Theta1` as a phone begins a line, are `theta1`; `\alpha_{i-1}` is
    `alpha_{i-1}`, `a_{i}` is `a_i`.
    """
    text = "".join(GREEK.get(letter, letter) for letter in name.translate(SUBSCRIPTS))
    text = text.replace("\\", "")
    stem, _, subscript = text.partition("_")
    stem = stem[:1].lower() + stem[1:] if _CAPITAL_GREEK.match(stem) else stem
    stem = _VARIANTS.get(stem, stem)
    subscript = subscript.strip("{}").replace(" ", "").replace("−", "-").replace("–", "-")
    if not subscript:
        return stem
    if subscript.isdigit():
        return stem + subscript
    return f"{stem}_{subscript}" if subscript.isalnum() else f"{stem}_{{{subscript}}}"


def parts(name: str) -> tuple[str, str]:
    """Stem and subscript of a name: `theta12` is theta, 12; `alpha_{i-1}` is alpha, i-1; `shoulder` has none."""
    match = _STEM.fullmatch(canonical(name))
    if match is None:
        return name, ""
    letters = (match["letters"] or "").strip("{}")
    return match["stem"], match["index"] + letters


def usual_aliases(names: Iterable[str]) -> dict[str, str]:
    """What else people write for names, where nothing else has that name: t1 and th1 for theta1, and A1 for a1.

    A capital C or S begins a cosine or a sine, and one without an index may mean something else. Where there is a t1,
    t2 is no angle.
    """
    found, names = dict[str, str](), tuple(names)
    for name in names:
        stem, index = parts(name)
        if stem == "theta":
            found |= {canonical(f"{short}{name.removeprefix('theta')}"): name for short in ("t", "th")}
        elif index and len(stem) == 1 and stem.islower() and stem not in "cs":
            found[capital(name)] = name
    return beside(found, names)


def beside(aliases: Mapping[str, str], names: Iterable[str]) -> dict[str, str]:
    """The aliases that stay where there are other names too: none that begins as one of these does."""
    stems = {parts(name)[0] for name in names}
    return {alias: name for alias, name in aliases.items() if parts(alias)[0] not in stems}


def capital(name: str) -> str:
    """A name with a capital for its first letter: `A1` for `a1`."""
    return name[:1].upper() + name[1:]


def suggestion(word: str, known: Iterable[str]) -> str:
    """A hint at the names that a word may have meant: those that only lack an index first, `theta_i` before theta1."""
    known = tuple(known)
    stem, index = parts(_TRIG.sub("", canonical(word)))
    alike = [name for name in known if parts(name)[0] == stem]
    if index or not alike:
        return did_you_mean(word, known)
    alike.sort(key=lambda name: (any(letter.isdigit() for letter in name), natural_key(name)))
    return "did you mean " + " or ".join(alike[:MOST_SUGGESTIONS]) + "?"


def is_greek(name: str) -> bool:
    """Whether a name is a Greek letter, alone or with an index."""
    return parts(name)[0] in GREEK_NAMES


def foreign_letter(letter: str) -> str | None:
    """The Latin letter that a look-alike from another alphabet imitates, or None.

    Pasted slides carry Cyrillic letters that no eye can tell from Latin ones.
    """
    return _LOOK_ALIKES.get(letter)


def describe(letter: str) -> str:
    """A letter with its Unicode name, for messages about characters that cannot be seen."""
    name = unicodedata.name(letter, f"U+{ord(letter):04X}")
    shown = letter if letter.isprintable() else ""
    return f"{shown} ({name.title()})".strip()


_LOOK_ALIKES = {
    **dict(zip("аеорсухіјѕԁԛ", "aeopcyxijsdq", strict=True)),
    **dict(zip("АВЕКМНОРСТХІЅ", "ABEKMHOPCTXIS", strict=True)),
    **dict(zip("οΟΑΒΕΖΗΙΚΜΝΡΤΥΧ", "oOABEZHIKMNPTYX", strict=True)),
}
