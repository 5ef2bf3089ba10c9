"""``python -m torquerig`` is the command line."""

from torquerig.cli import main

main()
