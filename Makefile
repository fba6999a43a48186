# SPDX-License-Identifier: MIT
# The everyday commands. Each is thin: what it does stands in tools/, in CMakePresets.json or in the program itself.
#   make demo    install what is missing, build the program, run the dry slope, say where its results are
#   make python  build the Python package as well
#   make test    install what is missing, build everything, run every test but those of tests/long_tests.txt
#   make test-all  run these as well
#   make package  Debian packages for every x86-64 processor with SSE 4.2, in build/package/packages
#   make studio-web  the studio with the LEM engine in WebAssembly: a static folder, build/studio-web
#   make build bench format lint docs
# DEMO_ARGS adds arguments to the demo's run, CMAKE_ARGS to the configuration (-DTALUS_MPI=ON), DEMO_OUT is its result folder; SETUP=true skips the installation.
# Drawings and workbooks are built wherever tools/setup.sh can install GDAL and libxlsxwriter.

PRESET    ?= release
BUILD     := build/$(PRESET)
SETUP     ?= tools/setup.sh
TALUS     := $(BUILD)/bin/talus
DEMO_CASE ?= examples/dry_slope/four_methods.toml
DEMO_OUT  ?= results/dry_slope
DEMO_ARGS ?=
CMAKE_ARGS ?=

.PHONY: demo test test-all configure build program python package studio-web bench format lint docs setup setup-dev

setup:
	@$(SETUP)

setup-dev: setup
	@$(SETUP) tools/apt-packages-dev.txt

# Ninja configures again by itself when a CMake file changes; new CMAKE_ARGS need a call of their own.
$(BUILD)/build.ninja: $(if $(strip $(CMAKE_ARGS)),configure) | setup
	@cmake --preset $(PRESET) $(CMAKE_ARGS)

configure:

program: $(BUILD)/build.ninja | setup
	@cmake --build --preset $(PRESET) --target everyday

python: $(BUILD)/build.ninja | setup
	@cmake --build --preset $(PRESET) --target everyday --target talus_python
	@echo "In Python: PYTHONPATH=$(BUILD)/python $$(sed -n 's/^Python_EXECUTABLE:[A-Z]*=//p' $(BUILD)/CMakeCache.txt), then import talus."

build: $(BUILD)/build.ninja | setup
	@cmake --build --preset $(PRESET)

# A package goes to other machines: it has the program for three levels of the instruction set.
package: | setup
	@for preset in package-v4 package-v3 package; do cmake --preset $$preset && cmake --build --preset $$preset || exit 1; done
	@cd build/package && cpack
	@ls -l build/package/packages/*.deb

studio-web: | setup
	@$(SETUP) tools/apt-packages-wasm.txt
	@cmake --preset wasm
	@cmake --build --preset wasm
	@tools/wasm/make_studio.sh build/wasm/bin build/studio-web

demo: program
	@$(TALUS) run $(DEMO_CASE) -o $(DEMO_OUT) --overwrite $(DEMO_ARGS)
	@tools/list_results.sh $(DEMO_OUT)

test: build
	@tools/test.sh $(PRESET)

test-all: build
	@tools/test.sh --all $(PRESET)

bench: build
	@tools/bench.sh $(BUILD)

format: setup-dev
	@tools/format.sh

lint: setup-dev
	@tools/lint.sh

docs: program
	@tools/docs.sh $(TALUS)
