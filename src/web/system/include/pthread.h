/* SPDX-License-Identifier: GPL-3.0-or-later */
/* POSIX threads for a single thread: locking a mutex always succeeds, and
 * creating a thread always fails, which all callers handle. */
#ifndef OVR_WEB_PTHREAD_H
#define OVR_WEB_PTHREAD_H
#include <errno.h>
#include <signal.h>
typedef int ovr_web_pthread, ovr_web_mutex, ovr_web_cond, ovr_web_once;
#define pthread_t ovr_web_pthread
#define pthread_mutex_t ovr_web_mutex
#define pthread_cond_t ovr_web_cond
#define PTHREAD_MUTEX_INITIALIZER 0
#define pthread_mutex_init(mutex, how) ((void)(mutex), 0)
#define pthread_mutex_destroy(mutex) ((void)(mutex), 0)
#define pthread_mutex_lock(mutex) ((void)(mutex), 0)
#define pthread_mutex_unlock(mutex) ((void)(mutex), 0)
#define pthread_cond_init(cond, how) ((void)(cond), 0)
#define pthread_cond_destroy(cond) ((void)(cond), 0)
#define pthread_cond_wait(cond, mutex) __builtin_trap()
#define pthread_cond_broadcast(cond) ((void)(cond), 0)
#define pthread_create(thread, how, work, data)                                \
    ((void)(thread), (void)(work), (void)(data), EAGAIN)
#define pthread_join(thread, result) ((void)(thread), 0)
#define pthread_sigmask(how, set, before) ((void)(set), (void)(before), 0)
#endif
