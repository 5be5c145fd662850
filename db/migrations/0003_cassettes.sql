-- Cassettes as the recorder knows them (DEC-33): the tape with its recordings and where it stands is one value. The
-- tables that the first version had for them were never written.

DROP TABLE recording;
DROP TABLE cassette;

CREATE TABLE cassette (          -- at most ten per person
  id         INTEGER PRIMARY KEY,
  person_id  INTEGER NOT NULL REFERENCES person (id) ON DELETE CASCADE,
  name       TEXT    NOT NULL,
  inserted   INTEGER NOT NULL DEFAULT 0 CHECK (inserted IN (0, 1)),  -- it lies in the recorder: at most one per person
  tape       BLOB    NOT NULL,   -- transfer::Cassette, at most 1 MiB
  changed_ms INTEGER NOT NULL,
  UNIQUE (person_id, name)
) STRICT;
