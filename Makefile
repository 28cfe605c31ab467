# `make demo` and `make test` are all the set-up there is: they make .venv on first use.
PYTHON ?= python3
BIN := .venv/bin
READY := .venv/.ready

.PHONY: help setup demo test check bench docs gallery screenshots stubs

help:
	@sed -n 's/^\([a-z]*\):[^#]*## */  make \1: /p' Makefile

setup: $(READY)  ## an environment with everything, in .venv; some minutes

$(READY): pyproject.toml scripts/setup
	$(PYTHON) scripts/setup .venv
	touch $@

demo: $(READY)  ## the main job on pick-place: demonstrations, a policy, its evaluation, a report; 18 minutes
	$(BIN)/optimus run pick-place --minutes 18 --out runs/demo

test: $(READY)  ## the tests
	$(BIN)/pytest

check: $(READY)  ## lint, import contracts, types, README's table against docs/results
	$(BIN)/ruff check
	$(BIN)/lint-imports
	$(BIN)/pyright
	$(BIN)/python scripts/results_table --check  # README.md says what docs/results says

bench: $(READY)  ## the speed of planning, collecting, training, acting and drawing
	$(BIN)/optimus bench expert stack --episodes 20
	$(BIN)/optimus bench collect stack --episodes 20
	$(BIN)/optimus bench step stack
	$(BIN)/optimus bench action stack
	$(BIN)/optimus bench render stack

docs: $(READY)  ## the site, in build/site
	$(BIN)/python scripts/make_reference
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict --quiet

gallery: $(READY)  ## the films of docs/gallery.md
	$(BIN)/python scripts/make_gallery

screenshots: $(READY)  ## the viewer's pictures in docs/images
	OPTIMUS_SCREENSHOTS=docs/images $(BIN)/pytest -n 0 tests/test_view.py

stubs: $(READY)  ## MuJoCo's wheel has no type stubs; run this after moving to another version of it
	$(BIN)/pip install --quiet pybind11-stubgen && $(BIN)/python scripts/make_stubs
