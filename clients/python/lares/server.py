"""The server itself."""

from typing import Any, Dict, List, cast

from .answers import Backup, State, Status
from .bodies import json_body
from .resource import Resource


class Server(Resource):
    def health(self) -> State:
        """Whether it runs."""
        return cast(State, self._json("/healthz"))

    def ready(self) -> State:
        """Whether it can answer and keep what it is given; LaresError "unavailable" says why not."""
        return cast(State, self._json("/readyz"))

    def status(self) -> Status:
        """Version and counts."""
        return cast(Status, self._json("/v1/status"))

    def metrics(self) -> str:
        """Counts and durations, as Prometheus reads them."""
        return self._file("/metrics", cached=False).text()

    def verify(self) -> Dict[str, Any]:
        """Reads everything and checks it: {"problems", "digest"}; raise `timeout_s` for much."""
        answer = self._transport.request("POST", "/v1/verification", safe=True)
        return cast(Dict[str, Any], answer.json())

    def back_up(self, name: str) -> Backup:
        """Copies everything as it is at one moment, below the server's folder for that."""
        answer = self._transport.request("POST", "/v1/backups", body=json_body({"name": name}))
        return cast(Backup, answer.json())

    def backups(self) -> List[Backup]:
        """The finished ones, by name."""
        return cast(List[Backup], self._json("/v1/backups")["items"])

    def openapi(self) -> Dict[str, Any]:
        """The description of the whole interface."""
        return cast(Dict[str, Any], self._json("/openapi.json"))
