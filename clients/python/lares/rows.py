"""SPARQL's JSON results (W3C, 2013), row by row while they arrive."""

import codecs
import json
from typing import Any, Dict, Iterator, cast

from .errors import CutOffError, LaresError

Row = Dict[str, Dict[str, str]]
"""Variable to term: "type" (uri, literal, bnode), "value", perhaps "datatype" or "xml:lang"."""

_MAX_ROW = 16 << 20


def rows_of(pieces: Iterator[bytes]) -> Iterator[Row]:
    """The bindings one by one; raises CutOffError for a document that is not one or is cut off."""
    decode = codecs.getincrementaldecoder("utf-8")()
    decoder = json.JSONDecoder()
    text = ""
    in_rows = False
    for piece in pieces:
        text += decode.decode(piece)
        if not in_rows:
            head, mark, rest = text.partition('"bindings"')
            colon, bracket, rest = rest.partition("[")
            if not mark or not bracket:
                _check_size(text)
                continue
            text, in_rows = rest, True
        at = 0
        while True:
            while at < len(text) and text[at] in " \t\r\n,":
                at += 1
            if at == len(text):
                break
            if text[at] == "]":
                for unused in pieces:
                    pass  # so that a cut is noticed, and the connection can be used again
                return
            try:
                row, at = decoder.raw_decode(text, at)
            except ValueError:
                break  # not whole yet
            if not isinstance(row, dict):
                raise CutOffError("a row of the answer is no JSON object")
            yield cast(Row, row)
        text = text[at:]
        _check_size(text)
    raise CutOffError("the answer ended before its last row")


def _check_size(text: str) -> None:
    if len(text) > _MAX_ROW:
        raise LaresError("too-large", "a row of the answer is longer than 16 MiB")


def value_of(term: Dict[str, str]) -> Any:
    """A term as Python has it: int, float, bool or str."""
    kind = term.get("datatype", "").rpartition("#")[2]
    text = term.get("value", "")
    if kind in ("integer", "int", "long", "nonNegativeInteger"):
        return int(text)
    if kind in ("decimal", "double", "float"):
        return float(text)
    if kind == "boolean":
        return text in ("true", "1")
    return text
