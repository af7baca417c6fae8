"""What all resources have in common."""

from pathlib import Path
from typing import Any, Dict, Iterator, Optional, cast

from .bodies import Body, Progress, Source, name_of
from .answers import Document, PutAnswer
from .cache import DownloadCache
from .remote_file import RemoteFile
from .transport import Query, Transport, path_of

_MEDIA_TYPES = {
    ".ttl": "text/turtle",
    ".trig": "application/trig",
    ".nt": "application/n-triples",
    ".nq": "application/n-quads",
    ".ofn": "text/owl-functional",
    ".owx": "application/owl+xml",
    ".jsonld": "application/ld+json",
    ".urdf": "application/urdf+xml",
    ".tsv": "text/tab-separated-values",
}


class Resource:
    def __init__(
        self, transport: Transport, cache: Optional[DownloadCache], offline_ok: bool
    ) -> None:
        self._transport = transport
        self._cache = cache
        self._offline_ok = offline_ok

    def _json(self, path: str, query: Optional[Query] = None) -> Any:
        headers = {"Accept": "application/json"}
        return self._transport.request("GET", path, query, headers=headers).json()

    def _file(
        self, path: str, query: Optional[Query] = None, accept: Optional[str] = None,
        cached: bool = True,
    ) -> RemoteFile:
        cache = self._cache if cached else None
        return RemoteFile(self._transport, path, query, accept, cache, self._offline_ok)

    def _items(self, path: str, query: Optional[Query] = None) -> Iterator[Any]:
        """Every item of a list, page by page as they are taken."""
        after: Optional[str] = None
        while True:
            page = self._json(path, {**(query or {}), "limit": 1000, "after": after})
            yield from page["items"]
            after = page["next"]
            if after is None:
                return


class Documents(Resource):
    """Documents that are kept in all versions: recipes, robots, ontology modules and the like."""

    collection = ""

    def put(
        self,
        source: Source,
        id: Optional[str] = None,
        *,
        file_name: Optional[str] = None,
        media_type: Optional[str] = None,
        recover: bool = False,
        editor: bool = False,
        quarantine: bool = False,
        if_match: Optional[str] = None,
        only_new: bool = False,
        progress: Optional[Progress] = None,
    ) -> PutAnswer:
        """Stores a document; its id is the stem of its file's name, unless given.

        `if_match` is the ETag that the stored one must still have; `only_new` refuses to replace
        any. Both fail as "precondition-failed". With `quarantine`, a document that contradicts what
        is known is kept aside, and the answer says so.
        """
        name = file_name or name_of(source)
        chosen = id or Path(name).stem
        if not chosen:
            raise ValueError("content without a file name needs an id")
        return self._put(
            "PUT", self._path(chosen), source, name, media_type,
            {"recover": recover, "editor": editor, "quarantine": quarantine},
            if_match, only_new, progress,
        )

    def add(
        self,
        source: Source,
        *,
        file_name: Optional[str] = None,
        media_type: Optional[str] = None,
        recover: bool = False,
        editor: bool = False,
        quarantine: bool = False,
        only_new: bool = False,
        idempotency_key: Optional[str] = None,
    ) -> PutAnswer:
        """Stores a document under an id that the server takes from its file's name."""
        name = file_name or name_of(source)
        return self._put(
            "POST", "/v1/" + self.collection, source, name, media_type,
            {"recover": recover, "editor": editor, "quarantine": quarantine},
            None, only_new, None, idempotency_key,
        )

    def list(self) -> Iterator[Document]:
        """Everything that is stored, by id."""
        return self._items("/v1/" + self.collection)

    def info(self, id: str, version: Optional[int] = None) -> Document:
        """What is known of a document: version, ETag, hash, names."""
        return cast(Document, self._json(self._path(id), {"as": "info", "version": version}))

    def file(self, id: str, version: Optional[int] = None) -> RemoteFile:
        """The document as it was received."""
        return self._file(self._path(id), {"version": version})

    def versions(self, id: str) -> Iterator[Document]:
        """All versions, newest first, those of a deleted document too."""
        return self._items(self._path(id) + "/versions")

    def delete(self, id: str, *, if_match: Optional[str] = None) -> None:
        """Removes it from lists and answers; its versions stay readable."""
        self._transport.delete(self._path(id), if_match)

    def _path(self, id: str) -> str:
        return path_of(*self.collection.split("/"), id)

    def _put(
        self, method: str, path: str, source: Source, file_name: str, media_type: Optional[str],
        query: Dict[str, Any], if_match: Optional[str], only_new: bool,
        progress: Optional[Progress], idempotency_key: Optional[str] = None,
    ) -> PutAnswer:
        guessed = _MEDIA_TYPES.get(Path(file_name).suffix.lower(), "application/octet-stream")
        answer = self._transport.request(
            method, path, {**query, "file_name": file_name or None},
            body=Body(source, media_type or guessed),
            headers=conditions(if_match, only_new, idempotency_key),
            progress=progress,
        )
        return cast(PutAnswer, answer.json())


def conditions(
    if_match: Optional[str], only_new: bool, idempotency_key: Optional[str] = None
) -> Dict[str, Optional[str]]:
    if if_match is not None and only_new:
        raise ValueError("if_match and only_new exclude each other")
    return {
        "If-Match": if_match,
        "If-None-Match": "*" if only_new else None,
        "Idempotency-Key": idempotency_key,
    }
