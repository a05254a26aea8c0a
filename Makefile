# SPDX-License-Identifier: GPL-3.0-or-later
# overroll: make, make check, make demo; `make help` lists the rest.

BUILD   ?= build
CFLAGS  ?= -O2 -g
CC      ?= cc
PKGS    := gsl zlib inih libzip expat
HDF5    := $(firstword $(foreach p,hdf5 hdf5-serial,\
             $(if $(shell pkg-config --exists $(p) && echo y),$(p))))
V       ?= 0
Q       := $(if $(filter 0,$(V)),@,)

ifeq ($(SAN),1)
BUILD   := $(BUILD)-san
SANFLAGS := -fsanitize=address,undefined -fno-sanitize-recover=all \
            -fno-omit-frame-pointer
endif

WARN := -Wall -Wextra -Wpedantic -Wconversion -Wshadow
# -ffp-contract=off: fused operations only where they are written, so that
# every compiler and instruction set computes the same thing.
OVR_CFLAGS := -std=c17 $(WARN) -ffp-contract=off -fno-math-errno -fPIC \
              -fvisibility=hidden -D_POSIX_C_SOURCE=200809L -Iinclude -Isrc \
              $(shell pkg-config --cflags $(PKGS) $(HDF5)) $(SANFLAGS)
OVR_LIBS   := $(shell pkg-config --libs $(PKGS)) \
              $(shell pkg-config --libs-only-L $(HDF5)) \
              -lhdf5_hl -lhdf5 -lm -lpthread

# Kernels (*.kernel.c) are compiled once for each instruction set; the program
# picks one when it starts.
KERNEL_CFLAGS := -O3 -fno-trapping-math
MACHINE := $(shell $(CC) -dumpmachine)
ISAS := base $(if $(filter x86_64%,$(MACHINE)),avx2 avx512)
ISA_base   :=
ISA_avx2   := -mavx2 -mfma
ISA_avx512 := -mavx512f -mavx512dq -mavx512vl -mfma -mprefer-vector-width=512

KERNELS := $(wildcard src/*/*.kernel.c)
LIBSRC  := $(filter-out $(KERNELS),$(wildcard $(addprefix src/,\
             $(addsuffix /*.c,base contact surface multigrid simulation \
             results pictures))))
CLISRC  := $(wildcard src/cli/*.c)
LIBOBJ  := $(LIBSRC:%.c=$(BUILD)/%.o) \
           $(foreach i,$(ISAS),$(KERNELS:%.kernel.c=$(BUILD)/%.$(i).o))
CLIOBJ  := $(CLISRC:%.c=$(BUILD)/%.o)
LIB     := $(BUILD)/liboverroll.a
PROGRAM := $(BUILD)/overroll

all: $(PROGRAM) $(LIB)

$(PROGRAM): $(CLIOBJ) $(LIB)
	@echo "  LINK  $@"
	$(Q)$(CC) $(CFLAGS) $(SANFLAGS) $(LDFLAGS) -o $@ $^ $(OVR_LIBS)

$(LIB): $(LIBOBJ)
	@echo "  AR    $@"
	$(Q)rm -f $@ && $(AR) rcs $@ $^

$(BUILD)/%.o: %.c
	@mkdir -p $(@D)
	@echo "  CC    $<"
	$(Q)$(CC) $(OVR_CFLAGS) $(CFLAGS) $(CPPFLAGS) -MMD -MP -c -o $@ $<

define isa_rule
$(BUILD)/%.$(1).o: %.kernel.c
	@mkdir -p $$(@D)
	@echo "  CC    $$< ($(1))"
	$$(Q)$$(CC) $$(OVR_CFLAGS) $$(CFLAGS) $$(CPPFLAGS) $$(KERNEL_CFLAGS) \
	  $$(ISA_$(1)) -DOVR_ISA=$(1) -MMD -MP -c -o $$@ $$<
endef
$(foreach i,$(ISAS),$(eval $(call isa_rule,$(i))))

# Tests: each tests/<kind>/*_test.c is one program, written with cmocka.
TESTSRC := $(wildcard tests/*/*_test.c)
TESTBIN := $(TESTSRC:%.c=$(BUILD)/%)
TESTLIB := $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/support/*.c))

$(BUILD)/tests/%_test: $(BUILD)/tests/%_test.o $(TESTLIB) $(LIB)
	@echo "  LINK  $@"
	$(Q)$(CC) $(CFLAGS) $(SANFLAGS) $(LDFLAGS) -o $@ $^ $(OVR_LIBS) -lcmocka

tests: $(TESTBIN) $(PROGRAM)

clean:
	rm -rf $(BUILD)

.PHONY: all tests clean
.SECONDARY:
-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
