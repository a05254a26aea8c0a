/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/team.h"

#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "support/test.h"

enum { ITEMS = 1000 };

typedef struct loop {
    int times[ITEMS];
    int by[ITEMS];
    int pause; /* us, of odd members */
} loop;

static void sleep_for(int us)
{
    nanosleep(&(struct timespec){.tv_nsec = 1000L * us}, NULL);
}

static void count_items(void *data, int member, size_t from, size_t to)
{
    loop *l = data;
    for (size_t k = from; k < to; k++) {
        l->times[k]++;
        l->by[k] = member;
    }
    if (l->pause && member % 2)
        sleep_for(l->pause);
}

static void check_parts(size_t count, int members, const loop *l)
{
    for (size_t k = 0; k < count; k++) {
        assert_int_equal(l->times[k], 1);
        assert_in_range(l->by[k], k ? l->by[k - 1] : 0, members - 1);
    }
    for (size_t k = count; k < ITEMS; k++)
        assert_int_equal(l->times[k], 0);
}

/* Each item is done once, by members in order, in shares that differ by one. */
TEST(all_items_are_done_once)
{
    static const size_t counts[] = {0, 1, 2, 5, 64, ITEMS};
    for (int members = 0; members <= 7; members++) {
        ovr_team team = {0};
        ovr_team_start(&team, members);
        int all = team.members > 1 ? team.members : 1;
        for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
            loop l = {.pause = 0};
            size_t share[8] = {0};
            ovr_team_run(&team, counts[c], count_items, &l);
            check_parts(counts[c], all, &l);
            for (size_t k = 0; k < counts[c]; k++)
                share[l.by[k]]++;
            for (int m = 0; m < all; m++)
                assert_in_range(share[m], counts[c] / (size_t)all,
                                counts[c] / (size_t)all + 1);
        }
        ovr_team_end(&team);
    }
}

/* Members that have gone to sleep, or are late, do their parts as well. */
TEST(sleeping_members_wake)
{
    ovr_team team = {0};
    ovr_team_start(&team, 4);
    for (int k = 0; k < 30; k++) {
        loop l = {.pause = k % 3 ? 0 : 2000};
        ovr_team_run(&team, ITEMS, count_items, &l);
        check_parts(ITEMS, 4, &l);
        if (k % 5 == 0)
            sleep_for(3000);
    }
    ovr_team_end(&team);
}

/* Members read what the caller wrote before a loop.  The caller reads what
 * members wrote in it. */
static void add_before(void *data, int member, size_t from, size_t to)
{
    long(*sums)[ITEMS] = data;
    (void)member;
    for (size_t k = from; k < to; k++)
        sums[1][k] = sums[0][k] + sums[0][(k + ITEMS / 2) % ITEMS];
}

TEST(loops_follow_each_other)
{
    static long sums[2][ITEMS];
    ovr_team team = {0};
    ovr_team_start(&team, 3);
    for (size_t k = 0; k < ITEMS; k++)
        sums[0][k] = (long)k;
    for (int turn = 0; turn < 2000; turn++) {
        ovr_team_run(&team, ITEMS, add_before, sums);
        for (size_t k = 0; k < ITEMS; k++)
            sums[0][k] = sums[1][k] % 1000003;
    }
    long expected[ITEMS];
    for (size_t k = 0; k < ITEMS; k++)
        expected[k] = (long)k;
    for (int turn = 0; turn < 2000; turn++) {
        long old[ITEMS];
        for (size_t k = 0; k < ITEMS; k++)
            old[k] = expected[k];
        for (size_t k = 0; k < ITEMS; k++)
            expected[k] = (old[k] + old[(k + ITEMS / 2) % ITEMS]) % 1000003;
    }
    for (size_t k = 0; k < ITEMS; k++)
        assert_int_equal(sums[0][k], expected[k]);
    ovr_team_end(&team);
}

/* A team can be started again. */
TEST(ended_teams_are_the_calling_thread)
{
    ovr_team team = {0};
    for (int k = 0; k < 3; k++) {
        loop l = {.pause = 0};
        ovr_team_start(&team, 2);
        ovr_team_end(&team);
        ovr_team_run(&team, ITEMS, count_items, &l);
        check_parts(ITEMS, 1, &l);
    }
    ovr_team_end(&team);
}

/* The child of a fork has no threads to wait for. */
TEST(children_of_a_fork_work_alone)
{
    ovr_team team = {0};
    ovr_team_start(&team, 3);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        loop l = {.pause = 0};
        alarm(20);
        ovr_team_run(&team, ITEMS, count_items, &l);
        ovr_team_end(&team);
        _exit(l.times[0] == 1 && l.times[ITEMS - 1] == 1 && l.by[ITEMS - 1] == 0
                  ? 0
                  : 1);
    }
    int status = -1;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    ovr_team_end(&team);
}
