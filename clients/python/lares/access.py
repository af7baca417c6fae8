"""Tokens, and the log of who wrote what."""

from typing import Iterator, Optional, Sequence, cast

from .answers import AuditRecord, NewToken, Token
from .bodies import json_body
from .resource import Resource
from .transport import path_of


class Tokens(Resource):
    def create(
        self,
        label: str,
        role: str,
        *,
        environments: Sequence[str] = (),
        expires: Optional[str] = None,
        max_requests_per_minute: Optional[int] = None,
        max_bytes_per_day: Optional[int] = None,
        max_queries: Optional[int] = None,
    ) -> Token:
        """Makes a token of role reader, robot, editor or admin.

        Its text is member "token" of this answer and is never shown again. `environments` are ids,
        or beginnings of ids that end with "*". The first token has to be an admin's; from then on
        every request needs one.
        """
        wanted = {"label": label, "role": role, "environments": list(environments) or None,
                  "expires": expires, "max_requests_per_minute": max_requests_per_minute,
                  "max_bytes_per_day": max_bytes_per_day, "max_queries": max_queries}
        body = cast(NewToken, {name: one for name, one in wanted.items() if one is not None})
        answer = self._transport.request("POST", "/v1/tokens", body=json_body(body))
        return cast(Token, answer.json())

    def list(self) -> Iterator[Token]:
        """All that were made, revoked ones too, without their text."""
        return self._items("/v1/tokens")

    def get(self, id: str) -> Token:
        return cast(Token, self._json(path_of("tokens", id)))

    def revoke(self, id: str) -> Token:
        """From now on it is refused; the last one of an admin cannot be ("conflict")."""
        return cast(Token, self._transport.request("DELETE", path_of("tokens", id)).json())


class Audit(Resource):
    def list(self, *, since: Optional[str] = None, token: Optional[str] = None,
             environment: Optional[str] = None) -> Iterator[AuditRecord]:
        """What was written, and what was refused, newest first; `since` is 2026-01-31T12:00:00Z."""
        query = {"since": since, "token": token, "environment": environment}
        return self._items("/v1/audit", query)
