/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/test.h"

#include <stdlib.h>
#include <string.h>

#include "base/arena.h"

enum { PIECES = 400 };

static bool all_bytes(const unsigned char *memory, size_t n, int value)
{
    for (size_t i = 0; i < n; i++)
        if (memory[i] != value)
            return false;
    return true;
}

/* Random sizes across the block size; each piece is filled with a byte of its
 * own as it comes, so that any overlap shows in the end. */
TEST(pieces_are_zeroed_aligned_and_apart)
{
    test_faults faults;
    ovr_arena arena;
    unsigned char *piece[PIECES];
    size_t bytes[PIECES];
    uint64_t seed = 1;
    test_faults_init(&faults);
    arena = ovr_arena_make(&faults.hook);
    for (int k = 0; k < PIECES; k++) {
        double size = test_random(&seed, 0, k % 50 ? 3000 : 200000);
        bytes[k] = (size_t)size;
        piece[k] = ovr_arena_take(&arena, bytes[k], 1, NULL);
        assert_non_null(piece[k]);
        assert_int_equal((uintptr_t)piece[k] % 64, 0);
        assert_true(all_bytes(piece[k], bytes[k], 0));
        memset(piece[k], k % 251, bytes[k]);
    }
    for (int k = 0; k < PIECES; k++)
        assert_true(all_bytes(piece[k], bytes[k], k % 251));
    assert_true(faults.calls < PIECES / 4);
    ovr_arena_release(&arena);
    assert_int_equal(faults.live, 0);
}

TEST(counts_allocations)
{
    ovr_arena arena = ovr_arena_make(NULL);
    assert_int_equal(arena.bytes, 0);
    assert_non_null(ovr_arena_take(&arena, 1000000, sizeof(double), NULL));
    assert_true(arena.bytes >= 8000000);
    assert_true(arena.bytes < 8100000);
    ovr_arena_release(&arena);
    assert_int_equal(arena.bytes, 0);
}

TEST(nothing_is_something)
{
    ovr_arena arena = ovr_arena_make(NULL);
    assert_non_null(ovr_arena_take(&arena, 0, 8, NULL));
    assert_non_null(ovr_arena_take(&arena, 8, 0, NULL));
    ovr_arena_release(&arena);
}

TEST(is_usable_after_release)
{
    ovr_arena arena = ovr_arena_make(NULL);
    for (int round = 0; round < 3; round++) {
        char *text = ovr_arena_text(&arena, "overroll", NULL);
        assert_string_equal(text, "overroll");
        ovr_arena_release(&arena);
        ovr_arena_release(&arena);
    }
}

TEST(refuses_sizes_that_overflow)
{
    static const size_t target[][2] = {
        {SIZE_MAX, SIZE_MAX}, {SIZE_MAX / 2, 3},  {SIZE_MAX / 8 + 2, 8},
        {SIZE_MAX, 1},        {1, SIZE_MAX - 64},
    };
    test_faults faults;
    ovr_arena arena;
    test_faults_init(&faults);
    arena = ovr_arena_make(&faults.hook);
    for (size_t k = 0; k < sizeof target / sizeof *target; k++) {
        ovr_error err = {0};
        assert_null(ovr_arena_take(&arena, target[k][0], target[k][1], &err));
        CHECK_ERROR(&err, OVR_NO_MEMORY, "out of memory");
    }
    assert_int_equal(faults.calls, 0);
    ovr_arena_release(&arena);
}

/* A thing as the library builds them: many pieces of all sizes, one text. */
static ovr_status build(void *data, const ovr_allocator *hook, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(hook);
    ovr_status status = OVR_OK;
    (void)data;
    for (size_t n = 1; n < 2000000 && !status; n *= 3)
        if (!ovr_arena_take(&arena, n, sizeof(double), err))
            status = OVR_NO_MEMORY;
    if (!status && !ovr_arena_text(&arena, "text", err))
        status = OVR_NO_MEMORY;
    ovr_arena_release(&arena);
    return status;
}

TEST(every_allocation_may_fail)
{
    assert_true(test_every_allocation(build, NULL) >= 4);
}

/* After a failure the pieces taken before are whole, and there are no more of
 * any size until the arena is released.  The message is that of the first. */
TEST(keeps_its_first_failure)
{
    test_faults faults;
    ovr_arena arena;
    ovr_error err = {0};
    char *text;
    test_faults_init(&faults);
    faults.fail = 2;
    arena = ovr_arena_make(&faults.hook);
    text = ovr_arena_text(&arena, "before", NULL);
    assert_int_equal(ovr_arena_status(&arena), OVR_OK);
    assert_null(ovr_arena_take(&arena, 1, 1 << 20, NULL));
    assert_int_equal(ovr_arena_status(&arena), OVR_NO_MEMORY);
    assert_null(ovr_arena_take(&arena, 1, 1 << 21, &err));
    CHECK_ERROR(&err, OVR_NO_MEMORY, "out of memory: 1048576 bytes needed");
    assert_null(ovr_arena_text(&arena, "after", NULL)); /* has space */
    assert_string_equal(text, "before");
    assert_int_equal(faults.live, 1);
    ovr_arena_release(&arena);
    assert_int_equal(faults.live, 0);
    assert_int_equal(ovr_arena_status(&arena), OVR_OK);
    assert_non_null(ovr_arena_text(&arena, "after", NULL));
    ovr_arena_release(&arena);
    assert_int_equal(faults.live, 0);
}
