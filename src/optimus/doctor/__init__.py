"""What works on this machine, and how to mend what does not: each part is tried out, none is asked what it thinks of itself."""

from optimus.doctor.examination import examine
from optimus.doctor.finding import Finding

__all__ = ["Finding", "examine"]
