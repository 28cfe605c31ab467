"""Data sets to and from the formats of other programs, one file a format."""
