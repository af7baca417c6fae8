"""Questions: plans, likely places, SPARQL, Prolog, reasons, watches."""

import json
import time
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Union, cast

from .answers import GoalAnswers, LikelyPlaces, PlanRequest
from .bodies import Body, json_body
from .errors import CutOffError, LaresError, NoServerError
from .events import Event, events_of, lines_of
from .resource import Resource
from .rows import Row, rows_of
from .transport import Response

Plan = Dict[str, Any]


class Plans(Resource):
    def make(
        self,
        task: str,
        robot: str,
        *,
        environment: Optional[str] = None,
        version: Optional[int] = None,
        strict: bool = False,
        templates: Optional[Mapping[str, str]] = None,
        set: Optional[Mapping[str, str]] = None,
        sequential: bool = False,
        from_: Optional[str] = None,
        done: Sequence[str] = (),
    ) -> Plan:
        """The plan (docs/schemas/plan.schema.json), with its "package": what it needs beside it.

        LaresError "not-feasible", "choice-needed" or "recipe-unusable" says exactly why there is
        none; `error.problem` has "match", "smallest_repair", "capable_robots" and "choices".
        """
        return cast(Plan, self._make(plan_request(task, robot, environment=environment,
                                                  version=version, strict=strict,
                                                  templates=templates, set=set,
                                                  sequential=sequential, from_=from_, done=done),
                                     "json").json())

    def make_text(self, task: str, robot: str, as_: str, **more: Any) -> str:
        """The plan as "text", "bt-xml", "dot", "pddl-domain" or "pddl-problem"."""
        return self._make(plan_request(task, robot, **more), as_).read().decode("utf-8")

    def diff(self, a: Union[Plan, PlanRequest], b: Union[Plan, PlanRequest]) -> Dict[str, Any]:
        """What differs between two plans, each one a plan or what asks for it (`plan_request`)."""
        return cast(Dict[str, Any], self._diff(a, b, "json").json())

    def diff_text(self, a: Union[Plan, PlanRequest], b: Union[Plan, PlanRequest]) -> str:
        return self._diff(a, b, "text").read().decode("utf-8")

    def _make(self, request: PlanRequest, as_: str) -> Response:
        return self._ask("/v1/plans", request, as_)

    def _diff(self, a: Any, b: Any, as_: str) -> Response:
        return self._ask("/v1/plans/diff", {"a": a, "b": b}, as_)

    def _ask(self, path: str, body: Any, as_: str) -> Response:
        return self._transport.request("POST", path, {"as": as_}, body=json_body(body), safe=True)


def plan_request(
    task: str, robot: str, *, environment: Optional[str] = None, version: Optional[int] = None,
    strict: bool = False, templates: Optional[Mapping[str, str]] = None,
    set: Optional[Mapping[str, str]] = None, sequential: bool = False,
    from_: Optional[str] = None, done: Sequence[str] = (),
) -> PlanRequest:
    """What asks for a plan, without what is not said."""
    request = {"task": task, "robot": robot, "environment": environment, "version": version,
               "strict": strict or None, "templates": dict(templates or {}) or None,
               "set": dict(set or {}) or None, "sequential": sequential or None, "from": from_,
               "done": list(done) or None}
    return cast(PlanRequest, {name: one for name, one in request.items() if one is not None})


class LikelyPlacesOf(Resource):
    def find(self, object: str, *, prior: Optional[str] = None,
             environment: Optional[str] = None, version: Optional[int] = None) -> LikelyPlaces:
        """Where an object was seen, and where it usually is, with the table that says so."""
        query = {"object": object, "prior": prior, "environment": environment, "version": version}
        return cast(LikelyPlaces, self._json("/v1/likely-places", query))


class Sparql(Resource):
    def select(self, query: str, **about: Any) -> Iterator[Row]:
        """The rows of a SELECT, one by one as they arrive; `rows.value_of` reads their terms.

        `about` may name recipe, robot, environment, version, timeout_ms and max_rows.
        """
        with self.query(query, "json", **about) as answer:
            yield from rows_of(answer.pieces())

    def ask(self, query: str, **about: Any) -> bool:
        with self.query(query, "json", **about) as answer:
            return bool(answer.json()["boolean"])

    def construct(self, query: str, as_: str = "turtle", **about: Any) -> str:
        """The graph of a CONSTRUCT or DESCRIBE as text."""
        with self.query(query, as_, **about) as answer:
            return answer.read().decode("utf-8")

    def query(
        self, query: str, as_: str, *, recipe: Optional[str] = None, robot: Optional[str] = None,
        environment: Optional[str] = None, version: Optional[int] = None,
        timeout_ms: Optional[int] = None, max_rows: Optional[int] = None,
        explain: Optional[str] = None, default_graphs: Sequence[str] = (),
        named_graphs: Sequence[str] = (), method: Optional[str] = None,
    ) -> Response:
        """The answer as the server writes it: json, xml, csv, tsv, turtle, ntriples, rdfxml, …

        `explain` ("plan" or "run") asks how it is answered instead. `method` is "GET" or "POST"; by
        default long queries are posted.
        """
        parameters: Dict[str, Any] = {
            "as": as_, "recipe": recipe, "robot": robot, "environment": environment,
            "version": version, "timeout_ms": timeout_ms, "max_rows": max_rows,
            "explain": explain, "default-graph-uri": list(default_graphs),
            "named-graph-uri": list(named_graphs),
        }
        if (method or ("GET" if len(query) < 1500 else "POST")) == "GET":
            return self._transport.request("GET", "/v1/sparql", {"query": query, **parameters})
        body = Body(query.encode(), "application/sparql-query")
        return self._transport.request("POST", "/v1/sparql", parameters, body=body, safe=True)


class Prolog(Resource):
    def ask(self, goal: str, **about: Any) -> GoalAnswers:
        """All answers at once: outcome "yes", "no" or "error", and the variables' values.

        `about` may name recipe, robot, environment, version, limit and timeout_s. An error before
        the first answer is raised ("goal-error", "timeout").
        """
        return cast(GoalAnswers, self._goal(goal, "application/json", about).json())

    def answers(self, goal: str, **about: Any) -> Iterator[Dict[str, Any]]:
        """The answers one by one, as they are found; an error after some of them is raised."""
        with self._goal(goal, "application/x-ndjson", about) as response:
            for line in lines_of(response.pieces()):
                read = json.loads(line)
                if "answer" in read:
                    yield read["answer"]
                    continue
                fault = read.get("error")
                if isinstance(fault, dict):
                    raise LaresError("goal-error", str(fault.get("detail")), problem=fault)
                return
        raise CutOffError("the goal's answers ended without saying how")

    def _goal(self, goal: str, accept: str, about: Mapping[str, Any]) -> Response:
        body = {name: value for name, value in about.items() if value is not None}
        return self._transport.request("POST", "/v1/prolog", body=json_body({"goal": goal, **body}),
                                       headers={"Accept": accept}, safe=True)


class Reasons(Resource):
    def why(self, subject: str, predicate: str, object: str, **about: Any) -> Dict[str, Any]:
        """The shortest proof of a triple; "not-found" when it does not hold.

        `about` may name recipe, robot, environment and version.
        """
        triple = {"subject": subject, "predicate": predicate, "object": object}
        return cast(Dict[str, Any], self._json("/v1/why", {**triple, **about, "as": "json"}))

    def why_text(self, subject: str, predicate: str, object: str, as_: str = "text",
                 **about: Any) -> str:
        """The same as "text", "svg" or "dot"."""
        query = {"subject": subject, "predicate": predicate, "object": object, **about, "as": as_}
        return self._file("/v1/why", query, cached=False).text()

    def contradiction(self, **about: Any) -> Dict[str, Any]:
        """A proof of a contradiction; "not-found" when there is none."""
        query = {**about, "contradiction": "true", "as": "json"}
        return cast(Dict[str, Any], self._json("/v1/why", query))

    def why_not(self, subject: str, predicate: str, object: str, **about: Any) -> Dict[str, Any]:
        """What is missing; "conflict" when it does hold."""
        triple = {"subject": subject, "predicate": predicate, "object": object}
        return cast(Dict[str, Any], self._json("/v1/why-not", {**triple, **about, "as": "json"}))

    def distance(self, from_: str, to: str, **about: Any) -> Dict[str, Any]:
        """How far apart two classes are: "rada" and "wu_palmer", with their paths."""
        query = {"from": from_, "to": to, **about}
        return cast(Dict[str, Any], self._json("/v1/distances", query))


class Watch:
    """A running watch: iterate over it; `close` ends it, from another thread too."""

    def __init__(self, resource: "Watches", query: Dict[str, Any], reconnect: bool,
                 idle_timeout_s: float) -> None:
        self._resource = resource
        self._query = query
        self._reconnect = reconnect
        self._idle_timeout_s = idle_timeout_s
        self._closed = False
        self._response: Optional[Response] = self._open()

    def _open(self) -> Response:
        return self._resource._transport.request(
            "GET", "/v1/watches", self._query, headers={"Accept": "text/event-stream"},
            timeout_s=self._idle_timeout_s,
        )

    def __iter__(self) -> Iterator[Event]:
        pause_s = 0.2
        while not self._closed:
            try:
                response = self._response or self._open()
                self._response = response
                for event in events_of(response):
                    pause_s = 0.2
                    yield event
                if not self._reconnect:
                    return
            except (CutOffError, NoServerError):
                if self._closed or not self._reconnect:
                    if self._closed:
                        return
                    raise
            if self._response is not None:
                self._response.close()
            self._response = None
            if not self._closed:
                time.sleep(pause_s)
                pause_s = min(pause_s * 2, 10.0)

    def close(self) -> None:
        self._closed = True
        response, self._response = self._response, None
        if response is not None:
            response.interrupt()

    def __enter__(self) -> "Watch":
        return self

    def __exit__(self, *unused: object) -> None:
        self.close()


class Watches(Resource):
    def watch(
        self, query: Optional[str] = None, *, subject: Optional[str] = None,
        predicate: Optional[str] = None, object: Optional[str] = None, first: Optional[str] = None,
        reconnect: bool = False, idle_timeout_s: float = 90.0, **about: Any,
    ) -> Watch:
        """Events whenever the answer to a query, or to a triple pattern, changes.

        The first one, "answer", holds the rows (`first="count"`: only their number), each "change"
        those "added" and "removed". With `reconnect` a lost connection is made anew, and the answer
        comes anew as an "answer". LaresError ends it when the server says so.
        """
        asked: Dict[str, Any] = {"query": query, "subject": subject, "predicate": predicate,
                                 "object": object, "first": first, **about}
        return Watch(self, asked, reconnect, idle_timeout_s)


__all__: List[str] = ["LikelyPlacesOf", "Plans", "Prolog", "Reasons", "Sparql", "Watch", "Watches",
                      "plan_request"]
