/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Functions that the program calls and wasi does not have. Creating processes
 * always fails, locks always succeed. Included before every file.
 */
#ifndef OVR_WEB_WASI_H
#define OVR_WEB_WASI_H
#include <fcntl.h>
#include <sys/types.h>

enum { F_RDLCK, F_WRLCK, F_UNLCK };
enum { F_SETLK = 1000, F_SETLKW, F_GETLK };
int ovr_web_fcntl(int fd, int what, ...);
#define fcntl ovr_web_fcntl
int flock(int fd, int how);

int kill(pid_t process, int number);

pid_t fork(void);
pid_t getppid(void);
int pipe(int end[2]);
int dup(int fd);
int dup2(int fd, int as);
mode_t umask(mode_t mask);
char *realpath(const char *restrict path, char *restrict to);
char *mkdtemp(char *name);
#endif
