"""Bad links: retries, resumed downloads, copies for when the server is away, memory."""

import json
import os
import shutil
import socket
import ssl
import subprocess
import tempfile
import threading
import tracemalloc
import unittest
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional

from support import DEMO, ROBOTS, BadLink, LiveServer, ScriptedServer, ServerTest, free_port

import lares

OK = {"Content-Type": "application/json"}
BUSY = json.dumps({"code": "unavailable", "detail": "full"}).encode()


def trajectory(path: Path, lines: int) -> Path:
    """A layer that is as large as wanted."""
    with open(path, "w", encoding="ascii") as file:
        for at in range(lines):
            file.write(f"{at}.5 1.25 {at % 100}.0 0.5 0 0 0 1\n")
    return path


class RetriesTest(unittest.TestCase):
    def scripted(self, *answers: Any) -> ScriptedServer:
        server = ScriptedServer(list(answers))
        self.addCleanup(server.close)
        return server

    def client(self, url: str, **named: Any) -> "lares.Client":
        client = lares.Client(url, **named)
        client.transport.backoff_s = 0.001
        self.addCleanup(client.close)
        return client

    def test_a_busy_server_is_asked_again(self) -> None:
        server = self.scripted((503, OK, BUSY), (429, OK, BUSY), (200, OK, b'{"status": "ok"}'))
        self.assertEqual(self.client(server.url).server.health(), {"status": "ok"})
        self.assertEqual(len(server.asked), 3)

    def test_patience_ends(self) -> None:
        server = self.scripted((503, OK, BUSY))
        with self.assertRaises(lares.LaresError) as caught:
            self.client(server.url, retries=2).server.health()
        self.assertEqual((caught.exception.code, len(server.asked)), ("unavailable", 3))

    def test_what_must_not_happen_twice_is_sent_once(self) -> None:
        server = self.scripted((503, OK, BUSY))
        client = self.client(server.url)
        sends: List[Callable[[], Any]] = [
            lambda: client.recipes.add(b"x", file_name="x.ttl"),
            lambda: client.recipes.put(b"x", "x", if_match='"1"'),
            lambda: client.environments.put_version("a", note="b"),
            lambda: client.quarantine.release("x"),
        ]
        for send in sends:
            server.asked.clear()
            with self.assertRaises(lares.LaresError):
                send()
            self.assertEqual(len(server.asked), 1)

    def test_an_idempotency_key_lets_it_be_sent_again_with_the_same_body(self) -> None:
        server = self.scripted((503, OK, BUSY), (201, OK, b'{"version": {}}'))
        self.client(server.url).environments.put_version("a", {"features": b"bytes"},
                                                         idempotency_key="k-1")
        self.assertEqual([headers["idempotency-key"] for _, _, headers, _ in server.asked],
                         ["k-1", "k-1"])
        self.assertEqual(server.asked[0][3], server.asked[1][3])

    def test_a_fault_is_not_asked_for_again(self) -> None:
        server = self.scripted((404, OK, b'{"code": "not-found", "detail": "no"}'))
        with self.assertRaises(lares.LaresError):
            self.client(server.url).recipes.info("x")
        self.assertEqual(len(server.asked), 1)

    def test_a_fault_of_a_stranger_is_one_too(self) -> None:
        server = self.scripted((418, {}, b"<html>teapot</html>"))
        with self.assertRaises(lares.LaresError) as caught:
            self.client(server.url).server.health()
        self.assertEqual(caught.exception.code, "http-418")

    def test_no_server(self) -> None:
        client = self.client(f"http://127.0.0.1:{free_port()}", retries=1)
        with self.assertRaises(lares.NoServerError) as caught:
            client.server.health()
        self.assertEqual(caught.exception.code, "no-server")
        self.assertFalse(caught.exception.was_sent)

    def test_the_token_is_sent_and_kept_from_open_networks(self) -> None:
        server = self.scripted((200, OK, b"{}"))
        os.environ["LARES_TOKEN"] = "secret-1"
        self.addCleanup(os.environ.pop, "LARES_TOKEN")
        self.client(server.url).server.health()
        self.assertEqual(server.asked[0][2]["authorization"], "Bearer secret-1")
        for url, token in (("http://lares.example.org", "t"), ("http://127.0.0.1", "a b"),
                           ("http://127.0.0.1", "a\r\nX: y"), ("ftp://127.0.0.1", ""),
                           ("http://127.0.0.1/v1", ""), ("http://u:p@127.0.0.1", "")):
            with self.assertRaises(ValueError, msg=url):
                lares.Client(url, token=token)

    def test_no_redirection_is_followed(self) -> None:
        other = self.scripted((200, OK, b"{}"))
        server = self.scripted((302, {"Location": other.url + "/healthz"}, b""))
        with self.assertRaises(lares.LaresError):
            self.client(server.url, token="secret").server.health()
        self.assertEqual(other.asked, [])


class BadLinkTest(ServerTest):
    def through(self, budgets: List[Optional[int]], **named: Any) -> "tuple[BadLink, lares.Client]":
        link = BadLink(self.server.port, budgets)
        self.addCleanup(link.close)
        client = lares.Client(link.url, **named)
        client.transport.backoff_s = 0.001
        self.addCleanup(client.close)
        return link, client

    def test_a_lost_answer_is_asked_for_again(self) -> None:
        link, client = self.through([0, 5, None])
        self.assertEqual(client.server.health()["status"], "ok")
        self.assertEqual(link.connections, 3)

    def test_a_delete_whose_answer_was_lost_is_done(self) -> None:
        self.client.robots.put(ROBOTS / "scout.ttl", "gone")
        _, client = self.through([0, None])
        client.robots.delete("gone")
        self.fails("not-found", client.robots.info, "gone")

    def test_a_download_goes_on_where_it_broke_off(self) -> None:
        file = trajectory(self.folder / "path.txt", 40_000)
        size = file.stat().st_size
        self.client.environments.put_version("far", {"trajectory": file}, type="Home")
        manifest = self.client.environments.version("far")["layers"][0]
        link, client = self.through([size // 3, size // 3, size // 3, None])
        seen: List[int] = []
        target = self.folder / "copy.txt"
        saved = client.environments.layer("far", "trajectory").save(
            target, progress=lambda done, total: seen.append(done), sha256=manifest["sha256"])
        self.assertEqual(target.read_bytes(), file.read_bytes())
        self.assertEqual((saved.size, saved.sha256), (size, manifest["sha256"]))
        self.assertEqual(seen, sorted(seen))
        self.assertGreater(link.connections, 2)
        self.assertEqual(sorted(one.name for one in self.folder.iterdir()),
                         ["copy.txt", "path.txt"])

    def test_a_later_process_goes_on_too_and_never_mixes_versions(self) -> None:
        file = trajectory(self.folder / "a.txt", 40_000)
        size = file.stat().st_size
        self.client.environments.put_version("two", {"trajectory": file}, type="Home")
        target = self.folder / "copy.txt"
        _, client = self.through([size // 2, 0], retries=0)
        layer = "latest"
        with self.assertRaises(lares.NoServerError):
            client.environments.layer("two", "trajectory", layer).save(target)
        self.assertFalse(target.exists())
        self.assertGreater((self.folder / "copy.txt.part").stat().st_size, size // 4)
        other = trajectory(self.folder / "b.txt", 39_000)
        self.client.environments.put_version("two", {"trajectory": other})
        link, whole = self.through([None])
        note = json.loads((self.folder / "copy.txt.part.json").read_text())
        note["url"] = note["url"].replace(client.transport.url, whole.transport.url)
        (self.folder / "copy.txt.part.json").write_text(json.dumps(note))
        whole.environments.layer("two", "trajectory", layer).save(target)
        self.assertEqual(target.read_bytes(), other.read_bytes())

    def test_wrong_content_does_not_stay(self) -> None:
        self.client.robots.put(ROBOTS / "scout.ttl")
        target = self.folder / "scout.ttl"
        self.fails("wrong-content", self.client.robots.file("scout").save, target, sha256="0" * 64)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_upload_that_is_refused_early_says_why(self) -> None:
        big = self.folder / "big.bin"
        with open(big, "wb") as file:
            file.truncate(64 << 20)
        self.client.environments.put_version("held", {"semantic": DEMO / "flat.ttl"}, type="Home")
        self.fails("precondition-failed", self.client.environments.put_version, "held",
                   {"features": big}, only_new=True)

    def test_an_upload_goes_on_where_it_broke_off_and_becomes_a_layer(self) -> None:
        file = trajectory(self.folder / "path.txt", 20_000)
        link, client = self.through([None, 0, None], retries=1)
        path = self.client.uploads.create(file.stat().st_size, "path.txt")
        seen: List[int] = []
        upload = client.uploads.send(file, path, progress=lambda done, total: seen.append(done))
        self.assertEqual(seen[-1], file.stat().st_size)
        self.assertGreater(link.connections, 1)
        self.client.environments.put_version("sent", {"trajectory": upload}, type="Home",
                                             idempotency_key="sent-1")
        again = self.client.environments.put_version("sent", {"trajectory": upload}, type="Home",
                                                     idempotency_key="sent-1")
        self.assertEqual(again["version"]["number"], 1)
        self.assertEqual(self.client.environments.layer("sent", "trajectory").read(),
                         file.read_bytes())

    def test_memory_stays_constant(self) -> None:
        file = trajectory(self.folder / "long.txt", 1_500_000)
        self.assertGreater(file.stat().st_size, 40 << 20)
        seen: Dict[str, int] = {}
        tracemalloc.start()
        self.client.environments.put_version(
            "long", {"trajectory": file}, type="Home",
            progress=lambda done, total: seen.update(done=done, total=total or 0))
        self.client.environments.layer("long", "trajectory").save(self.folder / "back.txt")
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        self.assertLess(peak, 8 << 20)
        self.assertEqual(seen["done"], seen["total"])
        self.assertEqual((self.folder / "back.txt").stat().st_size, file.stat().st_size)


class CacheTest(unittest.TestCase):
    def setUp(self) -> None:
        self.server = LiveServer().start()
        self.addCleanup(self.server.remove)
        self.cache = self.server.folder / "cache"
        self.client = lares.Client(self.server.url, cache_dir=self.cache, offline_ok=True,
                                   retries=0)
        self.client.environments.put_version("flat", {"semantic": DEMO / "flat.ttl"}, type="Home")
        self.layer = self.client.environments.layer("flat", "semantic")
        self.target = self.server.folder / "copy.ttl"

    def test_a_robot_in_a_dead_zone_keeps_its_map(self) -> None:
        first = self.layer.save(self.target)
        self.assertFalse(first.from_cache)
        again = self.layer.save(self.target)
        self.assertTrue(again.from_cache)
        self.assertFalse(again.stale)
        self.server.stop()
        self.target.unlink()
        kept = self.layer.save(self.target)
        self.assertTrue(kept.from_cache and kept.stale)
        self.assertEqual(self.target.read_bytes(), (DEMO / "flat.ttl").read_bytes())
        self.assertEqual(self.layer.read(), (DEMO / "flat.ttl").read_bytes())
        strict = lares.Client(self.server.url, cache_dir=self.cache, retries=0)
        with self.assertRaises(lares.NoServerError):
            strict.environments.layer("flat", "semantic").read()
        with self.assertRaises(lares.NoServerError):
            self.client.environments.layer("flat", "grid").read()  # never downloaded

    def test_a_download_into_the_cache_goes_on_where_it_broke_off(self) -> None:
        file = trajectory(self.server.folder / "path.txt", 40_000)
        self.client.environments.put_version("far", {"trajectory": file}, type="Home")
        size = file.stat().st_size
        link = BadLink(self.server.port, [size // 2, 0, None])
        self.addCleanup(link.close)
        robot = lares.Client(link.url, cache_dir=self.cache, retries=0)
        asked: List[int] = []
        robot.on_request(lambda method, target, status: asked.append(status))
        layer = robot.environments.layer("far", "trajectory")
        with self.assertRaises(lares.NoServerError):
            layer.read()
        self.assertEqual(layer.read(), file.read_bytes())
        self.assertEqual(asked, [200, 206])
        self.assertTrue(layer.save(self.target).from_cache)

    def test_the_same_is_downloaded_by_several_at_once(self) -> None:
        file = trajectory(self.server.folder / "path.txt", 40_000)
        self.client.environments.put_version("far", {"trajectory": file}, type="Home")
        wanted = file.read_bytes()
        got: List[bytes] = []
        layer = self.client.environments.layer("far", "trajectory")
        threads = [threading.Thread(target=lambda: got.append(layer.read())) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([one == wanted for one in got], [True] * 4)

    def test_a_change_is_noticed(self) -> None:
        self.layer.read()
        changed = (DEMO / "flat.ttl").read_bytes() + b"\n# painted\n"
        self.client.environments.put_version("flat", {"semantic": changed})
        self.assertEqual(self.layer.read(), changed)

    def test_a_damaged_copy_is_never_given_out(self) -> None:
        self.layer.read()
        for blob in (self.cache / "blobs").iterdir():
            blob.write_bytes(b"X" * blob.stat().st_size)
        self.assertEqual(self.layer.read(), (DEMO / "flat.ttl").read_bytes())
        for blob in (self.cache / "blobs").iterdir():
            blob.write_bytes(b"X" * blob.stat().st_size)
        self.server.stop()
        with self.assertRaises(lares.NoServerError):
            self.layer.read()

    def test_half_written_entries_are_as_none(self) -> None:
        self.layer.read()
        for entry in (self.cache / "entries").iterdir():
            entry.write_text('{"url": "http')
        self.assertEqual(self.layer.read(), (DEMO / "flat.ttl").read_bytes())

    def test_the_cache_can_be_bounded(self) -> None:
        cache = lares.DownloadCache(self.cache)
        self.layer.read()
        cache.prune(10)
        self.assertEqual(list((self.cache / "blobs").iterdir()), [])
        self.assertEqual(self.layer.read(), (DEMO / "flat.ttl").read_bytes())


@unittest.skipUnless(shutil.which("openssl"), "openssl is not installed")
class TlsTest(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="lares-test-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.certificate = self.folder / "cert.pem"
        subprocess.run(
            ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256",
             "-nodes", "-days", "2", "-subj", "/CN=localhost", "-addext",
             "subjectAltName=DNS:localhost", "-keyout", str(self.folder / "key.pem"),
             "-out", str(self.certificate)],
            check=True, capture_output=True,
        )
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        context.load_cert_chain(self.certificate, self.folder / "key.pem")
        self.server = ScriptedServer([(200, OK, b'{"status": "ok"}')], context)
        self.addCleanup(self.server.close)
        self.url = self.server.url.replace("http://127.0.0.1", "https://localhost")

    def test_an_authority_of_ones_own_is_believed_and_a_stranger_is_not(self) -> None:
        with lares.Client(self.url, token="secret", ca_file=str(self.certificate)) as client:
            self.assertEqual(client.server.health(), {"status": "ok"})
        with self.assertRaises(lares.LaresError) as caught:
            lares.Client(self.url, token="secret", retries=0).server.health()
        self.assertEqual(caught.exception.code, "not-trusted")
        other = self.url.replace("localhost", "127.0.0.1")  # not the name that it is for
        with self.assertRaises(lares.LaresError):
            lares.Client(other, ca_file=str(self.certificate), retries=0).server.health()
        self.assertEqual(len(self.server.asked), 1)


class TimeoutTest(unittest.TestCase):
    def test_a_server_that_says_nothing_is_given_up(self) -> None:
        with socket.create_server(("127.0.0.1", 0)) as silent:
            client = lares.Client(f"http://127.0.0.1:{silent.getsockname()[1]}", timeout_s=0.2,
                                  retries=0)
            with self.assertRaises(lares.NoServerError):
                client.server.health()


if __name__ == "__main__":
    unittest.main()
