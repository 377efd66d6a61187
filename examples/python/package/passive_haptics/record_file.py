"""A file of records that is only appended to: a process that is killed leaves each record whole or not at
all."""

from __future__ import annotations

import errno
import fcntl
import os
import struct
import zlib
from types import TracebackType
from typing import Union

HEADER = b"passive_haptics records 1\n"
"""The first bytes of the file."""
FRAME = struct.Struct("<QI")
"""What stands before each record: its length [bytes], and the CRC-32 of that length and the record."""

Path = Union[str, "os.PathLike[str]"]

# Files that this process has open. The system's locks keep out other processes alone, and all of a file's end where one
# of its descriptors is closed. Locks of the other kind (flock) would outlive this process in those that it started.
_open_here: set[tuple[int, int]] = set()


def _identity_of(found: os.stat_result) -> tuple[int, int]:
    return found.st_dev, found.st_ino


def _checksum(record: bytes) -> int:
    return zlib.crc32(record, zlib.crc32(struct.pack("<Q", len(record))))


class record_file:
    """The file at a path, made if it does not exist, open once at a time.

    Opening reads `records`. What follows the last whole record is cut off: it is what a process that was
    killed, or a full disk, left of one. Throws ValueError if it is another kind of file, BlockingIOError if
    it is open, here or in another process, OSError as of the system.
    """

    records: list[bytes]
    """The records that the file held when it was opened, oldest first."""

    def __init__(self, path: Path) -> None:
        self._path = os.fspath(path)
        if os.path.exists(self._path) and _identity_of(os.stat(self._path)) in _open_here:
            raise self._in_use()
        self._file = os.open(self._path, os.O_RDWR | os.O_CREAT | os.O_APPEND, 0o666)
        self._identity = _identity_of(os.fstat(self._file))
        _open_here.add(self._identity)
        try:
            self._lock()
            self.records = self._read()
        except BaseException:
            self._close()
            raise

    def append(self, record: bytes) -> None:
        """Adds a record; it is on the disk when this returns. Throws OSError, and then the file is as
        before."""
        self._write(FRAME.pack(len(record), _checksum(record)) + record)

    def __enter__(self) -> record_file:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._close()

    def _close(self) -> None:
        os.close(self._file)
        _open_here.discard(self._identity)

    def _lock(self) -> None:
        try:
            fcntl.lockf(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno not in (errno.EAGAIN, errno.EACCES):
                raise
            raise self._in_use() from None

    def _in_use(self) -> BlockingIOError:
        text = f"passive_haptics: file = {self._path} is in use, expected one that no other sweep writes"
        return BlockingIOError(errno.EAGAIN, text)

    def _read(self) -> list[bytes]:
        with open(self._file, "rb", closefd=False) as file:
            content = file.read()
        if not content.startswith(HEADER):
            if not HEADER.startswith(content):
                raise ValueError(f"passive_haptics: file = {self._path}, expected a new file or one of records")
            os.ftruncate(self._file, 0)
            self._write(HEADER)
            return []
        records, end = [], len(HEADER)
        while end + FRAME.size <= len(content):
            length, checksum = FRAME.unpack_from(content, end)
            record = content[end + FRAME.size : end + FRAME.size + length]
            if len(record) != length or _checksum(record) != checksum:
                break
            records.append(record)
            end += FRAME.size + length
        os.ftruncate(self._file, end)
        return records

    def _write(self, content: bytes) -> None:
        before = os.fstat(self._file).st_size
        try:
            left = memoryview(content)
            while left:
                left = left[os.write(self._file, left) :]
            os.fsync(self._file)
        except BaseException:
            os.ftruncate(self._file, before)
            raise
