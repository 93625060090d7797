/* Loaded before the C library (LD_PRELOAD), lets calls of a program fail that mostly succeed, as these
 * variables of the environment say:
 *
 * - FAILING_CALLS: which calls; "memory" (malloc and its kind), or "files" (open for writing, write, fsync,
 * syncfs, close and rename of what is neither standard output nor standard error)
 * - FAILING_FROM: the number of the first that fails, from 1; nothing fails without it
 * - FAILING_EACH: if it is there, all of them fail from that one on; otherwise it alone does
 * - FAILING_ERROR: errno of "files"
 * - FAILING_REPORT: a descriptor, to which the number of calls is written at the end of the program
 *
 * Calls are counted once the libraries of the program have begun, and before its own globals do. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* block, size_t size);
void* __libc_memalign(size_t alignment, size_t size);

enum kind { none, memory, files };

static enum kind failing = none;
static long first = 0;
static int is_each = 0;
static int error_number = 0;
static long calls = 0;

static long number_in(const char* name)
{
    const char* const text = getenv(name);
    return text == NULL ? 0 : strtol(text, NULL, 10);
}

static int fails(enum kind kind)
{
    if (kind != failing)
        return 0;
    const long number = __atomic_add_fetch(&calls, 1, __ATOMIC_RELAXED);
    return first > 0 && (is_each ? number >= first : number == first);
}

static int memory_fails(void)
{
    if (!fails(memory))
        return 0;
    errno = ENOMEM;
    return 1;
}

static int file_fails(void)
{
    if (!fails(files))
        return 0;
    errno = error_number;
    return 1;
}

void* malloc(size_t size) { return memory_fails() ? NULL : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return memory_fails() ? NULL : __libc_calloc(count, size); }
void* realloc(void* block, size_t size) { return memory_fails() ? NULL : __libc_realloc(block, size); }
void* memalign(size_t alignment, size_t size)
{
    return memory_fails() ? NULL : __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }

int posix_memalign(void** block, size_t alignment, size_t size)
{
    void* const found = memalign(alignment, size);
    if (found == NULL)
        return ENOMEM;
    *block = found;
    return 0;
}

static int is_written(int descriptor)
{
    const int flags = (int)syscall(SYS_fcntl, descriptor, F_GETFL);
    return descriptor > STDERR_FILENO && flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

static int is_folder(int flags) { return (flags & O_DIRECTORY) != 0; }

static int opened(int folder, const char* path, int flags, int mode)
{
    const int is_counted = (flags & O_ACCMODE) != O_RDONLY && strncmp(path, "/dev/", 5) != 0;
    if (is_counted && !is_folder(flags) && file_fails())
        return -1;
    return (int)syscall(SYS_openat, folder, path, flags, mode);
}

static int mode_behind(int flags, va_list rest)
{
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, int) : 0;
}

int open(const char* path, int flags, ...)
{
    va_list rest;
    va_start(rest, flags);
    const int mode = mode_behind(flags, rest);
    va_end(rest);
    return opened(AT_FDCWD, path, flags, mode);
}

int open64(const char* path, int flags, ...)
{
    va_list rest;
    va_start(rest, flags);
    const int mode = mode_behind(flags, rest);
    va_end(rest);
    return opened(AT_FDCWD, path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t size)
{
    return is_written(descriptor) && file_fails() ? -1 : syscall(SYS_write, descriptor, bytes, size);
}

ssize_t writev(int descriptor, const struct iovec* parts, int count)
{
    return is_written(descriptor) && file_fails() ? -1 : syscall(SYS_writev, descriptor, parts, count);
}

int fsync(int descriptor) { return file_fails() ? -1 : (int)syscall(SYS_fsync, descriptor); }

int syncfs(int descriptor) { return file_fails() ? -1 : (int)syscall(SYS_syncfs, descriptor); }

int close(int descriptor)
{
    const int is_failing = is_written(descriptor) && file_fails(); /* it is closed all the same */
    const int saved = errno;
    const int result = (int)syscall(SYS_close, descriptor);
    if (!is_failing)
        return result;
    errno = saved;
    return -1;
}

int rename(const char* from, const char* to)
{
    return file_fails() ? -1 : (int)syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0);
}

__attribute__((constructor)) static void begin(void)
{
    const char* const which = getenv("FAILING_CALLS");
    first = number_in("FAILING_FROM");
    is_each = getenv("FAILING_EACH") != NULL;
    error_number = (int)number_in("FAILING_ERROR");
    calls = 0;
    failing = which == NULL ? none : strcmp(which, "memory") == 0 ? memory : files;
}

__attribute__((destructor)) static void report(void)
{
    const long counted = calls;
    failing = none;
    const int descriptor = (int)number_in("FAILING_REPORT");
    if (descriptor > 0)
        dprintf(descriptor, "%ld\n", counted);
}
