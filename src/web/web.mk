# SPDX-License-Identifier: GPL-3.0-or-later
# The program as one page, $(BUILD)/web/overroll.html: compiled for wasm32-wasi
# with the libraries that src/web/libraries makes, once.
WEB      := $(BUILD)/web
WEB_LIBS ?= $(WEB)/libraries
WEB_SYSTEM := src/web/system/include
WEB_CC   := clang --target=wasm32-wasi --sysroot=/usr -nostdlibinc \
            -isystem $(WEB_SYSTEM) -isystem /usr/include/wasm32-wasi \
            -isystem $(WEB_LIBS)/include -include $(WEB_SYSTEM)/wasi.h \
            -std=c17 -O2 -msimd128 -ffp-contract=off -fno-math-errno \
            -fno-strict-aliasing -D_GNU_SOURCE -D_WASI_EMULATED_SIGNAL \
            -D_WASI_EMULATED_PROCESS_CLOCKS -D_WASI_EMULATED_GETPID \
            -D_WASI_EMULATED_MMAN -DFFTW_NO_Complex -Iinclude -Isrc -w
WEB_OBJ  := $(LIBSRC:%.c=$(WEB)/%.o) $(CLISRC:%.c=$(WEB)/%.o) \
            $(KERNELS:%.kernel.c=$(WEB)/%.base.o) $(WEB)/$(PAGE).o \
            $(patsubst %.c,$(WEB)/%.o,$(wildcard src/web/*.c))

$(WEB_LIBS)/complete: src/web/libraries
	$(call say,LIBS  $(WEB_LIBS))
	@mkdir -p $(WEB_LIBS)
	$(Q)src/web/libraries $(WEB_LIBS) >$(WEB_LIBS).log 2>&1 || \
	  { tail $(WEB_LIBS).log; exit 1; }

$(WEB)/%.o: %.c | $(WEB_LIBS)/complete
	$(call say,CC    $< (web))
	@mkdir -p $(@D)
	$(Q)$(WEB_CC) -MMD -MP -c -o $@ $<
$(WEB)/%.base.o: %.kernel.c $(WEB_LIBS)/complete
	$(call say,CC    $< (web))
	@mkdir -p $(@D)
	$(Q)$(WEB_CC) -O3 -fno-trapping-math -Wno-pass-failed -DOVR_ISA=base \
	  -MMD -MP -c -o $@ $<
$(WEB)/$(PAGE).o: $(BUILD)/$(PAGE).c
	@mkdir -p $(@D)
	$(Q)$(WEB_CC) -c -o $@ $<
-include $(WEB_OBJ:.o=.d)
web-objects: $(WEB_OBJ)
web-flags: # for tests/source/wasm.sh
	@echo '$(WEB_CC)'

# A library of functions (reactor): the page calls page_main again and again.
$(WEB)/overroll.wasm: $(WEB_OBJ)
	$(call say,LINK  $@)
	$(Q)clang --target=wasm32-wasi --sysroot=/usr -mexec-model=reactor \
	  -Wl,--strip-all -Wl,--gc-sections -Wl,--error-limit=0 -Wl,-z,stack-size=4194304 \
	  -o $@ $(WEB_OBJ) -L$(WEB_LIBS)/lib -lhdf5 -lfftw3 -lgsl \
	  -lexpat -ldeflate -lnettle -lz -lwasi-emulated-signal \
	  -lwasi-emulated-process-clocks -lwasi-emulated-getpid \
	  -lwasi-emulated-mman -lm

# The page: its texts put where app.html names them.
WEB_JS := $(PAGE)_data.js $(PAGE)_draw.js \
  src/physics/heat/pictures_page.js \
  $(addprefix src/web/app_,program.js case.js live.js picture.js run.js)
WEB_WORKER := src/web/wasi.js src/web/worker.js
$(WEB)/overroll.html: src/web/app.html src/web/app.css $(PAGE).css $(WEB_JS) \
  $(WEB_WORKER) $(WEB)/overroll.wasm
	$(call say,PAGE  $@)
	@gzip -9nc $(WEB)/overroll.wasm | base64 -w 0 >$@.program && echo >>$@.program
	@sed -e '/^@CSS@$$/{r $(PAGE).css' -e 'r src/web/app.css' -e 'd' -e '}' \
	  -e '/^@WORKER@$$/{' $(WEB_WORKER:%=-e 'r %') -e 'd' -e '}' \
	  -e '/^@PROGRAM@$$/{r $@.program' -e 'd' -e '}' \
	  -e '/^@JS@$$/{' $(WEB_JS:%=-e 'r %') -e 'd' -e '}' src/web/app.html >$@
	@rm $@.program
	@[ $$(wc -c <$@) -le 6000000 ] || { echo "$@: more than 6 MB"; exit 1; }
web: $(WEB)/overroll.html ## the program as one web page: build/web/overroll.html
.PHONY: web web-objects web-flags
$(WEB)/src/cli/main.o: WEB_CC += -Dmain=overroll_main

# The program here with the kernels that the page has: both compute the same.
$(WEB)/overroll-base: $(PROGRAM) src/multigrid/kernels.c
	$(call say,LINK  $@)
	$(Q)$(COMPILE) -DOVR_NO_AVX2 -c -o $(WEB)/kernels-base.o src/multigrid/kernels.c
	$(Q)$(LINK) -o $@ $(CLIOBJ) $(WEB)/kernels-base.o $(LIB) $(OVR_LIBS)
web-base: $(WEB)/overroll-base
.PHONY: web-base
