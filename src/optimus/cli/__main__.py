"""`python -m optimus.cli`: the `optimus` command where it is not installed."""

from optimus.cli import main

if __name__ == "__main__":
    main()
