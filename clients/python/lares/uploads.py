"""Resumable uploads (tus 1.0): large layers over bad links."""

import base64
import os
from dataclasses import dataclass
from typing import Dict, Optional, Union

from .bodies import FileRange, Progress, name_of, size_of
from .errors import LaresError, NoServerError
from .resource import Resource

PIECE_TYPE = "application/offset+octet-stream"
REFERENCE_TYPE = "application/vnd.lares.upload"

_PIECE_BYTES = 32 << 20
_TUS = {"Tus-Resumable": "1.0.0"}


@dataclass(frozen=True)
class Upload:
    """A finished upload: may be given to `environments.put_version` in the place of a layer."""

    path: str
    file_name: str


class Uploads(Resource):
    def send(
        self,
        source: Union[str, "os.PathLike[str]"],
        path: Optional[str] = None,
        progress: Optional[Progress] = None,
    ) -> Upload:
        """Uploads a file, going on where it stopped as long as anything arrives.

        With `path`, of an earlier upload of the same file (`create`), goes on with that one, also
        in a later process. The server keeps an upload for a day after its last byte.
        """
        total = size_of(source)
        path = path or self.create(total, name_of(source))
        offset = self.offset(path)
        in_vain = 0
        while offset < total:
            end = min(offset + _PIECE_BYTES, total)
            try:
                offset = self.continue_(path, FileRange(source, offset, end))
                in_vain = 0
            except NoServerError:
                before, offset = offset, self.offset(path)
                in_vain = 0 if offset > before else in_vain + 1
                if in_vain > self._transport.retries:
                    raise
            if progress is not None:
                progress(offset, total)
        return Upload(path, name_of(source))

    def describe(self) -> Dict[str, str]:
        """What the server can do: its headers Tus-Version, Tus-Extension, Tus-Max-Size."""
        answer = self._transport.request("OPTIONS", "/v1/uploads", safe=True)
        answer.read()
        return {name: one for name, one in answer.headers.items() if name.startswith("tus-")}

    def create(self, length: int, file_name: str = "") -> str:
        """Begins an upload of so many bytes; its path."""
        name = base64.b64encode(file_name.encode()).decode()
        answer = self._transport.request(
            "POST", "/v1/uploads",
            headers={**_TUS, "Upload-Length": str(length),
                     "Upload-Metadata": f"filename {name}" if file_name else None},
        )
        answer.read()
        return answer.headers["location"]

    def offset(self, path: str) -> int:
        """How many bytes the server has, synced."""
        answer = self._transport.request("HEAD", path, headers=_TUS)
        answer.read()
        return _offset_of(answer.headers)

    def continue_(self, path: str, piece: FileRange) -> int:
        """Sends the next piece, which begins where the server is; where it is then."""
        piece.content_type = PIECE_TYPE
        answer = self._transport.request(
            "PATCH", path, body=piece, headers={**_TUS, "Upload-Offset": str(piece.begin)}
        )
        answer.read()
        return _offset_of(answer.headers)

    def remove(self, path: str) -> None:
        """Gives an upload up; what was made of it stays."""
        self._transport.request("DELETE", path, headers=_TUS).read()


def _offset_of(headers: Dict[str, str]) -> int:
    text = headers.get("upload-offset", "")
    if not (text.isascii() and text.isdigit()):
        raise LaresError("wrong-content", "the answer tells no Upload-Offset")
    return int(text)
