/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mathematics/transform.h"

#include <pthread.h>

static pthread_mutex_t planning = PTHREAD_MUTEX_INITIALIZER;

void ovr_planning_begin(void)
{
    pthread_mutex_lock(&planning);
}

void ovr_planning_end(void)
{
    pthread_mutex_unlock(&planning);
}
