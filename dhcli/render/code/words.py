"""Words that no name may be in generated code: those of each language, and those that stand in the functions."""

from __future__ import annotations

import keyword
from collections.abc import Mapping

from dhcli.notation.styles import RESERVED as TYPED

TAKEN = frozenset(
    (
        *("T", "J", "q", "pi", "cosine", "solutions", "found", "forward", "jacobian", "inverse", "square"),
        *("cos", "sin", "tan", "sqrt", "pow", "fabs", "abs", "acos", "asin", "atan", "atan2", "zeros", "nargin"),
    )
)
"""Names that stand in the functions themselves, whatever the language."""

RESERVED: Mapping[str, frozenset[str]] = {
    "python": frozenset(keyword.kwlist) | {"math", "abs"},
    "numpy": TYPED["numpy"] | {"abs"},
    "matlab": TYPED["matlab"],
    "c": frozenset(
        (
            *("auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum"),
            *("extern", "float", "for", "goto", "if", "inline", "int", "long", "register", "restrict", "return"),
            *("short", "signed", "sizeof", "static", "struct", "switch", "typedef", "union", "unsigned", "void"),
            *("volatile", "while", "bool", "true", "false", "nullptr", "constexpr", "typeof", "alignas", "alignof"),
            *("asm", "class", "delete", "new", "private", "public", "template", "this", "namespace", "operator"),
            *("NAN", "INFINITY", "HUGE_VAL", "linux", "unix", "i386", "y0", "y1", "yn", "j0", "j1", "jn", "gamma"),
        )
    ),
    "julia": frozenset(
        (
            *("baremodule", "begin", "break", "catch", "const", "continue", "do", "else", "elseif", "end", "export"),
            *("false", "finally", "for", "function", "global", "if", "import", "in", "isa", "let", "local", "macro"),
            *(
                "module",
                "quote",
                "return",
                "struct",
                "true",
                "try",
                "using",
                "where",
                "while",
                "im",
                "push",
                "Inf",
                "NaN",
            ),
        )
    ),
    "javascript": frozenset(
        (
            *("abstract", "arguments", "await", "break", "case", "catch", "class", "const", "continue", "debugger"),
            *("default", "delete", "do", "else", "enum", "eval", "export", "extends", "false", "finally", "for"),
            *("function", "if", "implements", "import", "in", "instanceof", "interface", "let", "new", "null"),
            *("package", "private", "protected", "public", "return", "static", "super", "switch", "this", "throw"),
            *("true", "try", "typeof", "var", "void", "while", "with", "yield", "Math", "NaN", "Infinity", "undefined"),
        )
    ),
}
"""Words that a language keeps for itself, constants and macros too."""
