"""Files on the server: read whole, streamed, or saved with what a bad link needs."""

import hashlib
import json
import os
from dataclasses import dataclass, replace
from email.message import Message
from pathlib import Path
from typing import Dict, Iterator, Optional, Union

from .bodies import Progress
from .cache import DownloadCache, Entry, hash_of, pieces_of_file
from .errors import CutOffError, LaresError, NoServerError
from .transport import Query, Response, Transport, query_text

_AWAY = (502, 503, 504)


@dataclass(frozen=True)
class Saved:
    """A file that was saved. `stale` says that the server was away and could not be asked."""

    path: Path
    size: int
    sha256: str
    media_type: str
    etag: str
    file_name: str
    from_cache: bool = False
    stale: bool = False


class RemoteFile:
    """A file on the server; nothing is asked before one of its methods is called."""

    def __init__(
        self,
        transport: Transport,
        path: str,
        query: Optional[Query] = None,
        accept: Optional[str] = None,
        cache: Optional[DownloadCache] = None,
        offline_ok: bool = False,
    ) -> None:
        self._transport = transport
        self._path = path
        self._query = query or {}
        self._accept = accept
        self._cache = cache
        self._offline_ok = offline_ok

    @property
    def url(self) -> str:
        text = query_text(self._query)
        return self._transport.url + self._path + (f"?{text}" if text else "")

    def open(self) -> Response:
        """The answer as it arrives, past the cache: `with file.open() as answer: …pieces()`."""
        return self._get({})

    def read(self, max_bytes: int = 1 << 30) -> bytes:
        """The whole content in memory; LaresError "too-large" for more than `max_bytes`."""
        if self._cache is not None:
            kept = self._through_cache(self._cache, None)
            _check_size(kept.size, max_bytes)
            return kept.path.read_bytes()
        parts = []
        size = 0
        with self._get({}) as answer:
            for piece in answer.pieces():
                size += len(piece)
                _check_size(size, max_bytes)
                parts.append(piece)
        return b"".join(parts)

    def text(self) -> str:
        return self.read().decode("utf-8")

    def save(
        self,
        to: Union[str, "os.PathLike[str]"],
        progress: Optional[Progress] = None,
        sha256: Optional[str] = None,
    ) -> Saved:
        """Saves it as file `to`, which appears whole and synced or not at all.

        A transfer that breaks off goes on where it ended, also after this process was started anew:
        what came so far is kept beside it as `to`.part. With `sha256` other content is refused
        ("wrong-content"). Memory stays constant.
        """
        target = Path(to)
        if self._cache is not None:
            kept = self._through_cache(self._cache, progress)
            part = target.with_name(target.name + ".part")
            with open(part, "wb") as file:
                for piece in pieces_of_file(kept.path):
                    file.write(piece)
                file.flush()
                os.fsync(file.fileno())
            saved = kept
        else:
            fetched = self._fetch(target, progress, "")
            assert fetched is not None
            part, saved = fetched.path, fetched
        if sha256 is not None and saved.sha256 != sha256:
            part.unlink()
            raise LaresError("wrong-content", f"{self.url} has hash {saved.sha256}, not {sha256}")
        os.replace(part, target)
        _sync_folder(target.parent)
        return replace(saved, path=target)

    # ---- the cache -----------------------------------------------------------------------------

    def _through_cache(self, cache: DownloadCache, progress: Optional[Progress]) -> Saved:
        key = self.url + (f" {self._accept}" if self._accept else "")
        known = cache.find(key)
        with cache.place_for(key) as place:
            try:
                fetched = self._fetch(place, progress, known.etag if known else "")
            except LaresError as fault:
                is_away = isinstance(fault, (NoServerError, CutOffError)) or fault.status in _AWAY
                if known is None or not self._offline_ok or not is_away:
                    raise
                return _kept(cache, known, stale=True)
            if fetched is None:
                assert known is not None
                return _kept(cache, known, stale=False)
            cache.keep(fetched.path, Entry(key, fetched.etag, fetched.sha256, fetched.size,
                                           fetched.media_type, fetched.file_name))
            return replace(fetched, path=cache.blob_path(fetched.sha256))

    # ---- resuming ------------------------------------------------------------------------------

    def _fetch(self, target: Path, progress: Optional[Progress], etag: str) -> Optional[Saved]:
        """The content as file `target`.part, whole; nothing when it still has this `etag`."""
        part = target.with_name(target.name + ".part")
        note = target.with_name(target.name + ".part.json")
        in_vain = 0
        while True:
            before = part.stat().st_size if part.exists() else 0
            headers = _range_headers(part, note, self.url)
            if etag and not headers:
                headers = {"If-None-Match": etag}
            try:
                with self._get(headers) as answer:
                    if answer.status == 304:
                        answer.read()
                        return None
                    if answer.status != 206:
                        note.write_text(
                            json.dumps({"url": self.url, "etag": answer.headers.get("etag", "")}),
                            "utf-8",
                        )
                    saved = _write(answer, part, progress)
                note.unlink(missing_ok=True)
                return saved
            except CutOffError:
                in_vain = 0 if part.stat().st_size > before else in_vain + 1
                if in_vain > self._transport.retries:
                    raise
            except LaresError as fault:
                if fault.code != "range-not-satisfiable":
                    raise
                part.unlink(missing_ok=True)  # longer than what the server has: begin anew
                note.unlink(missing_ok=True)

    def _get(self, headers: Dict[str, str]) -> Response:
        return self._transport.request(
            "GET", self._path, self._query, headers={"Accept": self._accept, **headers}
        )


def _check_size(size: int, most: int) -> None:
    if size > most:
        raise LaresError("too-large", f"more than {most} bytes", hint="save it to a file")


def _kept(cache: DownloadCache, entry: Entry, stale: bool) -> Saved:
    return Saved(cache.blob_path(entry.sha256), entry.size, entry.sha256, entry.media_type,
                 entry.etag, entry.file_name, from_cache=True, stale=stale)


def _range_headers(part: Path, note: Path, url: str) -> Dict[str, str]:
    """What asks for the rest, if what there is belongs to this file and can be asked for."""
    try:
        size = part.stat().st_size
        known = json.loads(note.read_text("utf-8"))
        etag = str(known["etag"])
        if size > 0 and known["url"] == url and etag and not etag.startswith("W/"):
            return {"Range": f"bytes={size}-", "If-Range": etag}
    except (OSError, ValueError, KeyError, TypeError):
        pass
    return {}


def _write(answer: Response, part: Path, progress: Optional[Progress]) -> Saved:
    """Appends a part of content, or writes all of it anew."""
    going_on = answer.status == 206
    size = _begin_of_range(answer) if going_on else 0
    if going_on and size != part.stat().st_size:
        raise LaresError("wrong-content", "the server sent another range than was asked for")
    total = None if answer.length is None else size + answer.length
    digest = hashlib.sha256()
    with open(part, "ab" if going_on else "wb") as file:
        for piece in answer.pieces():
            file.write(piece)
            digest.update(piece)
            size += len(piece)
            if progress is not None:
                progress(size, total)
        file.flush()
        os.fsync(file.fileno())
    return Saved(
        path=part,
        size=size,
        sha256=hash_of(part) if going_on else digest.hexdigest(),
        media_type=answer.headers.get("content-type", ""),
        etag=answer.headers.get("etag", ""),
        file_name=_file_name(answer.headers.get("content-disposition", "")),
    )


def _begin_of_range(answer: Response) -> int:
    text = answer.headers.get("content-range", "").replace("bytes ", "").split("-")[0]
    return int(text) if text.isascii() and text.isdigit() else -1


def _file_name(disposition: str) -> str:
    """The name that the server says, without any folder."""
    message = Message()
    message["Content-Disposition"] = disposition
    name = message.get_filename() or ""
    return name.replace("\\", "/").rsplit("/", 1)[-1]


def _sync_folder(folder: Path) -> None:
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
