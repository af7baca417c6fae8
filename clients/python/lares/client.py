"""The client: one attribute for each resource."""

import os
from pathlib import Path
from typing import Callable, Optional, Union

from .access import Audit, Tokens
from .cache import DownloadCache
from .environments import Environments
from .knowledge import (
    ObjectModels,
    Ontology,
    Priors,
    Quarantine,
    Recipes,
    Robots,
    SkillTemplates,
)
from .questions import LikelyPlacesOf, Plans, Prolog, Reasons, Sparql, Watches
from .server import Server
from .transport import Transport
from .uploads import Uploads


class Client:
    """A Lares server. May be used by several threads; a context manager that closes it.

    `url` is by default LARES_SERVER or http://127.0.0.1:8080, `token` LARES_TOKEN. `ca_file` names
    the certificates to trust instead of the system's. With `cache_dir`, what is downloaded is kept
    by its hash and asked for again by its ETag only; with `offline_ok` the kept copy is given when
    the server is away (`Saved.stale` says so).
    """

    def __init__(
        self,
        url: Optional[str] = None,
        token: Optional[str] = None,
        ca_file: Optional[str] = None,
        timeout_s: float = 60.0,
        retries: int = 3,
        cache_dir: Union[None, str, "os.PathLike[str]"] = None,
        cache_max_bytes: Optional[int] = None,
        offline_ok: bool = False,
    ) -> None:
        where = url or os.environ.get("LARES_SERVER") or "http://127.0.0.1:8080"
        secret = token if token is not None else os.environ.get("LARES_TOKEN") or None
        if offline_ok and cache_dir is None:
            raise ValueError("offline_ok needs a cache_dir to have copies in")
        self.transport = Transport(where, secret, ca_file, timeout_s, retries)
        self.cache = DownloadCache(Path(cache_dir), cache_max_bytes) if cache_dir else None
        shared = (self.transport, self.cache, offline_ok)
        self.ontology = Ontology(*shared)
        self.priors = Priors(*shared)
        self.recipes = Recipes(*shared)
        self.skill_templates = SkillTemplates(*shared)
        self.robots = Robots(*shared)
        self.object_models = ObjectModels(*shared)
        self.environments = Environments(*shared)
        self.quarantine = Quarantine(*shared)
        self.plans = Plans(*shared)
        self.likely_places = LikelyPlacesOf(*shared)
        self.sparql = Sparql(*shared)
        self.prolog = Prolog(*shared)
        self.reasons = Reasons(*shared)
        self.watches = Watches(*shared)
        self.server = Server(*shared)
        self.uploads = Uploads(*shared)
        self.tokens = Tokens(*shared)
        self.audit = Audit(*shared)

    def on_request(self, log: Optional[Callable[[str, str, int], None]]) -> None:
        """Calls `log(method, target, status)` for each answer that arrives."""
        self.transport.log = log

    def close(self) -> None:
        self.transport.close()

    def __enter__(self) -> "Client":
        return self

    def __exit__(self, *unused: object) -> None:
        self.close()
