"""What was downloaded, kept by its hash, so that a robot in a dead zone has its map."""

import hashlib
import json
import os
import tempfile
import time
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Iterator, List, Optional, Union

_DAYS_TO_GO_ON = 7  # with a download that broke off


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
        for name in ("blobs", "entries", "parts"):
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

    @contextmanager
    def place_for(self, url: str) -> Iterator[Path]:
        """Where a download of this address is written, so that a later one can go on with it.

        While another thread or process downloads the same, a place of its own that does not stay.
        """
        place = self.folder / "parts" / hashlib.sha256(url.encode()).hexdigest()
        with open(place.with_suffix(".lock"), "ab") as lock:
            if _lock(lock.fileno()):
                yield place
                return
        with tempfile.TemporaryDirectory(dir=self.folder / "parts") as own:
            yield Path(own) / "download"

    def keep(self, file: Path, entry: Entry) -> None:
        """Takes `file`, whose hash the entry tells, and makes the entry findable."""
        os.replace(file, self.blob_path(entry.sha256))
        handle, part = tempfile.mkstemp(dir=self.folder / "parts")
        with open(handle, "w", encoding="utf-8") as written:
            json.dump(asdict(entry), written)
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
        for left in (self.folder / "parts").iterdir():
            if left.is_file() and time.time() - left.stat().st_mtime > _DAYS_TO_GO_ON * 86400:
                left.unlink()

    def _blobs(self) -> List[Path]:
        return [blob for blob in (self.folder / "blobs").iterdir() if blob.is_file()]

    def _entry_path(self, url: str) -> Path:
        return self.folder / "entries" / (hashlib.sha256(url.encode()).hexdigest() + ".json")


def _lock(handle: int) -> bool:
    """Whether nobody else holds it; where files cannot be locked, nobody is let in."""
    try:
        import fcntl
    except ImportError:
        return False
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True


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
