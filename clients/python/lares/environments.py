"""Environments: rooms and flats in immutable, numbered versions of layers."""

import io
import os
import re
import tarfile
import tempfile
from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union, cast

from .answers import Environment, MapObject, Version, VersionAnswer
from .bodies import Form, Progress, Source, name_of
from .cache import hash_of
from .remote_file import RemoteFile, Saved
from .resource import Resource, conditions
from .transport import path_of

Number = Union[int, str]
"""Of a version, or "latest"."""


class Environments(Resource):
    def list(self) -> Iterator[Environment]:
        return self._items("/v1/environments")

    def get(self, id: str) -> Dict[str, Any]:
        """An environment, with its newest version as member "version"."""
        return cast(Dict[str, Any], self._json(path_of("environments", id)))

    def versions(self, id: str) -> Iterator[Version]:
        """The log, newest first."""
        return self._items(path_of("environments", id, "versions"))

    def put_version(
        self,
        id: str,
        layers: Optional[Mapping[str, Source]] = None,
        *,
        type: Optional[str] = None,
        label: Optional[str] = None,
        author: Optional[str] = None,
        note: Optional[str] = None,
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
        with the image that it names. Files are streamed, memory stays constant. A version that was
        lost on the way is sent again only with an `idempotency_key`.
        """
        fields = [(name, value) for name, value in
                  (("type", type), ("label", label), ("author", author), ("note", note))
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

    def tar(self, id: str, number: Number = "latest") -> RemoteFile:
        """All layers of a version and its manifest in one tar."""
        return self._file(path_of("environments", id, "versions", number) + ".tar")

    def robot_grid(self, id: str, robot: str, number: Number = "latest") -> RemoteFile:
        """The occupancy grid for one robot's body: map_server's YAML."""
        return self._file(_grid_path(id, number, robot) + "/map.yaml")

    def robot_grid_image(self, id: str, robot: str, number: Number = "latest") -> RemoteFile:
        """The image that `robot_grid` names."""
        return self._file(_grid_path(id, number, robot) + "/map.pgm")


def _grid_path(id: str, number: Number, robot: str) -> str:
    return path_of("environments", id, "versions", number, "robot-grid", robot)


def _layer(name: str, source: Source, folder: str) -> Tuple[str, str, Source]:
    if name == "grid" and not isinstance(source, bytes) and name_of(source).endswith(".yaml"):
        return name, "grid.tar", pack_grid(Path(os.fspath(source)), Path(folder) / "grid.tar")
    return name, name_of(source, name), source


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
