"""Reading a file: what is accepted silently, and what is said of all that cannot be read."""

from __future__ import annotations

import errno
import io
import os
import sys
import tracemalloc
from pathlib import Path

import pytest

from dhcli.errors import FileError
from dhcli.files.reading import LIMIT, read_text, source_of


def problem_of(path: Path | str, limit: int = LIMIT) -> str:
    """What is wrong with a file, without the folder."""
    with pytest.raises(FileError) as caught:
        read_text(path, limit=limit)
    (problem,) = caught.value.problems
    return str(problem).replace(f"{Path(path).parent}/", "")


def pipe_in(monkeypatch: pytest.MonkeyPatch, content: bytes) -> None:
    """Put bytes on standard input."""
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(content), encoding="ascii"))


@pytest.mark.parametrize("content", ["θ: 30°\nx\n", "\ufeffθ: 30°\nx\n", "θ: 30°\r\nx\r\n", "θ: 30°\rx\r"])
def test_a_byte_order_mark_and_foreign_line_ends_are_accepted(tmp_path: Path, content: str) -> None:
    """The text is the same wherever it was written."""
    (tmp_path / "a.yaml").write_bytes(content.encode())
    assert read_text(tmp_path / "a.yaml") == "θ: 30°\nx\n"


def test_an_empty_file_is_an_empty_text(tmp_path: Path) -> None:
    """Whether that is wrong is for the caller to say."""
    (tmp_path / "a.yaml").touch()
    assert read_text(str(tmp_path / "a.yaml")) == ""


def test_a_dash_reads_standard_input_as_utf_8(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever encoding the terminal claims."""
    pipe_in(monkeypatch, "\ufeffθ\r\n".encode())
    assert read_text("-") == "θ\n"


def test_a_path_that_is_a_dash_reads_standard_input(monkeypatch: pytest.MonkeyPatch) -> None:
    """The library of names hands a Path back."""
    pipe_in(monkeypatch, b"x")
    assert read_text(Path("-")) == "x"


def test_standard_input_has_the_same_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """An endless pipe is not read to its end."""
    pipe_in(monkeypatch, b"x" * 11)
    assert problem_of("-", limit=10) == "standard input: is 11 bytes, more than the 10 bytes that dhcli reads"


@pytest.mark.parametrize("closed", [True, False])
def test_closed_standard_input_is_a_problem(monkeypatch: pytest.MonkeyPatch, closed: bool) -> None:
    """Started from a service there may be none at all."""
    pipe_in(monkeypatch, b"")
    sys.stdin.close()
    if not closed:
        monkeypatch.setattr(sys, "stdin", None)
    assert problem_of("-").startswith("standard input: cannot be read")


def test_a_missing_file_names_what_is_like_it(tmp_path: Path) -> None:
    """The usual cause is a slip of the finger."""
    (tmp_path / "scara.yaml").touch()
    assert problem_of(tmp_path / "scra.yaml") == "scra.yaml: there is no such file (did you mean scara.yaml?)"


def test_a_missing_folder_is_a_missing_file(tmp_path: Path) -> None:
    """There is nothing to compare its name with."""
    told = problem_of(tmp_path / "nowhere" / "a.yaml")
    assert told.endswith(f"a.yaml: there is no such file (there is no folder {tmp_path / 'nowhere'})")


def test_a_file_that_is_only_a_little_like_it_is_not_named(tmp_path: Path) -> None:
    """An ending is shared by all; the folder that was looked in tells more."""
    (tmp_path / "panda.yaml").touch()
    told = problem_of(tmp_path / "planar.yaml")
    assert told.endswith(f"planar.yaml: there is no such file (looked in {tmp_path})")


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    """`scara.yaml/x` is not there either."""
    (tmp_path / "a.yaml").touch()
    assert "x: there is no such file" in problem_of(tmp_path / "a.yaml" / "x")


def test_a_folder_is_not_a_file(tmp_path: Path) -> None:
    """The shell completes folders, so they are typed."""
    (tmp_path / "robots").mkdir()
    assert problem_of(tmp_path / "robots") == "robots: is a folder, not a file"


def test_a_file_without_permission_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulated, because the tests may run as root, who may read everything."""
    (tmp_path / "a.yaml").touch()

    def refuse(path: object, mode: str) -> None:
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(path))

    monkeypatch.setattr("builtins.open", refuse)
    assert problem_of(tmp_path / "a.yaml") == "a.yaml: may not be read: no permission"


def test_another_failure_says_what_the_system_says(tmp_path: Path) -> None:
    """A link to itself, for one."""
    (tmp_path / "loop.yaml").symlink_to(tmp_path / "loop.yaml")
    assert problem_of(tmp_path / "loop.yaml") == f"loop.yaml: cannot be read: {os.strerror(errno.ELOOP)}"


def test_a_large_file_is_refused_without_being_read(tmp_path: Path) -> None:
    """100 MB on disk take no more memory than any file may."""
    path = tmp_path / "large.yaml"
    with path.open("wb") as stream:
        stream.truncate(100_000_000)
    tracemalloc.start()
    try:
        said = problem_of(path)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert said == "large.yaml: is 100 MB, more than the 256 kB that dhcli reads"
    assert peak < 4 * LIMIT


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="this system has no endless device")
def test_a_file_without_end_or_size_is_refused() -> None:
    """A device says that it has no size."""
    assert problem_of("/dev/zero") == "zero: is more than the 256 kB that dhcli reads"


def test_a_file_of_exactly_the_limit_is_read(tmp_path: Path) -> None:
    """And one byte more is not."""
    (tmp_path / "a.yaml").write_text("x" * LIMIT)
    assert len(read_text(tmp_path / "a.yaml")) == LIMIT
    assert problem_of(tmp_path / "a.yaml", LIMIT - 1) == "a.yaml: is 256 kB, more than the 256 kB that dhcli reads"


def test_a_binary_file_is_not_text(tmp_path: Path) -> None:
    """A NUL byte stands in no text."""
    (tmp_path / "a.png").write_bytes(b"\x89PNG\r\n\x1a\n\0\0")
    assert problem_of(tmp_path / "a.png") == "a.png: is not a text file: byte 9 is NUL"


@pytest.mark.parametrize("mark", [b"\xff\xfe", b"\xfe\xff"])
def test_a_file_in_utf_16_is_called_that(tmp_path: Path, mark: bytes) -> None:
    """The shell of Windows writes such files."""
    (tmp_path / "a.yaml").write_bytes(mark + "a: 1".encode("utf-16-le"))
    assert problem_of(tmp_path / "a.yaml") == "a.yaml: is written in UTF-16 (save it as UTF-8)"


def test_a_file_in_latin_1_says_where_and_which_character(tmp_path: Path) -> None:
    """The degree sign is the usual one; the column counts characters."""
    (tmp_path / "a.yaml").write_bytes("a: 1\r\nθ: ".encode() + b"30\xb0\n")
    assert problem_of(tmp_path / "a.yaml") == (
        "a.yaml:2:6: is not UTF-8: byte 13 is 0xB0 (save the file as UTF-8; if it is Latin-1, this byte is '°')"
    )


def test_a_file_cut_inside_a_character_says_where(tmp_path: Path) -> None:
    """The first byte of the piece is named."""
    (tmp_path / "a.yaml").write_bytes("a: 30°".encode()[:-1])
    assert problem_of(tmp_path / "a.yaml").startswith("a.yaml:1:6: is not UTF-8: byte 6 is 0xC2")


def test_messages_call_a_dash_standard_input() -> None:
    """And a file as it was written."""
    assert (source_of("-"), source_of(Path("-")), source_of("./a.yaml")) == (
        "standard input",
        "standard input",
        "./a.yaml",
    )
