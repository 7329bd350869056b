# Two commands matter: `make demo` and `make test`. Both set everything up first.
PYTHON ?= python3.11
BIN := .venv/bin
SIZE :=
THREADS := 2
STAMP := .venv/.stamp

.PHONY: setup demo test test-all browser nats protocol check page-types format bench docs clean

setup: $(STAMP)

# uv comes from PyPI into the environment itself, so nothing but Python is needed; the lock file decides the versions.
# Unlike pip, uv leaves Python to be compiled at first import, and a first start takes three times as long. It could
# compile it, but all of it: a third is what other packages test and install themselves with. What does not compile is
# not for this Python, and nobody imports it.
$(STAMP): pyproject.toml uv.lock
	@command -v $(PYTHON) >/dev/null || { echo "cotouch needs Python 3.11: '$(PYTHON)' was not found; set PYTHON=/path/to/python3.11"; exit 2; }
	@printf 'setting up, once, for about half a minute '; \
	(while sleep 1; do printf .; done) & dots=$$!; trap 'kill $$dots; echo' EXIT; set -e; \
	test -x $(BIN)/python || $(PYTHON) -m venv .venv; \
	$(BIN)/python -m pip install --quiet --disable-pip-version-check "uv>=0.7,<1"; \
	$(BIN)/uv sync --quiet --frozen; \
	$(BIN)/python -m compileall -q -j 0 -x '/(tests|pip|setuptools|pkg_resources)/' .venv/lib || :; \
	touch $@

demo: $(STAMP)
	$(BIN)/cotouch demo --duration 30

# Types take most of this: two threads a quarter less of time, and a fifth more of processors, which tests have no use for.
check: $(STAMP) page-types
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/basedpyright --level error --threads $(THREADS)
	$(BIN)/lint-imports --no-cache

# Nobody needs Node for anything else: where it or its packages are not to be had, this says so and goes on.
page-types:
	@if ! command -v npm >/dev/null || ! node -e 'process.exit(+(parseInt(process.versions.node) < 20))' 2>/dev/null; then \
		echo "no Node 20 here: the types of page/ are not checked"; \
	elif ! cd page; then exit 2; \
	elif test node_modules/.package-lock.json -nt package-lock.json \
		|| npm ci --silent --no-audit --no-fund --fetch-retries=1 --fetch-timeout=20000; then npm run --silent check; \
	else echo "the packages of page/ cannot be had here: its types are not checked"; fi

# For the tests of pages; without one they are skipped, and say so. Chromium's shell, which has no windows, takes half of
# what chromium takes, and chromium is good enough where it cannot be had.
APT := DEBIAN_FRONTEND=noninteractive apt-get --quiet --yes -o Acquire::Retries=1 -o Acquire::http::Timeout=20
browser:
	@command -v chromium-headless-shell >/dev/null || { command -v apt-get >/dev/null && test "$$(id -u)" = 0 \
		&& $(APT) update && { $(APT) install chromium-headless-shell || $(APT) install chromium; }; } \
		|| command -v chromium >/dev/null \
		|| echo "no chromium here and no way to install it: tests in a browser will be skipped"

# For the tests of users behind NATs, which are this kernel's; likewise.
nats:
	@command -v iptables >/dev/null || { command -v apt-get >/dev/null && test "$$(id -u)" = 0 \
		&& $(APT) update && $(APT) install iptables; } \
		|| echo "no iptables here and no way to install it: tests of NATs will be skipped"

# Many tests start processes of their own; each would compile our Python anew where PYTHONDONTWRITEBYTECODE is set.
# The script begins with `check`.
test: $(STAMP) browser nats
	$(BIN)/python -m compileall -q src
	$(BIN)/python tests/run.py $(SIZE)

# The same on many more bodies, networks, devices and seeds: see tests/thorough.py.
test-all:
	$(MAKE) test SIZE=--thorough

# Proves what docs/protocol.md says of the agreement, and finds an attack on each lesser one. ProVerif comes with opam.
protocol: $(STAMP)
	@command -v proverif >/dev/null || { echo "no proverif here: opam install proverif brings it"; exit 2; }
	$(BIN)/pytest tests/samples/test_protocol.py

format: $(STAMP)
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .

bench: $(STAMP)
	$(BIN)/uv sync --quiet --frozen --group bench
	$(BIN)/python -m benchmarks

# The documentation as a folder, `site/`, that works without a server or a network; see `docs/site.py`.
docs: $(STAMP)
	$(BIN)/uv sync --quiet --frozen --group docs
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build
	@echo "site/index.html"

clean:
	rm -rf .venv build dist site .pytest_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
