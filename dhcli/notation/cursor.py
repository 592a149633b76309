"""A place among the tokens of a text: what comes next, and errors that point at it."""

from __future__ import annotations

from dhcli.errors import NotationError
from dhcli.notation.scope import Scope
from dhcli.notation.tokens import Source, Token


class Cursor:
    """Tokens read from left to right.

    Attributes:
        source: The text.
        tokens: Its tokens, the last of which is `end`.
        scope: The names it may use.
        position: Index of the next token.
    """

    def __init__(self, source: Source, tokens: list[Token], scope: Scope) -> None:
        """Start before the first token, the last of which must be `end`."""
        self.source = source
        self.tokens = tokens
        self.scope = scope
        self.position = 0

    @property
    def token(self) -> Token:
        """The token that comes next."""
        return self.tokens[self.position]

    def advance(self) -> Token:
        """Take the next token."""
        token = self.token
        self.position += token.kind != "end"
        return token

    def at(self, sign: str) -> bool:
        """Whether the next token is a certain sign."""
        return self.token.kind == "sign" and self.token.text == sign

    def take(self, sign: str) -> bool:
        """Take a sign if it comes next."""
        found = self.at(sign)
        self.position += found
        return found

    def expect(self, sign: str, after: str) -> None:
        """Take a sign that must come next."""
        if not self.take(sign):
            raise self.error(f"{self.shown()} where {sign} was expected {after}")

    def error(self, message: str, hint: str = "", token: Token | None = None) -> NotationError:
        """An error that points at a token, the next one unless told otherwise."""
        return self.source.error((token or self.token).start, message, hint)

    def shown(self) -> str:
        """The next token as a message names it."""
        return "the end" if self.token.kind == "end" else repr(self.token.text)

    def finish(self) -> None:
        """Make sure that nothing is left over."""
        if self.token.kind != "end":
            equals = self.token.text == "="
            hint = "write one side of the equation alone" if equals else "is a bracket or an operator missing?"
            raise self.error(f"{self.shown()} is left over here", hint)
