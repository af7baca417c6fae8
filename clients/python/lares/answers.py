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


class KnownOfModel(TypedDict, total=False):
    classes: List["Resource"]
    kinds: List["Resource"]
    algorithms: List["Resource"]
    makers: List["Resource"]
    created: Optional[str]
    extents: Optional[Dict[str, Any]]
    size_bytes: int


class ObjectModel(Document, KnownOfModel, total=False):
    fit: str
    probability: float
    why: str


TypicalModel = TypedDict(
    "TypicalModel",
    {
        "id": str,
        "version": int,
        "verdict": str,
        "why": str,
        "class": "Resource",
        "probability": float,
        "probability_of_room": float,
        "counted": List[str],
        "counted_above": bool,
        "nth_of_its_class": int,
        "robot_has": Optional[str],
        "files": List[Dict[str, Any]],
    },
    total=False,
)


class TypicalModels(TypedDict, total=False):
    room: "Resource"
    robot: Optional["Resource"]
    prior: Dict[str, Any]
    places: List["Resource"]
    places_above: bool
    size_bytes: int
    loaded: List["TypicalModel"]
    left_out: List["TypicalModel"]


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
    changed: str
    latest: int
    versions: int


class Layer(TypedDict, total=False):
    name: str
    file_name: str
    media_type: str
    size: int
    sha256: str
    facts: Dict[str, Any]
    href: str


class Version(TypedDict, total=False):
    environment: str
    number: int
    type: str
    label: str
    created: str
    author: str
    robot: str
    mission: str
    note: str
    origin: Any
    parents: List[int]
    base: int
    head: bool
    etag: str
    changed_layers: List[str]
    layers: List["Layer"]


class Tag(TypedDict, total=False):
    environment: str
    name: str
    version: int
    created: str
    author: str
    note: str


class Pin(TypedDict, total=False):
    robot: str
    environment: str
    version: int
    created: str
    author: str


VersionDiff = TypedDict(
    "VersionDiff",
    {
        "environment": str,
        "from": int,
        "to": int,
        "layers": List[Dict[str, Any]],
        "objects": Dict[str, Any],
        "grid": Optional[Dict[str, Any]],
        "grid_problem": str,
        "type": Dict[str, Any],
        "label": Dict[str, Any],
    },
    total=False,
)


class MergeConflict(TypedDict, total=False):
    layer: str
    subject: str
    property: str
    base: Any
    ours: Any
    theirs: Any


class MergeAnswer(TypedDict, total=False):
    base: int
    ours: int
    theirs: int
    up_to_date: bool
    conflicts: List["MergeConflict"]


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
        "part_of": str,
        "room": str,
        "maps": List[str],
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


class Backup(TypedDict, total=False):
    name: str
    folder: str
    digest: str
    bytes: int
    documentVersions: int
    environmentVersions: int
    blobs: int
    made: str
    schema: int


class _NewTokenAlways(TypedDict):
    label: str
    role: Any


class NewToken(_NewTokenAlways, total=False):
    environments: List[str]
    expires: Optional[str]
    max_requests_per_minute: int
    max_bytes_per_day: int
    max_queries: int


class _TokenAlways(TypedDict):
    id: str
    label: str
    role: Any
    environments: List[str]
    state: Any
    created: str
    expires: Optional[str]
    revoked: Optional[str]


class Token(_TokenAlways, total=False):
    token: str
    max_requests_per_minute: int
    max_bytes_per_day: int
    max_queries: int


class _AuditRecordAlways(TypedDict):
    id: str
    time: str
    token: str
    label: str
    operation: str
    target: str
    status: int
    result: str


class AuditRecord(_AuditRecordAlways, total=False):
    environment: Optional[str]
    version: Optional[int]
    bytes: int
    request_id: str


class Status(TypedDict, total=False):
    name: str
    version: str
    uptime_s: float
    writes_refused: str
    counts: Dict[str, int]
