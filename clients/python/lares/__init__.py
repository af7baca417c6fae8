"""Client of Lares, the knowledge-based semantic mapping engine for service robots."""

from .cache import DownloadCache
from .client import Client
from .environments import pack_grid
from .errors import CutOffError, LaresError, NoServerError
from .events import Event
from .questions import Watch, plan_request
from .remote_file import RemoteFile, Saved
from .rows import Row, value_of
from .transport import Response
from .uploads import Upload

__version__ = "0.1.0"
__all__ = [
    "Client", "CutOffError", "DownloadCache", "Event", "LaresError", "NoServerError", "RemoteFile",
    "Response", "Row", "Saved", "Upload", "Watch", "pack_grid", "plan_request", "value_of",
]
