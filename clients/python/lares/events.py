"""Server-sent events, and answers that come line by line."""

import json
from dataclasses import dataclass
from typing import Any, Dict, Iterator, List

from .errors import CutOffError, LaresError
from .transport import Response

_MAX_LINE = 16 << 20


@dataclass(frozen=True)
class Event:
    """One event of a watch: "answer", "change" or "error"; `data` is its JSON."""

    name: str
    data: Dict[str, Any]


def lines_of(pieces: Iterator[bytes]) -> Iterator[str]:
    """Lines without their ends (LF or CR LF), the last one too when it has none."""
    rest = b""
    for piece in pieces:
        lines = (rest + piece).split(b"\n")
        rest = lines.pop()
        if len(rest) > _MAX_LINE:
            raise LaresError("too-large", "a line of the answer is longer than 16 MiB")
        for line in lines:
            yield line.rstrip(b"\r").decode("utf-8", "replace")
    if rest:
        yield rest.decode("utf-8", "replace")


def events_of(response: Response) -> Iterator[Event]:
    """The events of a stream until it ends; an "error" event is raised as LaresError."""
    name = ""
    data: List[str] = []
    for line in lines_of(response.pieces()):
        field, _, value = line.partition(":")
        value = value[1:] if value.startswith(" ") else value
        if line == "":
            if data:
                yield _event(name, "\n".join(data))
            name, data = "", []
        elif field == "event":
            name = value
        elif field == "data":
            data.append(value)


def _event(name: str, text: str) -> Event:
    try:
        data = json.loads(text)
    except ValueError as fault:
        raise CutOffError(f"an event is no JSON: {fault}") from fault
    if not isinstance(data, dict):
        raise CutOffError("an event holds no JSON object")
    if name == "error":
        raise LaresError(str(data.get("code", "error")), str(data.get("detail", "")),
                         int(data.get("status", 0)), str(data.get("hint", "")), problem=data)
    return Event(name or "message", data)
