"""Requests over HTTP: connections that are kept, retries, TLS, the token."""

import http.client
import json
import random
import socket
import ssl
import threading
import time
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Tuple, Union
from urllib.parse import quote, urlencode, urlsplit

from .bodies import PIECE, Body, Progress
from .errors import CutOffError, LaresError, NoServerError, error_of_response

Query = Mapping[str, Union[None, str, int, float, bool, List[str]]]

RETRIED_STATUSES = (429, 502, 503)
_IDLE_CONNECTIONS = 8
_LOOPBACK = ("127.0.0.1", "localhost", "::1")


def path_of(*segments: Union[str, int]) -> str:
    """A path below /v1, each segment percent-encoded."""
    return "/v1/" + "/".join(quote(str(segment), safe="") for segment in segments)


def query_text(query: Query) -> str:
    pairs: List[Tuple[str, str]] = []
    for name, value in query.items():
        if value is None or value is False:
            continue
        if isinstance(value, list):
            pairs += [(name, one) for one in value]
        else:
            pairs.append((name, "true" if value is True else str(value)))
    return urlencode(pairs)


class Response:
    """An answer whose body is still to be read; a context manager that ends it."""

    def __init__(
        self,
        raw: http.client.HTTPResponse,
        release: Callable[[bool], None],
        interrupt: Callable[[], None],
        is_head: bool,
    ) -> None:
        self._is_head = is_head
        self.status = raw.status
        self.headers: Dict[str, str] = {name.lower(): value for name, value in raw.getheaders()}
        self._raw = raw
        self._release: Optional[Callable[[bool], None]] = release
        self._interrupt = interrupt

    @property
    def length(self) -> Optional[int]:
        text = self.headers.get("content-length", "")
        return int(text) if text.isascii() and text.isdigit() else None

    def pieces(self) -> Iterator[bytes]:
        """The body as it arrives; raises CutOffError when it does not end as it should."""
        got = 0
        while True:
            try:
                piece = self._raw.read1(PIECE)
            except (OSError, http.client.HTTPException, ValueError) as fault:
                self.close()
                raise CutOffError(f"the answer broke off after {got} bytes: {fault}") from fault
            if not piece:
                break
            got += len(piece)
            yield piece
        no_body = self._is_head or self.status == 304
        whole = no_body or self.length is None or got == self.length
        self._end(whole)
        if not whole:
            raise CutOffError(f"the answer broke off after {got} of {self.length} bytes")

    def read(self) -> bytes:
        return b"".join(self.pieces())

    def json(self) -> Any:
        text = self.read()
        try:
            return json.loads(text)
        except ValueError as fault:
            raise CutOffError(f"the answer is no JSON: {fault}") from fault

    def interrupt(self) -> None:
        """Ends the body for a thread that waits for it; may be called from another one."""
        self._interrupt()

    def close(self) -> None:
        """Gives up what was not read, and the connection with it."""
        self._end(False)

    def _end(self, reusable: bool) -> None:
        release, self._release = self._release, None
        if release is not None:
            self._raw.close()  # else the connection takes it as still being read
            release(reusable)

    def __enter__(self) -> "Response":
        return self

    def __exit__(self, *unused: object) -> None:
        self.close()


class Transport:
    """Where the server is and how it is spoken to. May be used by several threads."""

    def __init__(
        self,
        url: str,
        token: Optional[str] = None,
        ca_file: Optional[str] = None,
        timeout_s: float = 60.0,
        retries: int = 3,
        backoff_s: float = 0.2,
    ) -> None:
        parts = urlsplit(url)
        if parts.scheme not in ("http", "https") or not parts.hostname:
            raise ValueError(f"'{url}' is no address of a server: http:// or https:// and a host")
        if parts.path not in ("", "/") or parts.query or parts.fragment or parts.username:
            raise ValueError(f"'{url}' names more than a server")
        self.url = url.rstrip("/")
        self.timeout_s = timeout_s
        self.retries = retries
        self.backoff_s = backoff_s
        self._host, self._port = parts.hostname, parts.port
        self._tls = ssl.create_default_context(cafile=ca_file) if parts.scheme == "https" else None
        self._token: Optional[str] = None
        self.use_token(token)
        self._idle: List[http.client.HTTPConnection] = []
        self._lock = threading.Lock()
        self.log: Optional[Callable[[str, str, int], None]] = None

    def request(
        self,
        method: str,
        path: str,
        query: Optional[Query] = None,
        body: Optional[Body] = None,
        headers: Optional[Mapping[str, Optional[str]]] = None,
        safe: Optional[bool] = None,
        progress: Optional[Progress] = None,
        timeout_s: Optional[float] = None,
    ) -> Response:
        """The answer of a status below 400; else raises LaresError.

        `safe` says that sending it twice does no harm: by default so for GET, HEAD, unconditional
        PUT and DELETE, and for whatever carries an Idempotency-Key. Only such a request is sent
        again, after a growing pause, when no answer came or the server said to come again (429,
        502, 503); any other only when it had not been sent.
        """
        given = {name: value for name, value in (headers or {}).items() if value is not None}
        if safe is None:
            safe = _is_safe(method, given)
        target = path + (("?" + query_text(query)) if query and query_text(query) else "")
        sent_before = False
        for attempt in range(self.retries + 1):
            try:
                return self._once(method, target, body, given, safe, progress, timeout_s)
            except NoServerError as fault:
                if attempt == self.retries or not (safe or not fault.was_sent):
                    raise
                sent_before = sent_before or fault.was_sent
                self._pause(attempt, None)
            except LaresError as fault:
                # Gone already, by the request whose answer was lost.
                if method == "DELETE" and fault.status == 404 and sent_before:
                    raise LaresError("gone", "an earlier try removed it", 204) from fault
                if attempt == self.retries or not safe or fault.status not in RETRIED_STATUSES:
                    raise
                self._pause(attempt, fault.retry_after_s)
        raise AssertionError("not reached")

    def use_token(self, token: Optional[str]) -> None:
        """Sends this one from now on; ValueError for what is none, or may not be sent here."""
        if token is not None and (not token.isascii() or not token.isprintable() or " " in token):
            raise ValueError("a token is one word of ASCII")
        if token and self._tls is None and self._host not in _LOOPBACK:
            raise ValueError("a token is not sent over the network without TLS: use https://")
        self._token = token

    def delete(self, path: str, if_match: Optional[str] = None) -> None:
        try:
            self.request("DELETE", path, headers={"If-Match": if_match}).read()
        except LaresError as fault:
            if fault.code != "gone":
                raise

    def close(self) -> None:
        """Closes the connections that wait to be used again."""
        with self._lock:
            idle, self._idle = self._idle, []
        for connection in idle:
            connection.close()

    # ---- one try -------------------------------------------------------------------------------

    def _once(
        self,
        method: str,
        target: str,
        body: Optional[Body],
        headers: Mapping[str, str],
        safe: bool,
        progress: Optional[Progress],
        timeout_s: Optional[float],
    ) -> Response:
        # A kept connection may just be closing, which looks like a lost answer: what must not be
        # sent twice goes over a new one.
        connection = self._take(reuse=safe, timeout_s=timeout_s)
        try:
            self._send(connection, method, target, body, headers, progress)
            sock = connection.sock  # http.client forgets it when the answer ends the connection
            raw = connection.getresponse()
        except (OSError, http.client.HTTPException) as fault:
            connection.close()
            raise NoServerError(f"{self.url} gave no answer: {fault!r}", was_sent=True) from fault
        except BaseException:
            connection.close()
            raise
        if self.log is not None:
            self.log(method, target, raw.status)

        def release(reusable: bool) -> None:
            self._give_back(connection, reusable and not raw.will_close)

        def interrupt() -> None:
            try:
                sock.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass  # it ended by itself

        response = Response(raw, release, interrupt, method == "HEAD")
        if response.status >= 400:
            raise error_of_response(response.status, response.headers, _fault_body(response))
        return response

    def _take(self, reuse: bool, timeout_s: Optional[float]) -> http.client.HTTPConnection:
        seconds = self.timeout_s if timeout_s is None else timeout_s
        with self._lock:
            connection = self._idle.pop() if reuse and self._idle else None
        if connection is not None:
            connection.sock.settimeout(seconds)
            return connection
        assert self._host is not None
        if self._tls is not None:
            connection = http.client.HTTPSConnection(
                self._host, self._port, timeout=seconds, context=self._tls
            )
        else:
            connection = http.client.HTTPConnection(self._host, self._port, timeout=seconds)
        try:
            connection.connect()
            connection.sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        except ssl.SSLCertVerificationError as fault:
            raise LaresError(
                "not-trusted", f"the certificate of {self.url}: {fault.verify_message}",
                hint="ca_file= names the certificate of the authority that signed it",
            ) from fault
        except OSError as fault:
            raise NoServerError(f"{self.url} does not answer: {fault}", was_sent=False) from fault
        return connection

    def _send(
        self,
        connection: http.client.HTTPConnection,
        method: str,
        target: str,
        body: Optional[Body],
        headers: Mapping[str, str],
        progress: Optional[Progress],
    ) -> None:
        connection.putrequest(method, target)
        for name, value in headers.items():
            connection.putheader(name, value)
        if self._token:
            connection.putheader("Authorization", "Bearer " + self._token)
        if body is not None:
            connection.putheader("Content-Type", body.content_type)
        if body is not None or method in ("POST", "PUT", "PATCH"):
            connection.putheader("Content-Length", str(body.length if body is not None else 0))
        connection.endheaders()
        if body is None:
            return
        done = 0
        try:
            for piece in body.pieces():
                connection.send(piece)
                done += len(piece)
                if progress is not None:
                    progress(done, body.length)
        except (BrokenPipeError, ConnectionResetError):
            pass  # refused before the end: the answer says why

    def _give_back(self, connection: http.client.HTTPConnection, reusable: bool) -> None:
        with self._lock:
            if reusable and connection.sock is not None and len(self._idle) < _IDLE_CONNECTIONS:
                self._idle.append(connection)
                return
        connection.close()

    def _pause(self, attempt: int, retry_after_s: Optional[float]) -> None:
        most = self.backoff_s * 2**attempt
        time.sleep(max(random.uniform(most / 2, most), min(retry_after_s or 0.0, 30.0)))


def _is_safe(method: str, headers: Mapping[str, str]) -> bool:
    conditional = method not in ("GET", "HEAD") and (
        "If-Match" in headers or "If-None-Match" in headers
    )
    return "Idempotency-Key" in headers or (
        method in ("GET", "HEAD", "PUT", "DELETE") and not conditional
    )


def _fault_body(response: Response) -> bytes:
    """At most 1 MiB of it: a fault is short, whoever tells it."""
    body = b""
    try:
        for piece in response.pieces():
            body += piece
            if len(body) > 1 << 20:
                break
    except CutOffError:
        pass
    response.close()
    return body
