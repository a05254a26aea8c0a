/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_WEB_WAIT_H
#define OVR_WEB_WAIT_H
#define waitpid(process, state, how) ((void)(state), (pid_t)-1)
#define WIFEXITED(state) 0
#define WEXITSTATUS(state) 0
#define WIFSIGNALED(state) 0
#define WTERMSIG(state) 0
#define WNOHANG 1
#endif
