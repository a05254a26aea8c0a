/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The line is a pair of sockets rather than of pipes, so that writing to a
 * child that has died gives an error and no SIGPIPE, whatever the program
 * around this library does with its signals.
 */
#include "pictures/process.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#ifndef MSG_NOSIGNAL
#define MSG_NOSIGNAL 0
#endif

extern char **environ;

/* Its own process group: a Ctrl-C in the terminal is ours to handle. */
static int spawn(pid_t *pid, const char *const *argv, int end)
{
    posix_spawn_file_actions_t files;
    posix_spawnattr_t how;
    int code = posix_spawn_file_actions_init(&files);
    if (code)
        return code;
    code = posix_spawnattr_init(&how);
    if (code) {
        posix_spawn_file_actions_destroy(&files);
        return code;
    }
    for (int fd = 0; fd < 3 && !code; fd++)
        code = posix_spawn_file_actions_adddup2(&files, end, fd);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&how, 0);
    /* posix_spawnp does not write to the words; its signature is older than
     * const. */
    union {
        const char *const *ours;
        char *const *theirs;
    } words = {argv};
    if (!code)
        code = posix_spawnp(pid, argv[0], &files, &how, words.theirs, environ);
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&files);
    return code;
}

static void make_line(int ends[2])
{
    int bytes = 1 << 20;
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    setsockopt(ends[0], SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes);
#ifdef SO_NOSIGPIPE
    bytes = 1;
    setsockopt(ends[0], SOL_SOCKET, SO_NOSIGPIPE, &bytes, sizeof bytes);
#endif
}

ovr_status ovr_process_start(ovr_process *p, const char *const *argv,
                             const char *package, ovr_error *err)
{
    int ends[2], code;
    memset(p, 0, sizeof *p);
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
        return ovr_fail(err, OVR_IO, "cannot start %s: %s", argv[0],
                        strerror(errno));
    make_line(ends);
    code = spawn(&p->pid, argv, ends[1]);
    close(ends[1]);
    p->line = ends[0];
    if (code == 0)
        return OVR_OK;
    close(ends[0]);
    p->pid = 0;
    if (code == ENOENT)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s is not installed; on Debian: apt install %s",
                        argv[0], package);
    return ovr_fail(err, OVR_IO, "cannot start %s: %s", argv[0],
                    strerror(code));
}

bool ovr_process_send(ovr_process *p, const void *data, size_t bytes)
{
    const char *from = data;
    while (bytes > 0) {
        ssize_t sent = send(p->line, from, bytes, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent < 0)
            return false;
        from += sent;
        bytes -= (size_t)sent;
    }
    return true;
}

/* The next byte, or -1 at the end. */
static int read_character(ovr_process *p)
{
    while (p->from == p->to) {
        ssize_t got = recv(p->line, p->heard, sizeof p->heard, 0);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return -1;
        p->from = 0;
        p->to = (size_t)got;
    }
    return (unsigned char)p->heard[p->from++];
}

bool ovr_process_line(ovr_process *p, char *line, size_t size)
{
    size_t length = 0;
    int c = read_character(p);
    bool any = c >= 0;
    for (; c >= 0 && c != '\n'; c = read_character(p))
        if (length + 1 < size)
            line[length++] = (char)(c < ' ' ? ' ' : c);
    line[length] = '\0';
    return any;
}

static bool wait_for(ovr_process *p)
{
    int status = 0;
    pid_t pid;
    do {
        pid = waitpid(p->pid, &status, 0);
    } while (pid < 0 && errno == EINTR);
    p->pid = 0;
    /* Somebody else may have reaped it (SIGCHLD ignored): it is over. */
    return pid < 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

bool ovr_process_end(ovr_process *p, char *last, size_t size)
{
    char line[512];
    bool ok;
    if (last)
        last[0] = '\0';
    if (p->pid == 0)
        return true;
    shutdown(p->line, SHUT_WR);
    while (ovr_process_line(p, line, sizeof line))
        if (last && line[strspn(line, " ")])
            snprintf(last, size, "%s", line + strspn(line, " "));
    ok = wait_for(p);
    close(p->line);
    return ok;
}

void ovr_process_kill(ovr_process *p)
{
    if (p->pid == 0)
        return;
    kill(p->pid, SIGKILL);
    ovr_process_end(p, NULL, 0);
}
