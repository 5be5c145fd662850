-- What a replay is compared with (STO-007): every run has it, a trace only those of the lab machine.

ALTER TABLE run ADD COLUMN ticks INTEGER NOT NULL DEFAULT 0;   -- while it was started
ALTER TABLE run ADD COLUMN digest TEXT NOT NULL DEFAULT '';    -- of its steps, tick by tick; '' = recorded without
CREATE INDEX run_by_person ON run (person_id, id);
