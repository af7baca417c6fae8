"""What the server answers, as typed dictionaries.

Written by tools/make_types.py from server/api/operations.json: change that, then run it again.
"""

from typing import Any, Dict, List, Optional, TypedDict, Union


class _ResourceAlways(TypedDict):
    iri: str
    label: str


class Resource(_ResourceAlways, total=False):
    as_written: str


class Place(TypedDict, total=False):
    source: str
    line: int
    column: int


class _RemarkAlways(TypedDict):
    message: str


class Remark(_RemarkAlways, total=False):
    place: "Place"


class _ProblemAlways(TypedDict):
    type: str
    title: str
    status: int
    detail: str
    code: str
    instance: str


class Problem(_ProblemAlways, total=False):
    place: "Place"
    hint: str
    candidates: List[str]


class RobotRank(TypedDict):
    id: str
    robot: "Resource"
    feasible: bool
    cost: Optional[float]
    add: List[Dict[str, Any]]
    repair_is_smallest: bool
    downloads: List["Resource"]


class PlanProblem(Problem, total=False):
    text: str
    match: Dict[str, Any]
    smallest_repair: List["Resource"]
    capable_robots: List["Resource"]
    nearest_robots: List["RobotRank"]
    choices: List[Dict[str, Any]]
    problems: List[str]


class Document(TypedDict, total=False):
    kind: str
    id: str
    version: int
    media_type: str
    file_name: str
    size: int
    sha256: str
    etag: str
    received: str
    names: List[Dict[str, Any]]
    details: Dict[str, Any]


class Task(TypedDict, total=False):
    iri: str
    label: str
    as_written: str
    top_level: bool
    form: str
    steps: List["Resource"]
    problems: List[str]
    warnings: List[str]


class _CheckAnswerAlways(TypedDict):
    clean: bool
    owl2_rl: bool
    statements: int
    findings: List["Finding"]


class CheckAnswer(_CheckAnswerAlways, total=False):
    repairs: List["Remark"]
    warnings: List["Remark"]


class Finding(TypedDict):
    kind: str
    message: str
    count: int
    places: List["Place"]
    names: List[str]


PutAnswer = TypedDict(
    "PutAnswer",
    {
        "document": "Document",
        "statements": int,
        "inferred": int,
        "quarantined": str,
        "repairs": List["Remark"],
        "warnings": List["Remark"],
        "tasks": List["Task"],
        "robots": List["Resource"],
        "import": Dict[str, Any],
    },
    total=False,
)


class _UrdfFindingAlways(TypedDict):
    severity: str
    code: str
    message: str


class UrdfFinding(_UrdfFindingAlways, total=False):
    place: "Place"
    remedy: str


class ObjectModel(Document, total=False):
    classes: List["Resource"]


class Module(TypedDict, total=False):
    id: str
    origin: str
    statements: int
    document: "Document"


class Alias(TypedDict, total=False):
    alias: str
    canonical: str
    namespace: bool
    reason: str


class Class(TypedDict, total=False):
    iri: str
    label: str
    as_written: str
    superclasses: List["Resource"]
    subclasses: List["Resource"]


class SkillTemplate(TypedDict, total=False):
    iri: str
    label: str
    comment: str
    document: Optional[str]
    actions: List["Resource"]
    skill: str
    conditions: List[str]
    inputs: List[Dict[str, Any]]
    outputs: List[Dict[str, Any]]
    outcomes: List[Dict[str, Any]]
    claims: List["Resource"]
    preconditions: List[str]
    retries: str
    time_limit_s: str
    tree_fragment: str


class Environment(TypedDict, total=False):
    id: str
    type: str
    label: str
    created: str
    latest: int


class Layer(TypedDict, total=False):
    name: str
    file_name: str
    media_type: str
    size: int
    sha256: str
    facts: Dict[str, Any]


class Version(TypedDict, total=False):
    environment: str
    number: int
    type: str
    label: str
    created: str
    author: str
    note: str
    etag: str
    changed_layers: List[str]
    layers: List["Layer"]


class VersionAnswer(TypedDict, total=False):
    version: "Version"
    repairs: List["Remark"]
    warnings: List["Remark"]
    objects: int


class Pose(TypedDict, total=False):
    position_m: List[float]
    orientation_xyzw: List[float]


MapObject = TypedDict(
    "MapObject",
    {
        "iri": str,
        "label": str,
        "class": str,
        "class_as_written": str,
        "pose": "Pose",
        "extent_m": List[float],
        "existence": float,
        "first_seen": str,
        "last_seen": str,
        "age": str,
        "recognised_with": str,
    },
    total=False,
)


class RankedPlace(TypedDict, total=False):
    iri: str
    label: str
    probability: float
    support: float


class LikelyPlaces(TypedDict, total=False):
    object: "Resource"
    prior: Dict[str, Any]
    seen: List[Any]
    rooms: List["RankedPlace"]
    furniture: List["RankedPlace"]


class _GoalAlways(TypedDict):
    goal: str


class Goal(_GoalAlways, total=False):
    recipe: str
    robot: str
    environment: str
    version: int
    limit: int
    timeout_s: float


class _GoalAnswersAlways(TypedDict):
    outcome: str
    count: int
    complete: bool
    answers: List[Dict[str, Any]]


class GoalAnswers(_GoalAnswersAlways, total=False):
    error: Dict[str, Any]


PlanRequest = TypedDict(
    "PlanRequest",
    {
        "task": str,
        "robot": str,
        "environment": str,
        "version": int,
        "strict": bool,
        "templates": Dict[str, str],
        "set": Dict[str, str],
        "sequential": bool,
        "from": str,
        "done": List[str],
    },
    total=False,
)


class State(TypedDict, total=False):
    status: str


class Status(TypedDict, total=False):
    name: str
    version: str
    uptime_s: float
    writes_refused: str
    counts: Dict[str, int]
