/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Declarations for builds without dynamic loading of libraries. */
#ifndef OVR_WEB_DLFCN_H
#define OVR_WEB_DLFCN_H
enum { RTLD_LAZY, RTLD_LOCAL = 0 };
static inline void *dlopen(const char *name, int how)
{
    return (void)name, (void)how, (void *)0;
}
static inline void *dlsym(void *handle, const char *name)
{
    return (void)handle, (void)name, (void *)0;
}
static inline int dlclose(void *handle)
{
    return (void)handle, 0;
}
static inline char *dlerror(void)
{
    return (char *)0;
}
#endif
