// SPDX-License-Identifier: MIT
/* Makes the n-th call of one kind fail, in any program: LD_PRELOAD=fail_nth.so TALUS_FAIL=write:17 talus run …
   Kinds: write (write, pwrite), rename, sync (fsync), open (for writing), memory (an allocation of 4 KiB and more).
   With n = 0 nothing fails. Where TALUS_FAIL_COUNT names a file, the number of calls is appended to it at the end. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char kind[16];
static long nth = -1;
static atomic_long calls;

__attribute__((constructor)) static void begin(void) {
  const char* wanted = getenv("TALUS_FAIL");
  const char* colon = wanted ? strchr(wanted, ':') : 0;
  if (!colon || (size_t)(colon - wanted) >= sizeof kind) return;
  memcpy(kind, wanted, (size_t)(colon - wanted));
  nth = atol(colon + 1);
}

__attribute__((destructor)) static void end(void) {
  const char* path = getenv("TALUS_FAIL_COUNT");
  FILE* file = path ? fopen(path, "a") : 0;
  if (!file) return;
  fprintf(file, "%ld\n", atomic_load(&calls));
  fclose(file);
}

static int fails(const char* what) {
  return nth >= 0 && strcmp(kind, what) == 0 && atomic_fetch_add(&calls, 1) + 1 == nth;
}

#define REAL(type, name, ...)                                       \
  static type (*real)(__VA_ARGS__);                                 \
  if (!real) real = (type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, name)

ssize_t write(int fd, const void* data, size_t size) {
  REAL(ssize_t, "write", int, const void*, size_t);
  if (fd > 2 && fails("write")) return errno = ENOSPC, -1;
  return real(fd, data, size);
}
ssize_t pwrite(int fd, const void* data, size_t size, off_t at) {
  REAL(ssize_t, "pwrite", int, const void*, size_t, off_t);
  if (fails("write")) return errno = ENOSPC, -1;
  return real(fd, data, size, at);
}
ssize_t pwrite64(int fd, const void* data, size_t size, off64_t at) {
  REAL(ssize_t, "pwrite64", int, const void*, size_t, off64_t);
  if (fails("write")) return errno = ENOSPC, -1;
  return real(fd, data, size, at);
}
int rename(const char* from, const char* to) {
  REAL(int, "rename", const char*, const char*);
  if (fails("rename")) return errno = EIO, -1;
  return real(from, to);
}
int fsync(int fd) {
  REAL(int, "fsync", int);
  if (fails("sync")) return errno = EIO, -1;
  return real(fd);
}
static int open_as(const char* name, const char* path, int flags, mode_t mode) {
  int (*real)(const char*, int, ...) = (int (*)(const char*, int, ...))dlsym(RTLD_NEXT, name);
  if ((flags & (O_WRONLY | O_RDWR)) != 0 && fails("open")) return errno = EACCES, -1;
  return real(path, flags, mode);
}
int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
  va_end(more);
  return open_as("open", path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
  va_end(more);
  return open_as("open64", path, flags, mode);
}

extern void* __libc_malloc(size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_calloc(size_t, size_t);
enum { large = 4096 };
void* malloc(size_t size) {
  if (size >= large && fails("memory")) return errno = ENOMEM, (void*)0;
  return __libc_malloc(size);
}
void* realloc(void* old, size_t size) {
  if (size >= large && fails("memory")) return errno = ENOMEM, (void*)0;
  return __libc_realloc(old, size);
}
void* calloc(size_t count, size_t size) {
  if (count * size >= large && fails("memory")) return errno = ENOMEM, (void*)0;
  return __libc_calloc(count, size);
}
