"""The page of a diagnosis: tables, pictures and sentences; ``motion_*`` where the motion was measured."""
