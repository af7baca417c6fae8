"""Environments: rooms and flats in immutable, numbered versions of layers."""

import io
import os
import re
import tarfile
import tempfile
from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union, cast

from .answers import (
    Environment,
    MapObject,
    MergeAnswer,
    Tag,
    Version,
    VersionAnswer,
    VersionDiff,
)
from .bodies import ANY_TYPE, Form, Progress, Source, json_body, name_of
from .cache import hash_of
from .remote_file import RemoteFile, Saved
from .resource import Resource, conditions
from .transport import path_of
from .uploads import REFERENCE_TYPE, Upload

Number = Union[int, str]
"""Of a version, or "latest"."""


class Environments(Resource):
    def list(
        self, *, room_number: Optional[str] = None, street: Optional[str] = None,
        building: Optional[str] = None, level: Optional[str] = None, type: Optional[str] = None,
        holds: Optional[str] = None, layer: Optional[str] = None, text: Optional[str] = None,
        changed_from: Optional[str] = None, changed_until: Optional[str] = None,
    ) -> Iterator[Environment]:
        """All of them, or those that are all of what is asked for."""
        return self._items("/v1/environments", {
            "room_number": room_number, "street": street, "building": building, "level": level,
            "type": type, "holds": holds, "layer": layer, "q": text,
            "changed_from": changed_from, "changed_until": changed_until})

    def get(self, id: str) -> Dict[str, Any]:
        """An environment, with its newest version as member "version"."""
        return cast(Dict[str, Any], self._json(path_of("environments", id)))

    def versions(self, id: str) -> Iterator[Version]:
        """The log, newest first."""
        return self._items(path_of("environments", id, "versions"))

    def put_version(
        self,
        id: str,
        layers: Optional[Mapping[str, Union[Source, Upload]]] = None,
        *,
        type: Optional[str] = None,
        label: Optional[str] = None,
        author: Optional[str] = None,
        note: Optional[str] = None,
        robot: Optional[str] = None,
        mission: Optional[str] = None,
        parent: Optional[int] = None,
        remove: Sequence[str] = (),
        editor: bool = False,
        quarantine: bool = False,
        if_match: Optional[str] = None,
        only_new: bool = False,
        idempotency_key: Optional[str] = None,
        progress: Optional[Progress] = None,
    ) -> VersionAnswer:
        """Adds a version; the first one creates the environment.

        `layers` are given by name (semantic, features, octomap, grid, cloud, trajectory); layers
        that are not named stay as they were. A grid may be the path of map_server's YAML: it goes
        with the image that it names. Files are streamed, memory stays constant; over a bad link,
        `uploads.send` one first and give what it answers. A version that was lost on the way is
        sent again only with an `idempotency_key`. `parent` is the version that it was made from:
        another one than the newest makes a branch, for `merge`.
        """
        fields = [(name, value) for name, value in
                  (("type", type), ("label", label), ("author", author), ("note", note),
                   ("robot", robot), ("mission", mission),
                   ("parent", None if parent is None else str(parent)))
                  if value is not None]
        fields += [("remove", name) for name in remove]
        with tempfile.TemporaryDirectory(prefix="lares-") as folder:
            files = [_layer(name, source, folder) for name, source in (layers or {}).items()]
            answer = self._transport.request(
                "POST", path_of("environments", id, "versions"),
                {"editor": editor, "quarantine": quarantine},
                body=Form(fields, files), progress=progress,
                headers=conditions(if_match, only_new, idempotency_key),
            )
            return cast(VersionAnswer, answer.json())

    def version(self, id: str, number: Number = "latest") -> Version:
        """The manifest of a version."""
        return cast(Version, self._json(path_of("environments", id, "versions", number)))

    def objects(self, id: str, number: Number = "latest") -> Iterator[MapObject]:
        """The objects of a version's semantic layer."""
        return self._items(path_of("environments", id, "versions", number, "objects"))

    def layer(self, id: str, name: str, number: Number = "latest", *,
              accept: Optional[str] = None) -> RemoteFile:
        """A layer's file; `accept` asks for the semantic layer in another format of RDF."""
        path = path_of("environments", id, "versions", number, "layers", name)
        return self._file(path, accept=accept)

    def save(self, id: str, folder: "Union[str, os.PathLike[str]]", number: Number = "latest",
             progress: Optional[Progress] = None) -> List[Saved]:
        """Saves every layer of a version, each checked against the manifest's hash.

        Where the folder has a layer already, with the same hash, it is not downloaded again.
        """
        manifest = self.version(id, number)
        to = Path(folder)
        to.mkdir(parents=True, exist_ok=True)
        saved = []
        for layer in manifest["layers"]:
            name = layer["name"]
            file_name = f"{name}-{Path(layer['file_name']).name}"
            there = to / file_name
            if there.is_file() and hash_of(there) == layer["sha256"]:
                saved.append(Saved(there, layer["size"], layer["sha256"], layer["media_type"], "",
                                   layer["file_name"], from_cache=True))
                continue
            file = self.layer(id, name, manifest["number"])
            saved.append(file.save(there, progress, sha256=layer["sha256"]))
        return saved

    def diff(
        self, id: str, from_: Optional[Number] = None, to: Optional[Number] = None, *,
        tolerance_m: Optional[float] = None, tolerance_rad: Optional[float] = None,
    ) -> VersionDiff:
        """What changed: by default from the version that the newest was made from."""
        query = {"from": from_, "to": to, "tolerance_m": tolerance_m,
                 "tolerance_rad": tolerance_rad}
        return cast(VersionDiff, self._json(path_of("environments", id, "diff"), query))

    def roll_back(self, id: str, to: Number, *, if_match: Optional[str] = None,
                  **about: str) -> VersionAnswer:
        """Makes an older version the newest again, as a new one; `about`: author, note, …"""
        return cast(VersionAnswer, self._post(id, "rollback", {"to": to, **about}, if_match))

    def merge(
        self, id: str, theirs: Number, *, ours: Optional[Number] = None, dry_run: bool = False,
        take: Optional[Mapping[str, str]] = None, otherwise: Optional[str] = None,
        if_match: Optional[str] = None, **about: str,
    ) -> MergeAnswer:
        """Brings another version into the newest.

        Conflicts are LaresError "merge-conflict", listed in its `problem`, until `take` (by layer
        or IRI) or `otherwise` says "ours" or "theirs".
        """
        wanted = {"theirs": theirs, "ours": ours, "dry_run": dry_run or None,
                  "take": dict(take or {}) or None, "otherwise": otherwise, **about}
        body = {name: one for name, one in wanted.items() if one is not None}
        return cast(MergeAnswer, self._post(id, "merge", body, if_match))

    def tags(self, id: str) -> List[Tag]:
        """Names of its versions."""
        return cast(List[Tag], self._json(path_of("environments", id, "tags"))["items"])

    def tag(self, id: str, name: str, version: Optional[Number] = None, *, move: bool = False,
            **about: str) -> Tag:
        """Names a version, which then may be asked for by it; one that is there needs `move`."""
        wanted = {"version": version, "move": move or None, **about}
        body = json_body({name: one for name, one in wanted.items() if one is not None})
        answer = self._transport.request("PUT", path_of("environments", id, "tags", name),
                                         body=body)
        return cast(Tag, answer.json())

    def untag(self, id: str, name: str) -> None:
        """Takes a name off a version, which stays."""
        self._transport.delete(path_of("environments", id, "tags", name))

    def blob(self, sha256: str, name: Optional[str] = None) -> RemoteFile:
        """A file by its hash: a link that never changes."""
        return self._file(path_of("blobs", sha256), {"name": name})

    def _post(self, id: str, what: str, body: Any, if_match: Optional[str]) -> Any:
        answer = self._transport.request("POST", path_of("environments", id, what),
                                         body=json_body(body), headers=conditions(if_match, False))
        return answer.json()

    def tar(self, id: str, number: Number = "latest") -> RemoteFile:
        """All layers of a version and its manifest in one tar."""
        return self._file(path_of("environments", id, "versions", number) + ".tar")

    def robot_grid(self, id: str, robot: str, number: Number = "latest") -> RemoteFile:
        """The occupancy grid for one robot's body: map_server's YAML."""
        return self._file(_grid_path(id, number, robot) + "/map.yaml")

    def robot_grid_image(self, id: str, robot: str, number: Number = "latest") -> RemoteFile:
        """The image that `robot_grid` names."""
        return self._file(_grid_path(id, number, robot) + "/map.pgm")

    def thumbnail(
        self, id: str, number: Number = "latest", size_px: Optional[int] = None
    ) -> RemoteFile:
        """A version from above, as a PNG whose longer side has `size_px` pixels (256)."""
        path = path_of("environments", id, "versions", number) + "/thumbnail.png"
        return self._file(path, None if size_px is None else {"size": size_px})


def _grid_path(id: str, number: Number, robot: str) -> str:
    return path_of("environments", id, "versions", number, "robot-grid", robot)


def _layer(
    name: str, source: Union[Source, Upload], folder: str
) -> Tuple[str, str, Source, str]:
    if isinstance(source, Upload):
        return name, source.file_name, source.path.encode(), REFERENCE_TYPE
    if name == "grid" and not isinstance(source, bytes) and name_of(source).endswith(".yaml"):
        packed = pack_grid(Path(os.fspath(source)), Path(folder) / "grid.tar")
        return name, "grid.tar", packed, ANY_TYPE
    return name, name_of(source, name), source, ANY_TYPE


def pack_grid(yaml: Path, archive: Path) -> Path:
    """A tar of map_server's YAML and the image that it names; ValueError where it names none."""
    text = yaml.read_text("utf-8")
    line = re.search(r"^image:\s*(.+?)\s*(?:#.*)?$", text, re.MULTILINE)
    if line is None:
        raise ValueError(f"{yaml} has no line 'image:'")
    image = yaml.parent / line.group(1).strip("'\"")
    text = text[: line.start()] + f'image: "{image.name}"' + text[line.end() :]
    with tarfile.open(archive, "w", format=tarfile.USTAR_FORMAT) as tar:
        entry = tarfile.TarInfo(yaml.name)
        entry.size = len(text.encode())
        tar.addfile(entry, io.BytesIO(text.encode()))
        picture = tarfile.TarInfo(image.name)
        picture.size = image.stat().st_size
        with open(image, "rb") as file:
            tar.addfile(picture, file)
    return archive
