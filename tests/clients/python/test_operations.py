"""No operation of the interface is without a method, and each method speaks to its operation."""

import json
import re
import subprocess
import sys
import unittest
from typing import Any, Callable, Dict, List
from unittest import mock

from support import DEMO, LIBRARY, ROBOTS, ROOT, URDF, ServerTest

import lares
from lares.operations import FOR_BROWSERS, OPERATIONS

DESCRIBED = json.loads((ROOT / "server/api/operations.json").read_text("utf-8"))

TABLE = b"object\tplace\tcount\tsource\nCup\tKitchen\t3\tme\n"
MODULE = b"""@prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix ex: <http://example.org/mine#> .
<http://example.org/mine> a owl:Ontology . ex:Gadget a owl:Class .
"""
CONTRADICTION = b"""@prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix ex: <http://example.org/c#> .
<http://example.org/c> a owl:Ontology . ex:A a owl:Class ; owl:disjointWith ex:B . ex:B a owl:Class .
ex:x a ex:A , ex:B .
"""
SKILL_ID = "blink"
ABOUT = ("lares:Cup", "rdfs:subClassOf", "lares:Container")


class TableTest(unittest.TestCase):
    def test_every_operation_has_a_method_or_is_a_page_for_people(self) -> None:
        self.assertEqual(set(DESCRIBED["operations"]), set(OPERATIONS) | set(FOR_BROWSERS))

    def test_every_method_of_the_table_is_there(self) -> None:
        client = lares.Client("http://127.0.0.1:1")
        for operation, path in OPERATIONS.items():
            found: Any = client
            for name in path.split("."):
                found = getattr(found, name)
            self.assertTrue(callable(found), operation)

    def test_the_types_are_those_of_the_interface(self) -> None:
        written = subprocess.run(
            [sys.executable, ROOT / "clients/python/tools/make_types.py",
             ROOT / "server/api/operations.json"],
            check=True, capture_output=True, text=True,
        ).stdout
        self.assertEqual(written, (ROOT / "clients/python/lares/answers.py").read_text("utf-8"),
                         "run clients/python/tools/make_types.py again")


def calls(client: "lares.Client", folder: Any) -> Dict[str, Callable[[], Any]]:
    """One call of each operation, in an order in which all of them succeed."""
    search, scout = LIBRARY / "object-search.ttl", ROBOTS / "scout.ttl"
    skills = folder / "blink.ttl"
    guide = (ROOT / "docs/recipes.md").read_text("utf-8")
    skills.write_text(re.findall(r"```turtle\n(# blink\.ttl.*?)```", guide, re.DOTALL)[0])
    model = folder / "cup-model.ttl"
    model.write_text("@prefix lares: <https://w3id.org/lares#> . @prefix ex: "
                     "<http://example.org/m#> . ex:m a lares:PlanarObjectModel ; "
                     "lares:providesModelFor lares:Cup .")
    picture = folder / "face.png"
    picture.write_bytes(b"\x89PNG")
    wanted = lares.plan_request("search", "scout-2", set={"object": "Cup"})

    def documents(resource: Any, source: Any, kind: str, kinds: str, id: str,
                  other_id: str = "") -> Dict[str, Callable[[], Any]]:
        path = str(source)
        return {
            f"put{kind}": lambda: resource.put(path, id),
            f"add{kind}": lambda: resource.add(path),
            f"list{kinds}": lambda: list(resource.list()),
            f"get{kind}": lambda: resource.file(id).read(),
            f"list{kind}Versions": lambda: list(resource.versions(id)),
        }

    given: Dict[str, str] = {}
    module = folder / "mine.ttl"
    module.write_bytes(MODULE)
    (folder / "cart.urdf").write_bytes(URDF)
    return {
        "getHealth": client.server.health,
        "getReadiness": client.server.ready,
        "getStatus": client.server.status,
        "getMetrics": client.server.metrics,
        "getOpenApi": client.server.openapi,
        **documents(client.ontology, module, "OntologyModule", "OntologyModules", "mine"),
        "listAliases": lambda: list(client.ontology.aliases()),
        "checkOntology": lambda: client.ontology.check(MODULE, file_name="mine.ttl"),
        "getClass": lambda: client.ontology.show_class("Cup"),
        "putPrior": lambda: client.priors.put(TABLE, "mine", format="tsv"),
        "listPriors": lambda: list(client.priors.list()),
        "getPrior": lambda: client.priors.file("mine").read(),
        "listPriorVersions": lambda: list(client.priors.versions("mine")),
        **documents(client.recipes, search, "Recipe", "Recipes", "search"),
        **documents(client.robots, scout, "Robot", "Robots", "scout-2"),
        "rankRobots": lambda: client.recipes.robots("search"),
        "showRobotCapabilities": lambda: client.robots.capabilities("scout"),
        "getRobotUrdf": lambda: (client.robots.put_urdf(folder / "cart.urdf"),
                                 client.robots.urdf("cart").read()),
        "showRobotTree": lambda: client.robots.tree("cart"),
        "examineRobot": lambda: client.robots.examine("cart"),
        "examineUrdf": lambda: client.robots.examine_urdf(URDF, file_name="cart.urdf"),
        **documents(client.skill_templates, skills, "SkillTemplate", "SkillTemplates", SKILL_ID),
        "putObjectModel": lambda: client.object_models.put(model, [picture], "cup"),
        "listObjectModels": lambda: list(client.object_models.list("Cup")),
        "getObjectModel": lambda: client.object_models.file("cup").read(),
        "getObjectModelFile": lambda: client.object_models.model_file("cup", "face.png").read(),
        "listObjectModelVersions": lambda: list(client.object_models.versions("cup")),
        "putEnvironmentVersion": lambda: client.environments.put_version(
            "flat", {"semantic": DEMO / "flat.ttl", "grid": DEMO / "flat.yaml"}, type="Home"),
        "listEnvironments": lambda: list(client.environments.list()),
        "getEnvironment": lambda: client.environments.get("flat"),
        "listEnvironmentVersions": lambda: list(client.environments.versions("flat")),
        "getEnvironmentVersion": lambda: client.environments.version("flat"),
        "listMapObjects": lambda: list(client.environments.objects("flat")),
        "getEnvironmentLayer": lambda: client.environments.layer("flat", "semantic").read(),
        "getEnvironmentTar": lambda: client.environments.tar("flat").read(),
        "getRobotGrid": lambda: client.environments.robot_grid("flat", "scout").read(),
        "getRobotGridImage": lambda: client.environments.robot_grid_image("flat", "scout").read(),
        "getEnvironmentThumbnail": lambda: client.environments.thumbnail("flat", size_px=64).read(),
        "makePlan": lambda: client.plans.make("search", "scout-2", set={"object": "Cup"}),
        "diffPlans": lambda: client.plans.diff(wanted, wanted),
        "findLikelyPlaces": lambda: client.likely_places.find("Cup"),
        "querySparql": lambda: list(client.sparql.select("SELECT * { ?c a owl:Class } LIMIT 3")),
        "postSparql": lambda: client.sparql.query("ASK {}", "json", method="POST").read(),
        "askProlog": lambda: client.prolog.ask("subclass(lares:'Cup', lares:'Container')"),
        "explainTriple": lambda: client.reasons.why(*ABOUT),
        "explainAbsence": lambda: client.reasons.why_not("lares:Cup", "rdfs:subClassOf",
                                                         "lares:Robot"),
        "measureDistance": lambda: client.reasons.distance("Cup", "Bottle"),
        "watchQuery": lambda: _first_event(client),
        "listQuarantinedDocuments": lambda: (
            client.ontology.put(CONTRADICTION, "against", file_name="c.ttl", quarantine=True),
            list(client.quarantine.list())),
        "getQuarantinedDocument": lambda: client.quarantine.file("ontology.against").read(),
        "listQuarantinedDocumentVersions": lambda: list(
            client.quarantine.versions("ontology.against")),
        "releaseQuarantinedDocument": lambda: _still_refused(client),
        "deleteQuarantinedDocument": lambda: client.quarantine.delete("ontology.against"),
        "putEnvironmentTag": lambda: client.environments.tag("flat", "approved", 1),
        "listEnvironmentTags": lambda: client.environments.tags("flat"),
        "diffEnvironmentVersions": lambda: client.environments.diff("flat", 1, "approved"),
        "rollBackEnvironment": lambda: client.environments.roll_back("flat", "approved"),
        "mergeEnvironmentVersions": lambda: client.environments.merge("flat", 1, dry_run=True),
        "deleteEnvironmentTag": lambda: client.environments.untag("flat", "approved"),
        "getBlob": lambda: client.environments.blob(
            client.environments.version("flat")["layers"][0]["sha256"]).read(),
        "pinRobot": lambda: client.robots.pin("scout", "flat", 1),
        "listRobotPins": lambda: client.robots.pins("scout"),
        "unpinRobot": lambda: client.robots.unpin("scout", "flat"),
        "getTypicalObjectModels": lambda: client.object_models.typical("Kitchen"),
        "describeUploads": client.uploads.describe,
        "createUpload": lambda: given.update(upload=client.uploads.create(4, "face.png")),
        "getUploadOffset": lambda: client.uploads.offset(given["upload"]),
        "continueUpload": lambda: client.uploads.send(picture, given["upload"]),
        "removeUpload": lambda: client.uploads.remove(given["upload"]),
        "verifyStore": client.server.verify,
        "makeBackup": lambda: client.server.back_up("first"),
        "listBackups": client.server.backups,
        "deletePrior": lambda: client.priors.delete("mine"),
        "deleteObjectModel": lambda: client.object_models.delete("cup"),
        "deleteSkillTemplate": lambda: client.skill_templates.delete(SKILL_ID),
        "deleteRobot": lambda: client.robots.delete("scout-2"),
        "deleteRecipe": lambda: client.recipes.delete("search"),
        "deleteOntologyModule": lambda: client.ontology.delete("mine"),
        "createToken": lambda: _become_admin(client, given),
        "listTokens": lambda: list(client.tokens.list()),
        "getToken": lambda: client.tokens.get(given["token"]),
        "revokeToken": lambda: (given.update(reader=client.tokens.create("r", "reader")["id"]),
                                client.tokens.revoke(given["reader"])),
        "listAudit": lambda: list(client.audit.list()),
    }


def _become_admin(client: "lares.Client", given: Dict[str, str]) -> None:
    token = client.tokens.create("me", "admin")
    given["token"] = token["id"]
    client.transport.use_token(token["token"])


def _first_event(client: "lares.Client") -> None:
    with client.watches.watch("SELECT * { ?r a lares:Robot }") as watch:
        assert next(iter(watch)).name == "answer"


def _still_refused(client: "lares.Client") -> None:
    try:
        client.quarantine.release("ontology.against")
    except lares.LaresError as fault:
        assert fault.code == "contradiction", fault


class CallTest(ServerTest):
    def test_each_method_speaks_to_its_operation(self) -> None:
        paths = self.client.server.openapi()["paths"]
        of_operation = {
            methods[method]["operationId"]: (method.upper(), _pattern(path))
            for path, methods in paths.items() for method in methods
        }
        made = calls(self.client, self.folder)
        self.assertEqual(set(made), set(OPERATIONS), "add a call for the new operation")
        for operation, call in made.items():
            with self.subTest(operation=operation):
                asked: List[str] = []
                self.client.on_request(lambda method, target, status:
                                       asked.append(f"{method} {target.split('?')[0]}"))
                with mock.patch.object(self.client.transport, "retries", 0):
                    call()
                method, pattern = of_operation[operation]
                last_method, last_path = asked[-1].split(" ")
                self.assertEqual(last_method, method)
                self.assertRegex(last_path, pattern)
        self.client.on_request(None)


def _pattern(path: str) -> str:
    return "^" + re.sub(r"\\\{[^/]+?\\\}", "[^/]+", re.escape(path)) + "$"


if __name__ == "__main__":
    unittest.main()
