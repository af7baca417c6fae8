"""The server itself."""

from typing import Any, Dict, cast

from .answers import State, Status
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

    def openapi(self) -> Dict[str, Any]:
        """The description of the whole interface."""
        return cast(Dict[str, Any], self._json("/openapi.json"))
