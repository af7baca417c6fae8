"""Bodies of requests that are sent piece by piece, and can be sent again."""

import json
import os
import secrets
from pathlib import Path
from typing import Callable, Iterator, List, Optional, Sequence, Tuple, Union

Source = Union[bytes, str, "os.PathLike[str]"]
"""Bytes are the content itself; anything else is the path of a file, read while it is sent."""

Progress = Callable[[int, Optional[int]], None]
"""Called with the bytes done so far and all of them, None where that is not known."""

PIECE = 256 * 1024
ANY_TYPE = "application/octet-stream"


def size_of(source: Source) -> int:
    return len(source) if isinstance(source, bytes) else os.stat(source).st_size


def name_of(source: Source, otherwise: str = "") -> str:
    return otherwise if isinstance(source, bytes) else Path(os.fspath(source)).name


def pieces_of(source: Source) -> Iterator[bytes]:
    """The content; raises ValueError when a file changed its size while it was read."""
    if isinstance(source, bytes):
        for at in range(0, len(source), PIECE):
            yield source[at : at + PIECE]
        return
    left = size_of(source)
    with open(source, "rb") as file:
        while left > 0:
            piece = file.read(min(PIECE, left))
            if not piece:
                raise ValueError(f"{os.fspath(source)} became shorter while it was sent")
            left -= len(piece)
            yield piece


class Body:
    """A body of known length; `pieces()` begins anew each time."""

    def __init__(self, source: Source, content_type: str) -> None:
        self.content_type = content_type
        self.length = size_of(source)
        self._sources: List[Source] = [source]

    def pieces(self) -> Iterator[bytes]:
        for source in self._sources:
            yield from pieces_of(source)


class FileRange(Body):
    """The bytes from `begin` to before `end` of a file."""

    def __init__(self, source: "Union[str, os.PathLike[str]]", begin: int, end: int) -> None:
        self.content_type = "application/octet-stream"
        self.length = end - begin
        self.begin = begin
        self._source = source

    def pieces(self) -> Iterator[bytes]:
        left = self.length
        with open(self._source, "rb") as file:
            file.seek(self.begin)
            while left > 0:
                piece = file.read(min(PIECE, left))
                if not piece:
                    raise ValueError(f"{os.fspath(self._source)} became shorter")
                left -= len(piece)
                yield piece


def json_body(value: object) -> Body:
    return Body(json.dumps(value).encode(), "application/json")


class Form(Body):
    """multipart/form-data: text fields, then files as (field, file name, content, media type)."""

    def __init__(
        self, fields: Sequence[Tuple[str, str]], files: Sequence[Tuple[str, str, Source, str]]
    ) -> None:
        boundary = "lares-" + secrets.token_hex(16)
        sources: List[Source] = []
        for name, value in fields:
            sources.append(_part_head(boundary, name) + value.encode() + b"\r\n")
        for name, file_name, source, media_type in files:
            sources += [_part_head(boundary, name, file_name, media_type), source, b"\r\n"]
        sources.append(b"--" + boundary.encode() + b"--\r\n")
        self._sources = sources
        self.length = sum(size_of(source) for source in sources)
        self.content_type = f"multipart/form-data; boundary={boundary}"


def _part_head(
    boundary: str, name: str, file_name: Optional[str] = None, media_type: str = ANY_TYPE
) -> bytes:
    head = f'--{boundary}\r\nContent-Disposition: form-data; name="{_quoted(name)}"'
    if file_name is not None:
        head += f'; filename="{_quoted(file_name)}"\r\nContent-Type: {media_type}'
    return head.encode() + b"\r\n\r\n"


def _quoted(text: str) -> str:
    if any(ord(character) < 32 for character in text):
        raise ValueError(f"a name in a form holds a control character: {text!r}")
    return text.replace("\\", "\\\\").replace('"', '\\"')
