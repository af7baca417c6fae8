"""Which method speaks to which operation of the HTTP interface: the one table.

A test compares it with server/api/operations.json, and calls each method.
"""

from typing import Dict


def _documents(resource: str, noun: str, nouns: str, *leave_out: str) -> Dict[str, str]:
    operations = {
        f"put{noun}": "put",
        f"add{noun}": "add",
        f"list{nouns}": "list",
        f"get{noun}": "file",
        f"list{noun}Versions": "versions",
        f"delete{noun}": "delete",
    }
    return {operation: f"{resource}.{method}" for operation, method in operations.items()
            if method not in leave_out}


OPERATIONS: Dict[str, str] = {
    **_documents("ontology", "OntologyModule", "OntologyModules"),
    "listAliases": "ontology.aliases",
    "checkOntology": "ontology.check",
    "getClass": "ontology.show_class",
    **_documents("priors", "Prior", "Priors", "add"),
    **_documents("recipes", "Recipe", "Recipes"),
    "rankRobots": "recipes.robots",
    **_documents("skill_templates", "SkillTemplate", "SkillTemplates"),
    **_documents("robots", "Robot", "Robots"),
    "getRobotUrdf": "robots.urdf",
    "showRobotCapabilities": "robots.capabilities",
    "showRobotTree": "robots.tree",
    "examineRobot": "robots.examine",
    "examineUrdf": "robots.examine_urdf",
    **_documents("object_models", "ObjectModel", "ObjectModels", "add"),
    "getObjectModelFile": "object_models.model_file",
    "listEnvironments": "environments.list",
    "getEnvironment": "environments.get",
    "listEnvironmentVersions": "environments.versions",
    "putEnvironmentVersion": "environments.put_version",
    "getEnvironmentVersion": "environments.version",
    "listMapObjects": "environments.objects",
    "getEnvironmentLayer": "environments.layer",
    "getEnvironmentTar": "environments.tar",
    "getRobotGrid": "environments.robot_grid",
    "getRobotGridImage": "environments.robot_grid_image",
    "getEnvironmentThumbnail": "environments.thumbnail",
    **_documents("quarantine", "QuarantinedDocument", "QuarantinedDocuments", "put", "add"),
    "releaseQuarantinedDocument": "quarantine.release",
    "makePlan": "plans.make",
    "diffPlans": "plans.diff",
    "findLikelyPlaces": "likely_places.find",
    "querySparql": "sparql.select",
    "postSparql": "sparql.query",
    "askProlog": "prolog.ask",
    "explainTriple": "reasons.why",
    "explainAbsence": "reasons.why_not",
    "measureDistance": "reasons.distance",
    "watchQuery": "watches.watch",
    "getHealth": "server.health",
    "getReadiness": "server.ready",
    "getStatus": "server.status",
    "getMetrics": "server.metrics",
    "getOpenApi": "server.openapi",
    "diffEnvironmentVersions": "environments.diff",
    "rollBackEnvironment": "environments.roll_back",
    "mergeEnvironmentVersions": "environments.merge",
    "listEnvironmentTags": "environments.tags",
    "putEnvironmentTag": "environments.tag",
    "deleteEnvironmentTag": "environments.untag",
    "getBlob": "environments.blob",
    "listRobotPins": "robots.pins",
    "pinRobot": "robots.pin",
    "unpinRobot": "robots.unpin",
    "getTypicalObjectModels": "object_models.typical",
    "describeUploads": "uploads.describe",
    "createUpload": "uploads.create",
    "getUploadOffset": "uploads.offset",
    "continueUpload": "uploads.send",
    "removeUpload": "uploads.remove",
    "verifyStore": "server.verify",
    "makeBackup": "server.back_up",
    "listBackups": "server.backups",
    "createToken": "tokens.create",
    "listTokens": "tokens.list",
    "getToken": "tokens.get",
    "revokeToken": "tokens.revoke",
    "listAudit": "audit.list",
}

FOR_BROWSERS = ("getStartPage", "getDocs", "getPageStyle", "getStartScript", "getDocsScript",
                "overrideUploadMethod")
"""Pages for people, and a detour for those who cannot send PATCH: no method speaks to them."""
