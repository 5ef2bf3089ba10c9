"""Pictures of signals, spectra, orders, modes and rankings; ``picture`` makes the file."""
