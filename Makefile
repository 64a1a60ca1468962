# SPDX-License-Identifier: MIT
# Two commands for everybody. Both set up what they need, say so, and are quick the second time.
#
#   make run       run a program in the simulation; summary and what costs time, picture, report
#                  FILE=part.ngc MACHINE=cak6150n PICTURE=part.png REPORT=part.html to choose
#   make test      the suite, files of it side by side; DURATIONS=1 tells what each costs
#
# Three for those who change it (CONTRIBUTING.md):
#
#   make room      the tests of one room, quick, after an edit: R=smooth
#   make quick     a few of every kind, before a commit
#   make campaign  all that the suite draws from, and the long searches: WHAT=fuzz for one of them

PYTHON ?= python3
R ?= house
FILE ?= pycnc/examples/first_part.ngc
PICTURE ?= build/$(basename $(notdir $(FILE))).png
REPORT ?= build/$(basename $(notdir $(FILE))).html
MACHINE_OPTION = $(if $(MACHINE), --machine "$(MACHINE)")

BIN = .venv/bin
STAMP = build/stamp
PYTEST = $(BIN)/python -m pytest -n logical --maxprocesses 8 --dist loadfile --no-loadscope-reorder
SOURCES := $(shell find csrc opencl firmware_sim adapters cmake CMakeLists.txt -type f)
NAMES := $(shell find pycnc -name '*.py' | sort | cksum | cut -d' ' -f1)
# A room is a folder of tests.
IS_ROOM = test -n "$(R)" -a -e tests/$(R) || { echo "make room needs R=…, one of:" \
	$(sort $(notdir $(patsubst %/,%,$(dir $(wildcard tests/*/test_*))))) >&2; exit 2; }
# After an edit three failures say enough.
SOON = --maxfail 3 --max-worker-restart 3
PACKAGES_TEST = clang-19 libclang-rt-19-dev llvm-19 cppcheck gcc-arm-none-eabi \
                libnewlib-arm-none-eabi qemu-system-arm pkgconf linuxcnc-uspace \
                linuxcnc-uspace-dev chromium doxygen valgrind ccache git qemu-user \
                gcc-i686-linux-gnu gcc-aarch64-linux-gnu gcc-riscv64-linux-gnu \
                gcc-s390x-linux-gnu libc6-dev-i386-cross libc6-dev-arm64-cross \
                libc6-dev-riscv64-cross libc6-dev-s390x-cross
# What the senders of the campaign need: CNCjs, and bCNC on a display that nobody sees.
PACKAGES_SENDERS = nodejs npm xvfb xauth python3-tk

# $(call install,PACKAGES): install the Debian packages of the list that are missing.
install = missing=$$(for package in $(1); do \
        dpkg-query -W -f='$${Status}' $$package 2>/dev/null | grep -q ' installed' \
            || echo $$package; done); \
    if [ -z "$$missing" ]; then exit 0; fi; \
    echo "installing Debian packages:" $$missing; \
    if ! command -v apt-get >/dev/null; then \
        echo "no apt-get here: please install the like of" $$missing; exit 1; fi; \
    root=$$([ "$$(id -u)" = 0 ] || echo sudo); \
    $$root apt-get -qq update && \
    $$root env DEBIAN_FRONTEND=noninteractive \
        apt-get -qq install -y --no-install-recommends $$missing

# Compiled Python is kept, whatever the shell asks for: without it every process compiles the tests
# and pycnc anew, half a second of each program of the command line and a second of each pytest. pip
# compiles nothing: all modules of the packages would take 20 s, and few of them are ever imported.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: run test room quick campaign

run: $(STAMP)/module
	$(BIN)/pycnc run "$(FILE)"$(MACHINE_OPTION)
	$(BIN)/pycnc plot "$(FILE)"$(MACHINE_OPTION) -o "$(PICTURE)"
	@echo "The picture of the path, coloured by speed: $(PICTURE)"
	$(BIN)/pycnc report -q "$(FILE)"$(MACHINE_OPTION) -o "$(REPORT)"
	@echo "All of it in one page for your browser, which needs no network: $(REPORT)"
	@echo "More: $(BIN)/pycnc --help, and docs/why.md"

# Packages that few tests need come while the others run; see tests/builds.py.
test: export PACKAGES_COMING = $(STAMP)/packages-coming
test: $(STAMP)/venv-test $(STAMP)/module
	@touch $(PACKAGES_COMING); \
	($(MAKE) --no-print-directory $(STAMP)/packages-test; rm -f $(PACKAGES_COMING)) & \
	$(PYTEST); status=$$?; wait; exit $$status

room quick: $(STAMP)/venv-test
	@$(if $(filter room,$@),$(IS_ROOM))
	@$(MAKE) -q $(STAMP)/module || $(MAKE) --no-print-directory $(STAMP)/module-quick
	$(PYTEST) --draw quick -q $(if $(filter room,$@),$(SOON) tests/$(R))

campaign: $(STAMP)/packages-test $(STAMP)/packages-senders $(STAMP)/venv-test $(STAMP)/module
	$(BIN)/python tests/campaign.py $(WHAT)

# A C compiler, and a Python that can make a .venv and compile a module for it.
$(STAMP)/packages-run:
	@mkdir -p $(STAMP)
	@echo '#include <math.h>' | cc -E - >/dev/null 2>&1 || ($(call install,gcc libc6-dev))
	@$(PYTHON) -c 'import ensurepip, os, sysconfig as s, sys; \
	    sys.exit(not os.path.exists(s.get_path("include") + "/Python.h"))' 2>/dev/null \
	    || ($(call install,python3 python3-venv python3-dev))
	@touch $@

$(STAMP)/packages-test: Makefile
	@mkdir -p $(STAMP)
	@($(call install,$(PACKAGES_TEST)))
	@touch $@

$(STAMP)/packages-senders: Makefile
	@mkdir -p $(STAMP)
	@($(call install,$(PACKAGES_SENDERS)))
	@touch $@

$(STAMP)/venv: requirements.lock $(STAMP)/packages-run
	@echo "installing the packages of requirements.lock into .venv"
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install -q --disable-pip-version-check --no-compile -r requirements.lock
	@touch $@

# What only the tests need, an OpenCL among it.
$(STAMP)/venv-test: requirements-test.lock $(STAMP)/venv
	@echo "installing the packages of requirements-test.lock into .venv"
	$(BIN)/python -m pip install -q --disable-pip-version-check --no-compile -r requirements-test.lock
	@touch $@

$(STAMP)/names-$(NAMES):
	@mkdir -p $(STAMP)
	@rm -f $(STAMP)/names-*
	@touch $@

# The editable install: Python files are used where they stand, the C module is built. It knows the
# files by name, so a new one needs it again.
$(STAMP)/module: $(STAMP)/venv pyproject.toml $(SOURCES) $(STAMP)/names-$(NAMES)
	@echo "building pycnc: the kernel is compiled, some minutes the first time"
	$(BIN)/python -m pip install -q --disable-pip-version-check \
	    --no-build-isolation --no-deps -e .
	@touch $@

# The same module, compiled file by file with little optimization: after an edit one file is built.
$(STAMP)/module-quick: $(STAMP)/venv pyproject.toml $(SOURCES) $(STAMP)/names-$(NAMES)
	@test $(STAMP)/module -nt $(STAMP)/names-$(NAMES) || \
	    $(MAKE) --no-print-directory $(STAMP)/module
	@test -e build/quick/build.ninja || $(BIN)/cmake -S . -B build/quick -G Ninja -DSKBUILD=1 \
	    -DNCK_QUICK=ON -DCMAKE_MAKE_PROGRAM=$(abspath $(BIN))/ninja \
	    -DPython_EXECUTABLE=$(abspath $(BIN))/python >/dev/null
	@$(BIN)/ninja -C build/quick --quiet
	@$(BIN)/cmake --install build/quick --prefix \
	    "$$($(BIN)/python -c 'import sysconfig as s; print(s.get_path("platlib"))')" >/dev/null
	@touch $@
