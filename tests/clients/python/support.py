"""A real server on a port and folder of its own, and what stands between it and a client."""

import os
import shutil
import signal
import socket
import ssl
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Tuple

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "clients" / "python"))

import lares  # noqa: E402

LIBRARY = ROOT / "recipes" / "library"
ROBOTS = ROOT / "robots" / "models"
DEMO = ROOT / "demo"

URDF = b"""<?xml version="1.0"?>
<robot name="cart">
  <link name="base_link"><collision><geometry><box size="0.4 0.3 0.2"/></geometry></collision></link>
  <link name="laser"/>
  <joint name="mount" type="fixed"><parent link="base_link"/><child link="laser"/></joint>
</robot>
"""


class LiveServer:
    """`lares serve` as a process; `stop` and `start` keep port and data."""

    def __init__(self) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="lares-test-"))
        self.port = free_port()
        self.url = f"http://127.0.0.1:{self.port}"
        self.process: Optional["subprocess.Popen[bytes]"] = None

    def start(self) -> "LiveServer":
        with open(self.folder / "serve.log", "ab") as log:
            self.process = subprocess.Popen(
                [os.environ["LARES_BINARY"], "serve", "--port", str(self.port),
                 "--data", str(self.folder / "store")],
                stdout=log, stderr=log,
            )
        deadline = time.monotonic() + 60
        client = lares.Client(self.url, retries=0)
        while time.monotonic() < deadline and self.process.poll() is None:
            try:
                client.server.ready()
                return self
            except lares.LaresError:
                time.sleep(0.05)
        raise RuntimeError("no server: " + (self.folder / "serve.log").read_text())

    def stop(self) -> None:
        if self.process is not None:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()
            self.process = None

    def remove(self) -> None:
        self.stop()
        shutil.rmtree(self.folder, ignore_errors=True)


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


class ServerTest(unittest.TestCase):
    """Tests of one class share a server; `self.folder` is each one's own."""

    server: LiveServer
    client: "lares.Client"

    @classmethod
    def setUpClass(cls) -> None:
        cls.server = LiveServer().start()
        cls.addClassCleanup(cls.server.remove)
        cls.client = lares.Client(cls.server.url)
        cls.addClassCleanup(cls.client.close)

    def setUp(self) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="lares-test-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def fails(self, code: str, call: Callable[..., Any], *args: Any, **named: Any) -> Any:
        with self.assertRaises(lares.LaresError) as caught:
            call(*args, **named)
        self.assertEqual(caught.exception.code, code, str(caught.exception))
        return caught.exception


class BadLink:
    """A relay to a server that cuts each connection after so many bytes of answers.

    `budgets` are used up one by one, the last stays; None is a whole one.
    """

    def __init__(self, port: int, budgets: List[Optional[int]]) -> None:
        self.budgets = budgets
        self.connections = 0
        self._to = port
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"http://127.0.0.1:{self._listener.getsockname()[1]}"
        threading.Thread(target=self._accept, daemon=True).start()

    def close(self) -> None:
        self._listener.close()

    def _accept(self) -> None:
        while True:
            try:
                near, _ = self._listener.accept()
            except OSError:
                return
            budget = self.budgets[min(self.connections, len(self.budgets) - 1)]
            self.connections += 1
            far = socket.create_connection(("127.0.0.1", self._to))
            threading.Thread(target=self._copy, args=(near, far, None), daemon=True).start()
            threading.Thread(target=self._copy, args=(far, near, budget), daemon=True).start()

    def _copy(self, source: socket.socket, sink: socket.socket, left: Optional[int]) -> None:
        try:
            while True:
                piece = source.recv(65536)
                if not piece:
                    break
                if left is not None and len(piece) >= left:
                    sink.sendall(piece[:left])
                    break
                left = None if left is None else left - len(piece)
                sink.sendall(piece)
        except OSError:
            pass
        for end in (source, sink):
            try:
                end.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass


Answer = Tuple[int, Dict[str, str], bytes]


class ScriptedServer:
    """Answers one after the other, the last again and again; keeps what it was asked."""

    def __init__(self, answers: List[Answer], tls: Optional[ssl.SSLContext] = None) -> None:
        self.asked: List[Tuple[str, str, Dict[str, str], bytes]] = []
        outer = self

        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def answer(self) -> None:
                length = int(self.headers.get("Content-Length") or 0)
                headers = {name.lower(): value for name, value in self.headers.items()}
                outer.asked.append((self.command, self.path, headers, self.rfile.read(length)))
                at = min(len(outer.asked), len(answers)) - 1
                status, more, body = answers[at]
                self.send_response(status)
                for name, value in more.items():
                    self.send_header(name, value)
                self.send_header("Content-Length", str(len(body)))
                self.end_headers()
                self.wfile.write(body)

            do_GET = do_POST = do_PUT = do_DELETE = answer

            def log_message(self, *unused: Any) -> None:
                pass

        self._server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self._server.daemon_threads = True
        if tls is not None:
            self._server.socket = tls.wrap_socket(self._server.socket, server_side=True)
        self.url = f"http://127.0.0.1:{self._server.server_address[1]}"
        threading.Thread(target=self._server.serve_forever, daemon=True).start()

    def close(self) -> None:
        self._server.shutdown()
        self._server.server_close()
