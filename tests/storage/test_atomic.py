"""Writing a file whole or not at all."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path

import pytest

from dhcli.errors import FileError
from dhcli.storage.atomic import whole_file, write_whole


def problem_of(path: Path | str, content: str = "new", *, overwrite: bool = False) -> str:
    """What stops a file from being written, without the folder."""
    with pytest.raises(FileError) as caught:
        write_whole(path, content, overwrite=overwrite)
    (problem,) = caught.value.problems
    return str(problem).replace(f"{Path(path).parent}/", "")


def fail_with(monkeypatch: pytest.MonkeyPatch, function: str, number: int) -> None:
    """Make a function of `os` fail as the system would."""

    def fail(*_: object) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(os, function, fail)


def test_a_new_file_is_written_as_utf_8_with_its_own_line_ends(tmp_path: Path) -> None:
    """And with nothing beside it."""
    write_whole(tmp_path / "a.yaml", "θ: 30°\nx\r\n", overwrite=False)
    assert (tmp_path / "a.yaml").read_bytes() == "θ: 30°\nx\r\n".encode()
    assert os.listdir(tmp_path) == ["a.yaml"]


def test_bytes_are_written_as_they_are(tmp_path: Path) -> None:
    """Pictures and arrays."""
    write_whole(str(tmp_path / "a.npy"), b"\x93NUMPY\0", overwrite=False)
    assert (tmp_path / "a.npy").read_bytes() == b"\x93NUMPY\0"


@pytest.mark.skipif(os.name != "posix", reason="permissions are POSIX's")
def test_a_new_file_has_the_permissions_that_are_usual(tmp_path: Path) -> None:
    """Others may read it where others may read what the user writes."""
    before = os.umask(0o027)
    try:
        write_whole(tmp_path / "a", "x", overwrite=False)
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "a").stat().st_mode) == 0o640


def test_a_file_is_not_overwritten_unless_told(tmp_path: Path) -> None:
    """A student's sheet is not lost to `start`."""
    (tmp_path / "a").write_text("old")
    assert problem_of(tmp_path / "a") == "a: exists already (choose another name, or allow overwriting)"
    assert (tmp_path / "a").read_text() == "old"


@pytest.mark.skipif(os.name != "posix", reason="permissions are POSIX's")
def test_an_overwritten_file_keeps_its_permissions(tmp_path: Path) -> None:
    """A private file stays private."""
    (tmp_path / "a").write_text("old")
    (tmp_path / "a").chmod(0o600)
    write_whole(tmp_path / "a", "new", overwrite=True)
    assert (tmp_path / "a").read_text() == "new"
    assert stat.S_IMODE((tmp_path / "a").stat().st_mode) == 0o600
    assert os.listdir(tmp_path) == ["a"]


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    """What it points to is replaced."""
    (tmp_path / "real").write_text("old")
    (tmp_path / "link").symlink_to("real")
    write_whole(tmp_path / "link", "new", overwrite=True)
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_text() == "new"


def test_a_folder_is_not_replaced(tmp_path: Path) -> None:
    """Not even if overwriting is allowed."""
    (tmp_path / "robots").mkdir()
    assert problem_of(tmp_path / "robots", overwrite=True) == "robots: is a folder (name a file in it)"


@pytest.mark.skipif(not Path("/dev/null").is_char_device(), reason="this system has no such device")
def test_a_device_is_written_and_never_replaced() -> None:
    """Root could replace `/dev/null` for everyone."""
    write_whole("/dev/null", "x", overwrite=False)
    assert Path("/dev/null").is_char_device()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no full device")
def test_a_full_device_says_that_it_is_full() -> None:
    """The same words as for a disk."""
    assert problem_of("/dev/full") == "full: cannot be written: the disk is full"


@pytest.mark.parametrize("overwrite", [True, False])
def test_a_full_disk_leaves_the_folder_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, overwrite: bool
) -> None:
    """The old file whole, no half of the new one."""
    if overwrite:
        (tmp_path / "a").write_text("old")
    fail_with(monkeypatch, "fsync", errno.ENOSPC)
    assert problem_of(tmp_path / "a", overwrite=overwrite) == "a: cannot be written: the disk is full"
    assert [path.read_text() for path in tmp_path.iterdir()] == (["old"] if overwrite else [])


def test_an_interrupt_leaves_the_folder_as_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Ctrl-C is not swallowed either."""

    def interrupt(_: int) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", interrupt)
    with pytest.raises(KeyboardInterrupt):
        write_whole(tmp_path / "a", "new", overwrite=False)
    assert os.listdir(tmp_path) == []


def test_an_interrupt_as_soon_as_the_file_is_there_leaves_the_folder_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between the moment when the system has made it and the first thing that is done with it."""

    def interrupted(path: Path, mode: str) -> None:
        path.touch(exist_ok=False)
        assert os.listdir(tmp_path) != []
        raise KeyboardInterrupt(mode)

    with monkeypatch.context() as patched:
        patched.setattr("builtins.open", interrupted)
        with pytest.raises(KeyboardInterrupt):
            write_whole(tmp_path / "a", "new", overwrite=False)
    assert os.listdir(tmp_path) == []


def test_a_missing_folder_is_named(tmp_path: Path) -> None:
    """It is not made on the way: it may be a slip."""
    said = problem_of(tmp_path / "nowhere" / "a")
    assert said == f"a: cannot be written: there is no folder {tmp_path / 'nowhere'} (make it first)"


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    """`a/b` where `a` is a file."""
    (tmp_path / "a").touch()
    assert problem_of(tmp_path / "a" / "b").startswith(f"b: cannot be written: there is no folder {tmp_path / 'a'}")


def test_a_folder_without_permission_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulated, because the tests may run as root, who may write everywhere."""

    def refuse(*_: object) -> None:
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr("builtins.open", refuse)
    assert problem_of(tmp_path / "a") == "a: cannot be written: no permission"


def test_another_failure_says_what_the_system_says(tmp_path: Path) -> None:
    """A name too long, for one."""
    assert problem_of(tmp_path / ("x" * 300)).endswith(f"cannot be written: {os.strerror(errno.ENAMETOOLONG)}")


def test_half_a_character_is_not_written(tmp_path: Path) -> None:
    """An argument that is not UTF-8 reaches Python as such."""
    assert problem_of(tmp_path / "a", "x\udcb0") == "a: cannot be written: U+DCB0 has no UTF-8"
    assert os.listdir(tmp_path) == []


def test_a_file_written_in_pieces_appears_when_all_are_there(tmp_path: Path) -> None:
    """Whoever looks meanwhile finds the old one."""
    (tmp_path / "a").write_text("old")
    with whole_file(tmp_path / "a", overwrite=True) as stream:
        stream.write(b"one, ")
        stream.flush()
        assert (tmp_path / "a").read_text() == "old"
        stream.write(b"two")
    assert (tmp_path / "a").read_text() == "one, two"
    assert os.listdir(tmp_path) == ["a"]


@pytest.mark.parametrize("error", [KeyboardInterrupt, FileError, ValueError])
def test_work_that_fails_half_way_leaves_no_file(tmp_path: Path, error: type[BaseException]) -> None:
    """Whatever stopped it goes on as it is."""

    def work() -> None:
        with whole_file(tmp_path / "a", overwrite=False) as stream:
            stream.write(b"half")
            raise error("q.csv is cut off")

    with pytest.raises(error):
        work()
    assert os.listdir(tmp_path) == []
