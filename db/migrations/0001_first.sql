-- The first schema: everything that a lab keeps. Times are milliseconds since 1970-01-01 UTC.

CREATE TABLE lab (               -- single values of the whole lab
  key   TEXT PRIMARY KEY,        -- 'certificate', 'private_key', 'epoch', 'tools', 'workpiece'
  value BLOB NOT NULL
) STRICT;

CREATE TABLE person (            -- students, instructors, observers
  id            INTEGER PRIMARY KEY AUTOINCREMENT,  -- never given again, so that nothing late reaches a successor
  name          TEXT    NOT NULL UNIQUE,
  role          TEXT    NOT NULL CHECK (role IN ('student', 'instructor', 'observer')),
  language      TEXT    NOT NULL DEFAULT '' CHECK (language IN ('', 'de', 'en')),   -- '' = the lab's
  model         TEXT    NOT NULL DEFAULT '' CHECK (model IN ('', '3300', '3250')),  -- '' = the lab's
  password_hash TEXT    NOT NULL,
  must_change   INTEGER NOT NULL DEFAULT 0 CHECK (must_change IN (0, 1)),
  created_ms    INTEGER NOT NULL,
  last_seen_ms  INTEGER NOT NULL DEFAULT 0,
  archived_ms   INTEGER          -- NULL = on the roster (INS-004)
) STRICT;

CREATE TABLE program (           -- one row per program of a person; P0000 is the tool table
  person_id  INTEGER NOT NULL REFERENCES person (id) ON DELETE CASCADE,
  number     INTEGER NOT NULL CHECK (number BETWEEN 0 AND 9999),
  position   INTEGER NOT NULL,   -- storage order (SCR-054)
  version    INTEGER NOT NULL CHECK (version > 0),
  changed_ms INTEGER NOT NULL,
  PRIMARY KEY (person_id, number)
) STRICT, WITHOUT ROWID;

CREATE TABLE block (             -- the newest state of each block, with its check code (STO-003)
  person_id  INTEGER NOT NULL,
  program    INTEGER NOT NULL,
  number     INTEGER NOT NULL CHECK (number BETWEEN 1 AND 999),
  text       TEXT    NOT NULL,   -- tape form, e.g. N001G00X+50000
  check_code INTEGER NOT NULL,
  PRIMARY KEY (person_id, program, number),
  FOREIGN KEY (person_id, program) REFERENCES program (person_id, number) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;

CREATE TABLE program_change (    -- every change, invertible: undoing from the newest back gives each version (STO-005)
  id         INTEGER PRIMARY KEY,
  person_id  INTEGER NOT NULL REFERENCES person (id) ON DELETE CASCADE,
  program    INTEGER NOT NULL,
  version    INTEGER NOT NULL,   -- the version that this change made; deleting a program makes one too
  kind       TEXT    NOT NULL CHECK (kind IN ('put', 'insert', 'delete', 'replace', 'remove')),
  block      INTEGER NOT NULL DEFAULT 0,   -- put, insert, delete: the block's number
  before     TEXT    NOT NULL DEFAULT '',  -- put, delete: the block as it was; insert: the blocks that moved, as they
                                           -- were; replace, remove: the whole program (several blocks: README.md)
  after      TEXT    NOT NULL DEFAULT '',  -- put, insert: the block as it is; replace: the whole program
  time_ms    INTEGER NOT NULL,
  by_whom    TEXT    NOT NULL,
  station    INTEGER NOT NULL DEFAULT 0,
  UNIQUE (person_id, program, version)
) STRICT;

CREATE TABLE machine_datum (     -- person 0 is the lab machine; a number that is missing has its default
  person_id  INTEGER NOT NULL,
  number     INTEGER NOT NULL,
  value      INTEGER NOT NULL,
  check_code INTEGER NOT NULL,
  PRIMARY KEY (person_id, number)
) STRICT, WITHOUT ROWID;

CREATE TABLE machine_datum_change (
  id         INTEGER PRIMARY KEY,
  person_id  INTEGER NOT NULL,
  number     INTEGER NOT NULL,
  before     INTEGER,
  after      INTEGER,
  time_ms    INTEGER NOT NULL,
  by_whom    TEXT    NOT NULL,
  station    INTEGER NOT NULL DEFAULT 0
) STRICT;

CREATE TABLE control_state (     -- a control between two logins: modal state, parameters, Istwert, mode, entry line
  person_id INTEGER PRIMARY KEY REFERENCES person (id) ON DELETE CASCADE,
  state     BLOB    NOT NULL,    -- JSON, made and read by the panel
  time_ms   INTEGER NOT NULL
) STRICT;

CREATE TABLE journal (           -- append-only (STO-006, AUTH-015)
  id      INTEGER PRIMARY KEY,
  time_ms INTEGER NOT NULL,
  station INTEGER NOT NULL DEFAULT 0,
  person  TEXT    NOT NULL DEFAULT '',
  kind    TEXT    NOT NULL,
  detail  TEXT    NOT NULL DEFAULT '',
  lease   INTEGER NOT NULL DEFAULT 0
) STRICT;
CREATE INDEX journal_by_person ON journal (person, time_ms);
CREATE INDEX journal_by_time ON journal (time_ms);
CREATE TRIGGER journal_is_append_only BEFORE UPDATE ON journal
BEGIN SELECT RAISE(ABORT, 'the journal is append-only'); END;

CREATE TABLE run (               -- a recorded run and everything that decides its course (STO-007)
  id         INTEGER PRIMARY KEY,
  person_id  INTEGER NOT NULL REFERENCES person (id) ON DELETE CASCADE,
  station    INTEGER NOT NULL,
  machine    TEXT    NOT NULL CHECK (machine IN ('training', 'lab')),
  lease      INTEGER NOT NULL DEFAULT 0,
  started_ms INTEGER NOT NULL,
  program    INTEGER NOT NULL,
  block      INTEGER NOT NULL,
  setup      BLOB    NOT NULL,   -- JSON: programs, tools, machine data, position, modal state, parameters, software
  seconds    REAL,
  ended      TEXT
) STRICT;

CREATE TABLE run_event (         -- what acted on a run, by tick
  run_id INTEGER NOT NULL REFERENCES run (id) ON DELETE CASCADE,
  number INTEGER NOT NULL,
  tick   INTEGER NOT NULL,
  kind   TEXT    NOT NULL,
  value  REAL    NOT NULL DEFAULT 0,
  PRIMARY KEY (run_id, number)
) STRICT, WITHOUT ROWID;

CREATE TABLE run_trace (         -- what the lab machine really did, one fixed-size record per tick (db/README.md)
  run_id     INTEGER NOT NULL REFERENCES run (id) ON DELETE CASCADE,
  first_tick INTEGER NOT NULL,
  data       BLOB    NOT NULL,
  PRIMARY KEY (run_id, first_tick)
) STRICT, WITHOUT ROWID;

CREATE TABLE cassette (          -- virtual cassettes, at most ten per student (DEC-33)
  id        INTEGER PRIMARY KEY,
  person_id INTEGER NOT NULL REFERENCES person (id) ON DELETE CASCADE,
  name      TEXT    NOT NULL,
  position  REAL    NOT NULL DEFAULT 0,
  UNIQUE (person_id, name)
) STRICT;

CREATE TABLE recording (
  cassette_id INTEGER NOT NULL REFERENCES cassette (id) ON DELETE CASCADE,
  start       REAL    NOT NULL,
  data        BLOB    NOT NULL,
  PRIMARY KEY (cassette_id, start)
) STRICT, WITHOUT ROWID;
