"""The sizing of a drive and its duty cycle as text and pictures."""
