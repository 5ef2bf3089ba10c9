"""The pages of the first engine; ``motion_*`` where the motion was measured."""
