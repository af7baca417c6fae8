"""Faults, as the server tells them (RFC 9457) and as the way to it gives them."""

import json
from typing import Any, Dict, List, Mapping, Optional


class LaresError(Exception):
    """A fault. `code` is stable: what programs look at; `status` is HTTP's, 0 where none came.

    `problem` is the whole problem document, with members of its own for some codes: `match`,
    `smallest_repair` and `choices` for a plan that cannot be made.
    """

    def __init__(
        self,
        code: str,
        detail: str,
        status: int = 0,
        hint: str = "",
        candidates: Optional[List[str]] = None,
        request_id: str = "",
        problem: Optional[Dict[str, Any]] = None,
    ) -> None:
        super().__init__(detail)
        self.code = code
        self.detail = detail
        self.status = status
        self.hint = hint
        self.candidates = list(candidates or [])
        self.request_id = request_id
        self.problem: Dict[str, Any] = dict(problem or {})
        self.retry_after_s: Optional[float] = None

    def __str__(self) -> str:
        text = f"{self.code}: {self.detail}"
        place = self.problem.get("place")
        if isinstance(place, dict) and "line" in place:
            text += f" ({place.get('source', 'line')}:{place['line']}:{place.get('column', 1)})"
        if self.candidates:
            text += "; did you mean " + ", ".join(self.candidates) + "?"
        return text + (f" [{self.hint}]" if self.hint else "")


class NoServerError(LaresError):
    """No answer came: the server is not there, or the connection broke (`code` "no-server")."""

    def __init__(self, detail: str, was_sent: bool) -> None:
        super().__init__("no-server", detail)
        self.was_sent = was_sent  # the server may have acted on the request


class CutOffError(LaresError):
    """An answer began and did not end (`code` "cut-off")."""

    def __init__(self, detail: str) -> None:
        super().__init__("cut-off", detail)


def error_of_response(status: int, headers: Mapping[str, str], body: bytes) -> LaresError:
    """The fault that an answer of 400 or above tells; any server's, not only a Lares server's."""
    problem: Dict[str, Any] = {}
    try:
        read = json.loads(body.decode("utf-8", "replace"))
        problem = read if isinstance(read, dict) else {}
    except ValueError:
        pass
    candidates = problem.get("candidates")
    error = LaresError(
        code=str(problem.get("code", f"http-{status}")),
        detail=str(problem.get("detail") or body[:200].decode("utf-8", "replace") or "no detail"),
        status=status,
        hint=str(problem.get("hint", "")),
        candidates=[str(one) for one in candidates] if isinstance(candidates, list) else [],
        request_id=headers.get("x-request-id", str(problem.get("instance", ""))),
        problem=problem,
    )
    error.retry_after_s = _seconds(headers.get("retry-after", ""))
    return error


def _seconds(text: str) -> Optional[float]:
    return float(text) if text.isascii() and text.isdigit() else None
