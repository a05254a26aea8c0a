/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/queue.h"

#include <signal.h>

static bool allocate_parcel(ovr_parcel *p, size_t row_bytes, size_t columns,
                            ovr_arena *arena, ovr_error *err)
{
    p->rows = ovr_arena_take(arena, row_bytes, 1, err);
    p->step = ovr_arena_take(arena, OVR_PARCEL_STEPS, sizeof *p->step, err);
    p->values = ovr_arena_take(arena, OVR_PARCEL_STEPS * columns,
                               sizeof *p->values, err);
    return p->rows && p->step && p->values;
}

ovr_status ovr_queue_prepare(ovr_queue *q, size_t row_bytes, size_t columns,
                             ovr_arena *arena, ovr_error *err)
{
    bool blank = arena->blank, ok = true;
    arena->blank = true; /* written before it is read */
    for (size_t k = 0; ok && k < OVR_PARCELS; k++)
        ok = allocate_parcel(&q->parcel[k], row_bytes, columns, arena, err);
    arena->blank = blank;
    return ok ? OVR_OK : OVR_NO_MEMORY;
}

/* Writes a parcel unless an earlier one failed, and empties it. */
static ovr_status drain_one(ovr_queue *q, ovr_parcel *parcel, bool failed,
                            ovr_error *err)
{
    ovr_status status = OVR_OK;
    if (!failed)
        status = q->drain(q->context, parcel, err);
    parcel->snapshot = parcel->flush = false;
    parcel->steps = 0;
    return status;
}

/* Main function of the thread. The mutex protects first, posted, closing and
 * error. A posted parcel belongs to this thread until `posted` is decremented.
 * The thread is woken when half of the parcels are posted, for a flush, or if
 * the other thread waits. */
static void *drain_all(void *queue)
{
    ovr_queue *q = queue;
    ovr_error error;
    pthread_mutex_lock(&q->mutex);
    for (;;) {
        bool failed = q->error.status != OVR_OK;
        ovr_parcel *parcel = &q->parcel[q->first];
        if (q->posted == 0 && q->closing)
            break;
        if (q->posted == 0) {
            pthread_cond_wait(&q->changed, &q->mutex);
            continue;
        }
        pthread_mutex_unlock(&q->mutex);
        if (drain_one(q, parcel, failed, &error) == OVR_OK)
            error.status = OVR_OK;
        pthread_mutex_lock(&q->mutex);
        if (error.status != OVR_OK)
            q->error = error;
        q->first = (q->first + 1) % OVR_PARCELS;
        q->posted--;
        pthread_cond_broadcast(&q->changed);
    }
    pthread_mutex_unlock(&q->mutex);
    return NULL;
}

/* Starts the thread with all signals blocked: signals are handled by the
 * program's own threads. */
static bool start_thread(ovr_queue *q)
{
    sigset_t all, before;
    bool started;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    started = pthread_create(&q->thread, NULL, drain_all, q) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return started;
}

void ovr_queue_start(ovr_queue *q, bool threaded, ovr_drain *drain,
                     void *context)
{
    q->drain = drain;
    q->context = context;
    q->threaded = false;
    q->alone = threaded ? OVR_ALONE : 0;
}

static void start(ovr_queue *q)
{
    if (pthread_mutex_init(&q->mutex, NULL))
        return;
    if (pthread_cond_init(&q->changed, NULL)) {
        pthread_mutex_destroy(&q->mutex);
        return;
    }
    q->threaded = start_thread(q);
    if (!q->threaded) {
        pthread_cond_destroy(&q->changed);
        pthread_mutex_destroy(&q->mutex);
    }
}

ovr_parcel *ovr_queue_open(ovr_queue *q)
{
    return &q->parcel[q->filling];
}

static ovr_status report(const ovr_queue *q, ovr_error *err)
{
    if (q->error.status != OVR_OK && err)
        *err = q->error;
    return q->error.status;
}

ovr_status ovr_queue_post(ovr_queue *q, ovr_error *err)
{
    ovr_status status;
    if (q->alone && --q->alone == 0)
        start(q);
    if (!q->threaded) {
        drain_one(q, &q->parcel[0], q->error.status != OVR_OK, &q->error);
        return report(q, err);
    }
    pthread_mutex_lock(&q->mutex);
    bool flush = ovr_queue_open(q)->flush;
    q->posted++;
    q->filling = (q->filling + 1) % OVR_PARCELS;
    if (flush || q->posted >= OVR_PARCELS / 2)
        pthread_cond_broadcast(&q->changed);
    while (q->posted == OVR_PARCELS) /* waits for a free parcel */
        pthread_cond_wait(&q->changed, &q->mutex);
    status = report(q, err);
    pthread_mutex_unlock(&q->mutex);
    return status;
}

ovr_status ovr_queue_wait(ovr_queue *q, ovr_error *err)
{
    ovr_status status;
    if (!q->threaded)
        return report(q, err);
    pthread_mutex_lock(&q->mutex);
    pthread_cond_broadcast(&q->changed);
    while (q->posted > 0)
        pthread_cond_wait(&q->changed, &q->mutex);
    status = report(q, err);
    pthread_mutex_unlock(&q->mutex);
    return status;
}

void ovr_queue_stop(ovr_queue *q)
{
    if (!q->threaded)
        return;
    pthread_mutex_lock(&q->mutex);
    q->closing = true;
    pthread_cond_broadcast(&q->changed);
    pthread_mutex_unlock(&q->mutex);
    pthread_join(q->thread, NULL);
    pthread_cond_destroy(&q->changed);
    pthread_mutex_destroy(&q->mutex);
    q->threaded = false;
}
