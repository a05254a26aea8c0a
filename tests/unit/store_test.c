/* SPDX-License-Identifier: GPL-3.0-or-later */
/* File store: a commit is complete or absent wherever writing is interrupted.
 */
#include "support/test.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/disk.h"
#include "results/journal.h"
#include "results/store.h"

enum { BYTES = 50000, ROUNDS = 40 };

static ovr_error err;

static void prepare(ovr_store *s, ovr_arena *arena, const char *path)
{
    *arena = ovr_arena_make(NULL);
    CHECK_OK(ovr_store_prepare(s, path, arena, &err), &err);
}

/* Random pieces into the store and into its model in memory. */
static void scribble(ovr_store *s, unsigned char *model, uint64_t *seed)
{
    for (int k = 0; k < 20; k++) {
        size_t at = (size_t)test_random(seed, 0, BYTES - 5000);
        size_t bytes = (size_t)test_random(seed, 1, k % 4 ? 300 : 5000);
        for (size_t i = 0; i < bytes; i++)
            model[at + i] = (unsigned char)test_random(seed, 0, 256);
        ovr_store_write(s, at, bytes, model + at);
    }
}

static void check_content(ovr_store *s, const unsigned char *model)
{
    unsigned char found[BYTES] = {0};
    assert_true(s->length <= BYTES);
    assert_true(ovr_store_read(s, 0, (size_t)s->length, found));
    assert_memory_equal(found, model, (size_t)s->length);
}

static void check_disk(const char *path, const unsigned char *model,
                       size_t bytes)
{
    size_t have;
    char *data = test_read(path, &have);
    assert_true(have >= bytes);
    assert_memory_equal(data, model, bytes);
    free(data);
}

static void begin(ovr_store *s, ovr_arena *arena, const char *path,
                  unsigned char *model, uint64_t *seed)
{
    prepare(s, arena, path);
    CHECK_OK(ovr_store_create(s, false, &err), &err);
    memset(model, 0, BYTES);
    scribble(s, model, seed);
    CHECK_OK(ovr_store_commit(s, &err), &err);
    CHECK_OK(ovr_store_publish(s, false, &err), &err);
}

static void shorten(ovr_store *s, size_t length)
{
    ovr_store_resize(s, length);
    assert_int_equal(s->length, length);
}

/* What lies behind an end that moved back and forth is not defined, until it
 * is written again. */
static void fill_up(ovr_store *s, unsigned char *model, size_t length)
{
    size_t from = (size_t)s->length;
    if (from >= length)
        return;
    memset(model + from, 'f', BYTES - from);
    ovr_store_write(s, from, length - from, model + from);
}

TEST_IN_FOLDER(commits_whole_states)
{
    const char *path = test_path(*state, "a");
    unsigned char model[BYTES], before[BYTES];
    uint64_t seed = 7;
    ovr_store s;
    ovr_arena arena;
    begin(&s, &arena, path, model, &seed);
    memcpy(before, model, BYTES);
    for (int k = 0; k < ROUNDS; k++) {
        size_t committed = (size_t)s.committed;
        fill_up(&s, model, BYTES - 5000);
        scribble(&s, model, &seed);
        check_content(&s, model);
        check_disk(path, before, committed);
        if (k % 3 == 0)
            shorten(&s, (size_t)test_random(&seed, 1, (double)s.length));
        if (k % 4 != 0) {
            CHECK_OK(ovr_store_commit(&s, &err), &err);
            check_disk(path, model, (size_t)s.length);
            memcpy(before, model, BYTES);
        }
    }
    CHECK_OK(ovr_store_commit(&s, &err), &err);
    ovr_store_close(&s);
    check_disk(path, model, (size_t)s.length);
    assert_int_not_equal(access(s.journal_path, F_OK), 0);
    ovr_arena_release(&arena);
}

/* As if killed: descriptors closed, nothing tidied. */
static void die(ovr_store *s, ovr_arena *arena)
{
    close(s->fd);
    close(s->journal);
    ovr_arena_release(arena);
}

/* The pages of the commit under way that reached the file. */
static size_t apply_some(const ovr_store *s, double share, uint64_t *seed)
{
    size_t applied = 0;
    for (size_t k = 0; k < s->changed.count; k++) {
        uint64_t at = s->changed.page[k].number * OVR_PAGE;
        uint64_t left = s->committed > at ? s->committed - at : 0;
        if (test_random(seed, 0, 1) >= share)
            continue;
        ovr_write_all(s->fd, s->changed.page[k].data,
                      left < OVR_PAGE ? (size_t)left : OVR_PAGE, at);
        applied++;
    }
    return applied;
}

/* Killed in a commit: with its part of the journal cut after `keep` of its
 * bytes, or, when that is whole, with some of its pages in the file. */
static void cut_and_reopen(const char *path, double keep, double share,
                           uint64_t seed)
{
    unsigned char model[BYTES], before[BYTES];
    ovr_store s;
    ovr_arena arena;
    size_t length, applied = 0, pages;
    uint64_t end;
    bool torn;
    begin(&s, &arena, path, model, &seed);
    length = (size_t)s.committed;
    memcpy(before, model, BYTES);
    for (int k = 0; k < (int)(seed % 3); k++) {
        fill_up(&s, model, BYTES - 5000);
        scribble(&s, model, &seed);
        CHECK_OK(ovr_store_commit(&s, &err), &err);
    }
    scribble(&s, model, &seed);
    end = s.kept.end;
    assert_int_equal(ovr_journal_write(&s), 0);
    assert_int_equal(
        ftruncate(s.journal,
                  (off_t)(end + (uint64_t)(keep * (double)(s.kept.end - end)))),
        0);
    pages = s.changed.count;
    if (keep >= 1)
        applied = apply_some(&s, share, &seed);
    torn = applied > 0 && applied < pages;
    assert_int_equal(ovr_journal_torn(s.journal, s.fd, NULL), torn);
    die(&s, &arena);
    prepare(&s, &arena, path);
    CHECK_OK(ovr_store_open(&s, &err), &err);
    assert_int_equal(s.repaired, torn);
    assert_int_equal(s.length, length);
    check_disk(path, before, length);
    ovr_store_close(&s);
    ovr_arena_release(&arena);
    unlink(path);
}

TEST_IN_FOLDER(goes_back_to_the_checkpoint)
{
    const char *path = test_path(*state, "b");
    for (uint64_t k = 0; k < 20; k++) {
        cut_and_reopen(path, (double)k / 20, 0, 100 + k);
        cut_and_reopen(path, 1, (double)k / 20, 200 + k);
    }
}

/* A checkpoint later: the journal of the one before would destroy it. */
TEST_IN_FOLDER(goes_back_no_further)
{
    const char *path = test_path(*state, "f");
    unsigned char model[BYTES];
    uint64_t seed = 9;
    ovr_store s;
    ovr_arena arena;
    begin(&s, &arena, path, model, &seed);
    snprintf(s.created, sizeof s.created, "today");
    scribble(&s, model, &seed);
    ovr_store_write(&s, 0, 5, "today");
    memcpy(model, "today", 5);
    CHECK_OK(ovr_store_commit(&s, &err), &err);
    CHECK_OK(ovr_store_sync(&s, &err), &err);
    die(&s, &arena); /* the state names 1, the journal is still that of 0 */
    prepare(&s, &arena, path);
    snprintf(s.created, sizeof s.created, "today");
    s.kept.number = 1;
    CHECK_OK(ovr_store_open(&s, &err), &err);
    check_content(&s, model);
    s.kept.number = 0; /* what it would have done */
    assert_int_equal(ovr_journal_roll_back(&s), 0);
    assert_true(ovr_store_read(&s, 0, 5, model));
    assert_memory_not_equal(model, "today", 5);
    ovr_store_close(&s);
    ovr_arena_release(&arena);
}

TEST_IN_FOLDER(ignores_the_journal_of_another_file)
{
    const char *path = test_path(*state, "c");
    unsigned char model[BYTES];
    uint64_t seed = 3;
    ovr_store s;
    ovr_arena arena;
    begin(&s, &arena, path, model, &seed);
    snprintf(s.created, sizeof s.created, "today");
    scribble(&s, model, &seed);
    CHECK_OK(ovr_store_commit(&s, &err), &err);
    die(&s, &arena);
    memset(model, 'x', BYTES);
    test_write(path, model, BYTES);
    prepare(&s, &arena, path);
    CHECK_OK(ovr_store_open(&s, &err), &err);
    assert_false(s.repaired);
    check_disk(path, model, BYTES);
    ovr_store_close(&s);
    ovr_arena_release(&arena);
}

TEST_IN_FOLDER(keeps_a_second_writer_out)
{
    const char *path = test_path(*state, "d");
    unsigned char model[BYTES];
    uint64_t seed = 5;
    ovr_store s, other;
    ovr_arena arena, other_arena;
    begin(&s, &arena, path, model, &seed);
    prepare(&other, &other_arena, path);
    assert_int_equal(ovr_store_open(&other, &err), OVR_BAD_INPUT);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "another process is writing it");
    ovr_store_close(&other);
    ovr_arena_release(&other_arena);
    prepare(&other, &other_arena, path);
    assert_int_equal(ovr_store_create(&other, true, &err), OVR_BAD_INPUT);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "another process is writing it");
    ovr_store_close(&other);
    ovr_arena_release(&other_arena);
    scribble(&s, model, &seed);
    CHECK_OK(ovr_store_commit(&s, &err), &err);
    check_disk(path, model, (size_t)s.length);
    ovr_store_close(&s);
    ovr_arena_release(&arena);
}

TEST_IN_FOLDER(notices_a_replaced_file)
{
    const char *path = test_path(*state, "e");
    unsigned char model[BYTES];
    uint64_t seed = 6;
    ovr_store s;
    ovr_arena arena;
    begin(&s, &arena, path, model, &seed);
    scribble(&s, model, &seed);
    unlink(path);
    test_write_text(path, "somebody else's");
    assert_int_equal(ovr_store_commit(&s, &err), OVR_IO);
    CHECK_ERROR(&err, OVR_IO, "removed or replaced");
    ovr_store_close(&s);
    check_disk(path, (const unsigned char *)"somebody else's", 15);
    ovr_arena_release(&arena);
}
