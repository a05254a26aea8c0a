/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/gnuplot.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---------------------------------------------------------------- processes */

/* The connection is a pair of sockets instead of pipes. Writing to a child that
 * has ended then returns an error and causes no SIGPIPE, independent of the
 * program's signal handling. */

#ifndef MSG_NOSIGNAL
#define MSG_NOSIGNAL 0
#endif

extern char **environ;

/* Starts a process in its own process group, so that Ctrl-C in the terminal is
 * handled by this program. */
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
    /* posix_spawnp does not change the strings; its signature predates
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

/* Returns the next byte, or -1 at the end. */
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

/* Reads the next line of output without its line end, truncated to fit; false
 * at the end. */
static bool process_line(ovr_process *p, char *line, size_t size)
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
    /* The child may have been reaped elsewhere (SIGCHLD ignored); it has then
     * ended. */
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
    while (process_line(p, line, sizeof line))
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

static const char done[] = "overroll: drawn";

ovr_status ovr_gnuplot_start(ovr_gnuplot *g, ovr_error *err)
{
    /* -d: without start-up files. */
    static const char *const argv[] = {"gnuplot", "-d", NULL};
    g->path[0] = '\0';
    return ovr_process_start(&g->process, argv, "gnuplot-nox", err);
}

/* Appends a path as a string of gnuplot. gnuplot interprets names that begin
 * with '|' or '<' as commands and '~' as a home folder; a line end cannot be
 * quoted. */
ovr_status ovr_gnuplot_path(ovr_text *script, const char *path, ovr_error *err)
{
    for (const char *c = path; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            return ovr_fail(err, OVR_BAD_INPUT,
                            "the name of a picture must not contain control "
                            "characters");
    ovr_text_put(script, *path == '/' ? "'" : "'./");
    for (; *path; path++)
        ovr_text_add(script, *path == '\'' ? "''" : path,
                     *path == '\'' ? 2 : 1);
    ovr_text_put(script, "'");
    return OVR_OK;
}

/* Writes FOLDER/.NAMEsuffix; `name` has OVR_PATH_SIZE bytes. */
static ovr_status name_beside(char *name, const char *path, const char *suffix,
                              ovr_error *err)
{
    const char *slash = strrchr(path, '/');
    int folder = slash ? (int)(slash - path) + 1 : 0;
    int length = snprintf(name, OVR_PATH_SIZE, "%.*s.%s%s", folder, path,
                          path + folder, suffix);
    if (length > 0 && length < OVR_PATH_SIZE)
        return OVR_OK;
    name[0] = '\0';
    return ovr_fail(err, OVR_BAD_INPUT, "%.60s...: the name is too long", path);
}

/* Creates an empty file of this name; existing links are not followed. */
static bool make_anew(const char *path)
{
    int file;
    unlink(path);
    file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return file >= 0 && close(file) == 0;
}

/* Creates the temporary file, on the same file system as the path and without a
 * picture's suffix. If it cannot be created, this fails now; gnuplot would
 * continue and draw to its standard output. */
ovr_status ovr_part_make(char *part, const char *path, ovr_error *err)
{
    if (name_beside(part, path, ".part", err) != OVR_OK)
        return OVR_BAD_INPUT;
    if (make_anew(part))
        return OVR_OK;
    part[0] = '\0';
    return ovr_fail(err, OVR_BAD_INPUT, "%.500s: cannot be created: %s", path,
                    strerror(errno));
}

/* Sends the script as a file. gnuplot reads files in blocks but standard input
 * byte by byte, 100,000 system calls per picture. */
static ovr_status send_script(ovr_gnuplot *g, const ovr_text *script,
                              ovr_arena *arena, ovr_error *err)
{
    ovr_text file = ovr_text_make(arena), line = ovr_text_make(arena);
    ovr_status status;
    ovr_text_put(&file, "set output ");
    ovr_text_put(&line, "load ");
    status = ovr_gnuplot_path(&file, g->made, err);
    if (status == OVR_OK)
        status = ovr_gnuplot_path(&line, g->script, err);
    if (status != OVR_OK)
        return status;
    ovr_text_put(&file, "\n");
    ovr_text_add(&file, script->data, script->length);
    ovr_text_put(&file, "unset output\n");
    /* The empty line ends a picture that was written here. A template may
     * redirect its own output. */
    ovr_text_print(&line, "\nset print\nprint ''\nprint '%s'\n", done);
    status = ovr_text_save_anew(&file, g->script, err);
    if (status == OVR_OK)
        status = ovr_text_status(&line, err);
    /* If writing to gnuplot fails, waiting for it returns the reason. */
    if (status == OVR_OK)
        ovr_process_send(&g->process, line.data, line.length);
    return status;
}

static void clear_away(ovr_gnuplot *g)
{
    unlink(g->made);
    unlink(g->script);
    g->path[0] = '\0';
}

ovr_status ovr_gnuplot_ask(ovr_gnuplot *g, const ovr_text *script,
                           const char *path, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(&script->arena->allocator);
    ovr_status status = ovr_text_status(script, err);
    if (status == OVR_OK)
        status = name_beside(g->script, path, ".gp", err);
    if (status == OVR_OK)
        status = ovr_part_make(g->made, path, err);
    if (status != OVR_OK)
        return status;
    snprintf(g->path, sizeof g->path, "%s", path);
    status = send_script(g, script, &arena, err);
    if (status != OVR_OK)
        clear_away(g);
    ovr_arena_release(&arena);
    return status;
}

/* Keeps the reason of an error: gnuplot prints the line, a caret and then the
 * error. */
static void keep_reason(char *why, size_t size, const char *line)
{
    line += strspn(line, " ");
    if (*line && *line != '^')
        snprintf(why, size, "%s", line);
}

static ovr_status appear(ovr_gnuplot *g, const char *why, ovr_error *err)
{
    struct stat about;
    ovr_status status = OVR_OK;
    if (stat(g->made, &about) == 0 && about.st_size == 0)
        status = ovr_fail(err, OVR_IO, "%.500s: gnuplot: %s", g->path, why);
    else if (rename(g->made, g->path) != 0)
        status = ovr_fail(err, OVR_IO, "%.500s: cannot be written: %s", g->path,
                          strerror(errno));
    clear_away(g);
    return status;
}

ovr_status ovr_gnuplot_wait(ovr_gnuplot *g, ovr_error *err)
{
    char line[600], why[600] = "nothing was drawn";
    if (g->path[0] == '\0')
        return OVR_OK;
    while (process_line(&g->process, line, sizeof line)) {
        if (strcmp(line, done) == 0)
            return appear(g, why, err);
        keep_reason(why, sizeof why, line);
    }
    ovr_fail(err, OVR_IO, "%.300s: gnuplot: %s", g->path, why);
    clear_away(g);
    return OVR_IO;
}

void ovr_gnuplot_stop(ovr_gnuplot *g)
{
    if (g->path[0]) {
        ovr_process_kill(&g->process);
        clear_away(g);
    }
    ovr_process_end(&g->process, NULL, 0);
}
