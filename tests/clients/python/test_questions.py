"""Plans, places, SPARQL, Prolog, reasons, watches."""

import threading
import unittest
from typing import Any, Iterator, List

from support import DEMO, LIBRARY, ROBOTS, ServerTest

import lares
from lares.events import events_of, lines_of
from lares.rows import rows_of


class QuestionsTest(ServerTest):
    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        cls.client.recipes.put(LIBRARY / "object-search.ttl")
        cls.client.recipes.put(LIBRARY / "fetch-drink.ttl")
        cls.client.robots.put(ROBOTS / "scout.ttl")
        cls.client.robots.put(ROBOTS / "helper.ttl")
        cls.client.environments.put_version("flat", {"semantic": DEMO / "flat.ttl"}, type="Home")

    def test_a_plan_and_its_text(self) -> None:
        plan = self.client.plans.make("ObjectSearch", "scout", set={"object": "Cup"})
        self.assertIn("package", plan)
        xml = self.client.plans.make_text("ObjectSearch", "scout", "bt-xml", set={"object": "Cup"})
        self.assertIn('BTCPP_format="4"', xml)

    def test_why_there_is_no_plan_is_told_exactly(self) -> None:
        fault = self.fails("not-feasible", self.client.plans.make, "fetch-drink", "scout")
        self.assertTrue(fault.problem["smallest_repair"])
        self.assertIn("helper", [one["label"] for one in fault.problem["capable_robots"]])

    def test_plans_are_compared(self) -> None:
        cup = lares.plan_request("ObjectSearch", "scout", set={"object": "Cup"})
        bottle = lares.plan_request("ObjectSearch", "scout", set={"object": "Bottle"})
        self.assertTrue(self.client.plans.diff(cup, bottle)["differences"])
        self.assertEqual(self.client.plans.diff(cup, cup)["differences"], [])
        self.assertIn("Bottle", self.client.plans.diff_text(cup, bottle))

    def test_likely_places_add_up(self) -> None:
        places = self.client.likely_places.find("Cup", environment="flat")
        self.assertAlmostEqual(sum(one["probability"] for one in places["rooms"]), 1.0, places=2)
        self.assertTrue(places["prior"]["name"])

    def test_rows_arrive_one_by_one(self) -> None:
        query = "SELECT ?c ?l { ?c a owl:Class ; rdfs:label ?l }"
        rows = list(self.client.sparql.select(query))
        self.assertGreater(len(rows), 200)
        self.assertEqual(rows[0]["c"]["type"], "uri")
        count = next(iter(self.client.sparql.select(
            "SELECT (COUNT(*) AS ?n) { ?c a owl:Class ; rdfs:label ?l }")))
        self.assertEqual(lares.value_of(count["n"]), len(rows))
        self.assertEqual(list(self.client.sparql.select("SELECT * { ?x lares:no ?y }")), [])
        some = self.client.sparql.select(query)
        next(some)
        some.close()  # type: ignore[attr-defined]
        self.assertTrue(self.client.sparql.ask("ASK { lares:Cup a owl:Class }"))
        self.assertIn("Cup", self.client.sparql.construct("DESCRIBE lares:Cup"))
        self.fails("invalid", self.client.sparql.ask, "ASK {")

    def test_goals_answer_at_once_and_line_by_line(self) -> None:
        whole = self.client.prolog.ask("member(X, [1, two, \"three\"])")
        self.assertEqual((whole["outcome"], whole["count"]), ("yes", 3))
        lines = list(self.client.prolog.answers("member(X, [1, 2, 3])"))
        self.assertEqual([line["X"] for line in lines], [1, 2, 3])
        self.assertEqual(list(self.client.prolog.answers("fail")), [])
        self.fails("goal-error", self.client.prolog.ask, "atom_length(X, Y)")
        answers = self.client.prolog.answers("member(X, [1, 2]), (X < 2 ; atom_length(_, _))")
        self.assertEqual(next(answers)["X"], 1)
        self.fails("goal-error", list, answers)

    def test_reasons(self) -> None:
        self.assertTrue(self.client.reasons.why("lares:Cup", "rdfs:subClassOf", "lares:Container"))
        self.assertIn("cup", self.client.reasons.why_text(
            "lares:Cup", "rdfs:subClassOf", "lares:Container").lower())
        self.fails("not-found", self.client.reasons.why, "lares:Cup", "rdfs:subClassOf",
                   "lares:Robot")
        self.fails("not-found", self.client.reasons.contradiction)
        self.assertGreater(self.client.reasons.distance("Cup", "Bottle")["rada"]["edges"], 0)

    def test_a_watch_tells_each_change_and_ends_when_closed(self) -> None:
        names: List[str] = []
        ended = threading.Event()
        first = threading.Event()
        changed = threading.Event()
        watch = self.client.watches.watch("SELECT * { ?m a owl:Ontology }", first="count")

        def listen() -> None:
            for event in watch:
                names.append(event.name)
                (first if event.name == "answer" else changed).set()
            ended.set()

        threading.Thread(target=listen, daemon=True).start()
        self.assertTrue(first.wait(20))
        self.client.ontology.put(b"<http://e.org/new> a <http://www.w3.org/2002/07/owl#Ontology> .",
                                 "new", file_name="new.ttl")
        self.assertTrue(changed.wait(20))
        watch.close()
        self.assertTrue(ended.wait(20))
        self.assertEqual(names[:2], ["answer", "change"])

    def test_a_watch_on_what_is_not_there_is_refused_at_once(self) -> None:
        self.fails("not-found", self.client.watches.watch, "ASK {}", robot="nobody")


class Lines:
    """An answer of given pieces, for the readers of streams."""

    def __init__(self, *pieces: bytes) -> None:
        self._pieces = pieces

    def pieces(self) -> Iterator[bytes]:
        return iter(self._pieces)


class StreamsTest(unittest.TestCase):
    def events(self, *pieces: bytes) -> List[Any]:
        return list(events_of(Lines(*pieces)))  # type: ignore[arg-type]

    def test_events_are_read_however_they_are_cut(self) -> None:
        text = b': hello\r\nevent: change\ndata: {"a":\ndata: 1}\n\ndata: {}\n\nevent: lost\n'
        for size in (1, 2, 3, 7, 100):
            cut = [text[at : at + size] for at in range(0, len(text), size)]
            self.assertEqual(self.events(*cut), [lares.Event("change", {"a": 1}),
                                                 lares.Event("message", {})], size)

    def test_an_error_event_is_raised(self) -> None:
        with self.assertRaises(lares.LaresError) as caught:
            self.events(b'event: error\ndata: {"code": "too-large", "detail": "rows"}\n\n')
        self.assertEqual(caught.exception.code, "too-large")

    def test_events_that_are_no_json_are_told(self) -> None:
        for data in (b"data: {\n\n", b"data: [1]\n\n"):
            with self.assertRaises(lares.CutOffError):
                self.events(data)

    def test_rows_are_read_however_they_are_cut(self) -> None:
        text = ('{"head":{"vars":["x"]},"results":{"bindings":[\n{"x":{"type":"literal","value":'
                '"]}ä\\""}},\n{"x":{"type":"uri","value":"u"}}\n]}}').encode()
        for size in range(1, len(text) + 1):
            cut = (text[at : at + size] for at in range(0, len(text), size))
            self.assertEqual([row["x"]["value"] for row in rows_of(cut)], [']}ä"', "u"])

    def test_rows_that_are_cut_off_are_not_taken_for_all(self) -> None:
        whole = b'{"head":{},"results":{"bindings":[{"x":{"type":"uri","value":"u"}}]}}'
        for end in range(len(whole) - 3):
            with self.assertRaises(lares.CutOffError):
                list(rows_of(iter([whole[:end]])))

    def test_lines_without_an_end_do_not_fill_memory(self) -> None:
        with self.assertRaises(lares.LaresError):
            list(lines_of(b"x" * (1 << 20) for _ in range(32)))


if __name__ == "__main__":
    unittest.main()
