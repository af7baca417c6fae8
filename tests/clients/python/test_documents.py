"""Documents: conditions, versions, faults as the server tells them."""

import threading
import unittest
from typing import List

from support import DEMO, LIBRARY, ROBOTS, ServerTest

import lares

SEARCH = LIBRARY / "object-search.ttl"


class DocumentsTest(ServerTest):
    def test_what_was_put_comes_back_byte_for_byte(self) -> None:
        answer = self.client.recipes.put(SEARCH)
        self.assertEqual(answer["document"]["id"], "object-search")
        self.assertEqual(self.client.recipes.file("object-search").read(), SEARCH.read_bytes())
        self.assertEqual(self.client.recipes.info("object-search")["sha256"],
                         answer["document"]["sha256"])

    def test_a_condition_that_no_longer_holds_is_refused(self) -> None:
        etag = self.client.robots.put(ROBOTS / "scout.ttl", "mine")["document"]["etag"]
        changed = (ROBOTS / "scout.ttl").read_bytes() + b"\n# changed\n"
        second = self.client.robots.put(changed, "mine", if_match=etag)["document"]
        self.assertEqual(second["version"], 2)
        fault = self.fails("precondition-failed", self.client.robots.put, changed + b"# again\n",
                           "mine", if_match=etag)
        self.assertEqual(fault.status, 412)
        self.fails("precondition-failed", self.client.robots.put, changed, "mine", only_new=True)
        self.fails("precondition-failed", self.client.robots.delete, "mine", if_match=etag)
        self.client.robots.delete("mine", if_match=second["etag"])
        self.fails("not-found", self.client.robots.info, "mine")
        self.assertEqual([one["version"] for one in self.client.robots.versions("mine")], [2, 1])

    def test_a_fault_has_code_status_place_and_request_id(self) -> None:
        fault = self.fails("invalid", self.client.recipes.put, b"@prefix : <http://e.org/> .\n:a :b",
                           "broken", file_name="broken.ttl")
        self.assertEqual(fault.status, 422)
        self.assertEqual(fault.problem["place"]["source"], "broken.ttl")
        self.assertRegex(str(fault), r"broken\.ttl:\d+:\d+")
        self.assertRegex(fault.request_id, r"^[0-9a-f]{16}$")

    def test_a_misspelt_name_has_candidates(self) -> None:
        self.client.robots.put(ROBOTS / "helper.ttl")
        fault = self.fails("not-found", self.client.robots.info, "helpr")
        self.assertEqual(fault.candidates, ["helper"])
        self.assertIn("did you mean helper?", str(fault))

    def test_names_of_any_kind_travel_whole(self) -> None:
        for name in ("a/b", "a b", "ä", "a%2Fb", "a?b", "..", "a#b"):
            with self.subTest(name=name):
                fault = self.fails("not-found", self.client.recipes.info, name)
                self.assertIn(name, fault.detail)

    def test_lists_go_on_over_pages(self) -> None:
        aliases = list(self.client.ontology.aliases())
        page = self.client.ontology._json("/v1/ontology/aliases", {"limit": 1})
        self.assertEqual(len(aliases), page["count"])
        self.assertEqual(len({one["alias"] for one in aliases}), len(aliases))

    def test_threads_may_share_a_client(self) -> None:
        self.client.recipes.put(SEARCH)
        faults: List[Exception] = []

        def ask() -> None:
            try:
                for _ in range(20):
                    self.client.recipes.file("object-search").read()
            except Exception as fault:
                faults.append(fault)

        threads = [threading.Thread(target=ask) for _ in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(faults, [])


class EnvironmentsTest(ServerTest):
    def test_a_version_holds_its_layers_and_the_next_keeps_them(self) -> None:
        first = self.client.environments.put_version(
            "flat", {"semantic": DEMO / "flat.ttl", "grid": DEMO / "flat.yaml"}, type="Home",
            note="as built", only_new=True)["version"]
        self.assertEqual(first["number"], 1)
        self.fails("precondition-failed", self.client.environments.put_version, "flat",
                   note="again", only_new=True)
        second = self.client.environments.put_version("flat", note="looked again", remove=["grid"],
                                                      if_match=first["etag"])["version"]
        self.assertEqual([layer["name"] for layer in second["layers"]], ["semantic"])
        self.assertEqual([one["number"] for one in self.client.environments.versions("flat")],
                         [2, 1])
        saved = self.client.environments.save("flat", self.folder / "flat", 1)
        self.assertEqual({one.path.name for one in saved},
                         {"semantic-flat.ttl", "grid-grid.tar"})
        self.assertEqual((self.folder / "flat" / "semantic-flat.ttl").read_bytes(),
                         (DEMO / "flat.ttl").read_bytes())
        (self.folder / "flat" / "grid-grid.tar").write_bytes(b"damaged")
        again = self.client.environments.save("flat", self.folder / "flat", 1)
        self.assertEqual([one.from_cache for one in again],
                         [one.path.name == "semantic-flat.ttl" for one in again])

    def test_the_semantic_layer_comes_in_another_format(self) -> None:
        self.client.environments.put_version("lab", {"semantic": DEMO / "flat.ttl"}, type="Home")
        layer = self.client.environments.layer("lab", "semantic", accept="application/n-triples")
        self.assertIn("<https://w3id.org/lares", layer.text().split("\n")[0])

    def test_a_layer_that_is_none_is_refused_by_name(self) -> None:
        fault = self.fails("invalid", self.client.environments.put_version, "flat2",
                           {"sematic": DEMO / "flat.ttl"})
        self.assertIn("semantic", fault.candidates)
        self.fails("not-found", self.client.environments.get, "flat2")

    def test_a_file_that_is_missing_is_told_before_anything_is_sent(self) -> None:
        with self.assertRaises(FileNotFoundError):
            self.client.environments.put_version("flat3", {"semantic": self.folder / "none.ttl"})

    def test_a_grid_without_an_image_is_refused(self) -> None:
        yaml = self.folder / "map.yaml"
        yaml.write_text("resolution: 0.05\n")
        with self.assertRaisesRegex(ValueError, "no line 'image:'"):
            lares.pack_grid(yaml, self.folder / "grid.tar")


if __name__ == "__main__":
    unittest.main()
