# SPDX-License-Identifier: GPL-3.0-or-later
# overroll: make, make check, make demo; `make help` lists the rest.

# ------------------------------------------------------------- yours to set

CC      ?= cc
CFLAGS  ?= -O2 -g
PREFIX  ?= /usr/local
LIBDIR  ?= $(PREFIX)/lib
MANDIR  ?= $(PREFIX)/share/man
DESTDIR ?=
BUILD   ?= build
JOBS    ?= $(or $(shell nproc 2>/dev/null),2)
V       ?= 0

all: # the default goal, completed below

# ------------------------------------------------------------ what is there

Q := $(if $(filter 0,$(V)),@,)
# Nothing is said under make -s.
SILENT = $(findstring s,$(filter-out -%,$(firstword $(MAKEFLAGS))))
say = @$(if $(SILENT),:,echo "  $(1)")

# Goals that compile need the packages; the others run anywhere.
ifneq ($(filter-out clean help format uninstall,$(or $(MAKECMDGOALS),all)),)
COMPILES := 1
endif

PKG_CONFIG ?= pkg-config
PKGS := gsl zlib libdeflate expat nettle fftw3 fftw3f
HDF5 := $(firstword $(foreach p,hdf5 hdf5-serial,\
          $(if $(shell $(PKG_CONFIG) --exists $(p) 2>/dev/null && echo y),$(p))))
ifdef COMPILES
MISSING := $(if $(shell command -v $(firstword $(CC)) 2>/dev/null),,$(CC)) \
  $(if $(HDF5),,hdf5) \
  $(foreach p,$(PKGS),\
    $(if $(shell $(PKG_CONFIG) --exists $(p) 2>/dev/null && echo y),,$(p)))
ifneq ($(strip $(MISSING)),)
$(error missing: $(strip $(MISSING)); run tools/install-deps)
endif
endif

VERSION := $(shell sed -n 's/.*OVERROLL_VERSION "\(.*\)"/\1/p' \
             include/overroll/version.h)
MAJOR   := $(word 1,$(subst ., ,$(VERSION)))
MINOR   := $(word 2,$(subst ., ,$(VERSION)))
# Before 1.0 every minor version may change the binary interface.
SOVER   := $(if $(filter 0,$(MAJOR)),0.$(MINOR),$(MAJOR))

# ------------------------------------------------------------ kinds of build

# SAN=1: address and undefined-behaviour sanitizers; COV=1: line coverage;
# TSAN=1: thread sanitizer; FUZZ=1: for libFuzzer (clang); WERROR=1: warnings
# are errors (CI).  Each has a build folder of its own.
ifeq ($(SAN),1)
override BUILD := $(BUILD)-san
# -O1 -g1: instrumented code is compiled in half of the time, and its traces
# have lines.  Two instruction sets, the vectors of four among them, and in a
# FAST run one: all are the same source, and a kernel takes 3 s of the compiler
# for vectors of two, 6 s for vectors of four.
KIND := -fsanitize=address,undefined -fno-sanitize-recover=all \
        -fno-omit-frame-pointer -O1 -g1 -DOVR_NO_AVX512 -DOVR_CHECKED \
        $(if $(FAST),-DOVR_NO_AVX2)
# In kernels these are four fifths of the compiler's time (36 s for 8 of
# line.kernel.c), and find nothing that the address sanitizer does not where it
# is read or written: a NULL, a pointer that leaves its array.  Their plain
# twins are checked by all.
KERNEL_KIND := -fno-sanitize=null,alignment,pointer-overflow,object-size
endif
ifeq ($(TSAN),1)
override BUILD := $(BUILD)-tsan
KIND := -fsanitize=thread -fno-omit-frame-pointer
endif
ifeq ($(COV),1)
override BUILD := $(BUILD)-cov
# Threads count too: without atomic counts some come out negative.
KIND := --coverage -fprofile-update=atomic -O0
endif

ifeq ($(FUZZ),1)
override BUILD := $(BUILD)-fuzz
override CC := clang
KIND := -fsanitize=fuzzer-no-link,address,undefined \
        -fno-sanitize-recover=all -fno-omit-frame-pointer
endif

WARN := -Wall -Wextra -Wpedantic -Wconversion -Wshadow $(if $(WERROR),-Werror)
# -ffp-contract=off: fused operations only where they are written, so that
# every compiler and instruction set computes the same thing.
ifdef COMPILES
OVR_CFLAGS := -std=c17 $(WARN) -ffp-contract=off -fno-math-errno -fPIC \
              -fvisibility=hidden -D_POSIX_C_SOURCE=200809L -Iinclude -Isrc \
              $(shell $(PKG_CONFIG) --cflags $(PKGS) $(HDF5))
# Libraries whose own symbols are looked up most come first: the program
# starts a tenth sooner.
OVR_LIBS   := $(shell $(PKG_CONFIG) --libs-only-L $(HDF5)) \
              -lhdf5 -lhdf5_hl \
              $(shell $(PKG_CONFIG) --libs fftw3 fftw3f $(PKGS)) -lm -lpthread
MACHINE    := $(shell $(CC) -dumpmachine)
# The program takes archives where they are: HDF5's shared library brings 30
# others (by way of curl) that nothing here calls, and starting with them takes
# longer than a steady solution.  STATIC= takes shared libraries.
STATIC     ?= $(if $(KIND),,1)
LIBDIRS    := $(patsubst -L%,%,$(shell $(PKG_CONFIG) --libs-only-L $(HDF5))) \
              $(shell $(PKG_CONFIG) --variable=libdir gsl)
archive     = $(firstword $(wildcard $(LIBDIRS:%=%/lib$(1).a)))
ARCHIVES   := $(foreach l,hdf5_hl hdf5 sz aec fftw3 fftw3f gsl gslcblas expat deflate nettle z,\
                $(call archive,$(l)))
endif

# Kernels (*.kernel.c) are compiled once for each instruction set; the program
# picks one when it starts.
# -Wno-pass-failed: clang may ignore an unrolling hint.  -g1: full debug
# information of unrolled loops takes half of the compile time of a kernel.
KERNEL_CFLAGS := $(if $(SAN),-O1,-O3) $(if $(filter -g%,$(CFLAGS)),-g1) \
                 -fno-trapping-math -Wno-pass-failed$(KERNEL_KIND:%= %)
ISAS := base $(if $(filter x86_64%,$(MACHINE)),\
          $(if $(filter 1,$(SAN)),$(if $(FAST),,avx2),avx2 avx512))
ISA_base   :=
ISA_avx2   := -mavx2 -mfma
ISA_avx512 := -mavx512f -mavx512dq -mavx512vl -mfma -mprefer-vector-width=512

COMPILE = $(CC) $(OVR_CFLAGS) $(CFLAGS) $(CPPFLAGS) $(KIND)
LINK    = $(CC) $(CFLAGS) $(KIND) $(LDFLAGS)

# ---------------------------------------------------------- library, program

# A floor may have folders of its own, one deep.
FLOORS  := base mathematics contact elements surface multigrid strip stress simulation \
           results case physics run pictures
KERNELS := $(wildcard src/*/*.kernel.c src/*/*/*.kernel.c)
LIBSRC  := $(filter-out $(KERNELS),\
             $(wildcard $(FLOORS:%=src/%/*.c) $(FLOORS:%=src/%/*/*.c)))
CLISRC  := $(wildcard src/cli/*.c)
HEADERS := $(wildcard include/overroll/*.h)
LIBOBJ  := $(LIBSRC:%.c=$(BUILD)/%.o) \
           $(foreach i,$(ISAS),$(KERNELS:%.kernel.c=$(BUILD)/%.$(i).o)) \
           $(BUILD)/src/pictures/page.o
CLIOBJ  := $(CLISRC:%.c=$(BUILD)/%.o)
LIB     := $(BUILD)/liboverroll.a
SHARED  := $(BUILD)/liboverroll.so.$(VERSION)
PROGRAM := $(BUILD)/overroll
# What the program knows of itself, put where these two files name it.
CASE_PAGE  := $(BUILD)/overroll-case.5
COMPLETION := $(BUILD)/overroll.bash

all: $(PROGRAM) $(LIB) $(SHARED) $(CASE_PAGE) $(COMPLETION) ## the program and both libraries

# An HDF5 that was configured with more than zlib and szip needs libraries that
# only its shared form names: then all are shared.
STATIC_LIBS  = $(ARCHIVES) $(if $(call archive,z),,-lz) -lm -lpthread -ldl
LINKS_STATIC = $(if $(and $(STATIC),$(word 11,$(ARCHIVES))),$(shell \
  echo 'int H5open(void); int main(void) { return H5open(); }' | \
  $(LINK) -x c -o $(BUILD)/static - -x none $(STATIC_LIBS) 2>/dev/null && echo y))
PROGRAM_LIBS = $(if $(LINKS_STATIC),$(STATIC_LIBS),$(OVR_LIBS))

$(PROGRAM): $(CLIOBJ) $(LIB)
	$(call say,LINK  $@)
	$(Q)$(LINK) -o $@ $(CLIOBJ) $(LIB) $(PROGRAM_LIBS)

$(LIB): $(LIBOBJ)
	$(call say,AR    $@)
	$(Q)rm -f $@ && $(AR) qcs $@ $(LIBOBJ)

$(SHARED): $(LIBOBJ)
	$(call say,LINK  $@)
	$(Q)$(LINK) -shared -Wl,-soname,liboverroll.so.$(SOVER) -o $@ $(LIBOBJ) \
	  $(OVR_LIBS)

$(CASE_PAGE): src/case/overroll-case.5 $(PROGRAM)
	$(call say,PAGE  $@)
	$(Q)$(PROGRAM) help --roff > $@.rows
	$(Q)sed -e '/^\.\\" PARAMETERS:/{r $@.rows' -e 'd' -e '}' $< > $@

$(COMPLETION): src/cli/overroll.bash $(PROGRAM)
	$(call say,WORDS $@)
	$(Q)$(PROGRAM) help --bash > $@.options
	$(Q)$(PROGRAM) help --bash keys > $@.keys
	$(Q)sed -e '/^ *# OPTIONS:/{r $@.options' -e 'd' -e '}' \
	  -e '/^ *# KEYS:/{r $@.keys' -e 'd' -e '}' $< > $@

$(BUILD)/%.o: %.c $(BUILD)/flags
	$(call say,CC    $<)
	@mkdir -p $(@D)
	$(Q)$(COMPILE) -MMD -MP -c -o $@ $<

# What gnuplot runs and the page of `overroll view` as arrays; the page's style
# and script go into its text where they are named.
PAGE    := src/pictures/page
PAGE_JS := $(PAGE)_data.js $(PAGE)_draw.js $(PAGE)_areal.js \
           $(addsuffix /pictures_page.js,src/physics/heat src/physics/stress \
             src/elements) $(PAGE)_play.js
CHART   := src/pictures/chart.gp
# $(call array,NAME): standard input as ovr_NAME_text and ovr_NAME_bytes
array = { echo 'const char ovr_$(1)_text[] = {' && od -An -v -b | \
	  sed 's/ \([0-7][0-7]*\)/'"'\\\\\1',"'/g' && echo '};' && \
	  echo 'const size_t ovr_$(1)_bytes = sizeof ovr_$(1)_text;'; }
$(BUILD)/$(PAGE).c: $(PAGE).html $(PAGE).css $(PAGE_JS) $(CHART)
	$(call say,PAGE  $@)
	@mkdir -p $(@D)
	@{ echo '#include "pictures/page.h"' && \
	  sed -e '/^@CSS@$$/{r $(PAGE).css' -e 'd' -e '}' \
	    -e '/^@JS@$$/{' $(PAGE_JS:%=-e 'r %') -e 'd' -e '}' $(PAGE).html | \
	  $(call array,page) && $(call array,template) <$(CHART); } > $@
$(BUILD)/$(PAGE).o: $(BUILD)/$(PAGE).c src/pictures/page.h $(BUILD)/flags
	$(Q)$(COMPILE) -c -o $@ $<

define isa_rule
$(BUILD)/%.$(1).o: %.kernel.c $(BUILD)/flags
	$$(call say,CC    $$< ($(1)))
	@mkdir -p $$(@D)
	$$(Q)$$(COMPILE) $$(KERNEL_CFLAGS) $$(ISA_$(1)) -DOVR_ISA=$(1) \
	  -MMD -MP -c -o $$@ $$<
endef
$(foreach i,$(ISAS),$(eval $(call isa_rule,$(i))))

# Touched only when a compiler or flag is another than last time: everything
# that is compiled depends on it.
FLAGS := $(COMPILE) $(KERNEL_CFLAGS) $(foreach i,$(ISAS),$(ISA_$(i))) \
         $(LDFLAGS) $(OVR_LIBS) $(MACHINE) one-test-program
$(BUILD)/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(subst ','\'',$(FLAGS))' | cmp -s - $@ || \
	  echo '$(subst ','\'',$(FLAGS))' > $@

# Libraries and programs whose list of parts changed (a file was removed).
PARTS := $(LIBOBJ) $(CLIOBJ)
$(BUILD)/parts: FORCE
	@mkdir -p $(@D)
	@echo '$(PARTS)' | cmp -s - $@ || echo '$(PARTS)' > $@
$(PROGRAM) $(LIB) $(SHARED): $(BUILD)/parts

# -------------------------------------------------------------------- tests

# tests/<kind>/*_test.c are programs written with cmocka, tests/<kind>/*.sh
# scripts; tests/support helps both.  Names ending in _slow stay out of a FAST
# run; tests/verify is for `make verify` alone.
NOT_TESTS := tests/support/% tests/verify/% tests/bench/% tests/fuzz/%
# Instrumented, a FAST run has the tests in which memory is handed over: units
# but for the long calculations among them, files of others, the corpora of the
# fuzzer, each physics once and the commands that end soon.  All run in
# verify/sanitized.sh.
SANITIZED := $(filter-out $(addprefix tests/unit/,restart_test.c jumps_test.c \
               sample_test.c determinism_test.c modes_test.c yielding_test.c \
               residuals_test.c starvation_test.c traction_test.c), \
               $(wildcard tests/unit/*)) \
             $(addprefix tests/,reference/boundary_test.c \
               reference/cavitation_test.c reference/content_departures_test.c \
               reference/elements_test.c reference/friction_test.c \
               reference/heat_test.c reference/layered_stress_test.c \
               reference/reversal_test.c reference/spike_test.c \
               pictures/picture_test.c cli/check.sh cli/endings.sh \
               cli/export.sh cli/resume.sh cli/rheology.sh cli/run.sh \
               cli/sensitivity.sh cli/stribeck.sh cli/supply.sh \
               cli/unreadable.sh cli/usage.sh)
SLOW      := $(if $(FAST),%_slow_test.c %_slow.sh)
TESTSRC   := $(wildcard tests/*/*_test.c)
CHECKSRC  := $(filter-out $(NOT_TESTS) $(SLOW),$(TESTSRC))
CHECKSH   := $(filter-out $(NOT_TESTS) $(SLOW),$(wildcard tests/*/*.sh))
ifeq ($(and $(SAN),$(FAST)),1)
CHECKSRC  := $(filter $(SANITIZED),$(CHECKSRC))
CHECKSH   := $(filter $(SANITIZED),$(CHECKSH))
endif
ifdef ONLY
CHECKSRC  := $(filter $(ONLY:%=tests/%.c),$(TESTSRC))
CHECKSH   := $(filter $(ONLY:%=tests/%.sh),$(wildcard tests/*/*.sh))
# A name that matches nothing would pass unseen.
NO_TESTS  := $(strip $(foreach o,$(ONLY),$(if $(filter $(o:%=tests/%.c) $(o:%=tests/%.sh),\
               $(TESTSRC) $(wildcard tests/*/*.sh)),,$(o))))
ifneq ($(NO_TESTS),)
$(error ONLY: no test is called $(NO_TESTS); names are as unit/kernels_test, cli/run, unit/%)
endif
endif
# Surveys of make check that draw more in make verify.
SURVEYS   := $(addprefix tests/,reference/any_case_slow_test.c \
               reference/coated_slow_test.c reference/domains_slow_test.c \
               reference/stays_slow_test.c reference/touches_test.c \
               reference/elements_marched.sh reference/still_surfaces.sh \
               reference/mixes_slow.sh reference/wide_case_slow_test.c \
               reference/error_estimates_slow_test.c reference/histories_slow_test.c \
               reference/hot_starts_test.c \
               reference/film_waves_slow_test.c \
               unit/effects_slow_test.c unit/jumps_test.c \
               unit/levels_slow_test.c unit/restart_test.c \
               cli/power.sh cli/kills.sh cli/random_kills_slow.sh \
               cli/io_faults.sh)
VERIFYSRC := $(wildcard tests/verify/*_test.c) $(filter %.c,$(SURVEYS))
VERIFYSH  := $(wildcard tests/verify/*.sh) $(filter %.sh,$(SURVEYS))
SUPPORT   := $(patsubst %.c,$(BUILD)/%.o,\
               $(filter-out %/main.c,$(wildcard tests/support/*.c)))
TESTBIN   := $(TESTSRC:%.c=$(BUILD)/%)
# With a list of physics, or a page, of their own.
ALONE_TESTS := tests/unit/physics_test.c tests/unit/page_test.c

# A locale with a decimal comma, for the tests alone; empty where it cannot be
# made, which skips them.
LOCALE := $(BUILD)/locale/de_DE.UTF-8
$(LOCALE):
	@mkdir -p $(@D)
	@localedef -i de_DE -f UTF-8 $@ >/dev/null 2>&1 || mkdir -p $@

# What scripts are told.  Memory that there is not is an error of the library's
# own, instrumented too.
TESTENV = OVERROLL='$(abspath $(PROGRAM))' BUILD='$(abspath $(BUILD))' \
  LIB='$(abspath $(LIB))' SHARED='$(abspath $(SHARED))' TOP='$(CURDIR)' \
  CC='$(CC)' TEST_CFLAGS='$(OVR_CFLAGS)' INSTRUMENTED='$(KIND)' \
  TEST_LOCALES='$(abspath $(BUILD)/locale)' \
  UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=allocator_may_return_null=1 \
  MAKEFLAGS= MAKELEVEL=

$(BUILD)/tests/%.o: OVR_CFLAGS += -Itests

# All tests are one program, linked once, and a test is a name of it.  Those that
# link another part of the library than it has are programs of their own.
ALONE     := $(filter $(ALONE_TESTS),$(TESTSRC))
TOGETHER  := $(filter-out $(ALONE),$(TESTSRC))
TESTNAMES := $(TOGETHER:%.c=%)
TESTMAIN  := $(BUILD)/tests/support/main.o $(SUPPORT)
# With ONLY= or SAN=1, tests that are not run are not compiled.
RUN_NAMES := $(if $(and $(ONLY)$(SAN),$(filter check,$(MAKECMDGOALS))),\
               $(filter $(CHECKSRC:%.c=%),$(TESTNAMES)),$(TESTNAMES))
$(BUILD)/tests/names: FORCE
	@mkdir -p $(@D)
	@echo '$(RUN_NAMES)' | cmp -s - $@ || echo '$(RUN_NAMES)' > $@
$(BUILD)/tests/tests: $(RUN_NAMES:%=$(BUILD)/%.o) $(TESTMAIN) $(LIB) \
  $(BUILD)/tests/names
	$(call say,LINK  $@)
	$(Q)$(LINK) -o $@ $(filter-out %/names,$^) $(OVR_LIBS) -lcmocka
$(TESTNAMES:%=$(BUILD)/%): $(BUILD)/%: $(BUILD)/tests/tests
	@mkdir -p $(@D)
	@ln -sf ../tests $@
$(ALONE:%.c=$(BUILD)/%): %: %.o $(TESTMAIN) $(LIB)
	$(call say,LINK  $@)
	$(Q)$(LINK) -o $@ $^ $(OVR_LIBS) -lcmocka
# One of them without the others, for who works on it.
$(TESTNAMES:%=$(BUILD)/one/%): $(BUILD)/one/%: $(BUILD)/%.o $(TESTMAIN) $(LIB)
	@mkdir -p $(@D)
	$(Q)$(LINK) -o $@ $^ $(OVR_LIBS) -lcmocka

# tests/fuzz/NAME_fuzz.c: a target of libFuzzer, whose corpus is in
# tests/fuzz/corpus/NAME.  `replay NAME` takes files instead of making inputs
# up; it holds all targets, each under another name.
FUZZERS := $(patsubst tests/fuzz/%_fuzz.c,%,$(wildcard tests/fuzz/*_fuzz.c))
FUZZBIN := $(FUZZERS:%=$(BUILD)/tests/fuzz/%_fuzz)
REPLAY  := $(BUILD)/tests/fuzz/replay
REPLAYED := $(FUZZERS:%=$(BUILD)/tests/fuzz/%_replay.o)
$(REPLAYED): %_replay.o: %_fuzz.o
	$(Q)objcopy --redefine-sym LLVMFuzzerTestOneInput=replay_$(*F) $< $@
$(BUILD)/tests/fuzz/replay.o: CPPFLAGS += '-DTARGETS=${FUZZERS:%=TARGET(%)}'
$(FUZZBIN): %: %.o $(LIB)
	$(call say,LINK  $@)
	$(Q)$(LINK) -fsanitize=fuzzer -o $@ $^ $(OVR_LIBS)

# The command line has the program's parts, its main under another name.
COMMAND := $(filter-out %/main.o,$(CLIOBJ)) $(BUILD)/tests/fuzz/main.o
$(BUILD)/tests/fuzz/main.o: $(BUILD)/src/cli/main.o
	@mkdir -p $(@D)
	$(Q)objcopy --redefine-sym main=overroll_main $< $@
$(REPLAY): $(BUILD)/tests/fuzz/replay.o $(REPLAYED) $(COMMAND) $(LIB)
	$(call say,LINK  $@)
	$(Q)$(LINK) -o $@ $^ $(OVR_LIBS)
$(BUILD)/tests/fuzz/command_fuzz: $(COMMAND)
$(BUILD)/tests/fuzz/command_fuzz: OVR_LIBS := $(LIB) $(OVR_LIBS)
$(BUILD)/tests/unit/physics_test: $(BUILD)/tests/unit/layer.o $(COMMAND)
$(BUILD)/tests/unit/page_test: $(BUILD)/src/web/page.o $(COMMAND)
$(ALONE:%.c=$(BUILD)/%): OVR_LIBS := $(LIB) $(OVR_LIBS)

# What libFuzzer finds stays in $(BUILD)-fuzz; the corpora in the tree are
# only read.
FUZZ_SECONDS ?= 600
fuzz: ## fuzz every target (FUZZ_SECONDS=600 each, FUZZERS="a b")
	@$(MAKE) --no-print-directory FUZZ=1 \
	  $(FUZZERS:%=$(BUILD)-fuzz/tests/fuzz/%_fuzz)
	@for t in $(FUZZERS); do \
	  tests/fuzz/run $(BUILD)-fuzz $$t $(FUZZ_SECONDS) || exit 1; done

tests: $(TESTBIN) $(REPLAY) all ## compile the tests

need-cmocka:
	@$(PKG_CONFIG) --exists cmocka || \
	  { echo "missing: cmocka; run tools/install-deps check"; exit 1; }

# The program of a test that runs without the others.
one = $(BUILD)/$(if $(filter $(1),$(TESTNAMES)),one/)$(1)
CHECKS := $(CHECKSRC:%.c=$(BUILD)/%)
CHECK_REPLAY := $(if $(filter %/corpus.sh,$(CHECKSH)),$(REPLAY))
# What loads a shared library cannot load an instrumented one.
CHECK_PARTS  := $(PROGRAM) $(LIB) $(if $(KIND),,$(SHARED)) $(CASE_PAGE) $(COMPLETION)
check: need-cmocka $(CHECK_PARTS) $(LOCALE) $(CHECKS) $(CHECK_REPLAY) ## run the tests (FAST=1, SAN=1, ONLY="unit/% ...")
	@$(TESTENV) tests/support/run -j $(JOBS) -o $(BUILD)/check $(CHECKS) $(CHECKSH)

foretell: ## how many tests there are, and how long they will take
	@tests/support/run -n -j $(JOBS) -o $(BUILD)/check $(CHECKS) $(CHECKSH)

verify: need-cmocka all $(LOCALE) $(VERIFYSRC:%.c=$(BUILD)/%) ## what takes longer
	@mkdir -p $(BUILD)/verify
	@$(TESTENV) OVERROLL_VERIFY='$(abspath $(BUILD)/verify)' \
	  TEST_SECONDS=36000 tests/support/run -j $(JOBS) \
	  -o $(BUILD)/verify $(VERIFYSRC:%.c=$(BUILD)/%) $(VERIFYSH)

HOURS ?= 24
soak: $(PROGRAM) ## random cases for HOURS=24 of CPU (JOBS, SEED=...)
	@OVERROLL='$(PROGRAM)' tests/soak/run $(BUILD)/soak $(HOURS) $(JOBS) $(SEED)

tests/unit/corpus.run: $(REPLAY)

# A single test: make tests/unit/arena_test.run
%.run: need-cmocka $(LOCALE)
	@$(MAKE) --no-print-directory all $(if $(wildcard $*.c),$(call one,$*))
	@$(TESTENV) tests/support/run -j 1 -o $(BUILD)/check \
	  $(if $(wildcard $*.c),$(call one,$*),$*.sh)

coverage: ## lines and branches that the tests reach (gcovr)
	@command -v gcovr >/dev/null || \
	  { echo "missing: gcovr; run tools/install-deps lint"; exit 1; }
	@$(MAKE) --no-print-directory COV=1 check
	@mkdir -p $(BUILD)/coverage
	@gcovr -r . -f src $(BUILD)-cov --exclude-throw-branches \
	  --gcov-ignore-parse-errors \
	  --html-details $(BUILD)/coverage/index.html --print-summary
	@echo "$(BUILD)/coverage/index.html"

# -------------------------------------------------------- demo, bench, paper

program: $(PROGRAM) ## the program alone
demo: $(PROGRAM) ## roll a dent through a contact: result file and picture
	@OVERROLL='$(PROGRAM)' tools/run-demo $(BUILD)/demo

pictures: demo ## the pictures of README.md, into tools/pictures
	@OVERROLL='$(PROGRAM)' tools/examples/gear
	@$(PROGRAM) plot build/examples/gear.h5 --kind stress --at '0.36 ms' \
	  --h-max 0.6um --size 1280x1080 -o tools/pictures/gear.png --force -q \
	  --title 'A ground gear tooth: pressure, starved film, temperatures, stress'
	@$(PROGRAM) frames $(BUILD)/demo/dent.h5 --movie tools/pictures/dent.gif \
	  --every 2 --time 3:6.4 --p-max 1.4 --rate 20 --size 800x450 --force \
	  --title 'A dent passes through the contact of two steel rollers'
	@OVERROLL='$(PROGRAM)' tools/examples/round-dent
	@$(PROGRAM) plot build/examples/round-dent-round.h5 --size 1000x780 \
	  -o tools/pictures/strip.png --force -q \
	  --title 'A round dent with a raised rim'

PAPER_LEVEL ?= 17
paper: tests ## the paper's tables, computed and compared
	@mkdir -p $(BUILD)/verify
	@$(TESTENV) OVERROLL_VERIFY='$(abspath $(BUILD)/verify)' \
	  TEST_SECONDS=36000 OVERROLL_LEVELS=$(PAPER_LEVEL) \
	  tests/support/run -v -j 1 -o $(BUILD)/paper $(patsubst %.c,$(BUILD)/%,\
	    $(wildcard tests/paper/*_test.c)) $(wildcard tests/paper/*.sh)

validation: $(PROGRAM) ## beside published results: build/validation.html
	@OVERROLL='$(abspath $(PROGRAM))' tools/validation/run $(BUILD)

html: $(PROGRAM) $(CASE_PAGE) ## all that is to be read, as one site: build/html (FAST=1)
	@OVERROLL='$(abspath $(PROGRAM))' tools/site/run \
	  $(if $(FAST),--no-examples --fast) $(BUILD)

# tests/bench/*_bench.c: each a program that writes $(BUILD)/bench/NAME.json;
# FFTW and LAPACK, when there, are for comparison only.
ifneq ($(filter bench,$(MAKECMDGOALS)),)
ifeq ($(shell $(PKG_CONFIG) --exists cmocka 2>/dev/null && echo y),)
$(error make bench needs cmocka (libcmocka-dev): tools/install-deps check bench)
endif
endif
BENCHSRC := $(wildcard tests/bench/*_bench.c)
BENCHBIN := $(BENCHSRC:%.c=$(BUILD)/%)
BENCHSUP := $(patsubst %.c,$(BUILD)/%.o,\
              $(filter-out $(BENCHSRC),$(wildcard tests/bench/*.c)))
BENCHPKG := $(if $(filter bench,$(MAKECMDGOALS)),$(foreach p,\
  fftw3 openblas lapacke,\
  $(if $(shell $(PKG_CONFIG) --exists $(p) 2>/dev/null && echo y),$(p))))
$(BUILD)/tests/bench/%.o: CPPFLAGS += $(BENCHPKG:%=-DHAVE_%)
$(BUILD)/tests/bench/%_bench: $(BUILD)/tests/bench/%_bench.o $(BENCHSUP) \
  $(SUPPORT) $(LIB)
	$(call say,LINK  $@)
	$(Q)$(LINK) -o $@ $^ $(OVR_LIBS) -lcmocka \
	  $(if $(BENCHPKG),$(shell $(PKG_CONFIG) --libs $(BENCHPKG)))

bench: $(BENCHBIN) $(PROGRAM) $(SHARED) ## how fast it is, on this machine
	@mkdir -p $(BUILD)/bench
	@for b in $(BENCHBIN); do \
	  OVERROLL='$(PROGRAM)' $$b $(BUILD)/bench/$$(basename $$b _bench).json \
	    || exit 1; done
	@OVERROLL='$(PROGRAM)' tests/bench/users_bench.py $(BUILD)/bench
	@$(if $(PYTHON),OVERROLL_LIBRARY='$(abspath $(SHARED))' $(PYTHON) \
	  tools/python/setup.py -q build_py --build-lib '$(abspath $(BUILD))/python' \
	  >/dev/null 2>&1 && PYTHONPATH='$(BUILD)/python' $(PYTHON) -B \
	  tests/bench/python_bench.py $(BUILD)/bench/python.json,\
	  echo "no Python with cffi: its share is not measured")

# ------------------------------------------------------------- static checks

CALL  := $(wildcard src/*/*.[ch] src/*/*/*.[ch] include/overroll/*.h \
           tests/*/*.[ch])
SHALL := $(shell grep -lE '^\#!/bin/(ba)?sh' tools/* tools/examples/* tools/paper/* \
           src/web/* tests/*/* .ci/* 2>/dev/null)

format: ## lay out the sources with clang-format
	@clang-format -i $(CALL)

lint: lint-format lint-tidy lint-cppcheck lint-analyzer lint-shell ## all static checks (DEEP=1)

lint-format: need-lint
	$(call say,FORMAT)
	@clang-format --dry-run -Werror $(CALL)

# Each file again when its object is newer: the object follows the headers.
TIDY := $(LIBSRC:%.c=$(BUILD)/%.tidy) $(CLISRC:%.c=$(BUILD)/%.tidy) \
        $(KERNELS:%.kernel.c=$(BUILD)/%.kernel.tidy) $(BUILD)/src/web/page.tidy
# error.c defines what lint.h redefines.
tidy_include = $(if $(filter %/error.c,$(1)),,-include tools/lint.h)
# Paths through a file are followed by gcc (lint-analyzer); with DEEP=1 by clang
# too, which takes 7 minutes of two cores.
NO_PATHS := $(if $(DEEP),,--checks=-clang-analyzer-*)
lint-tidy: need-lint $(TIDY)
$(BUILD)/%.tidy: %.c $(BUILD)/%.o .clang-tidy tools/lint.h
	$(call say,TIDY  $<)
	$(Q)clang-tidy --quiet $(NO_PATHS) $< -- $(OVR_CFLAGS) \
	  $(call tidy_include,$<) 2>$@.err || \
	  { cat $@.err; exit 1; }
	@touch $@
$(BUILD)/%.kernel.tidy: %.kernel.c $(BUILD)/%.base.o .clang-tidy
	$(call say,TIDY  $<)
	$(Q)clang-tidy --quiet $(NO_PATHS) $< -- $(OVR_CFLAGS) \
	  -DOVR_ISA=base 2>$@.err || \
	  { cat $@.err; exit 1; }
	@touch $@

# The vector types of kernels are beyond cppcheck.
lint-cppcheck: need-lint
	$(call say,CPPCHECK)
	@mkdir -p $(BUILD)/cppcheck
	$(Q)cppcheck --quiet --std=c11 --error-exitcode=1 --inline-suppr \
	  --enable=warning,performance,portability --suppress=missingInclude \
	  --suppress=normalCheckLevelMaxBranches --suppress=unknownMacro \
	  --cppcheck-build-dir=$(BUILD)/cppcheck -j $(JOBS) -DOVR_ISA=base \
	  -Iinclude -Isrc -Itests $(LIBSRC) $(CLISRC) $(wildcard src/web/*.c) \
	  $(wildcard tests/*/*.c)

# gcc's own analysis, of paths through a file.
ANALYZED := $(LIBSRC:%.c=$(BUILD)/%.analyzed) $(CLISRC:%.c=$(BUILD)/%.analyzed)
lint-analyzer: $(ANALYZED)
$(BUILD)/%.analyzed: %.c $(BUILD)/%.o
	$(call say,ANALYZE $<)
	$(Q)gcc $(OVR_CFLAGS) -O2 -Wcast-qual -fanalyzer -Werror -c -o /dev/null $<
	@touch $@

lint-shell: need-lint
	$(call say,SHELLCHECK)
	@shellcheck --severity=warning -x -P SCRIPTDIR $(SHALL)

need-lint:
	@for t in clang-format clang-tidy cppcheck shellcheck; do \
	  command -v $$t >/dev/null || \
	  { echo "missing: $$t; run tools/install-deps lint"; exit 1; }; done

# ------------------------------------------------------------------ install

MAN        := $(filter-out src/case/overroll-case.5,$(wildcard src/*/*.[1357])) \
              $(CASE_PAGE)
SHARE      := $(DESTDIR)$(PREFIX)/share
COMPDIR    := $(SHARE)/bash-completion/completions
# Files written and folders created by install, without DESTDIR, for uninstall.
MANIFEST   := $(SHARE)/overroll/manifest
FOLDERS    := $(SHARE)/overroll/folders
INSTALLED_IN := $(PREFIX)/bin $(LIBDIR)/pkgconfig $(PREFIX)/include/overroll \
  $(PREFIX)/share/bash-completion/completions $(PREFIX)/share/overroll \
  $(sort $(foreach m,$(MAN),$(MANDIR)/man$(subst .,,$(suffix $(m)))))

# The installed program has no debug information: 11 MB for 33.  INSTALL_STRIP=
# keeps it.
INSTALL_STRIP := $(if $(KIND),,-s)

install: all ## into DESTDIR/PREFIX (/usr/local)
	@{ cat '$(FOLDERS)' 2>/dev/null; \
	   for d in $(INSTALLED_IN:%='%'); do \
	     while [ "$${d#/?}" != "$$d" ] && [ ! -d "$(DESTDIR)$$d" ]; do \
	       echo "$$d"; d=$$(dirname "$$d"); done; done; } | \
	   LC_ALL=C sort -ru > $(BUILD)/folders
	install -d '$(DESTDIR)$(PREFIX)/bin' '$(DESTDIR)$(LIBDIR)/pkgconfig' \
	  '$(DESTDIR)$(PREFIX)/include/overroll'
	install $(INSTALL_STRIP) $(PROGRAM) '$(DESTDIR)$(PREFIX)/bin/overroll'
	install -m 644 $(LIB) $(SHARED) '$(DESTDIR)$(LIBDIR)'
	ln -sf liboverroll.so.$(VERSION) \
	  '$(DESTDIR)$(LIBDIR)/liboverroll.so.$(SOVER)'
	ln -sf liboverroll.so.$(SOVER) '$(DESTDIR)$(LIBDIR)/liboverroll.so'
	install -m 644 $(HEADERS) '$(DESTDIR)$(PREFIX)/include/overroll'
	sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@LIBDIR@|$(LIBDIR)|' \
	  -e 's|@VERSION@|$(VERSION)|' -e 's|@LIBS@|$(OVR_LIBS)|' \
	  src/overroll.pc.in > '$(DESTDIR)$(LIBDIR)/pkgconfig/overroll.pc'
	$(foreach m,$(MAN),install -D -m 644 $(m) \
	  '$(DESTDIR)$(MANDIR)/man$(subst .,,$(suffix $(m)))/$(notdir $(m))' &&) :
	install -D -m 644 $(COMPLETION) '$(COMPDIR)/overroll'
	[ ! -e $(BUILD)/web/overroll.html ] || install -D -m 644 \
	  $(BUILD)/web/overroll.html '$(DESTDIR)$(PREFIX)/share/overroll/overroll.html'
	install -d '$(dir $(MANIFEST))'
	install -m 644 $(BUILD)/folders '$(FOLDERS)'
	@{ printf '%s\n' '$(PREFIX)/bin/overroll' \
	     '$(PREFIX)/share/bash-completion/completions/overroll' \
	     '$(PREFIX)/share/overroll/overroll.html'; \
	   printf '$(LIBDIR)/%s\n' $(notdir $(LIB) $(SHARED)) \
	     liboverroll.so.$(SOVER) liboverroll.so pkgconfig/overroll.pc; \
	   printf '$(PREFIX)/include/overroll/%s\n' $(notdir $(HEADERS)); \
	   printf '$(MANDIR)/%s\n' $(foreach m,$(MAN),\
	     man$(subst .,,$(suffix $(m)))/$(notdir $(m))); } > '$(MANIFEST)'
	$(call say,WROTE $(MANIFEST))

# A Python that has what the package is built with; PYTHON=venv/bin/python puts
# it there, PIPFLAGS=--user and the like elsewhere.
PYTHON ?= $(shell for p in python3 /usr/bin/python3; do \
            $$p -c 'import cffi, pip, setuptools, wheel' 2>/dev/null && \
            echo $$p && break; done)
install-python: $(SHARED) ## the Python package (PYTHON=venv/bin/python)
	$(if $(PYTHON),,$(error no Python with cffi, pip, setuptools and wheel: \
	  tools/install-deps python))
	OVERROLL_LIBRARY='$(abspath $(SHARED))' '$(PYTHON)' -m pip install \
	  --no-build-isolation --no-index $(PIPFLAGS) ./tools/python

# Another version may have installed other files: only the manifest knows.
uninstall: ## take out what install has put into PREFIX
	@[ -f '$(MANIFEST)' ] || \
	  { echo "nothing is installed in $(DESTDIR)$(PREFIX): no $(MANIFEST);" \
	    "make uninstall PREFIX=... looks elsewhere" >&2; exit 1; }
	@while IFS= read -r file; do rm -f "$(DESTDIR)$$file"; done < '$(MANIFEST)'
	@rm -f '$(MANIFEST)'
	@! [ -f '$(FOLDERS)' ] || { created=$$(cat '$(FOLDERS)'); rm '$(FOLDERS)'; \
	  printf '%s\n' "$$created" | while IFS= read -r d; do \
	    [ -z "$$d" ] || [ ! -d "$(DESTDIR)$$d" ] || \
	      rmdir --ignore-fail-on-non-empty "$(DESTDIR)$$d"; done; }
	@for d in '$(dir $(MANIFEST))' '$(DESTDIR)$(PREFIX)/include/overroll'; do \
	  [ ! -d "$$d" ] || rmdir --ignore-fail-on-non-empty "$$d"; done
	$(call say,GONE  from $(DESTDIR)$(PREFIX))

# Debian packages in $(BUILD)/deb, from the files that git knows.
DEB := $(abspath $(BUILD))/deb
DEBTREE := $(DEB)/overroll-$(VERSION)
deb: ## Debian packages, into $(BUILD)/deb
	@for t in git dpkg-buildpackage dh lintian; do command -v $$t >/dev/null || \
	  { echo "missing: $$t; run tools/install-deps deb"; exit 1; }; done
	rm -rf '$(DEB)' && mkdir -p '$(DEBTREE)'
	git ls-files -z | xargs -0 cp --parents -t '$(DEBTREE)'
	cp -r tools/debian '$(DEBTREE)/debian'
	cd '$(DEBTREE)/debian' && sed -i 's/@SOVER@/$(SOVER)/' control && \
	  mv liboverroll.install liboverroll$(SOVER).install && \
	  printf 'overroll (%s) unstable; urgency=medium\n\n%s\n\n -- %s  %s\n' \
	    '$(VERSION)' '  * See CHANGELOG.md of the source.' \
	    "$$(sed -n 's/^Maintainer: //p' control)" \
	    "$$(git log -1 --format=%aD)" > changelog
	cd '$(DEBTREE)' && dpkg-buildpackage -us -uc -b -j$(JOBS)
	cd '$(DEB)' && lintian --fail-on error,warning *.changes

ifneq ($(filter web web-%,$(MAKECMDGOALS)),)
include src/web/web.mk
endif

clean: ## remove every build folder
	rm -rf build build-san build-cov build-clang '$(BUILD)'

help: ## this list
	@echo "make [TARGET] [CC=clang] [CFLAGS=...] [SAN=1] [V=1] [PREFIX=...]"
	@sed -n 's/^\([a-z-]*\):[^#]*## \(.*\)/  \1\t\2/p' Makefile | expand -t 18

FORCE:
.PHONY: all program tests check foretell fuzz verify soak coverage demo pictures paper validation html bench \
  format lint lint-format lint-tidy lint-cppcheck lint-analyzer lint-shell need-lint need-cmocka \
  install install-python uninstall deb clean help FORCE
.SECONDARY:
.DELETE_ON_ERROR:
ifdef COMPILES
-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
endif
