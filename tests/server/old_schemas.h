// The tables as earlier programs made them: what a store of theirs looks like to this one.
#pragma once

namespace lares::store::testing {

// Schema 2, with a document, a deleted one, and an environment of two versions. Its blobs are left
// to the test: the hashes are those of "one" and "two".
inline constexpr const char* kSchema2 = R"sql(
CREATE TABLE schema_version (version INTEGER NOT NULL);

CREATE TABLE documents (
  key INTEGER PRIMARY KEY,
  kind TEXT NOT NULL,
  id TEXT NOT NULL,
  latest INTEGER NOT NULL,
  deleted INTEGER NOT NULL DEFAULT 0,
  UNIQUE (kind, id)
);
CREATE TABLE document_versions (
  key INTEGER PRIMARY KEY,
  document INTEGER NOT NULL REFERENCES documents,
  number INTEGER NOT NULL,
  media_type TEXT NOT NULL,
  file_name TEXT NOT NULL,
  sha256 TEXT NOT NULL,
  size INTEGER NOT NULL,
  received INTEGER NOT NULL,
  details TEXT NOT NULL,
  UNIQUE (document, number)
);
CREATE TABLE document_names (
  version INTEGER NOT NULL REFERENCES document_versions,
  position INTEGER NOT NULL,
  text TEXT NOT NULL,
  lowered TEXT NOT NULL,
  kind TEXT NOT NULL,
  target TEXT NOT NULL,
  current INTEGER NOT NULL,
  PRIMARY KEY (version, position)
) WITHOUT ROWID;
CREATE INDEX current_names ON document_names (lowered) WHERE current = 1;

CREATE TABLE environments (
  key INTEGER PRIMARY KEY,
  id TEXT NOT NULL UNIQUE,
  type_iri TEXT NOT NULL,
  label TEXT NOT NULL,
  created INTEGER NOT NULL,
  latest INTEGER NOT NULL
);
CREATE TABLE environment_versions (
  key INTEGER PRIMARY KEY,
  environment INTEGER NOT NULL REFERENCES environments,
  number INTEGER NOT NULL,
  created INTEGER NOT NULL,
  author TEXT NOT NULL,
  note TEXT NOT NULL,
  changed TEXT NOT NULL,
  type_iri TEXT NOT NULL DEFAULT '',
  label TEXT NOT NULL DEFAULT '',
  UNIQUE (environment, number)
);
CREATE TABLE layers (
  version INTEGER NOT NULL REFERENCES environment_versions,
  name TEXT NOT NULL,
  file_name TEXT NOT NULL,
  media_type TEXT NOT NULL,
  sha256 TEXT NOT NULL,
  size INTEGER NOT NULL,
  facts TEXT NOT NULL,
  PRIMARY KEY (version, name)
) WITHOUT ROWID;

INSERT INTO schema_version VALUES (2);
INSERT INTO documents VALUES (1, 'recipe', 'fetch', 2, 0), (2, 'recipe', 'gone', 1, 1);
INSERT INTO document_versions VALUES
  (1, 1, 1, 'text/turtle', 'fetch.ttl',
   '7692c3ad3540bb803c020b3aee66cd8887123234ea0c6e7143c0add73ff431ed', 3, 1000, '{}'),
  (2, 1, 2, 'text/turtle', 'fetch.ttl',
   '3fc4ccfe745870e2c0d99f71f30ff0656c8dedd41cc1d7d3d376b0dbe685e2f3', 3, 2000, '{}'),
  (3, 2, 1, 'text/turtle', 'gone.ttl',
   '3fc4ccfe745870e2c0d99f71f30ff0656c8dedd41cc1d7d3d376b0dbe685e2f3', 3, 2000, '{}');
INSERT INTO document_names VALUES
  (1, 0, 'Fetch', 'fetch', 'label', 'x:Fetch', 0), (2, 0, 'Fetch', 'fetch', 'label', 'x:Fetch', 1);
INSERT INTO environments VALUES (1, 'kitchen', 'x:Kitchen', 'Our kitchen', 1000, 2);
INSERT INTO environment_versions VALUES
  (1, 1, 1, 1000, 'ann', '', 'grid', 'x:Room', ''),
  (2, 1, 2, 2000, 'bob', 'semantic too', 'semantic', 'x:Kitchen', 'Our kitchen');
INSERT INTO layers VALUES
  (1, 'grid', 'g.pgm', 'image/x-portable-graymap',
   '7692c3ad3540bb803c020b3aee66cd8887123234ea0c6e7143c0add73ff431ed', 3, '{}'),
  (2, 'grid', 'g.pgm', 'image/x-portable-graymap',
   '7692c3ad3540bb803c020b3aee66cd8887123234ea0c6e7143c0add73ff431ed', 3, '{}'),
  (2, 'semantic', 's.ttl', 'text/turtle',
   '3fc4ccfe745870e2c0d99f71f30ff0656c8dedd41cc1d7d3d376b0dbe685e2f3', 3, '{}');
)sql";

// What turns schema 2 into schema 1, whose versions took type and label from their environment.
inline constexpr const char* kBackToSchema1 = R"sql(
ALTER TABLE environment_versions DROP COLUMN type_iri;
ALTER TABLE environment_versions DROP COLUMN label;
UPDATE schema_version SET version = 1;
)sql";

}  // namespace lares::store::testing
