"""What was downloaded, kept by its hash, so that a robot in a dead zone has its map."""

import hashlib
import json
import os
import tempfile
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Iterator, List, Optional, Union


@dataclass(frozen=True)
class Entry:
    """What is known of one address's content; `sha256` is of the bytes that are kept."""

    url: str
    etag: str
    sha256: str
    size: int
    media_type: str
    file_name: str


class DownloadCache:
    """A folder that several processes may share: blobs by hash, and entries by address.

    Everything appears by renaming, so a reader sees whole files only. `max_bytes` bounds the blobs:
    those longest unused go first.
    """

    def __init__(self, folder: Union[str, "os.PathLike[str]"], max_bytes: Optional[int] = None) -> None:
        self.folder = Path(folder)
        self.max_bytes = max_bytes
        for name in ("blobs", "entries"):
            (self.folder / name).mkdir(parents=True, exist_ok=True, mode=0o700)

    def find(self, url: str) -> Optional[Entry]:
        """The entry of an address, if its bytes are all there and are still those."""
        try:
            entry = Entry(**json.loads(self._entry_path(url).read_text("utf-8")))
            blob = self.blob_path(entry.sha256)
            if entry.url != url or blob.stat().st_size != entry.size:
                return None
            if hash_of(blob) != entry.sha256:
                blob.unlink()  # damaged: as if it had never been here
                return None
            os.utime(blob)
            return entry
        except (OSError, ValueError, TypeError):
            return None

    def blob_path(self, sha256: str) -> Path:
        return self.folder / "blobs" / sha256

    def new_file(self) -> Path:
        """An empty file beside the blobs, for `keep`."""
        handle, name = tempfile.mkstemp(dir=self.folder, prefix="part-")
        os.close(handle)
        return Path(name)

    def keep(self, file: Path, entry: Entry) -> None:
        """Takes `file`, whose hash the entry tells, and makes the entry findable."""
        os.replace(file, self.blob_path(entry.sha256))
        part = self.new_file()
        part.write_text(json.dumps(asdict(entry)), "utf-8")
        os.replace(part, self._entry_path(entry.url))
        if self.max_bytes is not None:
            self.prune(self.max_bytes)

    def prune(self, max_bytes: int) -> None:
        """Removes blobs, those longest unused first, until the rest fits."""
        blobs = sorted(self._blobs(), key=lambda blob: blob.stat().st_mtime, reverse=True)
        total = 0
        for blob in blobs:
            total += blob.stat().st_size
            if total > max_bytes:
                blob.unlink()
        for left in self.folder.glob("part-*"):
            if time.time() - left.stat().st_mtime > 86400:
                left.unlink()  # of a process that died

    def _blobs(self) -> List[Path]:
        return [blob for blob in (self.folder / "blobs").iterdir() if blob.is_file()]

    def _entry_path(self, url: str) -> Path:
        return self.folder / "entries" / (hashlib.sha256(url.encode()).hexdigest() + ".json")


def hash_of(file: Path) -> str:
    digest = hashlib.sha256()
    for piece in pieces_of_file(file):
        digest.update(piece)
    return digest.hexdigest()


def pieces_of_file(file: Path) -> Iterator[bytes]:
    with open(file, "rb") as opened:
        while True:
            piece = opened.read(1 << 20)
            if not piece:
                return
            yield piece
