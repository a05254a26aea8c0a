/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Creating a process always fails. */
#ifndef OVR_WEB_SPAWN_H
#define OVR_WEB_SPAWN_H
#include <errno.h>
typedef int posix_spawn_file_actions_t;
#define posix_spawn_file_actions_init(actions) (*(actions) = 0, 0)
#define posix_spawn_file_actions_destroy(actions) ((void)(actions), 0)
#define posix_spawn_file_actions_adddup2(actions, fd, as)                      \
    ((void)(actions), (void)(fd), (void)(as), 0)
#define posix_spawn_file_actions_addclose(actions, fd)                         \
    ((void)(actions), (void)(fd), 0)
typedef int posix_spawnattr_t;
enum { POSIX_SPAWN_SETPGROUP, SO_SNDBUF = 7 };
#define posix_spawnattr_init(how) (*(how) = 0, 0)
#define posix_spawnattr_destroy(how) ((void)(how), 0)
#define posix_spawnattr_setflags(how, flags) ((void)(how), 0)
#define posix_spawnattr_setpgroup(how, group) ((void)(how), 0)
#define setsockopt(fd, level, name, value, size) ((void)(fd), -1)
#define posix_spawnp(pid, file, actions, how, argv, environ)                   \
    ((void)(pid), (void)(file), (void)(actions), (void)(argv), ENOSYS)
#define socketpair(domain, kind, protocol, end)                                \
    ((void)(end), errno = ENOSYS, -1)
#endif
