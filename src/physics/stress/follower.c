/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A material history in a thread of its own.
 *
 * The solver's thread copies pressure and traction into a ring buffer and
 * continues. The follower reads them in order, so that the history does not
 * depend on the speed of the threads.  A full ring makes the solver wait.
 * Without a thread, samples are processed immediately.
 */
#include <pthread.h>
#include <string.h>

#include "physics/stress/stress.h"
#include "stress/stress.h"

enum { RING = 32 };

typedef struct posted {
    ovr_post part;
    ovr_moment moment;
    double *P, *Q; /* NULL: no traction */
} posted;

struct ovr_follower {
    ovr_arena arena;
    ovr_material_history *history;
    size_t nodes;
    posted ring[RING];
    size_t first, count; /* samples queued and not yet processed */
    bool threaded, closing;
    pthread_t thread;
    pthread_mutex_t mutex;
    pthread_cond_t changed;
};

static void process(ovr_material_history *p, const posted *m)
{
    if (m->part == OVR_POST_BEGIN)
        ovr_material_history_begin(p, m->P, m->Q, &m->moment);
    else if (m->part == OVR_POST_STEP)
        ovr_material_history_step(p, m->P, m->Q, &m->moment);
    else
        ovr_material_history_end(p, m->P, m->Q, &m->moment);
}

static void *follow(void *data)
{
    ovr_follower *f = data;
    pthread_mutex_lock(&f->mutex);
    for (;;) {
        while (!f->count && !f->closing)
            pthread_cond_wait(&f->changed, &f->mutex);
        if (!f->count)
            break;
        pthread_mutex_unlock(&f->mutex);
        process(f->history, &f->ring[f->first]);
        pthread_mutex_lock(&f->mutex);
        f->first = (f->first + 1) % RING;
        f->count--;
        pthread_cond_broadcast(&f->changed);
    }
    pthread_mutex_unlock(&f->mutex);
    return NULL;
}

ovr_follower *ovr_follower_create(const ovr_stress_plan *plan,
                                  const ovr_allocator *allocator,
                                  ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_follower *f = ovr_arena_take(&arena, 1, sizeof *f, err);
    size_t n = plan->options.nodes, loads = plan->options.traction ? 2 : 1;
    double *P = f ? ovr_arena_take(&arena, loads * RING * n, sizeof *P, err)
                  : NULL;
    if (P)
        f->history = ovr_material_history_create(&plan->options, &plan->range,
                                                 allocator, err);
    if (!P || !f->history) {
        ovr_arena_release(&arena);
        return NULL;
    }
    f->arena = arena;
    f->nodes = n;
    for (size_t k = 0; k < RING; k++) {
        f->ring[k].P = P + k * n;
        f->ring[k].Q = loads > 1 ? P + (RING + k) * n : NULL;
    }
    pthread_mutex_init(&f->mutex, NULL);
    pthread_cond_init(&f->changed, NULL);
    f->threaded = pthread_create(&f->thread, NULL, follow, f) == 0;
    return f;
}

void ovr_follower_post(ovr_follower *f, ovr_post part, const double *P,
                       const double *Q, const ovr_moment *moment)
{
    pthread_mutex_lock(&f->mutex);
    while (f->count == RING)
        pthread_cond_wait(&f->changed, &f->mutex);
    posted *m = &f->ring[(f->first + f->count) % RING];
    m->part = part;
    m->moment = *moment;
    memcpy(m->P, P, f->nodes * sizeof *P);
    if (m->Q)
        memcpy(m->Q, Q, f->nodes * sizeof *Q);
    if (f->threaded)
        f->count++;
    else
        process(f->history, m);
    pthread_cond_broadcast(&f->changed);
    pthread_mutex_unlock(&f->mutex);
}

ovr_material_history *ovr_follower_wait(ovr_follower *f)
{
    pthread_mutex_lock(&f->mutex);
    while (f->count)
        pthread_cond_wait(&f->changed, &f->mutex);
    pthread_mutex_unlock(&f->mutex);
    return f->history;
}

void ovr_follower_free(ovr_follower *f)
{
    if (!f)
        return;
    if (f->threaded) {
        pthread_mutex_lock(&f->mutex);
        f->closing = true;
        pthread_cond_broadcast(&f->changed);
        pthread_mutex_unlock(&f->mutex);
        pthread_join(f->thread, NULL);
    }
    pthread_cond_destroy(&f->changed);
    pthread_mutex_destroy(&f->mutex);
    ovr_material_history_free(f->history);
    ovr_arena arena = f->arena;
    ovr_arena_release(&arena);
}
