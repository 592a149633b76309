"""From the words on the command line to an exit code; the one place where errors become codes and text."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from types import FrameType

from dhcli.cli.shell.console import GuardedStream, complain, finish
from dhcli.errors import DhcliError, ExitStatus, Place, Problem, bug

INSTEAD = {
    "--force": "--overwrite",
    "--symbolic": "--derive",
    "-s": "--derive",
    "--linear": "--velocity",
    "--omega": "--angular",
}
"""What some commands have instead of an option that is typed in vain."""

ELSEWHERE = {"--rows": "rows of a file are read by fk, ik, draw and jacobian"}
"""Which commands have an option that is looked for in others."""

CALLED = {
    **dict.fromkeys(("forward", "fkine", "pose"), "fk"),
    **dict.fromkeys(("inverse", "ikine", "solve"), "ik"),
    **dict.fromkeys(("plot", "teach", "view", "render", "animate"), "draw"),
    **dict.fromkeys(("convert", "export", "dh", "screws"), "describe"),
    **dict.fromkeys(("mobility", "gruebler", "freedoms", "linkage"), "dof"),
    **dict.fromkeys(("workspace", "reach"), "sweep"),
    **dict.fromkeys(("velocity", "velocities", "speed"), "rates"),
    **dict.fromkeys(("force", "forces", "statics"), "torques"),
    **dict.fromkeys(("import", "create", "init"), "new"),
    **dict.fromkeys(("compose", "multiply"), "transform"),
    "info": "show",
    "manual": "help",
    "version": "--version",
}
"""What other programs and people call the commands."""

BUGS = "please report it with the command you typed; DHCLI_DEBUG=1 shows where it happened"
_STATUS = {"SIGTERM": ExitStatus.TERMINATED, "SIGHUP": ExitStatus.HUNG_UP}
"""The signals that ask a process to end, where the system has them, and the exit code that each leads to."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Args:
        arguments: The words after `dhcli`; those of this process by default.

    Returns:
        The exit code: 0 done, 1 an answer not right, 2 bad input, 3 a bug in dhcli, 130 Ctrl-C, 129 SIGHUP,
        143 SIGTERM.
    """
    words = list(sys.argv[1:] if arguments is None else arguments)
    streams = sys.stdout, sys.stderr
    sys.stdout = GuardedStream.around(streams[0])
    sys.stderr = GuardedStream.around(streams[1], is_talk=True)
    try:
        return _guarded(words)
    finally:
        sys.stdout, sys.stderr = streams


def _guarded(words: list[str]) -> int:
    """Run the words, and turn every way to fail into its code and its text."""
    try:
        with ending_in_order():
            code = _run(words)
            finish()
    except DhcliError as error:
        complain(error.problems, words)
        return error.status
    except KeyboardInterrupt:
        sys.stderr.write("\n")
        return ExitStatus.INTERRUPTED
    except Exception as error:
        if os.environ.get("DHCLI_DEBUG"):
            raise
        complain([bug(error, BUGS)], words)
        return ExitStatus.BUG
    return code


def _run(words: list[str]) -> int:
    """Let typer find the command and run it; its own errors in the words of ours."""
    from typer._click.exceptions import ClickException

    from dhcli.cli.app import build

    try:
        return build()(words or ["--help"], prog_name="dhcli", standalone_mode=False) or ExitStatus.DONE
    except ClickException as error:
        raise DhcliError(usage_problem(error)) from None
    except SystemExit as stopped:  # a signal; or typer's own printing met a closed pipe, and the work was done
        return stopped.code if isinstance(stopped.code, int) and stopped.code != 1 else ExitStatus.DONE


def usage_problem(error: Exception) -> Problem:
    """What typer found wrong with the words, said as dhcli says it."""
    from dhcli.errors import nearest

    context = getattr(error, "ctx", None)
    path = context.command_path if context else "dhcli"
    message: str = error.format_message().rstrip(".")  # type: ignore[attr-defined]
    hint = f"{path} --help shows what can be typed"
    params = context.command.get_params(context) if context else []
    known = [name for param in params for name in param.opts]
    takes = {*known, *(f"{name} {param.metavar}" for param in params for name in param.opts)}
    if option := getattr(error, "option_name", ""):
        if "No such" in message:
            message = f"there is no option {option}"
            words = [name.removeprefix("--") for name in known if name.startswith("--")]
            similar = [f"--{word}" for word in nearest(option.lstrip("-"), words, cutoff=0.7)]
            if (instead := INSTEAD.get(option)) in takes:
                similar = [str(instead)]
            near = f"did you mean {' or '.join(similar)}?" if similar else ELSEWHERE.get(option, "")
            near = near or ("options stand behind the command" if path == "dhcli" else "")
            hint = f"{near}; {hint}" if near else hint
    elif message.startswith("No such command"):
        wanted = message.split("'")[1]
        message = f"there is no command {wanted}"
        near = _meant(wanted, context.command.list_commands(context)) if context else ""
        hint = f"{near}; {hint}" if near else hint
    elif message.startswith("Got unexpected extra argument"):
        behind = "joint values stand behind --q; " if "--q" in known else ""
        hint = f"{behind}values that belong together have no blanks between them, or quotes around them; {hint}"
    elif message.startswith("Missing argument"):
        missing = getattr(error, "param", None)
        message = f"{path} needs {message.removeprefix('Missing argument ')}"
        if missing is not None and getattr(missing, "help", None):
            meant = missing.help.rstrip(".")
            meant = meant if meant[1:2].isupper() else meant[0].lower() + meant[1:]
            hint = f"{missing.make_metavar(context)} is {meant}; {hint}"
    message = message.replace("a valid int range", "a whole number").replace("a valid integer range", "a whole number")
    return Problem(message[:1].lower() + message[1:], Place(""), hint)


def _meant(wanted: str, commands: Sequence[str]) -> str:
    """What to type instead of a command that there is not: another one, or the page of the manual that has its name."""
    from dhcli.errors import UnknownNameError, nearest
    from dhcli.files.manual import find_topic

    if meant := CALLED.get(wanted.lower(), ""):
        return f"did you mean dhcli {meant}?"
    if near := nearest(wanted, commands, cutoff=0.6):
        return f"did you mean {' or '.join(near)}?"
    try:
        return f"dhcli help {find_topic(wanted).name} tells of it"
    except UnknownNameError:
        return ""


@contextmanager
def ending_in_order() -> Iterator[None]:
    """Raise `SystemExit` when a signal asks for it; one that is ignored (`nohup`) or has a handler stays as it is."""
    if threading.current_thread() is not threading.main_thread():  # only there may Python set handlers
        yield
        return
    known = {getattr(signal, name): status for name, status in _STATUS.items() if hasattr(signal, name)}
    taken = [number for number in known if signal.getsignal(number) is signal.SIG_DFL]

    def end(number: int, _: FrameType | None) -> None:
        for each in taken:  # what is cleaned up now must not be stopped again; SIGKILL and Ctrl-C still can
            signal.signal(each, signal.SIG_IGN)
        raise SystemExit(known[number])

    for number in taken:
        signal.signal(number, end)
    try:
        yield
    finally:
        for number in taken:
            signal.signal(number, signal.SIG_DFL)
