# Two commands matter: `make demo` and `make test`. Both set everything up first.
PYTHON ?= python3.11
BIN := .venv/bin
STAMP := .venv/.stamp

.PHONY: setup demo test browser nats check format bench clean

setup: $(STAMP)

# uv comes from PyPI into the environment itself, so nothing but Python is needed; the lock file decides the versions.
# Unlike pip, uv leaves Python to be compiled at first import, and a first start takes three times as long.
$(STAMP): pyproject.toml uv.lock
	@command -v $(PYTHON) >/dev/null || { echo "cotouch needs Python 3.11: '$(PYTHON)' was not found; set PYTHON=/path/to/python3.11"; exit 2; }
	test -x $(BIN)/python || $(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check "uv>=0.7,<1"
	$(BIN)/uv sync --quiet --frozen --compile-bytecode
	@touch $@

demo: $(STAMP)
	$(BIN)/cotouch demo --seconds 30

check: $(STAMP)
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/basedpyright --level error
	$(BIN)/lint-imports --no-cache

# For the tests of the animation's page; without one they are skipped, and say so.
browser:
	@command -v chromium >/dev/null || { command -v apt-get >/dev/null && test "$$(id -u)" = 0 \
		&& apt-get update --quiet && DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet chromium; } \
		|| echo "no chromium here and no way to install it: tests in a browser will be skipped"

# For the tests of users behind NATs, which are this kernel's; likewise.
nats:
	@command -v iptables >/dev/null || { command -v apt-get >/dev/null && test "$$(id -u)" = 0 \
		&& apt-get update --quiet && DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet iptables; } \
		|| echo "no iptables here and no way to install it: tests of NATs will be skipped"

# Many tests start processes of their own; each would compile our Python anew where PYTHONDONTWRITEBYTECODE is set.
test: check browser nats
	$(BIN)/python -m compileall -q src
	$(BIN)/pytest -n 2 --dist worksteal

format: $(STAMP)
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .

bench: $(STAMP)
	$(BIN)/uv sync --quiet --frozen --group bench
	$(BIN)/python -m benchmarks

clean:
	rm -rf .venv build dist .pytest_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
