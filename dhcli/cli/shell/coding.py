"""`--code`: which language a function is wanted in, and the options that do not go with it."""

from __future__ import annotations

from collections.abc import Mapping

from dhcli.cli.shell.delivery import Delivery
from dhcli.cli.shell.endings import check_ending
from dhcli.cli.shell.options import LANGUAGES
from dhcli.errors import DhcliError, UnknownNameError, did_you_mean


def code_delivery(
    kind: str,
    command: str,
    language: str | None,
    others: Mapping[str, object],
    format_: str | None,
    output: str | None,
    *,
    overwrite: bool,
) -> Delivery:
    """Where a function goes: its code, or with `--format json` its formulas as data.

    Args:
        kind: What kind of function it is.
        command: The command typed.
        language: The language asked for; None where only `--with-values` is.
        others: Options that ask for something else, with what was given for them.
        format_: What was given for `--format`.
        output: The file to write.
        overwrite: Whether that file may be overwritten.

    Raises:
        DhcliError: There is no language, none of this name, or one of those options was given, or
            the file ends as one in another language does.
    """
    if language is None:
        raise DhcliError("--with-values is for --code", "say the language: --code python")
    if language not in LANGUAGES:
        hint = did_you_mean(language, LANGUAGES) or f"languages: {', '.join(LANGUAGES)}"
        raise UnknownNameError(f"--code knows no language {language}", hint)
    check_alone("--code", others)
    if format_ not in {None, "json"}:
        raise DhcliError("--code says the language, and --format another", "leave --format out; json gives formulas")
    if format_ is None:
        check_ending(output, language, "--code", LANGUAGES)
    else:
        check_ending(output, format_, "--format", (), "leave --format out")
    delivery = Delivery(command, format_ or language, output=output, overwrite=overwrite)
    delivery.chosen(kind)
    return delivery


def check_alone(option: str, others: Mapping[str, object]) -> None:
    """Refuse options that ask for something else than this one does.

    Raises:
        DhcliError: One of them was given.
    """
    if given := [other for other, value in others.items() if value]:
        raise DhcliError(f"{option} and {' and '.join(given)} ask for different things", "leave one of the two out")
