"""`--code`: which language a function is wanted in, and the options that do not go with it."""

from __future__ import annotations

from collections.abc import Mapping

from dhcli.cli.shell.delivery import Delivery
from dhcli.cli.shell.written import LANGUAGES, Written
from dhcli.errors import DhcliError, UnknownNameError
from dhcli.render.endings import check_ending, meant


def code_delivery(out: Written, command: str, kind: str, others: Mapping[str, object]) -> Delivery:
    """Where a function goes: its code, or with `--format json` its formulas as data.

    Args:
        out: How it is wanted.
        command: The command typed.
        kind: What kind of function it is.
        others: Options that ask for something else, with what was given for them.

    Raises:
        DhcliError: There is no language, none of this name, or one of those options was given, or
            the file ends as one in another language does.
    """
    if out.code is None:
        raise DhcliError("--with-values is for --code", "say the language: --code python")
    if out.code not in LANGUAGES:
        hint = meant(out.code, LANGUAGES)
        more = "" if hint.startswith("did") else "; beside one of these --format json gives the formulas, for any other"
        raise UnknownNameError(f"--code knows no language {out.code}", hint + more)
    check_alone("--code", {**others, "--style": out.style, "--digits": out.digits})
    if out.format not in {None, "json"}:
        raise DhcliError("--code says the language, and --format another", "leave --format out; json gives formulas")
    if out.format is None:
        check_ending(out.output, out.code, "--code", LANGUAGES)
    else:
        check_ending(out.output, out.format, "--format", (), "leave --format out")
    delivery = Delivery(command, out.format or out.code, output=out.output, overwrite=out.overwrite)
    delivery.chosen(kind)
    return delivery


def check_alone(option: str, others: Mapping[str, object]) -> None:
    """Refuse options that ask for something else than this one does.

    Raises:
        DhcliError: One of them was given.
    """
    if given := [other for other, value in others.items() if value]:
        raise DhcliError(f"{option} and {' and '.join(given)} ask for different things", "leave one of the two out")
