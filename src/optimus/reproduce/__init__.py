"""The paper's tables and figures, one command each: tables as data, one engine that collects, trains, tries and writes."""

from optimus.reproduce.budget import BUDGETS, Budget, budget
from optimus.reproduce.engine import reproduce
from optimus.reproduce.site import Site
from optimus.reproduce.tables import TABLES

__all__ = ["BUDGETS", "TABLES", "Budget", "Site", "budget", "reproduce"]
