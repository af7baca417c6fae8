"""Resources of what is known: ontology, priors, recipes, skills, robots, models, quarantine."""

from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence, Union, cast

from .bodies import ANY_TYPE, Body, Form, Progress, Source, json_body, name_of
from .answers import (
    Alias,
    CheckAnswer,
    Class,
    Document,
    Module,
    ObjectModel,
    Pin,
    PutAnswer,
    SkillTemplate,
    TypicalModels,
    VersionAnswer,
)
from .remote_file import RemoteFile
from .resource import Documents, conditions
from .transport import path_of


class Ontology(Documents):
    collection = "ontology/modules"

    def list(self) -> Iterator[Module]:  # type: ignore[override]
        """The modules of the catalogue, those that ship with Lares too."""
        return self._items("/v1/ontology/modules")

    def aliases(self) -> Iterator[Alias]:
        """Historic names and what they mean here."""
        return self._items("/v1/ontology/aliases")

    def show_class(self, name: str) -> Class:
        """A class by IRI, prefixed name, local name or label."""
        return cast(Class, self._json(path_of("ontology", "classes", name)))

    def check(self, source: Source, *, file_name: Optional[str] = None,
              recover: bool = False) -> CheckAnswer:
        """What is wrong with an ontology document; nothing is kept."""
        answer = self._transport.request(
            "POST", "/v1/ontology/check",
            {"file_name": file_name or name_of(source) or None, "recover": recover},
            body=Body(source, "application/octet-stream"), safe=True,
        )
        return cast(CheckAnswer, answer.json())


class Priors(Documents):
    """Tables of where things usually are."""

    collection = "priors"

    def put(  # type: ignore[override]
        self, source: Source, id: Optional[str] = None, *, format: str,
        file_name: Optional[str] = None, recover: bool = False, if_match: Optional[str] = None,
        only_new: bool = False, progress: Optional[Progress] = None,
    ) -> PutAnswer:
        """Imports a table: `format` is "omics" or "tsv"."""
        name = file_name or name_of(source)
        chosen = id or Path(name).stem
        if not chosen:
            raise ValueError("content without a file name needs an id")
        return self._put("PUT", self._path(chosen), source, name, None,
                         {"format": format, "recover": recover}, if_match, only_new, progress)

    def add(self, *unused: Any, **also: Any) -> PutAnswer:
        """Not offered by the server: a table is put under an id."""
        raise TypeError("a prior has no add: put it")


class Recipes(Documents):
    collection = "recipes"

    def robots(self, task: str, *, environment: Optional[str] = None,
               strict: bool = False) -> Dict[str, Any]:
        """The stored robots, by how little they lack for a recipe: {"task", "robots"}."""
        query = {"environment": environment, "strict": strict}
        return cast(Dict[str, Any], self._json(self._path(task) + "/robots", query))


class SkillTemplates(Documents):
    collection = "skill-templates"

    def list(self) -> Iterator[SkillTemplate]:  # type: ignore[override]
        """The skills that plans are made of, built-in ones too."""
        return self._items("/v1/skill-templates")


class Robots(Documents):
    """Robots' descriptions: SRDL, or URDF that becomes SRDL."""

    collection = "robots"

    def put_urdf(
        self, source: Source, id: Optional[str] = None, *, has: Sequence[str] = (),
        name: Optional[str] = None, base_frame: Optional[str] = None, editor: bool = False,
        quarantine: bool = False, if_match: Optional[str] = None, only_new: bool = False,
    ) -> PutAnswer:
        """Stores a URDF; `has` names components that no URDF tells of."""
        file_name = name_of(source, f"{id or ''}.urdf")
        chosen = id or Path(file_name).stem
        query = {"has": list(has), "name": name, "base_frame": base_frame, "editor": editor,
                 "quarantine": quarantine}
        return self._put("PUT", self._path(chosen), source, file_name, "application/urdf+xml",
                         query, if_match, only_new, None)

    def rendered(self, id: str, as_: str, version: Optional[int] = None) -> RemoteFile:
        """Its SRDL as "turtle", "rdf-xml", "n-triples", "n-quads", "trig" or "json-ld"."""
        return self._file(self._path(id), {"as": as_, "version": version})

    def urdf(self, id: str, version: Optional[int] = None) -> RemoteFile:
        """The URDF that it was put from, byte for byte."""
        return self._file(self._path(id) + "/urdf", {"version": version})

    def capabilities(self, id: str, *, strict: bool = False) -> Dict[str, Any]:
        """Everything that it can do, and what keeps it from the rest."""
        return cast(Dict[str, Any], self._json(self._path(id) + "/capabilities",
                                               {"strict": strict}))

    def tree(self, id: str, as_: str = "svg") -> str:
        """Its kinematic tree as "svg" or "dot"."""
        return self._file(self._path(id) + "/tree", {"as": as_}, cached=False).text()

    def examine(self, id: str, *, srdl: Optional[str] = None) -> Dict[str, Any]:
        """What is wrong with its URDF, and where a stored robot's SRDL differs."""
        return cast(Dict[str, Any], self._json(self._path(id) + "/doctor", {"srdl": srdl}))

    def examine_urdf(self, source: Source, *, file_name: Optional[str] = None,
                     srdl: Optional[str] = None) -> Dict[str, Any]:
        """The same of a URDF that is not stored; nothing is kept."""
        answer = self._transport.request(
            "POST", "/v1/robots/doctor",
            {"file_name": file_name or name_of(source) or None, "srdl": srdl},
            body=Body(source, "application/urdf+xml"), safe=True,
        )
        return cast(Dict[str, Any], answer.json())


    def pins(self, id: str) -> List[Pin]:
        """The versions of environments that it is pinned to."""
        return cast(List[Pin], self._json(self._path(id) + "/pins")["items"])

    def pin(self, id: str, environment: str, version: Union[None, int, str] = None,
            author: Optional[str] = None) -> Pin:
        """Keeps it at one version of an environment: a number or a tag, by default the newest."""
        body = {"version": version, "author": author}
        answer = self._transport.request(
            "PUT", path_of("robots", id, "pins", environment),
            body=json_body({name: one for name, one in body.items() if one is not None}))
        return cast(Pin, answer.json())

    def unpin(self, id: str, environment: str) -> None:
        """Lets it use the newest version again."""
        self._transport.delete(path_of("robots", id, "pins", environment))


class ObjectModels(Documents):
    collection = "object-models"

    def put(  # type: ignore[override]
        self, description: Source, files: Sequence[Source] = (), id: Optional[str] = None, *,
        description_name: Optional[str] = None, recover: bool = False, editor: bool = False,
        quarantine: bool = False, if_match: Optional[str] = None, only_new: bool = False,
        progress: Optional[Progress] = None,
    ) -> PutAnswer:
        """Stores a model: its description and its files, which must be paths.

        Without files, those of the version before stay.
        """
        name = description_name or name_of(description)
        chosen = id or Path(name).stem
        if not chosen:
            raise ValueError("content without a file name needs an id")
        parts = [("description", name or "description", description, ANY_TYPE)]
        parts += [("file", name_of(file), file, ANY_TYPE) for file in files]
        answer = self._transport.request(
            "PUT", self._path(chosen),
            {"recover": recover, "editor": editor, "quarantine": quarantine},
            body=Form([], parts), headers=conditions(if_match, only_new), progress=progress,
        )
        return cast(PutAnswer, answer.json())

    def add(self, *unused: Any, **also: Any) -> PutAnswer:
        """Not offered by the server: a model is put under an id."""
        raise TypeError("an object model has no add: put it")

    def list(
        self, class_: Optional[str] = None, *, room: Optional[str] = None,
        maker: Optional[str] = None, algorithm: Optional[str] = None, kind: Optional[str] = None,
    ) -> Iterator[ObjectModel]:
        """All models, or those that are all of what is asked for."""
        return self._items("/v1/object-models", {"class": class_, "room": room, "maker": maker,
                                                 "algorithm": algorithm, "kind": kind})

    def typical(
        self, room: str, *, robot: Optional[str] = None, strict: bool = False,
        prior: Optional[str] = None, min_probability: Optional[float] = None,
        max_models: Optional[int] = None, max_bytes: Optional[int] = None,
    ) -> TypicalModels:
        """Which models are worth loading for a kind of room, and why each."""
        query = {"room": room, "robot": robot, "strict": strict, "prior": prior,
                 "min_probability": min_probability, "max_models": max_models,
                 "max_bytes": max_bytes}
        return cast(TypicalModels, self._json("/v1/object-models/typical", query))

    def model_file(self, id: str, name: str) -> RemoteFile:
        """One of the files that came with the description."""
        return self._file(self._path(id) + "/files" + path_of(name)[len("/v1") :])


class Quarantine(Documents):
    """Documents kept aside; ids are "kind.id", as in "ontology.my-furniture"."""

    collection = "quarantine"

    def put(self, *unused: Any, **also: Any) -> PutAnswer:
        """Not offered by the server: documents come here by put(…, quarantine=True)."""
        raise TypeError("nothing is put into the quarantine but by quarantine=True")

    add = put

    def release(self, id: str, *, editor: bool = False) -> "PutAnswer | VersionAnswer":
        """Puts it again, now that it may no longer contradict."""
        answer = self._transport.request("POST", self._path(id) + "/release", {"editor": editor})
        return cast("PutAnswer | VersionAnswer", answer.json())


__all__: List[str] = [
    "Document", "ObjectModels", "Ontology", "Priors", "Quarantine", "Recipes", "Robots",
    "SkillTemplates",
]
